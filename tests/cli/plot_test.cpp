// plot: files and standard output, and what is refused.
#include "program.h"

#include <cstdlib>
#include <gmock/gmock.h>

namespace lightbench::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(Cli, PlotListsItsKinds) {
    const Ran ran = run({"plot", "--list"});
    EXPECT_EQ(ran.code, 0);
    for (const char* kind : {"brdf", "fresnel", "attenuation", "form-factor"})
        EXPECT_THAT("\n" + ran.out, HasSubstr("\n" + std::string(kind) + " "));
    EXPECT_THAT(ran.out, HasSubstr("  incidence "));
}

TEST_F(Cli, PlotWithoutAFileIsCsv) {
    const Ran ran = run({"plot", "fresnel", "--param", "index=1.5", "--param", "side=outside"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with("curve,incidence_degrees,reflectance\nindex 1.5: mean,0,0.04")) << ran.out.substr(0, 90);
    EXPECT_THAT(ran.err, IsEmpty());
}

TEST_F(Cli, PlotWritesCsvAndSvgOfEveryKind) {
    if (std::system("command -v gnuplot >/dev/null") != 0) GTEST_SKIP() << "gnuplot is not installed";
    for (const std::string kind : {"brdf", "fresnel", "attenuation", "form-factor"}) {
        const Ran ran = run({"plot", kind, "-o", in_folder(kind + ".csv"), "-o", in_folder(kind + ".SVG")});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_THAT(ran.out, IsEmpty());
        EXPECT_TRUE(read_text(in_folder(kind + ".csv")).starts_with("curve,"));
        EXPECT_THAT(read_text(in_folder(kind + ".SVG")), HasSubstr("</svg>"));
    }
}

TEST_F(Cli, PlotRefusesWhatCannotBeDrawn) {
    const Ran ran = run({"plot", "fresnl", "--param", "x", "-o", in_folder("x.pdf")});
    EXPECT_EQ(ran.code, 2);
    for (const char* text : {"did you mean \"fresnel\"?", "\"x\" must be NAME=VALUE", "must end in .svg or .csv"})
        EXPECT_THAT(ran.err, HasSubstr(text));
    EXPECT_EQ(run({"plot"}).code, 2);
    const Ran twice = run({"plot", "fresnel", "-o", in_folder("a.csv"), "-o", in_folder("./a.csv")});
    EXPECT_EQ(twice.code, 2);
    EXPECT_THAT(twice.err, HasSubstr("./a.csv\" is there twice"));
    EXPECT_EQ(run({"plot", "brdf", "--param", "incidence=95"}).code, 2);
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Cli, PlotWithoutGnuplotSaysSo) {
    const Ran ran = run({"plot", "fresnel", "-o", in_folder("f.csv"), "-o", in_folder("f.svg")}, {{"PATH", "/nowhere"}});
    EXPECT_EQ(ran.code, 3);
    EXPECT_THAT(ran.err, HasSubstr("gnuplot"));
    EXPECT_THAT(files(), IsEmpty());
}

} // namespace
} // namespace lightbench::cli
