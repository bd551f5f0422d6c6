// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(location = 0) in vec2 position;  // display coordinates, y down
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;

uniform vec2 display_origin;
uniform vec2 display_size;

// Nothing is farther away than the rest, which saves a division a pixel.
noperspective out vec2 atlas_uv;
noperspective out vec4 vertex_colour;

void main() {
  vec2 unit = (position - display_origin) / display_size;
  atlas_uv = uv;
  vertex_colour = colour;
  gl_Position = vec4(unit.x * 2.0 - 1.0, 1.0 - unit.y * 2.0, 0.0, 1.0);
}
