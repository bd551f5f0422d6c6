// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec2 from_centre;
flat in vec4 marker_shape;
flat in vec4 fill_colour;
flat in vec4 rim_colour;

uniform float ui_scale;

out vec4 fragment;

// Signed distance to a square with round corners: roundness 1 is a disc.
float outline_distance(vec2 p) {
  float radius = marker_shape.x;
  float corner = radius * marker_shape.y;
  vec2 q = abs(p) - (radius - corner);
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - corner;
}

vec4 premultiplied(vec4 colour) { return vec4(colour.rgb * colour.a, colour.a); }

void main() {
  float d = outline_distance(from_centre);
  float outer = clamp(0.5 - d, 0.0, 1.0);
  float inner = clamp(0.5 - d - marker_shape.z, 0.0, 1.0);
  vec4 body = premultiplied(rim_colour) * (outer - inner) + premultiplied(fill_colour) * inner;
  float below = outline_distance(from_centre + vec2(0.0, ui_scale));
  float shadow = marker_shape.w * (1.0 - smoothstep(-ui_scale, 3.5 * ui_scale, below));
  shadow *= 1.0 - inner * (1.0 - step(0.001, fill_colour.a));  // none in the hole of a ring
  fragment = body + vec4(0.0, 0.0, 0.0, shadow) * (1.0 - body.a);
}
