// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCRaySampler
 * @brief The attributes of one image along a line of sight, as the volume mapper samples them.
 *
 * The line is start + t * direction in world coordinates, t in world lengths. Attributes are
 * interpolated trilinearly between points, or between cell centres with the border repeated; an
 * interpolated value that a NaN or a blanked sample takes part in is NaN. What the image draws is
 * the box of its points without ghost cells; a single layer is one voxel thick.
 */

#ifndef vtkTFCRaySampler_h
#define vtkTFCRaySampler_h

#include "vtkSmartPointer.h" // For images
#include "vtkTFCAttributeReader.h"
#include "vtkTFCTransferFunctionModule.h" // For export macro

#include <array>  // For points
#include <string> // For errors
#include <vector> // For values

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkMatrix4x4;

class VTKTFCTRANSFERFUNCTION_EXPORT vtkTFCRaySampler
{
public:
  /// Prepare for an image or rectilinear grid, which must outlive this. Returns false with `error`
  /// when an attribute is missing.
  bool Bind(vtkDataSet* data, const std::vector<vtkTFCAttribute>& attributes,
    vtkMatrix4x4* modelToWorld, std::string& error);

  /// Where the line is inside of what the image draws; false where it is not, or only touches it. A
  /// line along a face belongs to the image above.
  bool Intersect(const std::array<double, 3>& start, const std::array<double, 3>& direction,
    double interval[2]) const;

  /// Values of all attributes at a world position, one after the other.
  void Sample(const std::array<double, 3>& world, double* values) const;

  /// The same of any array of the attributes' association, all components.
  std::vector<double> SampleArray(vtkDataArray* array, const std::array<double, 3>& world) const;

  /// The nearest point, or the cell, at a world position.
  std::array<int, 3> FindVoxel(const std::array<double, 3>& world) const;

  /// Positions along the axes of the data: what cropping planes are given in.
  std::array<double, 3> FindAxisPosition(const std::array<double, 3>& world) const;
  /// Those at the ends of the points: lowest, highest.
  std::array<double, 2> GetAxisBounds(int axis) const;

  const vtkTFCAttributeReader& GetReader() const { return this->Reader; }
  /// For a rectilinear grid an image of its mean spacings that shares its arrays.
  vtkImageData* GetImage() const { return this->Image; }

private:
  struct Corner
  {
    vtkIdType Index;
    double Weight;
  };

  void BindGrid(vtkDataSet* data);
  std::array<double, 3> ToFrame(const std::array<double, 3>& point, double w) const;
  std::array<double, 3> ToIndex(const std::array<double, 3>& world) const;
  std::array<Corner, 8> FindCorners(const std::array<double, 3>& world) const;

  vtkSmartPointer<vtkImageData> Image;
  std::array<std::vector<double>, 3> Places; ///< of a rectilinear grid's points; else empty
  vtkTFCAttributeReader Reader;
  int Attributes = 0;
  /// To indices or, for a rectilinear grid, to positions along its axes.
  std::array<double, 16> WorldToFrame = {};
  std::array<double, 6> Drawn = {}; ///< box in that frame
  std::array<int, 6> Lattice = {};  ///< first and last sample along each axis
  double CellShift = 0;             ///< of a sample from its index
};

#endif
// VTK-HeaderTest-Exclude: vtkTFCRaySampler.h
