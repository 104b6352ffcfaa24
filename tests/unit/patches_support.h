// Checks of elements and patches by what they are, not by how they were cut.
#pragma once

#include "make_support.h"
#include "radiosity/patches.h"
#include "tess_support.h"

#include <numeric>

namespace lightbench::patches_test {

inline Polygon polygon(std::vector<glm::dvec3> points) {
    return {std::move(points), {}};
}

inline double longest_edge(const PatchMesh& m) {
    double longest = 0;
    for (const Element& e : m.elements)
        for (std::size_t i = 0; i < e.size(); ++i)
            longest = std::max(longest, glm::distance(m.points[e.corners[i]], m.points[e.corners[(i + 1) % e.size()]]));
    return longest / m.frame.scale;
}

inline double worst_aspect(const PatchMesh& m) {
    double worst = 0;
    for (const Element& e : m.elements) {
        double longest = 0;
        for (std::size_t i = 0; i < e.size(); ++i)
            longest = std::max(longest, glm::distance(m.points[e.corners[i]], m.points[e.corners[(i + 1) % e.size()]]));
        worst = std::max(worst, longest * longest / e.area); // of a rectangle, exactly
    }
    return worst;
}

// Square metres.
inline double area(const PatchMesh& m) {
    double sum = 0;
    for (const Element& e : m.elements) sum += e.area;
    return sum / (m.frame.scale * m.frame.scale);
}

// Corners that lie on an element's edge, not at its ends; exact, for meshes whose points are multiples of a power of two.
inline std::size_t hanging_corners(const PatchMesh& m) {
    std::size_t hanging = 0;
    for (const Element& e : m.elements)
        for (std::size_t i = 0; i < e.size(); ++i) {
            const glm::dvec3 a = m.points[e.corners[i]], b = m.points[e.corners[(i + 1) % e.size()]] - a;
            for (const glm::dvec3& p : m.points) {
                const double along = glm::dot(p - a, b);
                if (along > 0 && along < glm::dot(b, b) && glm::cross(p - a, b) == glm::dvec3(0)) ++hanging;
            }
        }
    return hanging;
}

// Edges that only one element has, of those in front.
inline std::size_t open_edges(const PatchMesh& m) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Element& e : m.elements)
        for (std::size_t i = 0; i < e.size(); ++i) ++uses[std::minmax(e.corners[i], e.corners[(i + 1) % e.size()])];
    return static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), [](const auto& u) { return u.second == 1; }));
}

// What holds for any scene.
inline void expect_sound(const PatchMesh& m) {
    std::uint32_t next = 0;
    for (std::uint32_t p = 0; p < m.patches.size(); ++p) {
        const Patch& patch = m.patches[p];
        ASSERT_EQ(patch.first, next);
        ASSERT_GT(patch.count, 0u);
        next += patch.count;
        ASSERT_LE(next, m.elements.size());
        double sum = 0;
        for (std::uint32_t i = patch.first; i < next; ++i) {
            const Element& e = m.elements[i];
            EXPECT_EQ(e.patch, p);
            EXPECT_EQ(e.surface, m.elements[patch.first].surface);
            EXPECT_EQ(e.group, m.elements[patch.first].group);
            sum += e.area;
            for (std::size_t k = 0; k < e.size(); ++k) EXPECT_LE(glm::distance(m.points[e.corners[k]], patch.center), patch.radius);
        }
        EXPECT_NEAR(patch.area / sum, 1, 1e-13);
        EXPECT_NEAR(glm::length(patch.normal), 1, 1e-14);
    }
    EXPECT_EQ(next, m.elements.size());
    for (std::uint32_t i = 0; i < m.elements.size(); ++i) {
        const Element& e = m.elements[i];
        ASSERT_LT(e.surface, m.surfaces.size());
        EXPECT_GT(e.area, 0);
        EXPECT_NEAR(glm::length(e.normal), 1, 1e-14);
        for (std::size_t k = 0; k < e.size(); ++k) ASSERT_LT(e.corners[k], m.points.size());
        if (e.behind == kNoElement) continue;
        const Element& other = m.elements.at(e.behind);
        EXPECT_EQ(other.behind, i);
        EXPECT_EQ(other.normal, -e.normal);
        EXPECT_EQ(other.center, e.center);
        EXPECT_NE(other.group, e.group);
        EXPECT_TRUE(std::equal(e.corners.begin(), e.corners.begin() + std::ptrdiff_t(e.size()),
                               std::make_reverse_iterator(other.corners.begin() + std::ptrdiff_t(e.size()))));
    }
}

inline std::size_t count_groups(const PatchMesh& m) {
    std::set<std::uint32_t> groups;
    for (const Element& e : m.elements) groups.insert(e.group);
    return groups.size();
}

} // namespace lightbench::patches_test
