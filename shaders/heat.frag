// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

uniform sampler2D colours;  // one texel a triangle, row by row
uniform int first_triangle;  // of this sheet

out vec4 fragment;

void main() {
  int width = textureSize(colours, 0).x;
  int triangle = first_triangle + gl_PrimitiveID;
  fragment = texelFetch(colours, ivec2(triangle % width, triangle / width), 0);
}
