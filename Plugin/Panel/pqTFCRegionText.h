// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Values of a region as text: what fields and cells show, and what is typed there.
 *
 * Numbers are in data units and shown with few digits. A number or colour that is typed as it was
 * shown keeps all the digits that it has. Between numbers may be blanks, commas, semicolons and
 * brackets.
 *
 * Every set function is one edit of the document: one step of undo. It returns false, tells the
 * user what was expected and changes nothing when the text cannot be read.
 */

#ifndef pqTFCRegionText_h
#define pqTFCRegionText_h

#include <QString>

class pqTFCDocument;
class vtkTFCRegion;

///@{
/// "#rrggbb", or typed any name of an SVG colour.
QString pqTFCColorText(vtkTFCRegion* region);
bool pqTFCSetColor(pqTFCDocument* document, vtkTFCRegion* region, const QString& text);
///@}

///@{
/// Of an ellipse or rectangle: centre x y; half of width and height; angle in degrees. Of a
/// triangle or polygon: its corners x y; x y; ... A text that begins with another kind of shape
/// changes the kind; without numbers behind it, they stay.
QString pqTFCGeometryText(vtkTFCRegion* region);
bool pqTFCSetGeometry(pqTFCDocument* document, vtkTFCRegion* region, const QString& text);
///@}

/// The kind of shape, and its geometry.
QString pqTFCShapeText(vtkTFCRegion* region);

///@{
/// Points of the opacity over the tertiary attribute: value opacity; value opacity; ...
QString pqTFCOpacityPointsText(vtkTFCRegion* region);
bool pqTFCSetOpacityPoints(pqTFCDocument* document, vtkTFCRegion* region, const QString& text);
///@}

///@{
/// Points of the colour over the tertiary attribute: value #rrggbb; value #rrggbb; ... Empty for
/// the colour of the region.
QString pqTFCColorPointsText(vtkTFCRegion* region);
bool pqTFCSetColorPoints(pqTFCDocument* document, vtkTFCRegion* region, const QString& text);
///@}

///@{
/// The extent of the tertiary attribute that is shown: low high. Empty for that of the data.
QString pqTFCTertiaryRangeText(vtkTFCRegion* region);
bool pqTFCSetTertiaryRange(pqTFCDocument* document, vtkTFCRegion* region, const QString& text);
///@}

#endif
