// --budget and --max-error: what a saved report says fits, and no more than that is taken from it.
#include "program.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

// A front that is known: three points, made up.
class Budget : public Cli {
  protected:
    Budget() {
        const auto point = [](const char* value, double ms, double rmse, bool front) {
            return json{{"value", value},
                        {"errors", {{"rmse", rmse}}},
                        {"device_ms", ms},
                        {"q1_ms", ms},
                        {"q3_ms", ms},
                        {"runs", 9},
                        {"settled", true},
                        {"pareto", front ? json{"rmse"} : json::array()},
                        {"image", ""},
                        {"command", ""},
                        {"options", {{"--seed", "7"}}},
                        {"note", ""}};
        };
        const json curve = {{"knob", "spp"},
                            {"meaning", ""},
                            {"metric", "rmse"},
                            {"time_only", false},
                            {"reference", {{"how", ""}, {"image", ""}, {"command", ""}, {"error", json::object()}}},
                            {"points",
                             {point("uniform/1", 10, 0.3, true), point("jittered/4", 20, 0.1, true), point("uniform/4", 30, 0.2, false),
                              point("jittered/16", 40, 0.02, true)}},
                            {"slopes", json::array()},
                            {"notes", json::array()}};
        const json report = {{"program", "lightbench"},
                             {"scene", in_folder("scene.toml")},
                             {"width", 64},
                             {"height", 48},
                             {"device", {{"name", "another"}, {"driver", "x"}, {"version", "1"}}},
                             {"command", ""},
                             {"curves", {curve}}};
        write_text(in_folder("cost.json"), report.dump());
    }
    Ran render(std::vector<std::string> more) const {
        std::vector<std::string> arguments = {"render", scene(kBall), "-o", in_folder("x.png")};
        if (std::ranges::find(more, "--size") == more.end()) more.insert(more.end(), {"--size", "64x48"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    Ran choose(std::vector<std::string> more) const {
        more.insert(more.end(), {"--cost", in_folder("cost.json")});
        return render(more);
    }
};

TEST_F(Budget, PicksWhatTheFrontSays) {
    const Ran time = choose({"--budget", "25ms"});
    ASSERT_EQ(time.code, 0) << time.err;
    EXPECT_THAT(time.err,
                HasSubstr("spp=jittered/4, 20 ms (20 to 20), rmse 0.1: the most accurate of the 3 points on the front that fit 25 ms"));
    EXPECT_THAT(time.err, HasSubstr("it was measured on another (1), and this is"));
    const std::string picture = read_text(in_folder("x.png"));
    ASSERT_EQ(render({"--sampling", "jittered", "--spp", "4"}).code, 0);
    EXPECT_EQ(read_text(in_folder("x.png")), picture);
    EXPECT_THAT(choose({"--max-error", "0.1"}).err, HasSubstr("spp=jittered/4"));
    EXPECT_THAT(choose({"--max-error", "0.05", "--budget", "0.04s"}).err, HasSubstr("spp=jittered/16"));
    EXPECT_THAT(choose({"--budget", "45", "--size", "128x48"}).err, HasSubstr("spp=jittered/4, 40 ms")); // twice the pixels
    EXPECT_THAT(choose({"--budget", "45", "--size", "128x96", "--crop", "0,0,64,24"}).err, HasSubstr("spp=jittered/16, 20 ms")); // half
}

// Without --size the picture is as large as the scene says: 64x48.
TEST_F(Budget, ScalesToTheSizeOfTheScene) {
    json report = json::parse(read_text(in_folder("cost.json")));
    report["width"] = 32;
    write_text(in_folder("cost.json"), report.dump());
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.png"), "--budget", "45", "--cost", in_folder("cost.json")});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("spp=jittered/4, 40 ms"));
    EXPECT_THAT(ran.err, HasSubstr("a first run takes longer"));
}

// A report sets how a picture is made: not which files are opened, and nothing that no sweep has.
TEST_F(Budget, TakesFromAReportWhatASweepSets) {
    json report = json::parse(read_text(in_folder("cost.json")));
    const auto with = [&](const json& options) {
        report["curves"][0]["points"][1]["options"] = options;
        write_text(in_folder("cost.json"), report.dump());
        return choose({"--budget", "25ms"});
    };
    const Ran shader = with({{"--shader", "/etc/passwd"}, {"--method", "raytrace"}});
    EXPECT_EQ(shader.code, 0) << shader.err;
    EXPECT_THAT(shader.err, HasSubstr("it was measured with another --sampling, --shader, --spp"));
    EXPECT_THAT(shader.err, HasSubstr("as measured: --method raytrace"));
    const Ran unknown = with({{"--colour", "red"}});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("the point jittered/4 has the option \"--colour\", which no sweep has"));
}

TEST_F(Budget, SaysWhatItReplacesAndWhatDiffers) {
    const Ran ran = choose({"--budget", "25ms", "--spp", "16", "--camera", "front", "--exposure", "1"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("--spp 16 is what the knob turns: jittered/4 takes its place"));
    EXPECT_THAT(ran.err, HasSubstr("it was measured with another --camera, --exposure"));
}

TEST_F(Budget, OffersTheNearestWhereNothingFits) {
    const Ran fast = choose({"--budget", "5ms"});
    EXPECT_EQ(fast.code, 2);
    EXPECT_THAT(fast.err, HasSubstr("fits 5 ms; the nearest is spp=uniform/1, 10 ms (10 to 10), rmse 0.3"));
    const Ran near = choose({"--max-error", "0.001"});
    EXPECT_EQ(near.code, 2);
    EXPECT_THAT(near.err, HasSubstr("--max-error: nothing in"));
    EXPECT_FALSE(fs::exists(in_folder("x.png")));
}

TEST_F(Budget, MistakesAreNamed) {
    EXPECT_THAT(render({"--budget", "5ms"}).err, HasSubstr("--cost: is missing"));
    EXPECT_THAT(render({"--cost", "x"}).err, HasSubstr("--cost: belongs to --budget or --max-error"));
    EXPECT_THAT(choose({"--budget", "fast"}).err, HasSubstr("--budget: \"fast\" must be a time, like 50ms"));
    EXPECT_THAT(choose({"--budget", ""}).err, HasSubstr("--budget: \"\" must be a time, like 50ms"));
    EXPECT_THAT(choose({"--budget", "5ms", "--knob", "sp"}).err, HasSubstr("did you mean \"spp\"?"));
    EXPECT_THAT(choose({"--budget", "25ms", "--metric", "flip"}).err, HasSubstr("no point of spp"));
    write_text(in_folder("cost.json"), "{}");
    const Ran wrong = choose({"--budget", "5ms"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("is no report of lightbench cost"));
}

} // namespace
} // namespace lightbench::cli
