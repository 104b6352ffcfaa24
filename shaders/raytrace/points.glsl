// The shaded points of a generation of rays as a table.
#ifndef LIGHTBENCH_RAYTRACE_POINTS_GLSL
#define LIGHTBENCH_RAYTRACE_POINTS_GLSL

#include "raytrace/rays.glsl"

FETCH_TABLE(points, FETCH_RAYS, 26)

// Where nothing was hit the surface is kNothing.
uint surface_of_point(uint i) { return fetch_points(kRayPointTexels * i).w; }

RayPoint read_point(uint i) {
    uint at = kRayPointTexels * i;
    uvec4 a = fetch_points(at), b = fetch_points(at + 1u), c = fetch_points(at + 2u), d = fetch_points(at + 3u), e = fetch_points(at + 4u),
          f = fetch_points(at + 5u);
    return RayPoint(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), 0.0, uintBitsToFloat(d.xyz), 0.0,
                    uintBitsToFloat(e.xyz), 0.0, uintBitsToFloat(f.xyz), 0.0);
}

#endif
