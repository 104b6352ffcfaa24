#include "plan/complete.h"

#include "plan/laws.h"
#include "scene/limits.h"

#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFittedFov = kPi / 4;

void problem(Problems& problems, std::string_view option, std::string text) {
    problems.push_back({std::string(option), 0, 0, std::move(text)});
}

struct Sphere3 {
    glm::dvec3 center{0};
    double radius = 1; // metres, > 0
};

// About the bounding box; a scene without extent gets a metre, so that a camera has something to look at.
Sphere3 bounding_sphere(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    if (bounds.empty()) return {};
    const double radius = glm::length(bounds.max - bounds.min) / 2;
    return {(bounds.min + bounds.max) / 2.0, radius > 0 ? radius : 1};
}

// From the front and above, a little to the right; far enough for the sphere to touch the narrower pair of the image's edges.
Camera fitted_camera(const Sphere3& sphere, glm::uvec2 size) {
    const double aspect = double(size.x) / size.y;
    const double half = std::atan(std::tan(kFittedFov / 2) * std::min(1.0, aspect));
    const glm::dvec3 from = glm::normalize(glm::dvec3(0.3, 0.45, 1));
    Camera camera;
    camera.name = "fitted";
    camera.fov = kFittedFov;
    camera.target = sphere.center;
    camera.position = sphere.center + from * (sphere.radius / std::sin(half));
    return camera;
}

std::string names_of(const std::vector<Camera>& cameras) {
    std::string names;
    for (const Camera& camera : cameras) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", camera.name);
    return names;
}

// The user's own camera, else the one asked for by name, else the first; none if the name is nobody's.
std::optional<Camera> choose_camera(const Scene& scene, const Request& request, Problems& problems) {
    const std::string& name = request.camera;
    if (request.placed) return request.placed;
    if (name.empty()) return scene.cameras.front();
    for (const Camera& camera : scene.cameras)
        if (camera.name == name) return camera;
    problem(problems, "--camera", fmt::format("no camera is named \"{}\"; the scene has {}", name, names_of(scene.cameras)));
    return std::nullopt;
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_camera(const Camera& camera, const Scene& scene, Problems& problems) {
    const auto say = [&](std::string text) { problem(problems, scene.name, fmt::format("camera \"{}\": {}", camera.name, text)); };
    if (!finite(camera.position) || !finite(camera.target) || !finite(camera.up)) say("position, target and up must be finite");
    if (camera.position == camera.target) say("position and target are the same point; the camera has no direction");
    if (camera.up == glm::dvec3(0)) say("up is 0; it must be a direction");
    if (!(camera.fov > 0 && camera.fov < kPi))
        say(fmt::format("fov is {:g} degrees; it must lie between 0 and 180", camera.fov * 180 / kPi));
    if (!(camera.hither >= 0) || !std::isfinite(camera.hither)) say("hither must be finite, 0 or more");
}

bool check_size(glm::uvec2 size, Problems& problems) {
    const auto fits = [](unsigned side) { return side >= 1 && side <= limits::kMaxImageSide; };
    if (fits(size.x) && fits(size.y)) return true;
    problem(problems, "--size", fmt::format("the image is {}x{}; a side must have 1 to {} pixels", size.x, size.y, limits::kMaxImageSide));
    return false;
}

// What was changed on the user's word; a word that changes nothing is told, too.
void edit(Scene& scene, const SceneEdits& edits, std::vector<Line>& notes) {
    for (std::size_t i = 0; i < kStrippable.size(); ++i)
        if (const std::uint32_t bit = 1u << i; edits.without & bit)
            notes.push_back({fmt::format("without {}", kStrippable[i]), fmt::format("materials changed: {}", keep_without(scene, bit))});
}

// Without sums that could wrap around.
void check_crop(const std::optional<Rect>& crop, glm::uvec2 size, Problems& problems) {
    if (!crop) return;
    const auto inside = [](unsigned offset, unsigned extent, unsigned side) {
        return extent >= 1 && extent <= side && offset <= side - extent;
    };
    if (inside(crop->offset.x, crop->size.x, size.x) && inside(crop->offset.y, crop->size.y, size.y)) return;
    problem(problems, "--crop",
            fmt::format("{}x{} at {},{} is not inside of the {}x{} image", crop->size.x, crop->size.y, crop->offset.x, crop->offset.y,
                        size.x, size.y));
}

// Rotation about an axis by the angle (Rodrigues 1840). Exact for no turn.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

// Frame N of the turntable: 3 N degrees about the up axis through the target, counter-clockwise seen from above.
void turn(Camera& camera, int frame, std::vector<Line>& notes) {
    const int step = ((frame % kTurntableFrames) + kTurntableFrames) % kTurntableFrames;
    if (step == 0) return;
    const double angle = 2 * kPi * step / kTurntableFrames;
    camera.position = camera.target + turned(camera.position - camera.target, glm::normalize(camera.up), angle);
    notes.push_back(
        {"turntable", fmt::format("frame {}: the camera is turned by {} degrees about its target", frame, 360 * step / kTurntableFrames)});
}

// A unit vector across `direction` that stays well defined if `up` is (nearly) parallel to it: then the axis farthest from it replaces up.
// The cross product of two unit vectors errs by at most 4 u = 2^-51 in each component; below 2^-40 it has fewer than 11 good bits.
glm::dvec3 across(const glm::dvec3& direction, const glm::dvec3& up, std::vector<Line>& notes) {
    glm::dvec3 right = glm::cross(direction, glm::normalize(up));
    if (glm::length(right) < 0x1p-40) {
        const glm::dvec3 a = glm::abs(direction);
        const glm::dvec3 axis = a.z <= a.x && a.z <= a.y ? glm::dvec3(0, 0, -1) : a.x <= a.y ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        right = glm::cross(direction, axis);
        notes.push_back(
            {"camera up", fmt::format("parallel to the viewing direction; {:g},{:g},{:g} is used instead", axis.x, axis.y, axis.z)});
    }
    // A short cross product carries its rounding into its direction; one more projection makes it orthogonal to the last bits (CA-1).
    right = glm::normalize(right);
    return glm::normalize(right - direction * glm::dot(direction, right));
}

glm::dmat4 look(const Camera& camera, std::vector<Line>& notes) {
    const glm::dvec3 direction = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = across(direction, camera.up, notes);
    const glm::dvec3 up = glm::cross(right, direction);
    const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(right, up, -direction));
    glm::dmat4 rigid(view_from_world);
    rigid[3] = glm::dvec4(-(view_from_world * camera.position), 1);
    return rigid;
}

