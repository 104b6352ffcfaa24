// Every kind of problem of a native scene: its line, its column, its words.
#include "scene/check.h"
#include "scene/toml_load.h"
#include "unit/load_fixtures.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using namespace testing_files;

struct Case {
    const char* text;
    const char* wanted; // all problems, one a line
};

std::string all_problems(std::string_view text, const LoadOptions& options = {}) {
    const Loaded loaded = load_toml(text, "room.toml", options);
    EXPECT_EQ(loaded.scene.has_value(), loaded.problems.empty());
    std::string lines;
    for (const Problem& problem : loaded.problems) {
        if (!lines.empty()) lines += '\n';
        lines += to_string(problem);
    }
    return lines;
}

void expect_problems(std::initializer_list<Case> cases) {
    for (const Case& c : cases) EXPECT_EQ(all_problems(c.text), c.wanted) << c.text;
}

#define POLYGON "[[object]]\nshape = \"polygon\"\n"

TEST(LoadTomlProblems, TheExampleOfTheManual) {
    EXPECT_EQ(all_problems("[[material]]\nname = \"pane\"\nopacity   = 1.7\n[[object]]\nshape = \"sphere\"\nradious = 2\n"),
              "room.toml:3:13: material \"pane\": opacity is 1.7; it must lie between 0 (invisible) and 1 (opaque)\n"
              "room.toml:6:1: object: unknown key \"radious\"; did you mean \"radius\"?");
}

TEST(LoadTomlProblems, Sections) {
    expect_problems({
        {"[lights]\n", "room.toml:1:2: scene: unknown key \"lights\"; did you mean \"light\"?"},
        {"xyzzy = 1\n", "room.toml:1:1: scene: unknown key \"xyzzy\"; the keys are film, camera, environment, light, material, object"},
        {"[light]\nposition = [0, 0, 0]\n", "room.toml:1:1: scene: light is a table; write [[light]]"},
        {"light = [1]\n", "room.toml:1:10: scene: light is a whole number; write [[light]]"},
        {"film = 3\n", "room.toml:1:8: scene: film is a whole number; write one [film]"},
        {"[[film]]\n", "room.toml:1:1: scene: film is an array; write one [film]"},
    });
}

TEST(LoadTomlProblems, Film) {
    expect_problems({
        {"[film]\nwidth = 640.0\nheight = 0\n", "room.toml:2:9: film: width is a number with a fraction; it must be a whole number\n"
                                                "room.toml:3:10: film: height is 0; it must lie between 1 and 16384"},
        {"[film]\nwidth = 9223372036854775807\nheight = -1\n",
         "room.toml:2:9: film: width is 9223372036854775807; it must lie between 1 and 16384\n"
         "room.toml:3:10: film: height is -1; it must lie between 1 and 16384"},
        {"[film]\nwidth = 640\n", "room.toml:1:1: film: height is missing; give it in pixels"},
    });
}

