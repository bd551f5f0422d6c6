// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

uniform sampler2D colours;  // one texel a triangle, row by row

out vec4 fragment;

void main() {
  int width = textureSize(colours, 0).x;
  fragment = texelFetch(colours, ivec2(gl_PrimitiveID % width, gl_PrimitiveID / width), 0);
}
