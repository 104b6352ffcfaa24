// A sweep with a renderer that is made up: what a report says must show what was put in (DESIGN, rule 10), and files must hold all of it.
#include "measure/sweep.h"

#include "measure/analysis.h"
#include "measure/budget.h"
#include "measure/pareto.h"
#include "measure/report_csv.h"
#include "measure/report_json.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ImageF grey(float value) {
    ImageF image{16, 16, std::vector<float>(16 * 16 * 4, value)};
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 1;
    return image;
}

// Of a variant: how much brighter than its reference, and how slow.
struct Made {
    std::string value;
    float share;
    double milliseconds;
};

CostPoint named(const std::string& value) {
    CostPoint point;
    point.value = value, point.image = fmt::format("images/{}.png", value);
    return point;
}

// Times wobble by a percent, as times do.
Swept sweep_made(const std::string& knob_name, const std::vector<Made>& made) {
    const Knob& knob = *find_knob(knob_name);
    CostCurve curve;
    curve.knob = knob_name, curve.metric = "rmse", curve.time_only = knob.time_only;
    for (const Made& m : made) curve.points.push_back(named(m.value));
    unsigned calls = 0;
    const SweepRunner runner{.run =
                                 [&](std::size_t i) {
                                     return Rendering{grey(0.5f * (1 + made[i].share)), made[i].milliseconds * (1 + 0.01 * (calls++ % 5))};
                                 },
                             .take_picture = [](std::size_t, const Rendering&) {},
                             .wall = [] { return 0.0; }};
    return sweep(curve, knob, {grey(0.5f), grey(0.5f)}, runner, {});
}

TEST(Sweep, SeesAnErrorAndASlowdown) {
    const Swept plain = sweep_made("accel", {{"bvh", 0, 10}, {"grid", 0, 10}});
    EXPECT_EQ(plain.broken, 0u);
    EXPECT_THAT(plain.curve.notes, IsEmpty());
    const Swept slow = sweep_made("accel", {{"bvh", 0, 10}, {"grid", 0, 15}});
    const CostPoint &bvh = slow.curve.points[0], &grid = slow.curve.points[1];
    EXPECT_NEAR(grid.device_ms / bvh.device_ms, 1.5, 0.02);
    EXPECT_GT(grid.q1_ms, bvh.q3_ms); // beyond the noise
    EXPECT_TRUE(bvh.pareto.contains("rmse"));
    EXPECT_FALSE(grid.pareto.contains("rmse"));
    const Swept wrong = sweep_made("accel", {{"bvh", 0, 10}, {"grid", 0.02f, 10}});
    EXPECT_EQ(wrong.broken, 1u);
    EXPECT_NEAR(wrong.curve.points[1].errors.at("relative rmse"), 0.02, 1e-6);
    EXPECT_GT(wrong.curve.points[1].errors.at("flip"), 0.005);
    EXPECT_THAT(wrong.curve.notes, ElementsAre(HasSubstr("the picture of grid differs from the reference by 0.01")));
}

TEST(Sweep, FitsSlopesByGroupAndSeesRises) {
    const Swept good = sweep_made("spp", {{"uniform/1", 0.16f, 1},
                                          {"uniform/4", 0.08f, 4},
                                          {"uniform/16", 0.04f, 16},
                                          {"jittered/1", 0.16f, 1},
                                          {"jittered/4", 0.16f / 2.828427f, 4},
                                          {"jittered/16", 0.02f, 16}});
    EXPECT_EQ(good.broken, 0u);
    ASSERT_EQ(good.curve.slopes.size(), 2u);
    EXPECT_EQ(good.curve.slopes[0].of, "jittered");
    EXPECT_NEAR(good.curve.slopes[0].measured, -0.75, 1e-3);
    EXPECT_EQ(good.curve.slopes[0].theory, -0.75);
    EXPECT_NEAR(good.curve.slopes[1].measured, -0.5, 1e-3);
    EXPECT_EQ(good.curve.slopes[1].against, "samples a pixel");
    // One picture of the sweep 2 % off.
    const Swept bad = sweep_made("spp", {{"uniform/1", 0.16f, 1}, {"uniform/4", 0.01f, 4}, {"uniform/16", 0.03f, 16}});
    EXPECT_EQ(bad.broken, 1u);
    EXPECT_THAT(bad.curve.notes, ElementsAre(HasSubstr("from uniform/4 to uniform/16 the rmse rises from 0.005 to 0.015")));
}

