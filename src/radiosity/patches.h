// The surfaces of a scene as elements, which receive light, grouped into patches, which send it (Cohen, Greenberg, Immel and Brock 1986,
// "An Efficient Radiosity Approach for Realistic Image Synthesis"). In: a tessellation, sizes. Out: PatchMesh. Pure, no Vulkan.
#pragma once

#include "scene/tessellate.h"
#include "shared/radiosity.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lightbench {

// Edges longer than these are cut. 0: chosen, so that there are about `elements` of them, and 16 elements a patch.
struct PatchRequest {
    double element = 0, patch = 0; // metres; a patch is no smaller than its elements
    std::size_t elements = 8000;
};

constexpr std::uint32_t kNoCorner = 0xffffffffu;
using gpu_layout::kNoElement;

// A quadrilateral or a triangle (corners[3] is kNoCorner), counter-clockwise seen from the side that it receives light on.
struct Element {
    std::array<std::uint32_t, 4> corners{kNoCorner, kNoCorner, kNoCorner, kNoCorner}; // index into PatchMesh::points
    std::uint32_t patch = 0;
    std::uint32_t surface = 0;         // index into PatchMesh::surfaces
    std::uint32_t group = 0;           // smoothing group: no value is averaged across two of them (creases, surfaces, sides)
    std::uint32_t behind = kNoElement; // the element on the other side, where a surface has two
    glm::dvec3 center{0};              // frame; of area
    glm::dvec3 normal{0};              // unit
    double area = 0;                   // frame units squared, > 0
    bool covered = false;              // lies on another surface: it neither sends nor receives, and no vertex takes part of it
    std::size_t size() const { return corners[3] == kNoCorner ? 3 : 4; }
};

// A run of elements that light is sent from together; all of one surface and one group.
struct Patch {
    std::uint32_t first = 0, count = 0; // into PatchMesh::elements
    glm::dvec3 center{0};               // frame; on the surface where the patch is flat
    glm::dvec3 normal{0};               // unit, the mean of its elements
    double area = 0;
    double radius = 0; // frame, of a sphere about the centre that holds it
};

struct PatchMesh {
    Frame frame;
    std::vector<glm::dvec3> points; // frame; one for all elements that meet there, whatever surface they are of
    std::vector<Element> elements;  // patch after patch
    std::vector<Patch> patches;
    std::vector<Surface> surfaces;
    double element_size = 0, patch_size = 0; // metres, that were asked for or chosen
    std::size_t dropped = 0;                 // faces without area
};

// Quadrilaterals (two triangles that make a rectangle are one) that share no edge that is to be cut with another kind of face become grids,
// whose lines go on from one to the next; everything else is cut into triangles by bisection of longest edges (Rivara 1984, "Algorithms for
// refining triangular grids suitable for adaptive and multigrid techniques"). No corner lies on an edge of another element, across objects
// too where they share whole edges. The aspect of an element of a grid is at most 2, unless its face is narrower than 1/32 of an element.
// A surface that is seen from both sides (two_sided; as the rasteriser does) has elements on both; backs come after all fronts.
// Patches are blocks of a grid, triangles that come from one, and neighbours of these that are small.
// Throws std::length_error if there would be more than `limits::kMaxElements`.
PatchMesh make_patches(const Scene& scene, const PatchRequest& request);

// Every element becomes a patch of its own, as the full matrix wants it.
void make_elements_patches(PatchMesh& mesh);

} // namespace lightbench
