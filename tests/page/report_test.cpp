// What is written of a report, without a browser: escapes, data, the page's independence, plots.
#include "measure/page.h"
#include "measure/report_data.h"
#include "measure/report_html.h"
#include "measure/report_plots.h"
#include "measure/report_svg.h"
#include "measure/sweep.h"
#include "measure/text.h"
#include "sample_report.h"

#include "gpu/errors.h"
#include "image/file_bytes.h"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <unistd.h>

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Report : public ::testing::Test {
  protected:
    Report() {
        std::string name = (fs::temp_directory_path() / "lightbench-report-XXXXXX").string();
        folder = ::mkdtemp(name.data());
        write_sample_pictures(sample_report(), folder);
    }
    ~Report() override { fs::remove_all(folder); }
    std::set<std::string> plots() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".svg") names.insert(entry.path().filename());
        return names;
    }
    std::string text_of(const std::string& name) const {
        const std::vector<unsigned char> bytes = read_file((folder / name).string());
        return {bytes.begin(), bytes.end()};
    }
    fs::path folder;
};

TEST(Text, IsHarmlessWhereItIsPut) {
    EXPECT_EQ(printable("a\tb\n\x01"), "a b  ");
    EXPECT_EQ(printable("\u00e9\u2026\U0001f600"), "\u00e9\u2026\U0001f600");
    EXPECT_EQ(printable("\xff\xc0\xaf\xed\xa0\x80\xf4\x90\x80\x80\xe2\x82"),
              std::string(12, '?')); // no start, overlong, surrogate, beyond, cut off
    EXPECT_EQ(html_escaped("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
    EXPECT_EQ(gnuplot_quoted("it's `rm`\n@x"), "'it''s `rm` @x'");
    EXPECT_EQ(file_word("cook-torrance/2 ../x"), "cook-torrance-2-x");
    EXPECT_EQ(file_word(""), "-");
}

// RFC 4648, section 10.
TEST(Text, Base64) {
    const std::pair<const char*, const char*> vectors[] = {{"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
                                                           {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [plain, coded] : vectors) EXPECT_EQ(base64(plain), coded);
    EXPECT_EQ(base64("\xff\xef\xbe"), "/+++");
}

TEST_F(Report, DataIsJsonAndHoldsEachPictureOnce) {
    const nlohmann::json data = nlohmann::json::parse(report_data(sample_report(), folder));
    ASSERT_EQ(data["curves"].size(), 3U);
    EXPECT_EQ(data["pictures"].size(), 12U); // 10 points and a reference of the first curve, one picture for all of the second
    EXPECT_EQ(data["curves"][1]["points"][0]["picture"], data["curves"][1]["points"][6]["picture"]);
    EXPECT_TRUE(data["curves"][2]["points"][0]["picture"].is_null());
    EXPECT_EQ(data["curves"][0]["metrics"][0], "rmse");
    EXPECT_EQ(data["curves"][0]["points"][1]["note"], sample_report().curves[0].points[1].note);
}

TEST_F(Report, PageNeedsNothingElse) {
    const std::string page = report_html(sample_report(), folder);
    EXPECT_FALSE(page_part("d3.min.js").empty());
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_FALSE(std::regex_search(page.substr(0, page.find("<script")), std::regex(R"((src|href)\s*=\s*["']?(https?:|//|file:))")));
    EXPECT_THAT(page, Not(HasSubstr("@import")));
    EXPECT_THAT(page, Not(HasSubstr("{{")));
    for (const char* text :
         {"llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6", "assets/scenes/default.toml", "1024 jittered samples a pixel", "rmse 0.00031",
          "-0.720", "Consequences of stratified sampling", "is still wider than 5 % of it both ways: jittered/256", "2 notes",
          "uniform/4: rmse is larger than that of none", "lightbench cost assets/scenes/default.toml --size 320x180", "octree/leaf=16"})
        EXPECT_THAT(page, HasSubstr(text));
}

TEST_F(Report, HostileTextStaysText) {
    const std::string page = report_html(hostile_report(), folder);
    EXPECT_THAT(page, Not(HasSubstr("<script>window.hurt")));
    EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
    const std::size_t start = page.find("id=\"report\">") + 12;
    const nlohmann::json data = nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
    EXPECT_THAT(data["curves"][0]["points"][0]["value"].get<std::string>(), HasSubstr("</script><script>window.hurt=1</script>"));
}

TEST_F(Report, AMissingPictureIsSaid) {
    fs::remove(folder / "images/accel.png");
    EXPECT_THROW(report_html(sample_report(), folder), FileError);
    write_file((folder / "images/accel.png").string(), "GIF89a");
    EXPECT_THROW(report_html(sample_report(), folder), FileError);
}

// Elements open and close in order, and no "&" or "<" stands bare.
void expect_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    const std::regex tag(R"(<(/?)([A-Za-z][\w:-]*)([^<>]*?)(/?)>)"), entity("&(?!(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9a-f]+);)");
    for (std::sregex_iterator at(svg.begin(), svg.end(), tag), end; at != end; ++at) {
        if ((*at)[4].length()) continue;
        if (!(*at)[1].length()) {
            open.push_back((*at)[2]);
            continue;
        }
        ASSERT_FALSE(open.empty());
        ASSERT_EQ(open.back(), (*at)[2].str());
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
    EXPECT_FALSE(std::regex_search(svg, entity));
    EXPECT_EQ(printable(std::regex_replace(svg, std::regex("[\n\t]"), " ")).find('\x01'), std::string::npos);
}

bool no_gnuplot() {
    return std::system("command -v gnuplot >/dev/null") != 0;
}

// The knob "accel" with a renderer that is made up: pictures of `grid` brighter by `share`, its times `slower`.
CostReport injected_report(float share, double slower) {
    const auto grey = [](float value) { return ImageF{16, 16, std::vector<float>(16 * 16 * 4, value)}; };
    CostReport report = sample_report();
    CostCurve curve = report.curves[1];
    curve.points.resize(2), curve.points[1].value = "grid";
    unsigned calls = 0;
    const SweepRunner runner{.run =
                                 [&](std::size_t i) {
                                     const double wobble = 1 + 0.01 * (calls++ % 3);
                                     return Rendering{grey(i == 1 ? 0.5f * (1 + share) : 0.5f), (i == 1 ? slower : 1) * 10 * wobble};
                                 },
                             .take_picture = [](std::size_t, const Rendering&) {},
                             .wall = [] { return 0.0; }};
    report.curves = {sweep(curve, *find_knob("accel"), {grey(0.5f), grey(0.5f)}, runner, {}).curve};
    return report;
}

// Of a row of the table: whether it is marked as the best.
bool is_best(const std::string& page, const std::string& value) {
    const std::size_t name = page.find(">" + value + "</th>"), row = page.rfind("<tr", name);
    EXPECT_NE(name, std::string::npos) << value;
    return page.substr(row, name - row).find("class=\"best\"") != std::string::npos;
}

// The test of the test: a slowdown by half and an error of 2 % are seen by who reads the page or looks at the plot.
TEST_F(Report, ShowsAnInjectedSlowdownAndError) {
    const CostReport plain = injected_report(0, 1), slow = injected_report(0, 1.5), wrong = injected_report(0.02f, 1);
    EXPECT_TRUE(is_best(report_html(plain, folder), "bvh") && is_best(report_html(plain, folder), "grid"));
    const std::string page = report_html(slow, folder);
    EXPECT_TRUE(is_best(page, "bvh") && !is_best(page, "grid"));
    EXPECT_THAT(page, HasSubstr("15.15</td>"));
    const std::string told = report_html(wrong, folder);
    EXPECT_THAT(told, HasSubstr("not as expected: the picture of grid differs from the reference by 0.01"));
    EXPECT_THAT(told, HasSubstr("1 note"));
    EXPECT_THAT(report_html(plain, folder), Not(HasSubstr("not as expected")));
    if (no_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_THAT(time_plot(plain, plain.curves[0]), AllOf(HasSubstr("the pictures are equal"), Not(HasSubstr("dominated"))));
    EXPECT_THAT(time_plot(slow, slow.curves[0]), HasSubstr("dominated"));
    EXPECT_THAT(time_plot(wrong, wrong.curves[0]), HasSubstr("NOT ALL PICTURES ARE EQUAL"));
}

// One run shows no noise: a bar of no width would look like a sure time.
TEST_F(Report, OneRunHasNoBar) {
    if (no_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    CostReport report = sample_report();
    const auto bars = [&] {
        const std::string svg = cost_plot(report, report.curves[0], "rmse");
        return svg.size();
    };
    const std::size_t with = bars();
    for (CostPoint& point : report.curves[0].points) point.runs = 1;
    EXPECT_LT(bars(), with);
}

TEST_F(Report, PlotsAreDrawn) {
    if (no_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    CostReport report = sample_report();
    report.curves.push_back(report.curves[2]);
    write_cost_plots(report, folder);
    EXPECT_EQ(plots(),
              (std::set<std::string>{"spp-rmse.svg", "spp-flip.svg", "accel-time.svg", "stable-relative.svg", "stable-relative-2.svg"}));
    const std::string svg = text_of("spp-rmse.svg");
    expect_well_formed(svg);
    for (const char* text : {"spp (samples a pixel): rmse against time", "reference: 1024 jittered", "rmse (linear light)", "Pareto front",
                             ">jittered/16<", " in ms "})
        EXPECT_THAT(svg, HasSubstr(text));
    EXPECT_THAT(text_of("stable-relative.svg"), HasSubstr("the error is 0"));
}

TEST_F(Report, PlotsOfHostileTextDoNoHarm) {
    if (no_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    write_cost_plots(hostile_report(), folder);
    EXPECT_EQ(plots().size(), 4U);
    for (const std::string& name : plots()) expect_well_formed(text_of(name));
    EXPECT_FALSE(fs::exists("hurt"));
}

TEST_F(Report, PlotsOfLittleOrOddData) {
    if (no_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    CostReport report = sample_report();
    CostCurve& curve = report.curves[0];
    const auto drawn = [&] { return cost_plot(report, curve, "rmse"); };
    curve.points.resize(1);
    expect_well_formed(drawn());
    curve.points[0].errors["rmse"] = 0, curve.points[0].device_ms = curve.points[0].q1_ms = curve.points[0].q3_ms = 0;
    expect_well_formed(drawn());
    curve.points[0].errors["rmse"] = std::nan("");
    EXPECT_THAT(drawn(), HasSubstr("not drawn: 1 of 1 points"));
    curve.points.clear();
    expect_well_formed(drawn());
    expect_well_formed(time_plot(report, curve));
}

TEST_F(Report, WithoutGnuplotThereIsASentence) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    std::string said;
    try {
        write_cost_plots(sample_report(), folder);
    } catch (const gpu::EnvironmentError& error) {
        said = error.what();
    }
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(said, HasSubstr("gnuplot"));
    EXPECT_TRUE(plots().empty());
}

} // namespace
} // namespace lightbench
