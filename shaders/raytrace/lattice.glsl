// The lattice of adaptive sampling (S26): points 2^-levels pixels apart over a band of pixels, of which few are traced. A cell of a level
// has its four corners among them, and is split if its middle was asked for: a middle belongs to one cell only.
#ifndef LIGHTBENCH_RAYTRACE_LATTICE_GLSL
#define LIGHTBENCH_RAYTRACE_LATTICE_GLSL

#include "shared/effects.h"
#include "shared/rays.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { LatticePush push; };

const uint kIdle = 0u, kAskedFor = 1u, kTraced = 2u; // states of a point

// Work groups come in rows, since not every device takes many along x.
uint invocation() { return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

// Steps of the lattice along a cell of this level.
uint cell_side(uint level) { return 1u << (push.levels - level); }
uint point_index(uvec2 p) { return p.y * ((push.size.x << push.levels) + 1u) + p.x; }

#endif
