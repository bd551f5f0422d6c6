// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

// A segment becomes a quad that is wider by a pixel than the line, for its soft edge.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 viewport;       // pixels
uniform float half_width;    // pixels
uniform int is_round;        // whether the ends are

noperspective out vec2 along_across;  // pixels from the first end, pixels from the middle
flat out float segment_length;

void corner(vec2 pixel, float along, float across) {
  along_across = vec2(along, across);
  gl_Position = vec4(pixel * 2.0 / viewport, 0.0, 1.0);
  EmitVertex();
}

void main() {
  vec2 a = gl_in[0].gl_Position.xy * 0.5 * viewport;
  vec2 b = gl_in[1].gl_Position.xy * 0.5 * viewport;
  float len = length(b - a);
  if (len == 0.0) return;
  vec2 direction = (b - a) / len;
  vec2 normal = vec2(-direction.y, direction.x);
  float reach = half_width + 1.0;
  float cap = is_round == 1 ? reach : 0.0;
  segment_length = len;
  corner(a - cap * direction - reach * normal, -cap, -reach);
  corner(b + cap * direction - reach * normal, len + cap, -reach);
  corner(a - cap * direction + reach * normal, -cap, reach);
  corner(b + cap * direction + reach * normal, len + cap, reach);
  EndPrimitive();
}
