// Shapes that oracles of several tests measure by: how far a point, or a whole ray, is from being right about them.
#pragma once

#include "measure/numerics/lines.h"

namespace lightbench::kernels {

// (r0, r1): cylinders, cones, those in between.
Inputs cone_radii();

// Of a point from the torus of radii 1 and m, negative inside.
double torus_distance(const Vec3& p, double m);

// How far the torus would have to be moved for this t to be right. start: the distance at `after`.
double off_torus(const Line& line, double m, double after, double start, double t);

} // namespace lightbench::kernels
