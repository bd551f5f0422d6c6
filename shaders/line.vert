// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(location = 0) in vec2 position;  // relative to the origin of the mesh

uniform vec2 clip_scale;
uniform vec2 clip_offset;

void main() { gl_Position = vec4(position * clip_scale + clip_offset, 0.0, 1.0); }
