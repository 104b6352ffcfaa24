// The element that a pixel of a hemi-cube sees: the side that is turned to it decides. In: both sides' elements. Out: the item.
#version 460
layout(location = 0) flat in uvec2 element_sides;
layout(location = 0) out uint item;

void main() { item = gl_FrontFacing ? element_sides.x : element_sides.y; }
