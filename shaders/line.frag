// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec2 along_across;
flat in float segment_length;

uniform float half_width;   // pixels
uniform float dash_length;  // pixels; 0: a solid line
uniform int is_round;
uniform vec4 colour;        // straight alpha

out vec4 fragment;

float dashes(float along) {
  float from_middle = abs(fract(along / (2.0 * dash_length)) - 0.5) * 2.0 * dash_length;
  return clamp(0.5 * dash_length + 0.5 - from_middle, 0.0, 1.0);
}

void main() {
  float beyond = max(max(-along_across.x, along_across.x - segment_length), 0.0);
  float distance = is_round == 1 ? length(vec2(beyond, along_across.y)) : abs(along_across.y);
  // Round ends lie over the next segment: without their soft edge, else its edge would be doubled.
  if (beyond > 0.0) distance += 0.5;
  float coverage = clamp(half_width + 0.5 - distance, 0.0, min(1.0, 2.0 * half_width));
  if (dash_length > 0.0) coverage *= dashes(along_across.x);
  float alpha = colour.a * coverage;
  fragment = vec4(colour.rgb * alpha, alpha);
}
