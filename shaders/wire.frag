// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec3 distances;
flat in vec3 fades;

uniform float half_width;  // pixels
uniform vec4 colour;       // straight alpha

out vec4 fragment;

// Each triangle draws its side of its edges: half the work of lines of their own, and nothing of
// what is hidden can show through. A pixel whose middle lies beyond an edge has a distance below 0.
void main() {
  vec3 within = half_width + 0.5 - abs(distances);
  vec3 coverage = clamp(within, 0.0, min(1.0, 2.0 * half_width)) * fades;
  float alpha = colour.a * max(coverage.x, max(coverage.y, coverage.z));
  fragment = vec4(colour.rgb * alpha, alpha);
}
