// Our ray tracer beside Embree 3, interleaved, two threads each: millions of rays a second for eye rays, their shadow rays, and one diffuse
// bounce, through a mesh and through spheres. Both are given the same primitives and rays; that they meet the same things is checked.
// Run: embree_bench [REPETITIONS]. Debian: libembree-dev, and glmark2-data for the mesh.
#include "embree_side.h"
#include "our_side.h"
#include "scene/load.h"
#include "scene/make.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace lightbench {
namespace {

constexpr unsigned kSide = 1024; // pixels
constexpr const char* kBunny = "/usr/share/glmark2/models/bunny.obj";
constexpr float kLift = 1e-4f; // frame units, from the surface: far above what either side is wrong by

struct Stage {
    std::string name;
    Scene scene;
    glm::dvec3 light{0}; // world
};

// The mesh fills the height of the image.
std::optional<Stage> bunny() {
    LoadOptions options;
    options.allow_outside = true;
    auto loaded = std::filesystem::exists(kBunny) ? load_scene(kBunny, options) : Loaded{};
    if (!loaded.scene) return std::nullopt;
    const Bounds bounds = bounds_of(*loaded.scene);
    const glm::dvec3 middle = 0.5 * (bounds.min + bounds.max);
    const double height = bounds.max.y - bounds.min.y;
    Camera camera;
    camera.target = middle, camera.position = middle + glm::dvec3(0, 0, 1.35 * height);
    loaded.scene->cameras = {camera};
    return Stage{"bunny", std::move(*loaded.scene), middle + height * glm::dvec3(2, 3, 3)};
}

Stage spheres() {
    Scene scene = std::get<Scene>(make_scene("sphereflake", {{"depth", "4"}}));
    const glm::dvec3 light = scene.lights.at(0).position;
    return {"sphereflake", std::move(scene), light};
}

// Blocks of 4 x 2 pixels, one packet each, as raytrace/tile.glsl orders them.
std::vector<BenchRay> eye_rays(const OurScene& ours) {
    std::vector<BenchRay> rays;
    const glm::vec3 eye = ours.view().eye_in_frame(ours.geometry().frame);
    for (unsigned y = 0; y < kSide; y += 2)
        for (unsigned x = 0; x < kSide; x += 4)
            for (unsigned i = 0; i < 8; ++i) {
                const glm::dvec2 pixel(x + (i & 3) + 0.5, y + (i >> 2) + 0.5);
                rays.push_back({eye, glm::vec3(ours.view().direction_through(pixel)), kMiss, {}});
            }
    return rays;
}

// Jarzynski, Olano 2020, "Hash Functions for GPU Rendering": pcg, as a fraction of 1.
float random_of(std::uint32_t key) {
    const std::uint32_t state = key * 747796405u + 2891336453u, word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return static_cast<float>(((word >> 22u) ^ word) >> 8u) * 0x1p-24f;
}

// By the cosine about n.
glm::vec3 diffuse_direction(const glm::vec3& n, std::uint32_t key) {
    const float turn = 6.2831853f * random_of(2 * key), s2 = random_of(2 * key + 1), s = std::sqrt(s2);
    const glm::vec3 t = glm::normalize(glm::cross(n, std::abs(n.x) > 0.5f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    return glm::normalize(s * std::cos(turn) * t + s * std::sin(turn) * glm::cross(n, t) + std::sqrt(1 - s2) * n);
}

struct Sent {
    std::vector<BenchRay> shadow, bounced;
};

// From every hit: towards the light where the surface faces it, and once onwards.
Sent sent_from(const std::vector<BenchRay>& rays, const Distances& distances, const std::vector<glm::vec3>& normals,
               const glm::vec3& light) {
    Sent sent;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (distances[i] == kMiss) continue;
        glm::vec3 n = glm::normalize(normals[i]);
        if (glm::dot(n, rays[i].direction) > 0) n = -n;
        const glm::vec3 p = rays[i].origin + distances[i] * rays[i].direction + kLift * n, way = light - p;
        if (glm::dot(n, way) > 0) sent.shadow.push_back({p, glm::normalize(way), glm::length(way), n});
        sent.bounced.push_back({p, diffuse_direction(n, static_cast<std::uint32_t>(i)), kMiss, n});
    }
    return sent;
}

// Rays for which one side meets something else than the other.
std::size_t differing(const Distances& a, const Distances& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] && !(std::abs(a[i] - b[i]) < kLift);
    return count;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void compare(const char* name, OurScene& ours, const EmbreeScene& embree, const std::vector<BenchRay>& rays, Travel travel,
             int repetitions) {
    Distances a, b;
    ours.trace(rays, travel, a); // the driver compiles
    embree.trace(rays, travel, b);
    const std::size_t different = differing(a, b);
    const double million = static_cast<double>(rays.size()) / 1e6;
    std::vector<double> our_rate, embree_rate, ratio;
    for (int i = 0; i < repetitions; ++i) {
        our_rate.push_back(million / (ours.trace(rays, travel, a) / 1e3));
        embree_rate.push_back(million / (embree.trace(rays, travel, b) / 1e3));
        ratio.push_back(our_rate.back() / embree_rate.back());
    }
    fmt::print("  {:<10}{:>9} rays {:>8.2f} {:>8.2f}   {:.3f} ({:.3f} to {:.3f}){:>8} differ\n", name, rays.size(), median(our_rate),
               median(embree_rate), median(ratio), *std::ranges::min_element(ratio), *std::ranges::max_element(ratio), different);
}

void run(gpu::Device& device, Stage stage, int repetitions) {
    OurScene ours(device, std::move(stage.scene), stage.light, glm::uvec2(kSide));
    const RayPrimitives primitives = ours.primitives();
    const EmbreeScene embree(primitives);
    fmt::print("{}: {} triangles, {} spheres; built in {:.0f} ms, Embree {:.0f} ms\n", stage.name, primitives.triangles.size(),
               primitives.spheres.size(), ours.accel().milliseconds, embree.build_milliseconds());
    const auto eye = eye_rays(ours);
    Distances distances;
    std::vector<glm::vec3> normals;
    embree.trace(eye, Travel::together, distances, &normals);
    const Sent sent = sent_from(eye, distances, normals, glm::vec3(ours.geometry().frame.from_world(stage.light)));
    compare("eye", ours, embree, eye, Travel::together, repetitions);
    compare("shadow", ours, embree, sent.shadow, Travel::shadow, repetitions);
    compare("bounced", ours, embree, sent.bounced, Travel::alone, repetitions);
}

void run_all(int repetitions) {
    setenv("LP_NUM_THREADS", std::to_string(kThreads).c_str(), 0); // of lavapipe
    gpu::Device device = gpu::Device::open();
    fmt::print("{}; {} threads; medians of {}\n{:<26}{:>9} {:>8}   {}\n", device.info().version, kThreads, repetitions, "Mrays/s", "ours",
               "Embree", "ratio");
    if (auto stage = bunny())
        run(device, std::move(*stage), repetitions);
    else
        fmt::print("no mesh: {} is not there (Debian: glmark2-data)\n", kBunny);
    run(device, spheres(), repetitions);
}

} // namespace
} // namespace lightbench

int main(int count, char** arguments) try {
    const int repetitions = count > 1 ? std::atoi(arguments[1]) : 9;
    lightbench::run_all(std::max(repetitions, 1));
} catch (const std::exception& e) {
    fmt::print(stderr, "embree_bench: {}\n", e.what());
    return 3;
}
