// Moving a camera about, as hands expect it. In: a camera, how far. Out: the same camera elsewhere. Pure.
#pragma once

#include "scene/tessellate.h"

namespace lightbench::view {

struct Basis {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1}; // unit, right-handed: right x up = -forward
};
Basis basis_of(const Camera& camera);

void orbit(Camera& camera, glm::dvec2 radians);                  // about the target: to the left and upwards
void look_around(Camera& camera, glm::dvec2 radians);            // about the eye: to the left and upwards
void pan(Camera& camera, glm::dvec2 heights);                    // by shares of the picture's height at the target
void dolly(Camera& camera, double steps);                        // towards the target, a tenth of the way each
void fly(Camera& camera, const glm::dvec3& metres);              // right, up, forward
void frame(Camera& camera, const Bounds& bounds, double aspect); // all of it, from the same direction
double radius_of(const Bounds& bounds);                          // metres, > 0

} // namespace lightbench::view
