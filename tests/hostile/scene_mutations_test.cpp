// Files cut off at every byte and files with random damage: the loader ends, and what it accepts keeps Scene's promises.
#include "hostile/scene_child.h"
#include "scene/nff.h"
#include "scene/toml_load.h"

#include <cfloat>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace lightbench::hostile {
namespace {

std::string corpus(const char* name) {
    const std::ifstream in(std::filesystem::path(LIGHTBENCH_SOURCE) / "tests/hostile/corpus" / name, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

bool within(const glm::vec3& v, float low, float high) {
    for (int i = 0; i < 3; ++i)
        if (!(v[i] >= low && v[i] <= high)) return false;
    return true;
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool keeps_promises(const Scene& s, const Material& m) {
    const bool pictures = !m.texture || !m.texture->picture || *m.texture->picture < s.pictures.size();
    return pictures && within(m.diffuse, 0, 1) && within(m.specular, 0, 1) && within(m.transmission, 0, 1) && within(m.opacity, 0, 1) &&
           within(m.emission, 0, FLT_MAX) && within(m.ior, FLT_TRUE_MIN, FLT_MAX) && std::isfinite(m.shininess) && m.shininess >= 0 &&
           m.roughness > 0 && std::isfinite(m.roughness) && (!m.f0 || within(*m.f0, 0, 0.99999994f));
}

bool keeps_promises(const Light& l) {
    return finite(l.position) && std::abs(glm::length(l.direction) - 1) < 1e-12 && within(l.intensity, 0, FLT_MAX) && l.d0 > 0 &&
           l.angle > 0 && l.angle <= 1.5707963267948968 && l.softness >= 0 && l.softness <= 1;
}

struct ShapeJudge {
    bool operator()(const Sphere& s) const { return finite(s.center) && s.radius > 0; }
    bool operator()(const Polygon& p) const { return p.points.size() >= 3 && (p.normals.empty() || p.normals.size() == p.points.size()); }
    bool operator()(const Box& b) const { return glm::all(glm::lessThan(b.min, b.max)); }
    bool operator()(const Cylinder& c) const { return c.base != c.top && c.radius > 0; }
    bool operator()(const Cone& c) const {
        return c.base != c.top && c.base_radius >= 0 && c.top_radius >= 0 && c.base_radius + c.top_radius > 0;
    }
    bool operator()(const Torus& t) const { return t.major > 0 && t.minor > 0 && std::abs(glm::length(t.axis) - 1) < 1e-12; }
    bool operator()(const MeshUse&) const { return false; } // the corpus has none
};

bool keeps_promises(const Scene& s, const Object& o) {
    if (o.material >= s.materials.size() || o.transform >= s.transforms.size() || o.subdivide > 8) return false;
    const double determinant = glm::determinant(glm::dmat3(s.transforms[o.transform]));
    return std::isfinite(determinant) && determinant != 0 && std::visit(ShapeJudge{}, o.shape);
}

bool keeps_promises(const Loaded& loaded) {
    if (loaded.scene.has_value() != loaded.problems.empty()) return false;
    if (!loaded.scene) return true;
    const Scene& s = *loaded.scene;
    bool fine = !s.materials.empty() && within(s.environment.ambient, 0, FLT_MAX) && within(s.environment.background, 0, FLT_MAX);
    for (const Material& m : s.materials) fine &= keeps_promises(s, m);
    for (const Light& l : s.lights) fine &= keeps_promises(l);
    for (const Object& o : s.objects) fine &= keeps_promises(s, o);
    for (const Camera& c : s.cameras) fine &= finite(c.position) && c.position != c.target && c.fov > 0 && c.fov < 3.141592653589793;
    return fine;
}

using Load = Loaded (*)(std::string_view, const std::filesystem::path&, const LoadOptions&);

// In one child: the first text whose scene breaks a promise is its problem; a crash shows as not ended.
void expect_sound(Load load, const std::function<std::optional<std::string>()>& next) {
    const Outcome outcome = load_in_child([&] {
        while (const auto text = next())
            if (!keeps_promises(load(*text, "x", {}))) return Loaded{std::nullopt, {{"broken promise", 0, 0, *text}}, 0};
        return Loaded{Scene{}, {}, 0};
    });
    EXPECT_TRUE(outcome.ended) << "crashed or did not end";
    EXPECT_TRUE(outcome.accepted) << outcome.report;
    EXPECT_LT(outcome.megabytes, kMaxMegabytes);
}

struct Seed {
    Load load;
    std::string text;
};

std::vector<Seed> seeds() {
    return {{load_toml, corpus("room.toml")}, {load_nff_text, corpus("balls.nff")}};
}

TEST(HostileScene, TheCorpusItselfLoads) {
    for (const Seed& seed : seeds()) {
        ASSERT_GT(seed.text.size(), 500u);
        const Loaded loaded = seed.load(seed.text, "x", {});
        for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
        EXPECT_TRUE(keeps_promises(loaded));
    }
}

TEST(HostileScene, CutOffAtEveryByte) {
    for (const Seed& seed : seeds()) {
        std::size_t size = 0;
        expect_sound(seed.load, [&]() -> std::optional<std::string> {
            if (size > seed.text.size()) return std::nullopt;
            return seed.text.substr(0, size++);
        });
    }
}

// One to eight edits: a byte, a token that parsers fear, a piece doubled, a piece cut out.
std::string mutated(std::string text, std::mt19937& random) {
    static constexpr std::string_view kFeared[] = {"nan",
                                                   "-inf",
                                                   "1e39",
                                                   "1e-46",
                                                   "-1",
                                                   "0",
                                                   "4294967296",
                                                   "9223372036854775808",
                                                   "0x1p3",
                                                   "\"",
                                                   "'''",
                                                   "[",
                                                   "]]",
                                                   "{",
                                                   "}",
                                                   "\n",
                                                   "\r\n",
                                                   "#",
                                                   ".",
                                                   "..",
                                                   "=",
                                                   ",",
                                                   "p 99999\n",
                                                   "s ",
                                                   "pp 3\n",
                                                   "f ",
                                                   "v\n",
                                                   "[[object]]\n",
                                                   "shape = \"sphere\"\n",
                                                   "\\u0000",
                                                   "\xff",
                                                   "1e308"};
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % std::max<std::size_t>(n, 1); };
    for (std::size_t edits = 1 + below(8); edits > 0; --edits) {
        const std::size_t at = below(text.size()), length = std::min(below(40), text.size() - at);
        switch (below(5)) {
        case 0: text.insert(at, 1, static_cast<char>(random())); break;
        case 1: text.replace(at, std::min<std::size_t>(length, 6), kFeared[below(std::size(kFeared))]); break;
        case 2: text.insert(below(text.size()), text.substr(at, length)); break;
        case 3: text.erase(at, length); break;
        default: text.insert(at, kFeared[below(std::size(kFeared))]);
        }
    }
    return text;
}

TEST(HostileScene, RandomDamage) {
    constexpr int kRounds = 4000;
    for (const Seed& seed : seeds()) {
        std::mt19937 random(2718281828u);
        int round = 0;
        expect_sound(seed.load, [&]() -> std::optional<std::string> {
            if (round++ == kRounds) return std::nullopt;
            return mutated(seed.text, random);
        });
    }
}

} // namespace
} // namespace lightbench::hostile
