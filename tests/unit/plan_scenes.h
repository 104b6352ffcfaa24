// Small scenes for the tests of the plan, built by hand: each says only what its test is about.
#pragma once

#include "plan/plan.h"
#include "scene/scene.h"

#include <algorithm>

namespace lightbench::testing {

inline Light light_of(LightType type, Attenuation law = Attenuation::linear, float ip = 1) {
    Light light;
    light.type = type, light.attenuation = law, light.intensity = glm::vec3(ip);
    return light;
}

// One grey sphere without highlight, no light, no ambient light, no camera.
inline Scene bare_sphere() {
    Scene scene;
    scene.name = "bare";
    scene.materials.emplace_back();
    scene.objects.push_back({Sphere{}});
    return scene;
}

inline Scene lit_sphere(LightType type = LightType::directional, Attenuation law = Attenuation::linear) {
    Scene scene = bare_sphere();
    scene.lights.push_back(light_of(type, law));
    return scene;
}

inline Scene with_lights(std::size_t n) {
    Scene scene = bare_sphere();
    scene.lights.assign(n, light_of(LightType::point));
    return scene;
}

inline Plan plan_of(const Scene& scene, const Request& request = {}) {
    return decide(gather_facts(scene), request);
}

// The reason of the line of this name; "(none)" if there is no such line.
inline std::string reason_of(const std::vector<Line>& lines, std::string_view name) {
    const auto at = std::find_if(lines.begin(), lines.end(), [&](const Line& line) { return line.name == name; });
    return at == lines.end() ? "(none)" : at->reason;
}

inline std::vector<std::string> pass_names(const Plan& plan) {
    std::vector<std::string> names;
    for (const Pass& pass : plan.passes) names.push_back(pass.name);
    return names;
}

inline std::size_t bytes_of(const Plan& plan, std::string_view name) {
    const auto at = std::find_if(plan.resources.begin(), plan.resources.end(), [&](const Resource& r) { return r.name == name; });
    return at == plan.resources.end() ? 0 : at->bytes;
}

} // namespace lightbench::testing
