// Everything that can be typed wrong: exit code 2, a sentence that names the option, nothing on standard output, no file.
#include "program.h"

#include <gmock/gmock.h>

namespace lightbench::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct BadOption {
    std::vector<std::string> arguments;
    const char* message;
};

const BadOption kBad[] = {
    {{"--method", "voodoo"}, "--method: \"voodoo\" is unknown; it must be raster"},
    {{"--shading", "fong"}, "--shading: \"fong\" is unknown; it must be flat, gouraud or phong"},
    {{"--sampling", "adaptive"}, "--sampling: adaptive sampling needs rays: --method raytrace"},
    {{"--method", "raytrace", "--sampling", "adaptive", "--spp", "4"}, "--spp: 4 samples a pixel, but --sampling adaptive"},
    {{"--method", "raytrace", "--sampling", "adaptive", "--filter", "gaussian"}, "--filter: adaptive sampling takes the mean"},
    {{"--sampling", "none", "--spp", "9"}, "--sampling: none takes one sample a pixel"},
    {{"--spp", "5"}, "--spp: \"5\" must be a square"},
    {{"--spp", "0"}, "--spp: \"0\" must be a square"},
    {{"--spp", "1089"}, "--spp: \"1089\" must be a square from 1 to 1024"},
    {{"--size", "640"}, "--size: \"640\" must be WIDTHxHEIGHT"},
    {{"--size", "640x"}, "--size: \"640x\""},
    {{"--size", "-1x10"}, "--size: \"-1x10\""},
    {{"--size", "64x48x3"}, "--size: \"64x48x3\""},
    {{"--size", "0x48"}, "--size: the image is 0x48; a side must have 1 to 16384 pixels"},
    {{"--size", "16385x1"}, "--size: the image is 16385x1"},
    {{"--crop", "0,0,10"}, "--crop: \"0,0,10\" must be X,Y,W,H"},
    {{"--crop", "60,0,10,10"}, "--crop: 10x10 at 60,0 is not inside of the 64x48 image"},
    {{"--subdivide", "9"}, "--subdivide: \"9\" must be a whole number from 0 to 8"},
    {{"--subdivide", "1.5"}, "--subdivide: \"1.5\""},
    {{"--exposure", "nan"}, "--exposure: \"nan\""},
    {{"--exposure", "1000"}, "--exposure: \"1000\""},
    {{"--seed", "-1"}, "--seed: \"-1\""},
    {{"--frame", "x"}, "--frame: \"x\" must be a whole number"},
    {{"--frames", "3"}, "--frames: \"3\" must be A:B"},
    {{"--frames", "3:1"}, "--frames: \"3:1\" must be A:B"},
    {{"--frames", "0:3"}, "must hold %04d once"},
    {{"--frame", "1", "--frames", "0:3"}, "--frame: one frame or --frames, not both"},
    {{"--camera", "0,0,0:0,0,0:0,1,0:45"}, "position and target are the same point"},
    {{"--camera", "0,0,5:0,0,0:0,1,0:180"}, "fov is 180 degrees; it must lie between 0 and 180"},
    {{"--camera", "0,0,5:0,0,0:0,1,0"}, "--camera: no camera is named"},
    {{"--without", "texture,fog"}, "--without: \"fog\" is unknown; it must be texture, bump, environment, transparency or reflection"},
    {{"--camera", "nobody"}, "--camera: no camera is named \"nobody\"; the scene has \"front\""},
    {{"--progress", "often"}, "--progress: \"often\" is unknown"},
    {{"--precision", "float16"}, "--precision: \"float16\" is unknown; it must be float32 or float64"},
    {{"--precision", "float64", "--shading", "flat"}, "--precision: float64 belongs to --method raster with --shading phong"},
    {{"--filter", "tent"}, "--filter: \"tent\" is unknown; it must be box or gaussian"},
    {{"--filter-width", "2"}, "--filter-width: belongs to --filter gaussian"},
    {{"--filter", "gaussian", "--filter-width", "0.5"}, "--filter-width: \"0.5\" must be a radius from 1 to 16"},
    {{"--sampling", "adaptive", "--contrast", "1,2,3"}, "--contrast: \"1,2,3\" must be R,G,B"},
    {{"--sampling", "adaptive", "--max-level", "7"}, "--max-level: \"7\" must be a whole number from 0 to 6"},
    {{"--accel-param", "fan=2"}, "--accel-param: \"fan=2\" must be leaf=N, cells=L,M,N, density=X, depth=N or builder=host|device"},
    {{"--accel-param", "builder=gpu"}, "--accel-param: builder: \"gpu\" must be host or device"},
    {{"--accel", "grid", "--accel-param", "builder=device"}, "--accel-param: builder has no meaning for --accel grid"},
    {{"--accel-param", "cells=1,2,3"}, "--accel-param: cells has no meaning for --accel bvh"},
    {{"--accel-param", "leaf=2", "--accel-param", "leaf=5"}, "--accel-param: leaf: \"5\" must be"},
    {{"--accel", "grid", "--accel-param", "density=2,cells=1,2"}, "--accel-param: cells: \"1,2\" must be L,M,N"},
    {{"--contrast", "0.1,0.1,0.1"}, "--contrast: belongs to --sampling adaptive"},
    {{"--max-level", "3"}, "--max-level: belongs to --sampling adaptive"},
    {{"--depth", "0"}, "--depth: 0 sees nothing"},
    {{"--method", "radiosity", "--terms"}, "--terms: radiosity has no layers"},
    {{"--method", "raytrace", "--sampling", "adaptive", "--terms"}, "--terms: layers of adaptive samples would not add up"},
    {{"--depth", "256"}, "--depth: \"256\" must be a whole number from 1 to 255"},
    {{"--cutoff", "1.5"}, "--cutoff: \"1.5\" must be a weight from 0 to 1"},
    {{"--accel", "kd-tree"}, "--accel: \"kd-tree\" is unknown"},
    {{"--method", "radiosity", "--hemicube", "51"}, "--hemicube: \"51\" must be an even number from 8 to 1024"},
    {{"--method", "radiosity", "--patch", "0"}, "--patch: \"0\" must be a length in metres, above 0"},
    {{"--method", "radiosity", "--patch", "inf"}, "--patch: \"inf\""},
    {{"--method", "radiosity", "--until", "1"}, "--until: \"1\" must be a share between 0 and 1"},
    {{"--method", "radiosity", "--until", "nan"}, "--until: \"nan\""},
    {{"--method", "radiosity", "--shots", "-1"}, "--shots: \"-1\" must be a whole number"},
    {{"--method", "radiosity", "--solver", "magic"}, "--solver: \"magic\" is unknown; it must be progressive or full"},
    {{"--method", "radiosity", "--solver", "full", "--element", "1"}, "--element: belongs to --solver progressive"},
    {{"--hemicube", "50"}, "--hemicube: belongs to --method radiosity"},
    {{"--patch", "0.1"}, "--patch: belongs to --method radiosity"},
    {{"--solver", "full"}, "--solver: belongs to --method radiosity"},
    {{"--shots", "5"}, "--shots: belongs to --method radiosity"},
    {{"--until", "0.1"}, "--until: belongs to --method radiosity"},
    {{"--no-ambient"}, "--no-ambient: belongs to --method radiosity"},
    {{"--terms"}, "--terms: layers need an .exr"},
    {{"--shadng", "flat"}, "--shadng"},
    {{"--size"}, "--size"},
    {{"--size", "64x48", "--size", "64x48"}, "--size"},
};

