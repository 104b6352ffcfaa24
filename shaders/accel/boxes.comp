// Boxes about the primitives in the tree, and bounds of their centres. In: tables of primitives in the order of their numbers; of shapes
// their boxes. Out: boxes by number, bounds. An invocation takes every push.lanes-th of them: atomics are dear, and few this way.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"
#include "lib/morton.glsl"

FETCH_TABLE(triangles, FETCH_BUILD, 0)
FETCH_TABLE(spheres, FETCH_BUILD, 2)
FETCH_BOXES(shape_boxes, 4)
layout(set = 0, binding = 6, scalar) writeonly buffer Boxes { uvec4 boxes[]; };
layout(set = 0, binding = 7, scalar) buffer Bounds { BuildBounds bounds; };

// push.pad is larger than what src/accel/boxes.cpp pads by, by more than the two roundings here.
Box box_of_triangle(uint i) {
    vec3 a = uintBitsToFloat(fetch_triangles(3u * i).xyz), b = uintBitsToFloat(fetch_triangles(3u * i + 1u).xyz),
         c = uintBitsToFloat(fetch_triangles(3u * i + 2u).xyz);
    return Box(min(a, min(b, c)) - push.pad, max(a, max(b, c)) + push.pad);
}

Box box_of_sphere(uint i) {
    vec4 sphere = uintBitsToFloat(fetch_spheres(2u * i));
    return Box((sphere.xyz - sphere.w) - push.pad, (sphere.xyz + sphere.w) + push.pad);
}

Box box_of_item(uint item) {
    uint type = type_of_item(item), i = item - first_of_type(type);
    Box box = kEmptyBox;
    if ((kTypes & 1u) != 0u && type == kTypeTriangle) box = box_of_triangle(i);
    if ((kTypes & 2u) != 0u && type == kTypeSphere) box = box_of_sphere(i);
    if ((kTypes & 4u) != 0u && type == kTypeShape) box = shape_boxes_box(i);
    return box;
}

void main() {
    vec3 low = vec3(3.4e38), high = vec3(-3.4e38);
    for (uint i = invocation(); i < push.items; i += push.count) {
        Box box = box_of_item(i);
        boxes[kBoxTexels * i] = uvec4(floatBitsToUint(box.low), 0u);
        boxes[kBoxTexels * i + 1u] = uvec4(floatBitsToUint(box.high), 0u);
        precise vec3 center = box.low + box.high;
        low = min(low, center), high = max(high, center);
    }
    if (invocation() >= push.count) return;
    for (int i = 0; i < 3; ++i) {
        atomicMin(bounds.low[i], ordered_word(low[i]));
        atomicMin(bounds.high[i], ordered_word(-high[i]));
    }
}
