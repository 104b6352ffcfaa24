// The numbers behind `lightbench plot`: known values of each formula, and what is refused.
#include "measure/plot_kinds.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace lightbench {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;
using Arguments = std::vector<std::pair<std::string, std::string>>;

Plot made(const char* kind, const Arguments& arguments = {}) {
    auto result = make_plot(kind, arguments);
    if (const auto* problems = std::get_if<Problems>(&result)) throw std::runtime_error(to_string(problems->front()));
    return std::get<Plot>(result);
}

std::string refused(const char* kind, const Arguments& arguments) {
    auto result = make_plot(kind, arguments);
    std::string text;
    if (const auto* problems = std::get_if<Problems>(&result))
        for (const Problem& problem : *problems) text += to_string(problem) + "\n";
    return text;
}

const PlotLine& line(const Plot& plot, const std::string& start) {
    for (const PlotLine& l : plot.lines)
        if (l.name.starts_with(start)) return l;
    throw std::runtime_error("no line " + start);
}

double at(const PlotLine& line, double x) {
    const glm::dvec2* best = &line.points.front();
    for (const glm::dvec2& p : line.points)
        if (std::abs(p.x - x) < std::abs(best->x - x)) best = &p;
    EXPECT_NEAR(best->x, x, 0.13);
    return best->y;
}

TEST(Plot, FresnelOfGlass) {
    const Plot plot = made("fresnel", {{"index", "1.5"}});
    ASSERT_EQ(plot.lines.size(), 6U);
    for (const char* name : {"index 1.5: mean", "index 1.5: s", "index 1.5: p", "index 1.5, from inside: mean"})
        EXPECT_NEAR(line(plot, name).points.front().y, 0.04, 1e-15) << name;
    for (const PlotLine& l : plot.lines) EXPECT_DOUBLE_EQ(l.points.back().y, 1) << l.name;
    EXPECT_LT(at(line(plot, "index 1.5: p"), 56.25), 1e-5);              // Brewster: atan 1.5 = 56.31 degrees
    EXPECT_LT(at(line(plot, "index 1.5, from inside: p"), 33.75), 1e-5); // and atan 1/1.5 = 33.69
    EXPECT_LT(at(line(plot, "index 1.5, from inside: mean"), 41.75), 1); // critical: asin 1/1.5 = 41.81
    EXPECT_EQ(at(line(plot, "index 1.5, from inside: mean"), 41.875), 1);
    // The sine form at 45 degrees: sin(45 - 28.1255) / sin(45 + 28.1255), squared.
    const double refracted = std::asin(std::sin(pi / 4) / 1.5), s = std::sin(pi / 4 - refracted) / std::sin(pi / 4 + refracted);
    EXPECT_NEAR(at(line(plot, "index 1.5: s"), 45), s * s, 1e-14);
    EXPECT_EQ(made("fresnel", {{"index", "1"}, {"side", "outside"}}).lines[0].points[300].y, 0);
}

TEST(Plot, AttenuationLaws) {
    const Plot plot = made("attenuation", {{"d0", "2"}, {"from", "0.5"}, {"to", "8"}});
    ASSERT_EQ(plot.lines.size(), 3U);
    EXPECT_EQ(plot.lines[0].points[7].y, 1);
    EXPECT_EQ(plot.lines[1].points.front().y, 1 / 2.5);
    EXPECT_NEAR(plot.lines[1].points.back().y, 0.1, 1e-15);
    EXPECT_NEAR(plot.lines[2].points.front().y, 1 / pi, 1e-15);
    EXPECT_NEAR(plot.lines[2].points.back().y, 1 / (256 * pi), 1e-15);
}

TEST(Plot, PhongLobe) {
    const Plot plot = made("brdf", {{"incidence", "30"}, {"shininess", "10"}, {"scale", "none"}});
    const PlotLine& phong = line(plot, "Phong, n = 10: largest 1 at 30");
    EXPECT_GE(phong.points.size(), 721U);
    EXPECT_NEAR(at(phong, 75), std::pow(std::cos(pi / 4), 10), 1e-14);
    EXPECT_EQ(at(phong, -75), 0);
}