TEST(LoadTomlProblems, Camera) {
    expect_problems({
        {"[camera]\nfov = 180\n", "room.toml:2:7: camera: fov is 180; it must lie between 0 and 180 degrees, both excluded"},
        {"[camera]\nfov = 0\n", "room.toml:2:7: camera: fov is 0; it must lie between 0 and 180 degrees, both excluded"},
        {"[camera]\nposition = [1, 1, 1]\ntarget = [1, 1, 1]\n",
         "room.toml:3:10: camera: target is the same point as position; the camera must look somewhere"},
        {"[camera]\nposition = [0, 9, 0]\n",
         "room.toml:1:1: camera: up is [0, 1, 0], along the view direction; it must point to another side"},
        {"[camera]\nup = [0, 0, -2]\n", "room.toml:2:6: camera: up is [0, 0, -2], along the view direction; it must point to another side"},
        {"[camera]\nup = [0, 0, 0]\n", "room.toml:2:6: camera: up is [0, 0, 0], along the view direction; it must point to another side"},
        {"[camera]\nposition = [0, nan, 1e16]\n",
         "room.toml:2:16: camera: position's y is nan; it must be a finite number\n"
         "room.toml:2:21: camera: position's z is 1e+16; it must lie between -1e15 and 1e15 (limit kMaxCoordinate)"},
        {"[camera]\nposition = [0, 1]\n", "room.toml:2:12: camera: position has 2 elements; it must be three numbers [x, y, z]"},
        {"[camera]\nposition = 3\n", "room.toml:2:12: camera: position is a whole number; it must be three numbers [x, y, z]"},
        {"[camera]\nposition = [0, \"1\", 2]\n", "room.toml:2:16: camera: position's y is a string; it must be a number"},
        {"[[camera]]\nname = \"a\"\n[[camera]]\nname = \"a\"\n",
         "room.toml:4:8: camera \"a\": another camera has this name; names must differ"},
        {"[camera]\nname = 1\nfof = 3\n", "room.toml:2:8: camera: name is a whole number; it must be a string\n"
                                          "room.toml:3:1: camera: unknown key \"fof\"; did you mean \"fov\"?"},
        {"[camera]\nhither = -1\n", "room.toml:2:10: camera: hither is -1; it must lie between 0 and 1e15 (limit kMaxCoordinate)"},
    });
}

TEST(LoadTomlProblems, Environment) {
    expect_problems({
        {"[environment]\nbackground = [0, -0.5, 0]\nambient = inf\n",
         "room.toml:2:18: environment: background's green is -0.5; it must be 0 or greater, and at most 3.4e38\n"
         "room.toml:3:11: environment: ambient is inf; it must be a finite number"},
        {"[environment]\nmap = 1\n", "room.toml:2:7: environment: map is a whole number; it must be a string"},
        {"[environment]\nmap = \"sky.hdr\"\n", "room.toml:2:7: environment: map \"sky.hdr\": there is no such file"},
        {"[environment]\nmap = []\n", "room.toml:2:7: environment: map has 0 faces; it must be one file or six: +x, -x, +y, -y, +z, -z"},
    });
}

TEST(LoadTomlProblems, Lights) {
    expect_problems({
        {"[[light]]\n", "room.toml:1:1: light: position is missing; give [x, y, z]"},
        {"[[light]]\ntype = \"spotty\"\nposition = [0, 0, 0]\n", "room.toml:2:8: light: unknown type \"spotty\"; did you mean \"spot\"?"},
        {"[[light]]\ntype = \"sun\"\nposition = [0, 0, 0]\n",
         "room.toml:2:8: light: unknown type \"sun\"; it must be one of \"point\", \"directional\", \"spot\""},
        {"[[light]]\ntype = \"directional\"\n", "room.toml:1:1: light: direction is missing; give [x, y, z], the way the light travels"},
        {"[[light]]\ntype = \"directional\"\ndirection = [0, 0, 0]\n",
         "room.toml:3:13: light: direction is [0, 0, 0]; it must point somewhere"},
        {"[[light]]\nposition = [0, 0, 0]\nd0 = 0\nintensity = -1\n",
         "room.toml:4:13: light: intensity is -1; it must be 0 or greater, and at most 3.4e38\n"
         "room.toml:3:6: light: d0 is 0; it must be greater than 0 and at most 1e15 (limit kMaxCoordinate)"},
        {"[[light]]\nposition = [0, 0, 0]\nintensity = 1e39\n",
         "room.toml:3:13: light: intensity is 1e+39; it must be 0 or greater, and at most 3.4e38"},
        {"[[light]]\nposition = [0, 0, 0]\ncolor = 1e30\nintensity = 1e30\n",
         "room.toml:4:13: light: color times intensity is too large; it must be at most 3.4e38"},
        {"[[light]]\nposition = [0, 0, 0]\nattenuation = \"quadratic\"\n",
         "room.toml:3:15: light: unknown attenuation \"quadratic\"; it must be one of \"none\", \"linear\", \"inverse-square\""},
        {"[[light]]\nposition = [0, 0, 0]\nangle = 91\nsoftness = 1.5\n",
         "room.toml:3:9: light: angle is 91; it is the half-angle of the cone and must be greater than 0 and at most 90 degrees\n"
         "room.toml:4:12: light: softness is 1.5; it must lie between 0 and 1"},
    });
}