class BadOptions : public Cli, public ::testing::WithParamInterface<BadOption> {};

TEST_P(BadOptions, AreRefused) {
    std::vector<std::string> arguments = {"render", scene(kBall), "-o", in_folder("x.png")};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr(GetParam().message));
    EXPECT_THAT(ran.out, IsEmpty());
    EXPECT_THAT(files(), ElementsAre("scene.toml"));
}

INSTANTIATE_TEST_SUITE_P(All, BadOptions, ::testing::ValuesIn(kBad));

TEST_F(Cli, AllProblemsOfACommandLineAreToldTogether) {
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.jpg"), "--spp", "3", "--shading", "fong", "--depth", "0"});
    EXPECT_EQ(ran.code, 2);
    for (const char* part : {"-o: ", "--spp: ", "--shading: ", "--depth: "}) EXPECT_THAT(ran.err, HasSubstr(part));
}

TEST_F(Cli, OutputsThatCannotBeAreRefusedBeforeAnythingRuns) {
    const std::string ball = scene(kBall);
    EXPECT_THAT(run({"render", ball, "-o", in_folder("x.jpg")}).err, HasSubstr("must end in .png (a picture) or .exr (linear radiance)"));
    const Ran ran = run({"render", ball, "-o", in_folder("missing/x.png")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("there is no folder"));
    EXPECT_EQ(run({"render", ball}).code, 2);
    EXPECT_EQ(run({"render", "-o", in_folder("x.png")}).code, 2);
}

TEST_F(Cli, HelpAndVersionAreEverywhere) {
    EXPECT_THAT(run({"--version"}).out, HasSubstr("lightbench 0."));
    for (const char* name :
         {"render", "plan", "compare", "check", "make", "devices", "gallery", "view", "cost", "probe", "plot", "numerics"}) {
        const Ran help = run({name, "--help"}), version = run({name, "--version"});
        EXPECT_EQ(help.code, 0) << name;
        EXPECT_THAT(help.out, HasSubstr("Usage: lightbench " + std::string(name)));
        EXPECT_THAT(help.err, IsEmpty());
        EXPECT_EQ(version.code, 0) << name;
        EXPECT_THAT(version.out, HasSubstr("lightbench 0."));
    }
    EXPECT_THAT(run({"--help"}).out, HasSubstr("render"));
}

TEST_F(Cli, WantsASubcommandThatItKnows) {
    EXPECT_EQ(run({"nonsense"}).code, 2);
    EXPECT_EQ(run({}).code, 2);
}

} // namespace
} // namespace lightbench::cli
