// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec2 pattern_position;  // in the picture, y up

uniform sampler2D image;  // premultiplied, first row at the top

out vec4 fragment;

void main() { fragment = texture(image, vec2(pattern_position.x, 1.0 - pattern_position.y)); }