TEST(Sweep, SaysWhatItCannotKnow) {
    const Knob& knob = *find_knob("spp");
    CostCurve curve;
    curve.metric = "rmse", curve.points = {named("4")};
    unsigned calls = 0;
    const SweepRunner runner{.run =
                                 [&](std::size_t) {
                                     return Rendering{grey(float(++calls)), double(calls)};
                                 },
                             .take_picture = [](std::size_t, const Rendering&) {},
                             .wall = [] { return 0.0; }};
    const Swept swept = sweep(curve, knob, {grey(0.5f), grey(std::nanf(""))}, runner, {.most = 3});
    EXPECT_FALSE(swept.curve.points[0].settled);
    EXPECT_EQ(swept.curve.points[0].runs, 3u);
    EXPECT_THAT(swept.curve.points[0].note, HasSubstr("its runs gave different pictures"));
    EXPECT_THAT(swept.curve.notes, ElementsAre(HasSubstr("the rmse by which the reference is uncertain is not finite"),
                                               "3 runs are too few to tell how sure a median time is (7 are needed): 4"));
    EXPECT_EQ(swept.broken, 1u);
    const Swept many = sweep(curve, knob, {grey(0.5f), grey(0.5f)}, runner, {.most = 8});
    EXPECT_THAT(many.curve.notes, ElementsAre(HasSubstr("after 8 runs the 95 % interval of the median time is still wider than 5 %")));
    EXPECT_TRUE(std::isinf(swept.curve.reference_error.at("rmse")));
}

TEST(Sweep, SaysThatAKnobChangesNothing) {
    const Swept equal = sweep_made("spp", {{"1", 0, 10}, {"4", 0, 10}, {"16", 0, 20}});
    EXPECT_THAT(equal.curve.notes, ElementsAre("all pictures of this knob are equal in this scene"));
    EXPECT_TRUE(equal.curve.points[1].pareto.contains("rmse"));
    EXPECT_FALSE(equal.curve.points[2].pareto.contains("rmse"));
}

// The sum of one hemi-cube's delta form factors needs no picture; a slope that theory knows of every scene is a promise.
TEST(Sweep, HoldsTheSumOfAHemicubeAgainstTheory) {
    const std::vector<Made> made = {{"16", 0.16f, 1}, {"32", 0.08f, 2}, {"64", 0.04f, 4}, {"128", 0.02f, 8}, {"256", 0.01f, 16}};
    const Swept swept = sweep_made("hemicube", made);
    EXPECT_EQ(swept.broken, 0u);
    ASSERT_EQ(swept.curve.slopes.size(), 2u);
    EXPECT_EQ(swept.curve.slopes[1].metric, "sum");
    EXPECT_NEAR(swept.curve.slopes[1].measured, -2, 0.1);
    EXPECT_EQ(swept.curve.slopes[1].theory, -2);
    Knob wrong = *find_knob("hemicube");
    wrong.computed = [](std::string_view value) { return Errors{{"sum", 1 / std::stod(std::string(value))}}; };
    CostCurve curve = swept.curve;
    curve.slopes.clear(), curve.notes.clear();
    for (CostPoint& point : curve.points)
        point.errors.merge(wrong.computed(point.value)), point.errors["sum"] = wrong.computed(point.value)["sum"];
    EXPECT_EQ(conclude(curve, wrong), 1u);
    EXPECT_THAT(curve.notes, ElementsAre("not as expected: the slope of sum is -1.000, and theory says -2 +- 0.1"));
}

TEST(Sweep, SaysWhyASlopeLeavesPointsOut) {
    Knob knob = *find_knob("spp");
    CostCurve curve;
    curve.metric = "rmse", curve.reference_error = {{"rmse", 0.01}};
    for (const auto& [value, rmse] :
         {std::pair("jittered/1", 0.8), {"jittered/4", 0.6}, {"jittered/9", INFINITY}, {"jittered/16", 0.4}, {"jittered/64", 0.015}}) {
        curve.points.push_back(named(value));
        curve.points.back().errors = {{"rmse", rmse}}, curve.points.back().settled = true;
    }
    EXPECT_EQ(conclude(curve, knob), 1u);
    ASSERT_EQ(curve.slopes.size(), 1u);
    EXPECT_THAT(curve.slopes[0].why,
                HasSubstr("fitted to 3 of 5 points: of 1 the error is below twice the reference's uncertainty, of 1 it "
                          "is not finite"));
    EXPECT_THAT(curve.notes,
                ElementsAre(HasSubstr("the rmse rises from 0.6 to inf"),
                            HasSubstr("the slope (jittered) of rmse is -0.250, and theory says -0.75 +- 0.25: this scene is")));
    EXPECT_THAT(curve.points[4].note, HasSubstr("below twice what the reference is uncertain by"));
}

TEST(Sweep, AStopInTheFirstRoundLeavesNoCurve) {
    CostCurve curve;
    curve.metric = "rmse", curve.points = {named("1"), named("4")};
    int runs = 0;
    const auto swept_until = [&](int most) {
        runs = 0;
        return sweep(curve, *find_knob("spp"), {grey(0.5f), grey(0.5f)},
                     {.run =
                          [&](std::size_t) {
                              return ++runs, Rendering{grey(0.4f), 1};
                          },
                      .take_picture = [](std::size_t, const Rendering&) {},
                      .wall = [] { return 0.0; },
                      .stop = [&, most] { return runs >= most; }},
                     {});
    };
    EXPECT_TRUE(swept_until(2).stopped);
    EXPECT_TRUE(swept_until(4).stopped);
    const Swept some = swept_until(8);
    EXPECT_FALSE(some.stopped);
    EXPECT_EQ(some.curve.points[1].runs, 2u);
}