// All of a material's ranges: what is just outside is told, what is on the bound is taken.
TEST(LoadTomlProblems, MaterialRanges) {
    struct Range {
        const char* key;
        std::vector<const char*> wrong, right;
    };
    const std::vector<Range> ranges = {
        {"diffuse", {"-1e-9", "1.001", "[0, 0, 2]", "nan", "\"red\"", "[1, 1]", "[1, 1, 1, 1]", "true"}, {"0", "1", "[0, 0.5, 1]"}},
        {"specular", {"-0.1", "1.1", "-inf"}, {"0", "1"}},
        {"shininess", {"-1", "inf", "nan", "1e39", "[1, 2, 3]"}, {"0", "1", "200", "100000"}},
        {"roughness", {"0", "-0.1", "1e-46", "nan"}, {"1e-6", "0.5", "3"}}, // 1e-46 is 0 as a float
        {"ior", {"0", "-1", "[1, 1, 0]", "inf"}, {"0.5", "1", "[1.4, 1.5, 1.6]"}},
        {"f0", {"1", "-0.1", "0.99999999999", "[0, 0, 1]"}, {"0", "0.999"}}, // 0.99999999999 is 1 as a float
        {"fresnel", {"1", "\"yes\""}, {"true", "false"}},
        {"reflection", {"1.5", "-1"}, {"0", "1"}},
        {"transmission", {"1.5", "-1"}, {"0", "1"}},
        {"scatter", {"-0.1", "nan"}, {"0", "0.2"}},
        {"dispersion", {"[0, -1]", "[1]", "[1, nan]", "\"glass\"", "99"}, {"[1.5, 0.01]", "0.004", "0"}},
        {"opacity", {"1.7", "-0.5", "[0, 0, 1.5]"}, {"0", "1"}},
        {"emission", {"-1", "1e39"}, {"0", "1000"}},
        {"two_sided", {"1"}, {"true"}},
        {"environment", {"-1", "2", "[0, 0, 0]"}, {"0", "1"}},
        {"model", {"\"phog\"", "1"}, {"\"phong\"", "\"cook-torrance\""}},
        {"distribution", {"\"ggx\""}, {"\"gaussian\"", "\"beckmann\""}},
        {"texture",
         {"1", "{}", "{checker = false}", "{file = \"no.png\"}", "{checker = true, scale = 0}", "{checker = true, mapping = \"cubic\"}",
          "{checker = true, size = 1}"},
         {"{checker = true}", "{checker = true, scale = [1, 2]}"}},
        {"bump",
         {"\"waves\"", "{}", "{function = \"wave\"}", "{function = \"waves\", frequency = 0}", "{function = \"waves\", amplitude = nan}",
          "{function = \"noise\", normal_map = true}"},
         {"{function = \"waves\"}", "{function = \"noise\", amplitude = -1, frequency = 2}"}},
    };
    for (const Range& range : ranges) {
        const auto problems = [&](const char* value) {
            return all_problems(fmt::format("[[material]]\nname = \"m\"\n{} = {}\n", range.key, value));
        };
        for (const char* value : range.wrong) {
            EXPECT_THAT(problems(value), testing::StartsWith("room.toml:3:")) << range.key << " = " << value;
            EXPECT_THAT(problems(value), testing::Not(testing::HasSubstr("\n"))) << range.key << " = " << value;
            EXPECT_THAT(problems(value), testing::HasSubstr("material \"m\": ")) << range.key << " = " << value;
        }
        for (const char* value : range.right) EXPECT_EQ(problems(value), "") << range.key << " = " << value;
    }
}

