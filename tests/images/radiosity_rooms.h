// Rooms that exist only as areas and form factors, so that solvers can be held against closed forms and a direct solution.
#pragma once

#include "images/gpu_fixture.h"
#include "radiosity/matrix.h"
#include "render/radiosity/solver.h"

#include <random>

namespace lightbench {

struct Room {
    PatchMesh mesh;
    std::vector<double> areas;                    // of elements
    std::vector<std::vector<std::uint32_t>> rows; // of a patch to all elements
    std::vector<glm::vec3> emission, reflectance;

    std::size_t size() const { return areas.size(); }
    // What progressive refinement converges to, from these very rows, brought down to 1 where they sum to more.
    std::vector<glm::dvec3> direct_solution() const;
};

// Areas, and runs of `of_patch` elements as patches.
Room make_room(const std::vector<double>& areas, std::size_t of_patch);
// Entries in units of 1 / kHemicubeOne; sums to `sum` exactly.
std::vector<std::uint32_t> to_units(const std::vector<double>& row, double sum);

// Closed and reciprocal, from random exchanges; sizes differ by 20. Some elements shine, no two reflect alike.
Room random_room(std::size_t elements, std::size_t of_patch, float most_reflectance, unsigned seed);
// A sphere, from within: every patch sees all alike, itself included. Every row is the same, to whomever it belongs.
Room sphere_room(std::size_t elements, glm::vec3 emission, glm::vec3 reflectance);
// Two spheres with one centre, the inner one first.
Room two_spheres(double inner_area, double outer_area);

// One batch: what is chosen, is looked up in the room. Returns how many shot.
unsigned shoot_batch(gpu::Device& device, ProgressiveSolver& solver, const Room& room, unsigned batch, unsigned most = ~0u);
// Until the unshot fraction is below the bound; fails the test after `most` batches. Returns the number of shots.
unsigned shoot_until(gpu::Device& device, ProgressiveSolver& solver, const Room& room, unsigned batch, double fraction,
                     unsigned most = 20'000);

// All rows, of one element each.
gpu::Buffer full_matrix(gpu::Device& device, const Room& room);

} // namespace lightbench
