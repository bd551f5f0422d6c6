// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec2 pattern_position;  // a period is two squares

uniform vec4 middle;           // of the light and the dark colour
uniform vec4 half_difference;  // half of light less dark

out vec4 fragment;

// Of light squares under a pixel, less the dark ones: the mean over a box as wide as the pixel is in
// rest space. Per axis, a triangle wave is the integral of the square wave whose product makes the
// board. Few operations, for this is the largest area that a software rasteriser shades.
float lightness(vec2 p) {
  vec2 along_x = dFdx(p);
  vec2 along_y = dFdy(p);
  vec2 width = sqrt(along_x * along_x + along_y * along_y) + 5e-6;
  vec2 before = abs(fract(p - 0.5 * width) - 0.5);
  vec2 after = abs(fract(p + 0.5 * width) - 0.5);
  vec2 mean = (before - after) / width;
  return mean.x * mean.y;
}

void main() { fragment = lightness(pattern_position) * half_difference + middle; }