TEST(LoadTomlProblems, Materials) {
    expect_problems({
        {"[[material]]\ndiffuse = 2\n", "room.toml:1:1: material: name is missing; objects refer to it\n"
                                        "room.toml:2:11: material: diffuse is 2; it must lie between 0 and 1"},
        {"[[material]]\nname = \"\"\n", "room.toml:2:8: material \"\": the name is empty; objects refer to it"},
        {"[[material]]\nname = \"a\"\n\n[[material]]\nname = \"a\"\n",
         "room.toml:5:8: material \"a\": the material at line 2 has this name; names must differ"},
        {"[[material]]\nname = \"a\"\ncolour = 1\n",
         "room.toml:3:1: material \"a\": unknown key \"colour\"; the keys are name, diffuse, specular, shininess, model, distribution, "
         "roughness, f0, ior, "
         "fresnel, reflection, transmission, scatter, dispersion, opacity, environment, emission, two_sided, texture, bump"},
        {"[[material]]\nname = \"a\"\nDiffuse = 1\n", "room.toml:3:1: material \"a\": unknown key \"Diffuse\"; did you mean \"diffuse\"?"},
        {"[[material]]\nname = \"a\"\ntexture = {file = \"x.png\", checker = true}\n",
         "room.toml:3:19: material \"a\": texture: file \"x.png\": there is no such file\n"
         "room.toml:3:11: material \"a\": texture: both file and checker; give one of them"},
        {"[[material]]\nname = \"a\\u001b[2J\\n\"\nf0 = 1\n",
         "room.toml:2:8: material: the name \"a\\x1b[2J\\x0a\" holds a control character; it must be printable\n"
         "room.toml:3:6: material: f0 is 1; it must be at least 0 "
         "and less than 1 (the index of refraction is infinite there)"},
        {"[camera]\nname = \"\\u007f\"\n", "room.toml:2:8: camera: the name \"\\x7f\" holds a control character; it must be printable"},
    });
}

TEST(LoadTomlProblems, Objects) {
    expect_problems({
        {"[[object]]\n", "room.toml:1:1: object: shape is missing; it must be one of sphere, polygon, mesh, cone, box, cylinder, torus"},
        {"[[object]]\nshape = \"spere\"\n", "room.toml:2:9: object: unknown shape \"spere\"; did you mean \"sphere\"?"},
        {"[[material]]\nname = \"glass\"\n[[object]]\nshape = \"box\"\nmaterial = \"glas\"\n",
         "room.toml:5:12: object: unknown material \"glas\"; did you mean \"glass\"?"},
        {"[[object]]\nshape = \"box\"\nmaterial = \"glas\"\n",
         "room.toml:3:12: object: unknown material \"glas\"; no [[material]] has this name"},
        {"[[object]]\nshape = \"box\"\nmaterial = 3\n", "room.toml:3:12: object: material is a whole number; it must be a string"},
        {"[[object]]\nshape = \"box\"\nscale = 0\n", "room.toml:3:9: object: scale is 0 along x; its size must lie between 1e-15 and 1e15"},
        {"[[object]]\nshape = \"box\"\nscale = [1, 1e-300, 1]\n",
         "room.toml:3:9: object: scale is 1e-300 along y; its size must lie between 1e-15 and 1e15"},
        {"[[object]]\nshape = \"box\"\nrotate = [0, 0]\ntranslate = 5\n",
         "room.toml:4:13: object: translate is a whole number; it must be three numbers [x, y, z]\n"
         "room.toml:3:10: object: rotate has 2 elements; it must be three numbers [x, y, z]"},
        {"[[object]]\nshape = \"box\"\ncrease = 181\nsubdivide = 9\n",
         "room.toml:3:10: object: crease is 181; it must lie between 0 and 180 degrees\n"
         "room.toml:4:13: object: subdivide is 9; it must lie between 0 and 8"},
        {"[[object]]\nshape = \"box\"\nradius = 1\n", "room.toml:3:1: object: unknown key \"radius\"; the keys are shape, material, "
                                                      "translate, rotate, scale, crease, subdivide, min, max"},
    });
}

