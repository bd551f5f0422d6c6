// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(location = 0) in vec2 position;  // relative to the origin of the mesh
layout(location = 1) in vec2 rest;

uniform vec2 clip_scale;
uniform vec2 clip_offset;

out vec2 rest_position;

void main() {
  rest_position = rest;
  gl_Position = vec4(position * clip_scale + clip_offset, 0.0, 1.0);
}