// Between the grid's angles, a thousandth of a degree wide: the exponent and the slope are the extremes that may be typed.
TEST(Plot, NarrowLobesAreFound) {
    const Plot plot = made("brdf", {{"incidence", "45.1"}, {"shininess", "1e6"}, {"roughness", "0.001"}, {"scale", "none"}});
    const PlotLine& phong = line(plot, "Phong, n = 1e+06: largest 1 at 45.1");
    double half = 0; // width where it is above a half, degrees: 2 acos(2^(-1/n))
    for (std::size_t i = 1; i < phong.points.size(); ++i)
        if (phong.points[i].y >= 0.5) half += phong.points[i].x - phong.points[i - 1].x;
    EXPECT_NEAR(half, 2 * std::acos(std::pow(0.5, 1e-6)) * 180 / pi, 0.02);
    // At the mirror direction D is 1 / (4 m^2) and G is 1.
    const double c = std::cos(45.1 * pi / 180), eta = 1.5, g = std::sqrt(eta * eta - 1 + c * c), a = (g - c) / (g + c),
                 b = (c * (g + c) - 1) / (c * (g - c) + 1), fresnel = 0.5 * a * a * (1 + b * b);
    EXPECT_NEAR(at(line(plot, "Cook-Torrance, Beckmann"), 45.1) / (fresnel / (4e-6 * c)), 1, 1e-9);
    EXPECT_THAT(line(plot, "Cook-Torrance, Beckmann").name, HasSubstr("at 45.1"));
}

// At normal incidence and view: D F, since G / (N.V) = 1. Beckmann's D is 1 / (4 m^2), and F 0.04.
TEST(Plot, CookTorranceLobes) {
    const Plot plot = made("brdf", {{"incidence", "0"}, {"roughness", "0.4"}, {"index", "1.5"}, {"scale", "none"}});
    EXPECT_NEAR(at(line(plot, "Cook-Torrance, Beckmann"), 0), 0.04 / (4 * 0.16), 1e-12);
    const double dawson =
        0.4 * (1 - 2.0 / 3 * 0.16 + 4.0 / 15 * 0.0256 - 8.0 / 105 * 0.004096 + 16.0 / 945 * 0.00065536); // series of Daw(0.4)
    EXPECT_NEAR(at(line(plot, "Cook-Torrance, Gaussian"), 0), 0.04 / (4 * 0.4 * dawson), 2e-6);
    for (const PlotLine& l : plot.lines)
        for (const glm::dvec2& p : l.points) ASSERT_TRUE(std::isfinite(p.y) && p.y >= 0) << l.name << " at " << p.x;
    const Plot scaled = made("brdf", {{"incidence", "60,89.9"}});
    for (const PlotLine& l : scaled.lines) {
        double largest = 0;
        for (const glm::dvec2& p : l.points) largest = std::max(largest, p.y);
        EXPECT_DOUBLE_EQ(largest, 1) << l.name;
    }
}

// The BRDF D G F / (pi (N.L) (N.V)) is the same both ways, so the factor times N.V / N.L is.
TEST(Plot, CookTorranceIsReciprocal) {
    const auto factor = [](const char* light, double view) {
        const Plot plot = made("brdf", {{"incidence", light}, {"roughness", "0.3"}, {"scale", "none"}});
        return at(line(plot, "Cook-Torrance, Beckmann"), view);
    };
    const double a = 20 * (pi / 180), b = 65 * (pi / 180);
    EXPECT_NEAR(factor("20", 65) / std::cos(a), factor("65", 20) / std::cos(b), 1e-13);
}

double slope(const PlotLine& line) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const glm::dvec2& p : line.points)
        n += 1, x += std::log(p.x), y += std::log(p.y), xx += std::log(p.x) * std::log(p.x), xy += std::log(p.x) * std::log(p.y);
    return (n * xy - x * y) / (n * xx - x * x);
}

