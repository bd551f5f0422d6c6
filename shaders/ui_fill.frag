// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

noperspective in vec4 vertex_colour;

out vec4 fragment;

// Of what has one colour; without the atlas a large area takes a software rasteriser a third.
void main() { fragment = vertex_colour; }
