// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in vec2 rest_position;

uniform vec2 box_min;  // of the rest mesh
uniform float square_size;
uniform vec4 light;
uniform vec4 dark;

out vec4 fragment;

// Share of dark squares under a pixel: the mean over a box as wide as the pixel is in rest space.
// Per axis, a triangle wave is the integral of the square wave whose product makes the board.
float dark_share(vec2 p) {
  vec2 along_x = dFdx(p);
  vec2 along_y = dFdy(p);
  vec2 width = sqrt(along_x * along_x + along_y * along_y) + 1e-5;
  vec2 before = abs(fract((p - 0.5 * width) * 0.5) - 0.5);
  vec2 after = abs(fract((p + 0.5 * width) * 0.5) - 0.5);
  vec2 mean = 2.0 * (before - after) / width;
  return 0.5 - 0.5 * mean.x * mean.y;
}

void main() {
  fragment = mix(light, dark, dark_share((rest_position - box_min) / square_size));
}
