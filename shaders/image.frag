// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in vec2 rest_position;

uniform vec2 box_min;  // of the picture in the rest plane
uniform vec2 box_size;
uniform sampler2D image;  // premultiplied, first row at the top

out vec4 fragment;

void main() {
  vec2 uv = (rest_position - box_min) / box_size;
  fragment = texture(image, vec2(uv.x, 1.0 - uv.y));
}
