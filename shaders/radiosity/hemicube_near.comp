// Which elements are too near a patch for its hemi-cube (HC-3): one invocation an element, one layer of work groups a hemi-cube. In: views,
// receivers. Out: a list of hemi-cube * elements + element, in any order.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "radiosity/hemicube_view.glsl"
#include "radiosity/receivers.glsl"
#include "shared/rays.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { HemicubePush push; };
layout(set = 0, binding = 36, scalar) buffer Counters { RayCounters counters; };
layout(set = 0, binding = 62, scalar) buffer NearCount { uint near_count; };
layout(set = 0, binding = 63, scalar) writeonly buffer NearList { uint near_list[]; };

void main() {
    uint element = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    uint cube = gl_WorkGroupID.z;
    if (gl_LocalInvocationIndex == 0u && element < push.count) atomicAdd(counters.done, min(gl_WorkGroupSize.x, push.count - element));
    if (element >= push.count) return;
    HemicubeView v = read_view(cube);
    Receiver r = read_receiver(element);
    vec3 way = r.center - v.center;
    bool near = dot(way, way) < (push.near_sizes * push.near_sizes * 4.0) * v.radius * v.radius;
    // Some of the patch lies above the element's horizon, and the element is not behind all of the patch.
    bool facing = dot(way, r.normal) < v.radius && dot(way, v.normal) > -v.radius;
    bool other = element - v.first >= v.count && r.covered == 0u && v.patch_number != kNoElement;
    if (near && facing && other) near_list[atomicAdd(near_count, 1u)] = cube * push.count + element;
}
