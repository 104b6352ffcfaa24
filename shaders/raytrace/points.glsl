// The shaded points of a generation of rays as a table. What no effect asks for is not there, and 0.
#ifndef LIGHTBENCH_RAYTRACE_POINTS_GLSL
#define LIGHTBENCH_RAYTRACE_POINTS_GLSL

#include "raytrace/rays.glsl"
#include "shade.glsl"

FETCH_TABLE(points, FETCH_RAYS, 26)

RayPoint read_point(uint i) {
    uint at = kRayPointTexels * i;
    uvec4 a = fetch_points(at), b = fetch_points(at + 1u), c = uvec4(0u), d = uvec4(0u), e = uvec4(0u), f = uvec4(0u);
    if (wants_ray(RAY_SHADOWS)) c = fetch_points(at + 2u), d = fetch_points(at + 3u);
    if (wants(EFFECT_ANY_TEXTURE)) e = fetch_points(at + 4u);
    if (wants(EFFECT_TRANSPARENCY)) f = fetch_points(at + 5u);
    return RayPoint(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), 0.0, uintBitsToFloat(d.xyz), 0.0,
                    uintBitsToFloat(e.xyz), 0.0, uintBitsToFloat(f.xyz), 0.0);
}

#endif
