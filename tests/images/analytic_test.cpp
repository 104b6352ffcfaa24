// Planes under lights, where every pixel has a closed form: S1 to S5, S7 to S9 against the formulas in double.
#include "images/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lightbench::testing {
namespace {

using glm::dvec3;

struct Closed {
    const Scene& scene;
    dvec3 eye;

    double factor(const Light& light, dvec3 p) const {
        const double d = glm::length(light.position - p);
        if (light.type == LightType::directional || light.attenuation == Attenuation::none) return 1;
        if (light.attenuation == Attenuation::linear) return 1 / (d + light.d0);
        return 1 / (4 * std::numbers::pi * d * d);
    }

    // The illumination equation as SPEC.md writes it, for a point of the plane y = 0 seen from above.
    dvec3 radiance(dvec3 p) const {
        const Material& m = scene.materials.front();
        const dvec3 n(0, 1, 0), v = glm::normalize(eye - p);
        dvec3 sum = dvec3(m.emission) + dvec3(m.diffuse) * dvec3(scene.environment.ambient);
        for (const Light& light : scene.lights) {
            const dvec3 l = light.type == LightType::directional ? -light.direction : glm::normalize(light.position - p);
            const double nl = glm::dot(n, l);
            if (nl <= 0) continue;
            const dvec3 r = 2 * nl * n - l;
            const dvec3 ip = dvec3(light.intensity) * factor(light, p);
            sum += ip * (dvec3(m.diffuse) * nl + dvec3(m.specular) * std::pow(std::max(0.0, glm::dot(r, v)), double(m.shininess)));
        }
        return sum;
    }

    static dvec3 hit(const View& view, double x, double y) {
        const dvec3 d = view.direction_through({x + 0.5, y + 0.5});
        return view.eye - d * (view.eye.y / d.y);
    }
};

// A rasteriser moves each vertex to the nearest 2^-bits of a pixel, so what a pixel shows belongs to a point up to half of that away along
// x and y, and with it by the most that `value` changes there (SwiftShader has 4 bits, lavapipe 8).
template <class Value> double snapping(double x, double y, Value&& value) {
    const double half = std::ldexp(0.5, -static_cast<int>(test_device().info().subpixel_bits));
    double most = 0;
    for (const double dx : {-half, half})
        for (const double dy : {-half, half}) most = std::max(most, glm::length(value(x + dx, y + dy) - value(x, y)));
    return most;
}

// Every pixel that sees the plane well inside of it. Positions are interpolated in float from vertices 4 m off and then enter through
// distances and cosines: 2e-5 of the brightest pixel.
void expect_closed_form(const Scene& scene, const Rendered& r) {
    const Closed closed{scene, r.view.eye};
    double brightest = 0;
    unsigned seen = 0;
    for (unsigned y = 0; y < r.plan.size.y; ++y)
        for (unsigned x = 0; x < r.plan.size.x; ++x) brightest = std::max(brightest, pixel(*r.output.radiance, x, y).x);
    for (unsigned y = 0; y < r.plan.size.y; ++y)
        for (unsigned x = 0; x < r.plan.size.x; ++x) {
            const dvec3 p = Closed::hit(r.view, x, y);
            if (std::abs(p.x) > 3.9 || std::abs(p.z) > 3.9) continue;
            const dvec3 want = closed.radiance(p), got = pixel(*r.output.radiance, x, y);
            const double snap = snapping(x, y, [&](double u, double v) { return closed.radiance(Closed::hit(r.view, u, v)); });
            ASSERT_LT(glm::length(got - want), 2e-5 * brightest + snap) << x << ' ' << y << ": " << got.x << " for " << want.x;
            ++seen;
        }
    EXPECT_GT(seen, r.plan.size.x * r.plan.size.y / 4);
    EXPECT_GT(brightest, 0);
}

TEST(Analytic, PhongMatchesTheEquationForEveryLaw) {
    for (const Attenuation law : {Attenuation::none, Attenuation::linear, Attenuation::inverse_square}) {
        Scene scene = plane_scene({0, 6, 0.5});
        scene.environment.ambient = {0.1f, 0.2f, 0.3f};
        scene.materials[0].specular = glm::vec3(0.4f), scene.materials[0].shininess = 20;
        scene.lights = {point_light({1, 2, -1}, {3, 2, 1}, law)};
        expect_closed_form(scene, render_scene(scene, radiance_request(Shading::phong)));
    }
}

TEST(Analytic, PhongMatchesTheEquationForMixedLights) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.materials[0].specular = {0.2f, 0.3f, 0.4f}, scene.materials[0].emission = {0.01f, 0.02f, 0.03f};
    Light sun;
    sun.type = LightType::directional, sun.direction = glm::normalize(dvec3(1, -2, 0.5)), sun.intensity = {0.5f, 0.6f, 0.7f};
    scene.lights = {point_light({1, 2, -1}, {3, 2, 1}, Attenuation::linear), sun,
                    point_light({-2, 1, 1}, {1, 5, 1}, Attenuation::inverse_square), point_light({0, 3, 0}, {1, 1, 1}, Attenuation::none)};
    expect_closed_form(scene, render_scene(scene, radiance_request(Shading::phong)));
}

