// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(location = 0) in vec2 position;  // relative to the origin of the mesh
layout(location = 1) in vec2 rest;

uniform vec2 clip_scale;
uniform vec2 clip_offset;
uniform vec2 pattern_origin;  // in the rest plane
uniform vec2 pattern_size;    // of one period

// Nothing is farther away than the rest, which saves a division a pixel.
noperspective out vec2 pattern_position;  // periods from the origin

void main() {
  pattern_position = (rest - pattern_origin) / pattern_size;
  gl_Position = vec4(position * clip_scale + clip_offset, 0.0, 1.0);
}
