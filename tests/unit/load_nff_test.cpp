// Haines' NFF: what each statement becomes, what is refused and where, and the files that the world has.
#include "scene/nff.h"
#include "unit/load_fixtures.h"

#include <cmath>
#include <ctime>
#include <gmock/gmock.h>
#include <numbers>

namespace lightbench {
namespace {

using namespace testing_files;
using testing::ElementsAre;
using testing::HasSubstr;

Loaded load(std::string_view text) {
    return load_nff_text(text, "x.nff", {});
}
Scene scene_from(std::string_view text) {
    return scene_of(load(text));
}

std::vector<std::string> problems_of(std::string_view text) {
    const Loaded loaded = load(text);
    EXPECT_EQ(loaded.scene.has_value(), loaded.problems.empty()) << text;
    std::vector<std::string> lines;
    for (const Problem& problem : loaded.problems) lines.push_back(to_string(problem));
    return lines;
}

constexpr const char* kView = "v\nfrom 2.1 1.3 1.7\nat 0 0 0.5\nup 0 0 1\nangle 45\nhither 0\nresolution 512 256\n";

TEST(LoadNff, View) {
    const Scene s = scene_from(kView);
    ASSERT_EQ(s.cameras.size(), 1u);
    const Camera& c = s.cameras[0];
    EXPECT_EQ(c.position, glm::dvec3(2.1, 1.3, 1.7));
    EXPECT_EQ(c.target, glm::dvec3(0, 0, 0.5));
    EXPECT_EQ(c.up, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(c.fov, std::numbers::pi / 4);
    EXPECT_EQ(c.hither, 0);
    EXPECT_EQ(s.film, glm::uvec2(512, 256));
    EXPECT_EQ(s.environment.background, glm::vec3(0));
    EXPECT_EQ(s.environment.ambient, glm::vec3(0));
    EXPECT_EQ(s.name, "x.nff");
}

TEST(LoadNff, BackgroundAndLights) {
    const Scene s = scene_from("b 0.078 0.361 0.753\nl 4 3 2\nl 1 -4 4 0.5 0.25 1\nl -3 1 5\nl 0 0 0\n");
    EXPECT_EQ(s.environment.background, glm::vec3(0.078f, 0.361f, 0.753f));
    ASSERT_EQ(s.lights.size(), 4u);
    EXPECT_EQ(s.lights[0].position, glm::dvec3(4, 3, 2));
    EXPECT_EQ(s.lights[0].type, LightType::point);
    EXPECT_EQ(s.lights[0].attenuation, Attenuation::none);
    EXPECT_EQ(s.lights[0].intensity, glm::vec3(0.5f)); // 1 / sqrt(4), all lights counted
    EXPECT_EQ(s.lights[1].intensity, glm::vec3(0.5f, 0.25f, 1));
    EXPECT_EQ(s.lights[3].intensity, glm::vec3(0.5f));
}

TEST(LoadNff, Materials) {
    const Scene s = scene_from("f 1 0.5 0.25 0.8 0.5 45.5 0.25 1.5\ns 0 0 0 1\n"
                               "f 1 0.75 0.33 0.8 0 100000 0 0\ns 1 0 0 1\n"
                               "f 1 0.5 0.25 0.8 0.5 45.5 0.25 1.5\ns 2 0 0 1\n");
    ASSERT_EQ(s.materials.size(), 2u); // equal fills are one material
    const Material& m = s.materials[0];
    EXPECT_EQ(m.diffuse, glm::vec3(0.8f, 0.4f, 0.2f));
    EXPECT_EQ(m.specular, glm::vec3(0.5f));
    EXPECT_EQ(m.reflection, glm::vec3(0.5f));
    EXPECT_EQ(m.shininess, 45.5f);
    EXPECT_EQ(m.transmission, glm::vec3(0.25f));
    EXPECT_EQ(m.ior, glm::vec3(1.5f));
    EXPECT_EQ(m.opacity, glm::vec3(1));
    EXPECT_EQ(m.model, Model::phong);
    const Material& dull = s.materials[1]; // shine without Ks and index without T count for nothing
    EXPECT_EQ(dull.specular, glm::vec3(0));
    EXPECT_EQ(dull.shininess, Material{}.shininess);
    EXPECT_EQ(dull.ior, Material{}.ior);
    EXPECT_EQ(s.objects[0].material, 0u);
    EXPECT_EQ(s.objects[1].material, 1u);
    EXPECT_EQ(s.objects[2].material, 0u);
    EXPECT_TRUE(s.remarks.empty());
}

TEST(LoadNff, Shapes) {
    const Scene s = scene_from("f 1 1 1 1 0 0 0 0\ns 1 -2 .5 +2\nc\n0 0 0 2\n0 0 5 2\nc 0 0 0 2 0 0 5 0\n"
                               "p 4\n0 0 0\n1 0 0\n1 1 0\n0.2 0.2 0\npp 3\n0 0 0 0 0 2\n1 0 0 0 0 1\n0 1 0 0 3 4\n");
    ASSERT_EQ(s.objects.size(), 5u);
    EXPECT_EQ(std::get<Sphere>(s.objects[0].shape).center, glm::dvec3(1, -2, 0.5));
    EXPECT_EQ(std::get<Sphere>(s.objects[0].shape).radius, 2);
    const auto& cylinder = std::get<Cylinder>(s.objects[1].shape);
    EXPECT_EQ(cylinder.top, glm::dvec3(0, 0, 5));
    EXPECT_EQ(cylinder.radius, 2);
    EXPECT_FALSE(cylinder.capped);
    const auto& cone = std::get<Cone>(s.objects[2].shape);
    EXPECT_EQ(cone.base_radius, 2);
    EXPECT_EQ(cone.top_radius, 0);
    EXPECT_FALSE(cone.capped);
    EXPECT_EQ(std::get<Polygon>(s.objects[3].shape).points.size(), 4u);
    EXPECT_TRUE(std::get<Polygon>(s.objects[3].shape).normals.empty());
    const auto& patch = std::get<Polygon>(s.objects[4].shape);
    EXPECT_THAT(patch.points, ElementsAre(glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
    EXPECT_THAT(patch.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0.6f, 0.8f)));
}

TEST(LoadNff, CommentsBlanksAndLineEndsOfAnyKind) {
    const Scene s = scene_from(
        "\xef\xbb\xbf# a file\r\n\r\n  f 1 1 1 1 0 0 0 0 # a fill\r\n\ts\t0 0 0 1\r\n#s 9 9 9 9\np 3\n# first\n0 0 0\n\n1 0 0\n0 1 0");
    EXPECT_EQ(s.objects.size(), 2u);
}

TEST(LoadNff, PolygonsOfRealFiles) {
    const Scene s = scene_from("f 1 1 1 1 0 0 0 0\n"
                               "p 4\n0 0 0\n1 0 0\n1 0 0\n0 1 0\n"               // a point twice: a triangle
                               "p 4\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n"               // closed by hand: a triangle
                               "p 3\n0 0 0\n1 0 0\n2 0 0\n"                      // no area
                               "p 3\n0 0 0\n0 0 0\n0 0 0\n"                      // a point
                               "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n"             // bent: two triangles
                               "pp 3\n0 0 0 0 0 0\n1 0 0 0 0 1\n0 1 0 0 0 1\n"); // a normal of length 0
    ASSERT_EQ(s.objects.size(), 5u);
    EXPECT_EQ(std::get<Polygon>(s.objects[0].shape).points.size(), 3u);
    EXPECT_EQ(std::get<Polygon>(s.objects[1].shape).points.size(), 3u);
    EXPECT_THAT(std::get<Polygon>(s.objects[3].shape).points, ElementsAre(glm::dvec3(0), glm::dvec3(1, 1, 0), glm::dvec3(0, 1, 0.5)));
    EXPECT_TRUE(std::get<Polygon>(s.objects[4].shape).normals.empty());
    EXPECT_THAT(s.remarks, ElementsAre("2 polygons without area left out (the first at line 12)",
                                       "1 polygon not planar, cut into triangles (the first at line 20)",
                                       "1 polygon with normals of length 0 take the face normal (the first at line 25)"));
}

TEST(LoadNff, ProblemsHaveTheirPlace) {
    const struct {
        const char* text;
        const char* wanted;
    } cases[] = {
        {"tess 4\n", "x.nff:1:1: \"tess\" is an extension of other writers and not supported; NFF has v b l f s c p pp and # comments"},
        {"s 0 0 0 1\nxyz 1 2\n4 5\ns 0 0 0 1\n", "x.nff:2:1: unknown statement \"xyz\"; NFF has v b l f s c p pp and # comments"},
        {"angle 45\n", "x.nff:1:1: \"angle\" stands outside a view; it belongs behind v"},
        {"f 1 1 1 1 0 0 0 0 wood.png\n",
         "x.nff:1:19: f: \"wood.png\" after the last number; a texture is an extension that is not supported"},
        {"s 1 -4 2 4 2 2\n", "x.nff:1:12: s: \"2\" after the last number; one number too many"},
        {"f 0.3 0.3 0.3 1 1\ns 0 0 0 1\n", "x.nff:2:1: f: \"s\" where a number should be, the shine"},
        {"s 0 0 0", "x.nff:1:8: s: the file ends where the radius should be"},
        {"s 0 0 0 nan\n", "x.nff:1:9: s: radius is not a finite number; it must be one"},
        {"s 0 0 0 1e400\n", "x.nff:1:9: s: radius is not a finite number; it must be one"},
        {"s 0 0 1e39 1\n", "x.nff:1:7: s: center z is 1e+39; it must lie between -1e15 and 1e15 (limit kMaxCoordinate)"},
        {"s 0 0 0 0x1p3\n", "x.nff:1:9: s: \"0x1p3\" where a number should be, the radius"},
        {"s 0 0 0 1,5\n", "x.nff:1:9: s: \"1,5\" where a number should be, the radius"},
        {"s 0 0 0 0\n", "x.nff:1:9: s: radius is 0; it must be greater than 0"},
        {"s 0 0 0 -1\n", "x.nff:1:9: s: a negative radius (seen from inside only) is not supported; it must be greater than 0"},
        {"c 0 0 0 1 0 0 0 1\n", "x.nff:1:1: c: base and apex are the same point; they must differ"},
        {"c 0 0 0 0 0 0 1 0\n", "x.nff:1:1: c: both radii are 0; one must be greater"},
        {"f 1.5 1 1 1 0 0 0 0\n", "x.nff:1:3: f: red is 1.5; it must lie between 0 and 1"},
        {"f 1 1 1 1 0.5 -1 0 0\n", "x.nff:1:1: f: shine is -1; it must be 0 or greater where Ks is not 0"},
        {"f 1 1 1 1 0 0 0.5 0\n", "x.nff:1:1: f: index of refraction is 0; it must be greater than 0 where T is not 0"},
        {"b 0 -1 0\n", "x.nff:1:5: b: green is -1; it must be 0 or greater, and at most 3.4e38"},
        {"l 0 0 0 1\n", "x.nff:2:1: l: the file ends where the green should be"},
        {"p 2\n0 0 0\n1 0 0\n", "x.nff:1:3: p: \"2\" points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p -1\n", "x.nff:1:3: p: \"-1\" points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p 2147483648\n0 0 0\n", "x.nff:1:3: p: \"2147483648\" points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p 9223372036854775808\n",
         "x.nff:1:3: p: \"9223372036854775808\" points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p 3.5\n", "x.nff:1:3: p: \"3.5\" points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p\n0 0 0\n", "x.nff:1:1: p: no number of points; the number must lie between 3 and 65536 (limit kMaxPolygonPoints)"},
        {"p 3\n0 0 0\n1 0 0\n0 1\ns 0 0 0 1\n", "x.nff:5:1: p: \"s\" where a number should be, the z"},
        {"\x1b[2J\n", "x.nff:1:1: unknown statement \"\\x1b[2J\"; NFF has v b l f s c p pp and # comments"},
        {"1 2 3\n4 5\n", "x.nff:1:1: \"1\" belongs to no statement; NFF has v b l f s c p pp and # comments"},
        {"v\nfrom 1 0 0\nat 0 0 0\nup 0 0 1\nangle 180\nresolution 4 4\n",
         "x.nff:5:7: angle is 180; it must lie between 0 and 180 degrees, both excluded"},
        {"v\nfrom 1 0 0\nat 1 0 0\nup 0 0 1\nangle 45\nresolution 4 4\n",
         "x.nff:3:1: at is the same point as from; the camera must look somewhere"},
        {"v\nfrom 1 0 0\nat 0 0 0\nup 2 0 0\nangle 45\nresolution 4 4\n",
         "x.nff:4:1: up is along the view direction; it must point to another side"},
        {"v\nfrom 1 0 0\nat 0 0 0\nup 0 0 1\nangle 45\nresolution 4.5 4\n", "x.nff:6:16: resolution must be two whole numbers"},
        {"v\nfrom 1 0 0\nat 0 0 0\nup 0 0 1\nangle 45\n", "x.nff:1:1: v: resolution is missing"},
    };
    for (const auto& c : cases) EXPECT_THAT(problems_of(c.text), ElementsAre(c.wanted)) << c.text;
}

TEST(LoadNff, AllProblemsAreToldTogether) {
    EXPECT_THAT(problems_of("f 1 1 1 2 0 0 0 0\ns 0 0 0 0\nfoo\np 3\n0 0 0\n1 x 0\n0 1 0\ns 0 0 0 1 9\nl 1 2\nb 0 0 0\n"),
                ElementsAre(HasSubstr(":1:9: f: Kd is 2"), HasSubstr(":2:9: s: radius is 0"), HasSubstr(":3:1: unknown statement \"foo\""),
                            HasSubstr(":6:3: p: \"x\" where a number"), HasSubstr(":8:11: s: \"9\" after"),
                            HasSubstr(":10:1: l: \"b\" where a number")));
}

TEST(LoadNff, ObjectsBeforeAnyFillAreToldOf) {
    const Scene s = scene_from("s 0 0 0 1\nf 1 0 0 1 0 0 0 0\ns 1 0 0 1\n");
    EXPECT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.objects[0].material, 0u);
    EXPECT_EQ(s.objects[1].material, 1u);
    EXPECT_THAT(s.remarks, ElementsAre(HasSubstr("line 1: objects before the first f line have the default material")));
}

// --- files that nobody here wrote ----------------------------------------------------------------------------------------------------

// Beside the checkout, or beside the folder that holds it.
std::filesystem::path scenes() {
    const std::filesystem::path source = LIGHTBENCH_SOURCE, near = source / "../shared/scenes";
    return std::filesystem::exists(near) ? near : source / "../../shared/scenes";
}
const std::filesystem::path kModels = "/usr/share/assimp/models/NFF/NFF";

// Counted by `grep -c` in the files.
TEST(LoadNff, HainesBallsTeapotTetra) {
    const struct {
        const char* file;
        std::size_t objects, lights, materials;
    } cases[] = {{"balls_4.nff", 7382, 3, 2}, {"teapot_12.nff", 9264, 2, 3}, {"tetra_6.nff", 4096, 1, 1}};
    if (!std::filesystem::exists(scenes())) GTEST_SKIP() << "no scenes at " << scenes();
    for (const auto& c : cases) {
        const Scene s = scene_of(load_scene(scenes() / c.file));
        EXPECT_EQ(s.objects.size(), c.objects) << c.file;
        EXPECT_EQ(s.lights.size(), c.lights) << c.file;
        EXPECT_EQ(s.materials.size(), c.materials) << c.file;
        EXPECT_EQ(s.cameras.size(), 1u) << c.file;
        EXPECT_EQ(s.film, glm::uvec2(512, 512)) << c.file;
        EXPECT_TRUE(s.remarks.empty()) << c.file << ": " << s.remarks[0];
    }
}

TEST(LoadNff, OfAssimpsModelsThePureOneLoadsAndTheOthersAreRefusedWithLines) {
    if (!std::filesystem::exists(kModels)) GTEST_SKIP() << "no models at " << kModels << " (package assimp-testmodels)";
    for (const auto& entry : std::filesystem::directory_iterator(kModels)) {
        const Loaded loaded = load_scene(entry.path());
        if (entry.path().filename() == "WithCamera.nff") {
            EXPECT_EQ(scene_of(loaded).objects.size(), 4u);
            continue;
        }
        EXPECT_FALSE(loaded.scene) << entry.path();
        for (const Problem& problem : loaded.problems) EXPECT_GT(problem.line, 0u) << to_string(problem);
    }
}

TEST(LoadNff, HalfAMillionSpheresAreReadInATrice) {
    std::string text = "f 1 1 1 1 0 0 0 0\n";
    for (int i = 0; i < 600000; ++i) text += fmt::format("s {:.6g} {:.6g} {:.6g} 0.00617284\n", std::sin(i), std::cos(i), i * 1e-5);
    const std::clock_t begin = std::clock();
    const Loaded loaded = load(text);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    ASSERT_TRUE(loaded.scene);
    EXPECT_EQ(loaded.scene->objects.size(), 600000u);
    RecordProperty("seconds", fmt::format("{:.3f}", seconds));
#ifdef NDEBUG
    EXPECT_LT(seconds, 1.0);
#endif
}

} // namespace
} // namespace lightbench