TEST(Analytic, HundredLightsAddUp) {
    Scene scene = plane_scene({0, 6, 0.5});
    for (int i = 0; i < 100; ++i)
        scene.lights.push_back(
            point_light({(i % 10) - 4.5, 1 + 0.01 * i, (i / 10) - 4.5}, glm::vec3(0.1f + 0.01f * float(i)), Attenuation::linear));
    expect_closed_form(scene, render_scene(scene, radiance_request(Shading::phong)));
}

TEST(Analytic, LightsBeyondOnePassAddUp) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.environment.ambient = glm::vec3(0.25f);
    const std::size_t count = kLightsPerPass + 5;
    for (std::size_t i = 0; i < count; ++i)
        scene.lights.push_back(point_light({0, 2 + 1e-5 * double(i), 0}, glm::vec3(1e-4f), Attenuation::none));
    const Rendered r = render_scene(scene, radiance_request(Shading::phong, {16, 12}));
    EXPECT_EQ(r.plan.light_passes, 2u);
    expect_closed_form(scene, r);
    // A driver that had ended a loop early would have left NaN; the plane's vertices are shaded for both sides.
    EXPECT_EQ(render_scene(scene, radiance_request(Shading::gouraud, {16, 12})).output.non_finite, 0u);
}

TEST(Analytic, FlatTakesTheValueAtTheCentreOfThePolygon) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.materials[0].specular = glm::vec3(0.4f);
    scene.lights = {point_light({1, 2, -1}, {3, 2, 1}, Attenuation::linear)};
    const Rendered r = render_scene(scene, radiance_request(Shading::flat));
    const dvec3 want = Closed{scene, r.view.eye}.radiance({0, 0, 0});
    const dvec3 first = pixel(*r.output.radiance, 32, 24);
    EXPECT_LT(glm::length(first - want), 2e-6 * glm::length(want));
    for (unsigned x = 0; x < 64; ++x)
        if (std::abs(Closed::hit(r.view, x, 24).x) < 3.9) {
            EXPECT_EQ(pixel(*r.output.radiance, x, 24), first);
        }
}

