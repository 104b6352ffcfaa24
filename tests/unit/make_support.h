// What the tests of procedural scenes share: a kind made with parameters, its shapes, normals by definition.
#pragma once

#include "scene/make.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace lightbench::make_test {

inline Scene made(std::string_view kind, const MakeArguments& arguments = {}) {
    auto result = make_scene(kind, arguments);
    if (const auto* problems = std::get_if<Problems>(&result)) ADD_FAILURE() << to_string(problems->front());
    return std::holds_alternative<Scene>(result) ? std::get<Scene>(result) : Scene{};
}

template <typename S> std::vector<S> shapes(const Scene& scene) {
    std::vector<S> found;
    for (const Object& o : scene.objects)
        if (const S* s = std::get_if<S>(&o.shape)) found.push_back(*s);
    return found;
}

inline std::array<double, 4> numbers(const Sphere& s) {
    return {s.center.x, s.center.y, s.center.z, s.radius};
}

inline glm::dvec3 newell(const std::vector<glm::dvec3>& p) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a = p[i], b = p[(i + 1) % p.size()];
        sum += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    return sum;
}

inline std::vector<glm::dvec3> face_points(const Mesh& m, std::size_t f) {
    std::vector<glm::dvec3> points;
    for (std::uint32_t c = m.face_starts[f]; c < m.face_starts[f + 1]; ++c) points.emplace_back(m.positions[m.corners[c]]);
    return points;
}

// Vertex normals by definition: the angle-weighted mean of the faces around (Thuermer and Wuethrich 1998), every edge smoothed over.
inline std::vector<glm::dvec3> averaged_normals(const Mesh& m) {
    std::vector<glm::dvec3> sums(m.positions.size(), glm::dvec3(0));
    for (std::size_t f = 0; f < m.face_count(); ++f) {
        const auto p = face_points(m, f);
        const glm::dvec3 n = glm::normalize(newell(p));
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 a = glm::normalize(p[(i + 1) % p.size()] - p[i]), b = glm::normalize(p[(i + p.size() - 1) % p.size()] - p[i]);
            sums[m.corners[m.face_starts[f] + i]] += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * n;
        }
    }
    for (glm::dvec3& n : sums) n = glm::normalize(n);
    return sums;
}

} // namespace lightbench::make_test
