// Cuts a planar polygon into triangles: convex ones as fans, others ear by ear. In: its points and its normal. Out: triples of corners.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightbench {

using CornerTriple = std::array<std::uint32_t, 3>;

// Drops the axis along which the normal is longest: what is left keeps its coordinates as they are, counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> loop, const glm::dvec3& normal);

// Twice the signed area of a triangle. The differences of float32 coordinates of like size, and their products, are exact in double, so the
// sign is exact for meshes; for others it errs only where the area is within 4 u of the products, which is no area.
double twice_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// Is every corner a true left turn, and the loop simple? Corners on a straight edge make it false: a fan could leave a gap there.
bool strictly_convex(std::span<const glm::dvec2> loop);

// Appends the triangles of a simple loop (no point twice in a row); every corner, those on straight edges too, is a corner of a triangle,
// so neighbours along an edge meet without gaps. The signed areas add up to the loop's, even where it crosses itself. The first corner of
// the triangles of a convex loop is its corner 0.
void triangulate(std::span<const glm::dvec2> loop, std::vector<CornerTriple>& triangles);

} // namespace lightbench