CostReport full_report() {
    Swept swept = sweep_made("spp", {{"uniform/1", 0.16f, 1}, {"uniform/4", 0.08f, 4}, {"uniform/16", 0.04f, 16}});
    CostCurve& curve = swept.curve;
    curve.meaning = "a \"meaning\"", curve.reference = "how", curve.reference_image = "images/r.png",
    curve.reference_command = "lightbench render";
    curve.slopes[0].theory = -0.5, curve.slopes.push_back({"", "flip", "x", 0.1, std::nullopt, "why"});
    curve.notes = {"a note"};
    curve.points[0].command = "lightbench render x", curve.points[0].note = "n", curve.points[0].options = {{"--spp", "1"}};
    curve.points[1].errors["relative rmse"] = INFINITY;
    mark_fronts(curve.points);
    return {"lightbench 0.1.0", "room.toml", 320, 180, "a device", "its driver", "1.3", "lightbench cost room.toml", {curve}};
}

TEST(CostJson, ReadsBackWhatItWrote) {
    const CostReport report = full_report();
    const std::string json = cost_json(report);
    const CostReport back = read_cost_json(json);
    EXPECT_EQ(cost_json(back), json);
    EXPECT_TRUE(std::isnan(back.curves[0].points[1].errors.at("relative rmse")));
    EXPECT_EQ(back.curves[0].points[0].pareto, report.curves[0].points[0].pareto);
    EXPECT_EQ(back.curves[0].points[2].device_ms, report.curves[0].points[2].device_ms);
    EXPECT_EQ(back.curves[0].slopes[0].theory, -0.5);
    EXPECT_FALSE(back.curves[0].slopes[1].theory);
    EXPECT_EQ(back.curves[0].points[0].options.at("--spp"), "1");
    EXPECT_EQ(back.height, 180u);
}

TEST(CostJson, RefusesWhatItIsNot) {
    EXPECT_THROW(read_cost_json("{"), ReportError);
    EXPECT_THROW(read_cost_json("{}"), ReportError);
    EXPECT_THROW(read_cost_json("[1, 2]"), ReportError);
    std::string json = cost_json(full_report());
    json.replace(json.find("\"points\""), 8, "\"dots\"");
    EXPECT_THROW(read_cost_json(json), ReportError);
}

// Numbers that nothing measures, and fronts that hold what they cannot.
TEST(CostJson, TrustsNothing) {
    const auto wrong = [](const std::function<void(nlohmann::ordered_json&)>& change) {
        nlohmann::ordered_json json = nlohmann::ordered_json::parse(cost_json(full_report()));
        change(json);
        try {
            read_cost_json(json.dump());
        } catch (const ReportError& error) {
            return std::string(error.what());
        }
        return std::string("read");
    };
    const auto point = [](nlohmann::ordered_json& json) -> nlohmann::ordered_json& { return json["curves"][0]["points"][0]; };
    EXPECT_EQ(wrong([](auto&) {}), "read");
    EXPECT_EQ(wrong([&](auto& j) { point(j)["device_ms"] = -5; }),
              "is no report of lightbench cost: device_ms is -5; it must be a time above 0, or null");
    EXPECT_THAT(wrong([&](auto& j) { point(j)["q1_ms"] = 0; }), HasSubstr("q1_ms is 0"));
    EXPECT_THAT(wrong([&](auto& j) { point(j)["runs"] = 1e300; }), HasSubstr("runs is 1e+300"));
    EXPECT_THAT(wrong([&](auto& j) { point(j)["errors"] = {1, 2}; }), HasSubstr("errors is [1,2]; it must be an object"));
    EXPECT_THAT(wrong([&](auto& j) { point(j)["errors"]["rmse"] = -1; }), HasSubstr("rmse is -1"));
    EXPECT_THAT(wrong([](auto& j) { j["width"] = -1; }), HasSubstr("width is -1; it must be a whole number from 1 to"));
    EXPECT_THAT(wrong([](auto& j) { j["height"] = 0; }), HasSubstr("height is 0"));
    EXPECT_THAT(wrong([](auto& j) { j["width"] = 4294967297; }), HasSubstr("width is 4294967297"));
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(cost_json(full_report()));
    for (auto& p : json["curves"][0]["points"]) p["errors"].erase("rmse"), p["pareto"] = {"rmse"};
    const CostReport report = read_cost_json(json.dump());
    EXPECT_EQ(choose(report.curves[0], {.milliseconds = 1e9, .error = {}, .metric = "rmse"}).point, nullptr);
    point(json)["errors"]["rmse"] = nullptr;
    EXPECT_EQ(choose(read_cost_json(json.dump()).curves[0], {.milliseconds = 1e9, .error = {}, .metric = "rmse"}).point, nullptr);
}

TEST(CostCsv, HasALineForEachMetricOfEachPoint) {
    const std::string csv = cost_csv(full_report());
    EXPECT_TRUE(csv.starts_with("knob,value,metric,error,device_ms,q1_ms,q3_ms,runs,pareto,image\n"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 4);
    EXPECT_THAT(csv, HasSubstr("\nspp,uniform/4,rmse,0.04"));
}

} // namespace
} // namespace lightbench
