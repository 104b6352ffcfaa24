// The camera's matrices, in double until the last step. In: View (plan/complete.h). Out: matrices and rays.
#include "plan/complete.h"

#include <cmath>

namespace lightbench {

// Perspective with reversed z and the far plane at infinity (Upchurch and Desbrun 2012, "Tightening the Precision of Perspective
// Rendering", sec. 3.2): depth = near / distance. A float keeps that quotient to a relative 2^-24 whatever `near` is, so that a small near
// plane costs no precision: its only lower limit is underflow.
glm::dmat4 perspective(double fov, double aspect, double near) {
    const double f = 1 / std::tan(fov / 2);
    glm::dmat4 clip_from_view(0);
    clip_from_view[0][0] = f / aspect;
    clip_from_view[1][1] = -f; // Vulkan's y points down
    clip_from_view[2][3] = -1;
    clip_from_view[3][2] = near;
    return clip_from_view;
}

double View::pixel_angle() const {
    return 2 * std::atan(std::tan(fov / 2) / size.y);
}

glm::vec3 View::eye_in_frame(const Frame& frame) const {
    return glm::vec3(frame.from_world(eye));
}

// The eye is the pivot: world coordinates, which may be large (SC-2), meet only in the difference eye - origin. All of clip space is in
// frame units, that is multiplied by frame.scale, which the division by w takes out again: a scene scaled by 2^k keeps its bits (SC-1).
glm::mat4 View::clip_from_frame(const Frame& frame, glm::dvec2 shift_pixels) const {
    const glm::dmat3 rotation(view_from_world);
    glm::dmat4 view_from_frame(rotation);
    view_from_frame[3] = glm::dvec4(-(rotation * frame.from_world(eye)), 1);
    glm::dmat4 clip_from_scaled_view = clip_from_view;
    clip_from_scaled_view[3][2] *= frame.scale;
    // x' = x + (2 sx / width) w moves the picture by sx pixels; w = -z of the view.
    clip_from_scaled_view[2][0] -= 2 * shift_pixels.x / size.x;
    clip_from_scaled_view[2][1] -= 2 * shift_pixels.y / size.y;
    return glm::mat4(clip_from_scaled_view * view_from_frame);
}

glm::dvec3 View::direction_through(glm::dvec2 pixel) const {
    const glm::dvec2 ndc = 2.0 * pixel / glm::dvec2(size) - 1.0;
    const glm::dvec3 in_view(ndc.x / clip_from_view[0][0], ndc.y / clip_from_view[1][1], -1);
    return glm::normalize(glm::transpose(glm::dmat3(view_from_world)) * in_view);
}

} // namespace lightbench
