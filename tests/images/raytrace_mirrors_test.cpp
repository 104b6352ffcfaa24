// Corner cubes, facing mirrors, Fresnel's split, panes (S13 to S15, S19, RT rows): each pixel against a closed form.
#include "images/ray_screen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lightbench::testing {
namespace {

using glm::dvec3;

// RT-3: three mirrors send every ray back the way it came: mirrored in the corner.
TEST(RayOptics, ACornerCubeSendsRaysBack) {
    const Screen wall{{5.4, 7.2, 9}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 7};
    const dvec3 eye(3, 4, 5);
    Scene scene = screen_scene(wall, eye, {0.0131, 0.0172, 0.0119}, 12 * kDegree); // no pixel's ray meets an edge
    add(scene, Polygon{{{0, 0, 0}, {0, 30, 0}, {0, 30, 30}, {0, 0, 30}}, {}}, mirror());
    add(scene, Polygon{{{0, 0, 0}, {0, 0, 30}, {30, 0, 30}, {30, 0, 0}}, {}}, mirror());
    add(scene, Polygon{{{0, 0, 0}, {30, 0, 0}, {30, 30, 0}, {0, 30, 0}}, {}}, mirror());
    expect_landing(
        scene, wall, [&](const dvec3& d) { return wall.meet(-eye, -d); }, 2e-5);
}

// RT-2: mirrors of rho = 0.9 that glow face each other: 1 + rho + ... + rho^(depth - 1).
TEST(RayOptics, FacingMirrorsAreAGeometricSeries) {
    Scene scene;
    Camera camera;
    camera.position = {0.1, 0, 0.2}, camera.target = {0.1, 1, 0.2}, camera.up = {0, 0, 1}, camera.fov = 0.002;
    scene.cameras = {camera};
    Material glowing = mirror(0.875f);
    glowing.emission = glm::vec3(1);
    for (const double y : {-1.0, 1.0}) add(scene, Polygon{{{-4, y, 4}, {4, y, 4}, {4, y, -4}, {-4, y, -4}}, {}}, glowing);
    for (const unsigned depth : {1u, 5u, 200u}) {
        Request request = ray_request({8, 6}, depth);
        request.count = true;
        const Rendered r = render_scene(scene, request);
        const double want = (1 - std::pow(0.875, depth)) / (1 - 0.875);
        for (unsigned y = 0; y < 6; ++y)
            for (unsigned x = 0; x < 8; ++x)
                ASSERT_NEAR(pixel(*r.output.radiance, x, y).y, want, want * depth * 4 * 0x1p-24) << "depth " << depth;
        EXPECT_EQ(r.output.rays->reflected, 48u * (depth - 1));
    }
}

// RT-1: a ball whose weights are split by Fresnel, in a furnace of radiance 1: what is missing is what the depth cuts off, R^(depth - 2).
TEST(RayOptics, FresnelsSplitLosesNothing) {
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 4}, camera.fov = 25 * kDegree;
    scene.cameras = {camera};
    scene.environment.background = glm::vec3(1);
    Material m = glass(1.5f);
    m.fresnel = true;
    add(scene, Sphere{{0, 0, 0}, 1}, m);
    for (const unsigned depth : {2u, 3u, 9u}) {
        const Rendered r = render_scene(scene, ray_request({48, 36}, depth));
        for (unsigned y = 0; y < 36; ++y)
            for (unsigned x = 0; x < 48; ++x) {
                const dvec3 d = r.view.direction_through({x + 0.5, y + 0.5});
                const double b = 4 * std::hypot(d.x, d.y);
                if (std::abs(b - 1) < 0.01) continue;
                double want = 1;
                if (b < 1) {
                    const double ci = std::sqrt(1 - b * b), ct = std::sqrt(1 - b * b / 2.25);
                    const double s = (ci - 1.5 * ct) / (ci + 1.5 * ct), p = (1.5 * ci - ct) / (1.5 * ci + ct), share = (s * s + p * p) / 2;
                    want = share + (1 - share) * (1 - std::pow(share, depth - 2));
                }
                ASSERT_NEAR(pixel(*r.output.radiance, x, y).x, want, 1e-5) << x << ' ' << y << " depth " << depth;
            }
    }
}

Scene panes(int n, double bottom) {
    const dvec3 eye(0.5, 6, 1);
    Scene scene = screen_scene(kFloor, eye, {0, 0, 0}, 30 * kDegree);
    scene.environment.ambient = {0.2f, 0.4f, 0.6f};
    Material pane;
    pane.diffuse = {0.5f, 0.5f, 1}, pane.opacity = {0.25f, 0.5f, 0.75f};
    for (int i = 0; i < n; ++i) {
        const double y = bottom + 0.25 * i;
        add(scene, Polygon{{{-20, y, 20}, {20, y, 20}, {20, y, -20}, {-20, y, -20}}, {}}, pane);
    }
    return scene;
}

// S13: I = t If + (1 - t) Ib, pane after pane, unlit by the lights below; straight through, whatever the depth; as the rasteriser has it.
TEST(RayOptics, PanesAreStraightThrough) {
    for (const int n : {0, 5}) {
        Scene scene = panes(n, 2);
        const Rendered r = render_scene(scene, ray_request({47, 35}, 1));
        Request drawn = radiance_request(Shading::phong, {47, 35});
        const ImageF raster = *render_scene(scene, drawn).output.radiance;
        const dvec3 t(0.25, 0.5, 0.75), kd(0.5, 0.5, 1), ambient(scene.environment.ambient);
        for (unsigned y = 0; y < 35; ++y)
            for (unsigned x = 0; x < 47; ++x) {
                const dvec3 d = r.view.direction_through({x + 0.5, y + 0.5});
                dvec3 want = kFloor.radiance(*kFloor.meet(r.view.eye, d)) + ambient;
                for (int i = 0; i < n; ++i) want = t * kd * ambient + (1.0 - t) * want;
                const dvec3 got = pixel(*r.output.radiance, x, y);
                ASSERT_LT(glm::length(got - want), 1e-5 * glm::length(want)) << n << " panes";
                // A rasteriser's pixel belongs to a point up to 1/32 of a pixel off: 1e-3 here.
                ASSERT_LT(glm::length(got - pixel(raster, x, y)), 2e-3) << n << " panes";
            }
    }
}

// S15: panes between the light and the floor take (1 - t)^n of it; with --opaque-shadows all.
TEST(RayOptics, PanesDimShadows) {
    for (const int n : {4})
        for (const bool opaque : {false, true}) {
            Scene scene = panes(n, 0.25); // below the lights at 1.5
            Request request = ray_request({31, 23});
            request.opaque_shadows = opaque;
            const Rendered r = render_scene(scene, request);
            Reference reference{scene};
            reference.clear_shadows = !opaque;
            const Agreement a = compare_to_reference(scene, r, reference);
            EXPECT_EQ(a.differ, 0u) << n << " panes, worst " << a.worst << " at " << a.where.x << ' ' << a.where.y;
            EXPECT_GT(a.sure, 600u);
        }
}

} // namespace
} // namespace lightbench::testing
