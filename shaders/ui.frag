// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec2 atlas_uv;
noperspective in vec4 vertex_colour;

uniform sampler2D atlas;

out vec4 fragment;

void main() { fragment = vertex_colour * texture(atlas, atlas_uv); }