TEST(LoadTomlProblems, Shapes) {
    expect_problems({
        {"[[object]]\nshape = \"sphere\"\nradius = 0\n",
         "room.toml:3:10: object: radius is 0; it must be greater than 0 and at most 1e15 (limit kMaxCoordinate)"},
        {"[[object]]\nshape = \"sphere\"\nradius = -1\ncenter = [inf, 0, 0]\n",
         "room.toml:4:11: object: center's x is inf; it must be a finite number\n"
         "room.toml:3:10: object: radius is -1; it must be greater than 0 and at most 1e15 (limit kMaxCoordinate)"},
        {"[[object]]\nshape = \"box\"\nmin = [0, 0, 0]\nmax = [1, 0, -1]\n",
         "room.toml:4:7: object: max's y is 0; it must be greater than min's, 0\n"
         "room.toml:4:7: object: max's z is -1; it must be greater than min's, 0"},
        {"[[object]]\nshape = \"box\"\nmin = [2, 0, 0]\n", "room.toml:3:7: object: max's x is 0.5; it must be greater than min's, 2"},
        {"[[object]]\nshape = \"cylinder\"\ntop = [0, 0, 0]\n", "room.toml:3:7: object: top is the same point as base; they must differ"},
        {"[[object]]\nshape = \"cone\"\nbase = [1, 1, 1]\napex = [1, 1, 1]\n",
         "room.toml:4:8: object: apex is the same point as base; they must differ"},
        {"[[object]]\nshape = \"cone\"\napex = [0, 1, 0]\ntop = [0, 2, 0]\n",
         "room.toml:3:8: object: both apex and top; give apex for a point, top and top_radius for a cone cut off"},
        {"[[object]]\nshape = \"cone\"\napex = [0, 1, 0]\ntop_radius = 1\n",
         "room.toml:4:14: object: an apex has no radius; write top in place of apex"},
        {"[[object]]\nshape = \"cone\"\nbase_radius = 0\n",
         "room.toml:3:15: object: base_radius and top_radius are both 0; one must be greater"},
        {"[[object]]\nshape = \"cone\"\nbase_radius = -1\n",
         "room.toml:3:15: object: base_radius is -1; it must lie between 0 and 1e15 (limit kMaxCoordinate)"},
        {"[[object]]\nshape = \"torus\"\naxis = [0, 0, 0]\nminor = 0\n",
         "room.toml:3:8: object: axis is [0, 0, 0]; it must point somewhere\n"
         "room.toml:4:9: object: minor is 0; it must be greater than 0 and at most 1e15 (limit kMaxCoordinate)"},
        {"[[object]]\nshape = \"mesh\"\n", "room.toml:1:1: object: file is missing; give the mesh's file name"},
        {"[[object]]\nshape = \"mesh\"\nfile = \"no.obj\"\n", "room.toml:3:8: object: file \"no.obj\": there is no such file"},
    });
}

TEST(LoadTomlProblems, Polygons) {
    expect_problems({
        {POLYGON, "room.toml:1:1: object: points is missing; give [[x, y, z], ...]"},
        {POLYGON "points = 3\n", "room.toml:3:10: object: points is a whole number; it must be an array of points [[x, y, z], ...]"},
        {POLYGON "points = [[0, 0, 0], [1, 0, 0]]\n", "room.toml:3:10: object: points has 2 points; a polygon needs 3"},
        {POLYGON "points = [[0, 0, 0], [1, 0, nan], [1, 1]]\n",
         "room.toml:3:29: object: point 2's z is nan; it must be a finite number\n"
         "room.toml:3:35: object: point 3 has 2 elements; it must be three numbers [x, y, z]"},
        {POLYGON "points = [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2], [0.3, 0.3, 0.3]]\n",
         "room.toml:3:10: object: all points lie on one line; a polygon needs an area"},
        {POLYGON "points = [[1, 0, 0], [1, 0, 0], [1, 0, 0]]\n",
         "room.toml:3:10: object: all points lie on one line; a polygon needs an area"},
        {POLYGON "points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.25]]\n",
         "room.toml:3:10: object: a point lies 0.0615 off the polygon's plane; it must lie within 3.5e-05; cut the polygon into triangles"},
        {POLYGON "points = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\nnormals = [[0, 0, 1]]\n",
         "room.toml:4:11: object: normals must be an array of 3 vectors, one a point"},
        {POLYGON "points = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\nnormals = [[0, 0, 1], [0, 0, 0], [0, 0, 1]]\n",
         "room.toml:4:23: object: a normal is [0, 0, 0]; it must point somewhere"},
    });
}

