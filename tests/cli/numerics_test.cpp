// lightbench numerics: every row in the table and in JSON, exit codes.
#include "program.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

using testing::AllOf, testing::HasSubstr;

TEST_F(Cli, NumericsPrintsEveryFunctionAndHolds) {
    const Ran ran = run({"numerics", "--quick"});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("function"), HasSubstr("domain"), HasSubstr("bound"), HasSubstr("where")));
    for (const char* function : {"phong_specular",
                                 "lambert",
                                 "power_one_minus",
                                 "exp_negative",
                                 "log_one_minus",
                                 "attenuation_linear",
                                 "attenuation_inverse_square",
                                 "spot_falloff",
                                 "safe_normalize",
                                 "safe_length",
                                 "fast_normalize",
                                 "fresnel",
                                 "fresnel_dense",
                                 "cook_torrance_gaussian",
                                 "cook_torrance_beckmann",
                                 "refracted_direction",
                                 "mirror_direction",
                                 "ray_sphere",
                                 "near_sphere",
                                 "ray_triangle",
                                 "ray_cube",
                                 "slab",
                                 "ray_cone",
                                 "ray_torus",
                                 "offset_origin",
                                 "map_spherical",
                                 "gradient_noise",
                                 "perturb_normal",
                                 "sample_bilinear",
                                 "sample_trilinear",
                                 "srgb_encode",
                                 "quantize8",
                                 "sum_add",
                                 "point_to_quad",
                                 "random_unit4",
                                 "filter_gaussian"})
        EXPECT_THAT(ran.out, HasSubstr("\n" + std::string(function)));
    EXPECT_THAT(ran.out, HasSubstr(" bounds hold, over "));
}

TEST_F(Cli, NumericsInJson) {
    const Ran ran = run({"numerics", "--quick", "--only", "lib/phong", "--json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto report = nlohmann::json::parse(ran.out);
    EXPECT_TRUE(report.at("holds").get<bool>());
    ASSERT_EQ(report.at("rows").size(), 3u);
    for (const auto& row : report.at("rows")) {
        EXPECT_EQ(row.at("file"), "lib/phong.glsl");
        EXPECT_GT(row.at("inputs").get<int>(), 1000);
        EXPECT_GT(row.at("share").get<double>(), 0);
        EXPECT_LE(row.at("share").get<double>(), 1);
        EXPECT_GT(row.at("error").get<double>(), 0);
        EXPECT_FALSE(row.at("where").empty());
    }
}

TEST_F(Cli, NumericsOfPairs) {
    const Ran text = run({"numerics", "--pairs", "--quick", "--only", "Fresnel"}),
              ran = run({"numerics", "--pairs", "--quick", "--only", "Fresnel", "--json"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_THAT(text.out, AllOf(HasSubstr("\nFresnel: stable "), HasSubstr("\nFresnel: naive "), HasSubstr("ns a call")));
    const auto report = nlohmann::json::parse(ran.out);
    ASSERT_EQ(report.at("pairs").size(), 1u);
    const auto& forms = report.at("pairs")[0].at("forms");
    ASSERT_EQ(forms.size(), 3u);
    EXPECT_LT(forms[0].at("relative").get<double>(), 1e-6);
    EXPECT_GT(forms[1].at("relative").get<double>(), 1e-4);
    EXPECT_EQ(run({"numerics", "--pairs", "--only", "nonsense"}).code, 2);
}

TEST_F(Cli, NumericsOfNothingIsRefused) {
    const Ran ran = run({"numerics", "--only", "nonsense"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "--only: no function or file contains \"nonsense\"; right would be one like phong_specular or lib/ray\n");
}

} // namespace
} // namespace lightbench::cli
