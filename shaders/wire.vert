// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

// The corners of triangles, three by three. Edge 0, 1, 2 of a triangle lies opposite its corner.
layout(location = 0) in vec2 position;  // relative to the origin of the mesh
layout(location = 1) in float height;   // of this corner over the edge opposite
layout(location = 2) in vec3 lengths;   // of the edges; negative: not drawn

uniform vec2 clip_scale;
uniform vec2 clip_offset;
uniform vec2 viewport;       // pixels
uniform float fade_length;   // pixels; shorter edges fade, 0: none do

// Nothing is farther away than the rest, which saves a division a pixel.
noperspective out vec3 distances;  // pixels to the lines of the edges
flat out vec3 fades;

void main() {
  float pixels = 0.5 * clip_scale.y * viewport.y;  // in a unit of the mesh
  bvec3 is_opposite = equal(ivec3(0, 1, 2), ivec3(gl_VertexID % 3));
  distances = vec3(is_opposite) * height * pixels;
  vec3 faded = fade_length > 0.0 ? clamp(lengths * pixels / fade_length, 0.15, 1.0) : vec3(1.0);
  fades = faded * step(0.0, lengths);
  gl_Position = vec4(position * clip_scale + clip_offset, 0.0, 1.0);
}
