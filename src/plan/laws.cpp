#include "plan/laws.h"

#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

// The other model's highlight, equally wide. With N.H = cos d and R.V = cos 2d in the plane of incidence, cos^n 2d is exp(-2 n d^2) and the
// slope distribution exp(-d^2 / m^2) for small d (Cook and Torrance 1982, eq. for the Gaussian and Beckmann models): m = 1 / sqrt(2 n).
void replace_model(Material& material, Model model) {
    if (material.model == model) return;
    material.model = model;
    if (model == Model::cook_torrance)
        material.roughness = static_cast<float>(1 / std::sqrt(2 * std::max(double(material.shininess), 0.5))); // n below 1/2 has no small d
    else
        material.shininess = static_cast<float>(1 / (2 * double(material.roughness) * material.roughness));
}

} // namespace

std::vector<Line> replace_laws(Scene& scene, const Request& request) {
    std::vector<Line> lines;
    if (request.model) {
        for (Material& material : scene.materials) replace_model(material, *request.model);
        lines.push_back({"model", fmt::format("--model {} in the place of the materials' own; a highlight keeps its width",
                                              *request.model == Model::phong ? "phong" : "cook-torrance")});
    }
    if (request.attenuation) {
        static constexpr const char* kNames[] = {"none", "linear", "inverse-square"};
        for (Light& light : scene.lights) light.attenuation = *request.attenuation;
        lines.push_back({"attenuation", fmt::format("--attenuation {} in the place of the lights' own",
                                                    kNames[static_cast<std::size_t>(*request.attenuation)])});
    }
    return lines;
}

} // namespace lightbench
