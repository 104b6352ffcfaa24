// What the plan makes of samples and filters where rays are traced, and where they are not.
#include "plan_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;

Request traced() {
    Request request;
    request.method = Method::raytrace;
    return request;
}

TEST(PlanSampling, OneSampleAPixelNeedsNoSum) {
    const Plan plan = plan_of(lit_sphere(), traced());
    EXPECT_FALSE(plan.runs("accumulate") || plan.runs("filter") || plan.runs("split-cells") || plan.has("sum") || plan.has("lattice"));
    EXPECT_FALSE(plan.runs("film") || plan.has("radiance")) << "what is shown needs no image";
    Request linear = traced();
    linear.output = Output::radiance;
    EXPECT_TRUE(plan_of(lit_sphere(), linear).runs("film"));
}

TEST(PlanSampling, TheGaussianTakesThePlaceOfTheSum) {
    Request request = traced();
    request.filter = Filter::gaussian, request.spp = 4, request.sampling = Sampling::uniform;
    const Plan plan = plan_of(lit_sphere(), request);
    EXPECT_TRUE(plan.runs("filter") && plan.has("samples") && plan.has("sum"));
    EXPECT_FALSE(plan.runs("accumulate") || plan.has("radiance"));
}

TEST(PlanSampling, TheRasteriserKeepsItsBoxAndSaysSo) {
    Request request;
    request.filter = Filter::gaussian;
    const Plan plan = plan_of(lit_sphere(), request);
    EXPECT_FALSE(plan.runs("filter"));
    EXPECT_TRUE(std::ranges::any_of(plan.fallbacks, [](const Line& line) { return line.name == "filter"; }));
}

TEST(PlanSampling, AdaptiveSamplingWorksOnALattice) {
    Request request = traced();
    request.sampling = Sampling::adaptive;
    const Plan plan = plan_of(lit_sphere(), request);
    EXPECT_TRUE(plan.runs("split-cells") && plan.runs("list-points") && plan.runs("lattice-pixels") && plan.has("lattice"));
    EXPECT_FALSE(plan.has("sum") || plan.runs("accumulate"));
    request.max_level = 0;
    EXPECT_FALSE(plan_of(lit_sphere(), request).runs("split-cells"));
}

} // namespace
} // namespace lightbench