// Six-digit files: a square in a tilted plane far from the origin is planar in spite of its rounded coordinates; a dent of 1 % is not.
TEST(LoadTomlProblems, PlanarityToleratesSixDigitsAndNoMore) {
    const auto square = [](double dent) {
        std::string points;
        const glm::dvec3 u = glm::normalize(glm::dvec3(1, 2, 3)), v = glm::normalize(glm::cross(u, glm::dvec3(0, 0, 1))),
                         n = glm::cross(u, v);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 p =
                glm::dvec3(7, -8, 9) + (i == 1 || i == 2 ? 1.0 : 0.0) * u + (i >= 2 ? 1.0 : 0.0) * v + (i == 3 ? dent : 0.0) * n;
            points += fmt::format("[{:.6g}, {:.6g}, {:.6g}],", p.x, p.y, p.z);
        }
        return fmt::format(POLYGON "points = [{}]\n", points);
    };
    EXPECT_EQ(all_problems(square(0)), "");
    EXPECT_THAT(all_problems(square(0.01)), testing::HasSubstr("off the polygon's plane"));
}

TEST(LoadTomlProblems, SyntaxErrorIsTheOnlyProblem) {
    EXPECT_THAT(all_problems("[film]\nwidth = \nxyz = 3\n"), testing::StartsWith("room.toml:2:9: not valid TOML: "));
    EXPECT_THAT(all_problems("[film]\nwidth = 1\nwidth = 2\n"), testing::StartsWith("room.toml:3:"));
    EXPECT_THAT(all_problems("a = 0x1p3\n"), testing::StartsWith("room.toml:1:"));
    EXPECT_THAT(all_problems("[camera]\nfov = 4,5\n"), testing::StartsWith("room.toml:2:8: not valid TOML"));
}

TEST(LoadTomlProblems, AllAreCountedSomeAreListed) {
    std::string text;
    for (int i = 0; i < 25; ++i) text += "[[light]]\nposition = [0, 0, 0]\nd0 = 0\n";
    const Loaded loaded = load_toml(text, "room.toml", {.allow_outside = false, .max_problems = 10});
    ASSERT_EQ(loaded.problems.size(), 11u);
    EXPECT_EQ(loaded.unlisted, 15u);
    EXPECT_EQ(to_string(loaded.problems.back()), "room.toml: and 15 more problems");
    EXPECT_EQ(problem_lines(loaded, "room.toml").back(), "25 problems in room.toml");
}

TEST(LoadTomlProblems, CheckPrintsEveryProblemAndTheirNumber) {
    const Folder folder;
    const auto file = folder.write("room.toml", "[film]\nwidth = 0\nheight = 0\n");
    EXPECT_THAT(check_file(file), testing::ElementsAre(file.string() + ":2:9: film: width is 0; it must lie between 1 and 16384",
                                                       file.string() + ":3:10: film: height is 0; it must lie between 1 and 16384",
                                                       "2 problems in " + file.string()));
    EXPECT_THAT(check_file(folder.write("fine.toml", "")), testing::IsEmpty());
    EXPECT_THAT(check_file(folder.path() / "no.toml"),
                testing::ElementsAre((folder.path() / "no.toml").string() + ": there is no such file",
                                     "1 problem in " + (folder.path() / "no.toml").string()));
}

} // namespace
} // namespace lightbench
