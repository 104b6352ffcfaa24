// S2 to S6 as SPEC.md writes them, in double.
#include "render/probe_terms.h"

#include "scene/distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lightbench {
namespace {

double attenuation_of(const Light& light, double d) {
    if (light.type == LightType::directional || light.attenuation == Attenuation::none) return 1;
    if (light.attenuation == Attenuation::linear) return 1 / (d + light.d0);
    return 1 / (4 * std::numbers::pi * d * d);
}

// The cubic edge of lib/spot.glsl; its cones as render/gpu_scene.cpp hands them over.
double spot_of(const Light& light, const glm::dvec3& l) {
    if (light.type != LightType::spot) return 1;
    const double outer = std::cos(light.angle), inner = std::cos(light.angle * (1 - light.softness)), c = -glm::dot(light.direction, l);
    if (c >= inner) return 1;
    if (c <= outer) return 0;
    const double t = (c - outer) / (inner - outer);
    return t * t * (3 - 2 * t);
}

// D G F / (N.V), S6; times ks Ip it is the term.
glm::dvec3 cook_torrance(const Material& m, double nl, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    const double nv = glm::dot(n, v);
    if (nl <= 0 || nv <= 0) return glm::dvec3(0);
    const glm::dvec3 h = glm::normalize(l + v);
    const double nh = glm::dot(n, h), vh = glm::dot(v, h), slope = std::max(double(m.roughness), kLeastRoughness);
    const double alpha = std::acos(std::min(nh, 1.0)), tangent = std::tan(alpha);
    const double shape = m.distribution == Distribution::gaussian ? std::exp(-alpha * alpha / (slope * slope))
                                                                  : std::exp(-tangent * tangent / (slope * slope)) / std::pow(nh, 4);
    const double d = lobe_factor(m.distribution, slope) * shape, g = std::min({1.0, 2 * nh * nv / vh, 2 * nh * nl / vh});
    return d * g / nv * probe_fresnel(vh, glm::dvec3(m.f0 ? ior_of_f0(*m.f0) : m.ior));
}

} // namespace

// Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", sec. 3.
glm::dvec3 probe_fresnel(double c, const glm::dvec3& eta) {
    glm::dvec3 out(1);
    for (int i = 0; i < 3; ++i) {
        const double k = eta[i] * eta[i] + c * c - 1;
        if (k <= 0) continue;
        const double g = std::sqrt(k), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
        out[i] = 0.5 * a * a * (1 + b * b);
    }
    return out;
}

ProbedLight probe_light(const Light& light, const Material& material, const ProbedHit& hit) {
    ProbedLight out;
    out.type = light.type, out.intensity = light.intensity;
    const bool far = light.type == LightType::directional;
    const glm::dvec3 way = far ? -light.direction : light.position - hit.position;
    const double d = glm::length(way);
    if (!far) out.distance = d;
    if (d == 0) return out; // a light at the point itself (LI-5)
    out.l = way / d, out.nl = glm::dot(hit.normal, out.l);
    out.r = 2 * out.nl * hit.normal - out.l, out.rv = glm::dot(out.r, hit.viewer);
    out.attenuation = attenuation_of(light, d), out.spot = spot_of(light, out.l);
    if (out.nl <= 0) return out;
    const glm::dvec3 arriving = out.intensity * (out.attenuation * out.spot);
    out.diffuse = hit.kd * arriving * out.nl;
    const glm::dvec3 lobe = material.model == Model::phong ? glm::dvec3(out.rv > 0 ? std::pow(out.rv, double(material.shininess)) : 0)
                                                           : cook_torrance(material, out.nl, hit.normal, out.l, hit.viewer);
    out.specular = glm::dvec3(material.specular) * arriving * lobe;
    return out;
}

} // namespace lightbench