// One triangle: the value at a pixel is the barycentric mean of the values at its corners.
TEST(Analytic, GouraudInterpolatesTheCorners) {
    Scene scene = plane_scene({0, 6, 3});
    const std::vector<dvec3> corners{{-4, 0, 4}, {4, 0, 4}, {0, 0, -4}};
    scene.objects[0].shape = Polygon{corners, {}};
    scene.materials[0].specular = glm::vec3(0.4f);
    scene.lights = {point_light({1, 2, -1}, {3, 2, 1}, Attenuation::linear)};
    const Rendered r = render_scene(scene, radiance_request(Shading::gouraud));
    const Closed closed{scene, r.view.eye};
    const dvec3 at[3] = {closed.radiance(corners[0]), closed.radiance(corners[1]), closed.radiance(corners[2])};
    const auto weights = [&](double x, double y) {
        const dvec3 p = Closed::hit(r.view, x, y);
        const double w2 = (4 - p.z) / 8, side = 4 * (1 - w2), w1 = (p.x / side + 1) / 2 * (1 - w2);
        return dvec3(1 - w1 - w2, w1, w2);
    };
    const auto mean = [&](double x, double y) {
        const dvec3 w = weights(x, y);
        return w.x * at[0] + w.y * at[1] + w.z * at[2];
    };
    unsigned seen = 0;
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const dvec3 w = weights(x, y);
            if (std::min({w.x, w.y, w.z}) < 0.02) continue;
            const dvec3 want = mean(x, y), got = pixel(*r.output.radiance, x, y);
            ASSERT_LT(glm::length(got - want), 2e-5 * glm::length(want) + snapping(x, y, mean)) << x << ' ' << y;
            ++seen;
        }
    EXPECT_GT(seen, 300u);
}

TEST(Analytic, NoLightLeaksFromBehind) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.materials[0].specular = glm::vec3(1), scene.materials[0].shininess = 2;
    scene.lights = {point_light({1, -2, -1}, {3, 2, 1}, Attenuation::linear)};
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        const Rendered r = render_scene(scene, radiance_request(shading));
        for (std::size_t i = 0; i < r.output.radiance->rgba.size(); ++i)
            if (i % 4 != 3) {
                ASSERT_EQ(r.output.radiance->rgba[i], 0.0f);
            }
    }
}

TEST(Analytic, BothSidesOfAPlaneAreShadedTowardsTheViewer) {
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Scene above = plane_scene({0, 6, 0.5}), below = plane_scene({0, -6, 0.5});
        above.lights = {point_light({1, 2, -1}, {3, 2, 1})}, below.lights = {point_light({1, -2, -1}, {3, 2, 1})};
        const Rendered a = render_scene(above, radiance_request(shading)), b = render_scene(below, radiance_request(shading));
        EXPECT_GT(pixel(*a.output.radiance, 32, 24).x, 0.1);
        EXPECT_NEAR(pixel(*a.output.radiance, 32, 24).x, pixel(*b.output.radiance, 32, 24).x, 0.05 * pixel(*a.output.radiance, 32, 24).x);
    }
}

TEST(Analytic, ASpotLightsItsConeOnly) {
    Scene scene = plane_scene({0, 6, 0.5});
    Light spot = point_light({0, 2, 0}, glm::vec3(1));
    spot.type = LightType::spot, spot.direction = {0, -1, 0}, spot.angle = 0.5, spot.softness = 0;
    scene.lights = {spot};
    const Rendered r = render_scene(scene, radiance_request(Shading::phong));
    const double edge = 2 * std::tan(0.5);
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const auto radius_at = [&](double u, double v) {
                const dvec3 p = Closed::hit(r.view, u, v);
                return dvec3(std::hypot(p.x, p.z), 0, 0);
            };
            const auto inside_at = [&](double u, double v) { return dvec3(0.7 * 2 / std::hypot(radius_at(u, v).x, 2), 0, 0); };
            const dvec3 got = pixel(*r.output.radiance, x, y);
            const double radius = radius_at(x, y).x;
            if (std::abs(radius - edge) < 0.001 * edge + snapping(x, y, radius_at)) continue;
            ASSERT_NEAR(got.x, radius < edge ? inside_at(x, y).x : 0, radius < edge ? 1e-5 + snapping(x, y, inside_at) : 0)
                << x << ' ' << y;
        }
}

} // namespace
} // namespace lightbench::testing