TEST(Plot, HemicubeComesNearTheClosedForm) {
    const Plot plot = made("form-factor");
    EXPECT_THAT(plot.lines[0].name, HasSubstr("0.23946")); // Lambert, from the center: 4 (2 x atan(x) / pi / 2), x = 0.5 / sqrt(1.25)
    EXPECT_THAT(plot.lines[1].name, HasSubstr("0.071093"));
    for (const PlotLine& l : plot.lines) {
        EXPECT_NEAR(slope(l), -1, 0.25) << l.name; // rows of pixels that are in or out as a whole
        EXPECT_LT(l.points.back().y, 0.01) << l.name;
    }
    const Plot near = made("form-factor", {{"over", "distance"}, {"resolution", "200"}});
    EXPECT_NEAR(near.lines[0].points.front().y, 1, 0.02);
    EXPECT_EQ(near.lines[0].points.size(), 201U);
    for (std::size_t i = 0; i < 21; ++i) // up to the side: 41 marks against 201 points
        EXPECT_NEAR(near.lines[1].points[i].y / near.lines[0].points[5 * i].y, 1, 0.03) << near.lines[1].points[i].x;
}

TEST(Plot, Csv) {
    const std::string csv = plot_csv(made("attenuation", {{"d0", "1"}}));
    EXPECT_TRUE(csv.starts_with("curve,distance_m,factor\nnone,0.05,1\n"));
    EXPECT_THAT(csv, HasSubstr("\n\"linear, d0 = 1 m\",20,0.047619047619047616\n"));
}

TEST(Plot, EveryProblemIsNamed) {
    EXPECT_EQ(refused("brd", {}), "plot: unknown kind \"brd\"; did you mean \"brdf\"?\n");
    EXPECT_EQ(refused("fresnel", {{"indx", "2"}, {"side", "up"}, {"index", "1,x"}}),
              "plot fresnel: unknown parameter \"indx\"; did you mean \"index\"?\n"
              "plot fresnel: parameter \"side\" is \"up\"; it must be outside or inside or both\n"
              "plot fresnel: parameter \"index\" is \"1,x\"; it must be one to 4 numbers from 0.01 to 1000, with commas between\n");
    EXPECT_THAT(refused("brdf", {{"index", "nan"}}), HasSubstr("it must be a number from 1.0001 to 1000"));
    EXPECT_THAT(refused("brdf", {{"scale", "none"}, {"scale", "none"}}), HasSubstr("given twice"));
    EXPECT_THAT(refused("brdf", {{"incidence", "1,2,3,4,5"}}), HasSubstr("one to 4 numbers"));
    EXPECT_THAT(refused("brdf", {{"incidence", ""}}), HasSubstr("incidence"));
    EXPECT_THAT(refused("attenuation", {{"from", "3"}, {"to", "2"}}), HasSubstr("from must be the smaller one"));
    EXPECT_THAT(refused("form-factor", {{"over", "distance"}, {"resolution", "3.5"}}), HasSubstr("whole number"));
    EXPECT_EQ(refused("form-factor", {{"resolution", "64"}}), "plot form-factor: parameter \"resolution\" belongs to over=distance\n");
    EXPECT_EQ(refused("form-factor", {{"over", "distance"}, {"distance", "3"}, {"largest", "64"}}),
              "plot form-factor: parameter \"distance\" belongs to over=resolution\n"
              "plot form-factor: parameter \"largest\" belongs to over=resolution\n");
    EXPECT_EQ(refused("form-factor", {{"over", "distance"}, {"resolution", "50,49"}}),
              "plot form-factor: parameter \"resolution\" is \"50,49\": two curves would be the same\n");
    EXPECT_THAT(refused("fresnel", {{"index", "1.5,1.50"}}), HasSubstr("two curves would be the same"));
}

} // namespace
} // namespace lightbench