View view_of(const Camera& camera, glm::uvec2 size, double scene_radius, std::vector<Line>& notes) {
    View view;
    view.eye = camera.position;
    view.view_from_world = look(camera, notes);
    view.near = camera.hither > 0 ? camera.hither : 1e-6 * scene_radius; // no precision is lost by it: see perspective()
    view.fov = camera.fov;
    view.size = size;
    view.clip_from_view = perspective(camera.fov, double(size.x) / size.y, view.near);
    return view;
}

Light headlight(const View& view) {
    Light light;
    light.type = LightType::directional;
    light.direction = -glm::dvec3(glm::transpose(glm::dmat3(view.view_from_world))[2]);
    light.attenuation = Attenuation::none;
    return light;
}

// The size asked for, else the file's, else the default.
glm::uvec2 image_size(const Scene& scene, const Request& request) {
    return request.size.value_or(scene.film.value_or(glm::uvec2(1280, 720)));
}

} // namespace

CompleteResult complete(Scene& scene, const Request& request) {
    CompleteResult result;
    std::vector<Line> notes = replace_laws(scene, request);
    const glm::uvec2 size = image_size(scene, request);
    if (!check_size(size, result.problems)) return result;
    check_crop(request.crop, size, result.problems);
    edit(scene, request.edits, notes);
    const Sphere3 sphere = bounding_sphere(scene);
    if (scene.cameras.empty() && !request.placed) {
        scene.cameras.push_back(fitted_camera(sphere, size));
        notes.push_back({"camera", "the scene has none: one that sees all of it, 45 degrees, from the front and above"});
    }
    std::optional<Camera> camera = choose_camera(scene, request, result.problems);
    if (camera) check_camera(*camera, scene, result.problems);
    if (!result.problems.empty()) return result;
    if (request.frame) turn(*camera, *request.frame, notes);
    const View view = view_of(*camera, size, sphere.radius, notes);
    const bool dark = scene.lights.empty() && !(request.method == Method::radiosity && gather_facts(scene).emissive_materials > 0);
    if (dark) {
        scene.lights.push_back(headlight(view));
        notes.push_back({"light", "the scene has none: a headlight, directional along the view, Ip 1"});
    }
    for (const std::string& remark : scene.remarks) notes.push_back({"file", remark});
    result.completed = Completed{view, std::move(notes), dark, *camera};
    return result;
}

} // namespace lightbench
