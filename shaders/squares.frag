// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

uniform vec2 corner;  // of a light square, framebuffer pixels
uniform float side;   // of a square
uniform vec4 light;
uniform vec4 dark;

out vec4 colour;

void main() {
  vec2 square = floor((gl_FragCoord.xy - corner) / side);
  colour = mod(square.x + square.y, 2.0) < 0.5 ? light : dark;
}
