// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

// One instance a marker; the corners of its square come from the vertex number.
layout(location = 0) in vec2 centre;     // relative to the origin of the mesh
layout(location = 1) in vec4 shape;      // radius, roundness, rim width, shadow opacity
layout(location = 2) in vec4 fill;
layout(location = 3) in vec4 rim;

uniform vec2 clip_scale;
uniform vec2 clip_offset;
uniform vec2 viewport;  // pixels
uniform float ui_scale;

noperspective out vec2 from_centre;  // pixels, y up
flat out vec4 marker_shape;
flat out vec4 fill_colour;
flat out vec4 rim_colour;

void main() {
  vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
  float reach = shape.x + 5.0 * ui_scale;
  from_centre = corner * reach;
  marker_shape = shape;
  fill_colour = fill;
  rim_colour = rim;
  // On whole half pixels, so that small markers look alike wherever they are.
  vec2 pixel = floor((centre * clip_scale + clip_offset) * viewport + 0.5) * 0.5;
  gl_Position = vec4((pixel + from_centre) * 2.0 / viewport, 0.0, 1.0);
}
