//VTK::System::Dec
// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Hands the picture of all blocks to the window's blending, pixel by pixel (vtkTFCBlendBuffer.h).
//VTK::Output::Dec

uniform sampler2D picture;
uniform vec2 origin; // of the viewport in the picture
uniform vec2 size;
in vec2 texCoord; // 0 to 1 over the viewport

void main()
{
  gl_FragData[0] = texture(picture, origin + texCoord * size);
}
