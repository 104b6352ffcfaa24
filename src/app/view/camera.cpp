#include "app/view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lightbench::view {
namespace {

// Short of the poles, where "up" has no meaning, by half a degree.
constexpr double kSteepest = 89.5 * glm::pi<double>() / 180;

// Rodrigues 1840.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

// `v` turned about the camera's up axis and then against the pole, but not beyond it.
glm::dvec3 swung(const Camera& camera, const glm::dvec3& v, glm::dvec2 radians) {
    const glm::dvec3 pole = glm::normalize(camera.up);
    const glm::dvec3 around = turned(v, pole, radians.x);
    const glm::dvec3 across = glm::cross(around, pole);
    const double length = glm::length(v);
    if (glm::length(across) < 1e-9 * length) return around;
    const double height = std::asin(std::clamp(glm::dot(around, pole) / length, -1.0, 1.0));
    const double wanted = std::clamp(height + radians.y, -kSteepest, kSteepest);
    return turned(around, glm::normalize(across), wanted - height);
}

} // namespace

Basis basis_of(const Camera& camera) {
    Basis b;
    b.forward = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = glm::cross(b.forward, camera.up);
    const glm::dvec3 other = std::abs(b.forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    b.right = glm::normalize(glm::length(right) > 1e-12 * glm::length(camera.up) ? right : glm::cross(b.forward, other));
    b.up = glm::cross(b.right, b.forward);
    return b;
}

void orbit(Camera& camera, glm::dvec2 radians) {
    camera.position = camera.target + swung(camera, camera.position - camera.target, {radians.x, -radians.y});
}

void look_around(Camera& camera, glm::dvec2 radians) {
    camera.target = camera.position + swung(camera, camera.target - camera.position, radians);
}

void pan(Camera& camera, glm::dvec2 heights) {
    const Basis b = basis_of(camera);
    const double height = 2 * std::tan(camera.fov / 2) * glm::length(camera.target - camera.position);
    const glm::dvec3 move = (b.right * heights.x + b.up * heights.y) * height;
    camera.position += move, camera.target += move;
}

void dolly(Camera& camera, double steps) {
    camera.position = camera.target + (camera.position - camera.target) * std::pow(0.9, steps);
}

void fly(Camera& camera, const glm::dvec3& metres) {
    const Basis b = basis_of(camera);
    const glm::dvec3 move = b.right * metres.x + b.up * metres.y + b.forward * metres.z;
    camera.position += move, camera.target += move;
}

double radius_of(const Bounds& bounds) {
    const double radius = bounds.empty() ? 1 : glm::length(bounds.max - bounds.min) / 2;
    return radius > 0 ? radius : 1;
}

void frame(Camera& camera, const Bounds& bounds, double aspect) {
    const Basis b = basis_of(camera);
    const double half = std::atan(std::tan(camera.fov / 2) * std::min(1.0, aspect));
    camera.target = bounds.empty() ? glm::dvec3(0) : (bounds.min + bounds.max) / 2.0;
    camera.position = camera.target - b.forward * (radius_of(bounds) / std::sin(half));
}

} // namespace lightbench::view
