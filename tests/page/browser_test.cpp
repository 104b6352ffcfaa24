// The report's page in headless Chromium: without a network and without a complaint it shows, compares and sorts, by mouse and by keys.
// LIGHTBENCH_PAGE_SHOTS=FOLDER keeps screenshots.
#include "browser.h"
#include "image/files.h"
#include "measure/report_html.h"
#include "sample_report.h"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <unistd.h>

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Page : public ::testing::Test {
  protected:
    void SetUp() override {
        const std::string program = find_chromium();
        if (program.empty()) GTEST_SKIP() << "chromium is not installed";
        std::string name = (fs::temp_directory_path() / "lightbench-report-XXXXXX").string();
        if (!::mkdtemp(name.data())) FAIL() << "no temporary folder";
        folder = name;
        browser = std::make_unique<Browser>(program, 1280, 900);
    }
    void TearDown() override {
        browser.reset();
        if (!folder.empty()) fs::remove_all(folder);
    }
    void open(const CostReport& report) {
        write_sample_pictures(sample_report(), folder);
        std::ofstream(folder / "report.html", std::ios::binary) << report_html(report, folder);
        fs::remove_all(folder / "images"); // the page stands alone
        browser->open(folder / "report.html");
        ASSERT_TRUE(
            browser->becomes_true("document.querySelectorAll('.chart svg').length === document.querySelectorAll('section').length"));
    }
    // The middle of an element in the window, which it is scrolled into.
    std::pair<double, double> middle(const std::string& selector) {
        const auto box =
            browser->evaluate(fmt::format("(() => {{ const e = document.querySelector(`{}`); e.scrollIntoView({{block: 'center'}}); "
                                          "const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()",
                                          selector));
        return {box[0], box[1]};
    }
    void click(const std::string& selector) {
        const auto [x, y] = middle(selector);
        browser->click(x, y);
    }
    bool shown(const std::string& image, int picture) {
        return browser->becomes_true(
            fmt::format("(() => {{ const i = document.querySelector('#curve-0 .stage {}'); return !i.hidden && i.complete && "
                        "i.naturalWidth === 64 && i.src === report.pictures[{}]; }})()",
                        image, picture));
    }
    // Of every fourth pixel, in the middle of the square that it is enlarged to.
    void expect_difference(const std::string& left, const std::string& right, int gain) {
        write_sample_pictures(sample_report(), folder);
        const Image8 a = picture_file(folder / left), b = picture_file(folder / right);
        const auto box = browser->evaluate(
            "(() => { const b = document.querySelector('#curve-0 .pair').getBoundingClientRect(); return [b.x, b.y, b.width]; })()");
        browser->screenshot(folder / "seen.png");
        const Image8 seen = picture_file(folder / "seen.png");
        const double x = box[0], y = box[1], size = box[2].get<double>() / a.width;
        for (unsigned j = 18; j < a.height; j += 4) // below the names
            for (unsigned i = 2; i < a.width; i += 4) {
                const auto at =
                    static_cast<std::size_t>(y + (j + 0.5) * size) * seen.width + static_cast<std::size_t>(x + (i + 0.5) * size);
                for (unsigned c = 0; c < 3; ++c) {
                    const std::size_t k = 4 * (std::size_t{j} * a.width + i) + c;
                    EXPECT_NEAR(seen.rgba[4 * at + c], std::min(255, gain * std::abs(a.rgba[k] - b.rgba[k])), 2)
                        << i << " " << j << " " << c;
                }
            }
    }
    static Image8 picture_file(const fs::path& file) { return std::get<Image8>(read_image(file.string())); }
    int picture_of(int point) { return browser->evaluate(fmt::format("report.curves[0].points[{}].picture", point)); }
    void keep(const char* name) {
        if (const char* shots = std::getenv("LIGHTBENCH_PAGE_SHOTS")) browser->screenshot(fs::path(shots) / (std::string(name) + ".png"));
    }
    void expect_no_complaints() {
        EXPECT_THAT(browser->requests, ElementsAre("file://" + (folder / "report.html").string()));
        EXPECT_THAT(browser->complaints, IsEmpty());
    }

    fs::path folder;
    std::unique_ptr<Browser> browser;
};

TEST_F(Page, LoadsAloneAndShowsThePictureUnderTheMouse) {
    open(sample_report());
    EXPECT_TRUE(shown("img.under", browser->evaluate("report.curves[0].reference.picture"))); // at rest
    const auto [x, y] = middle("#curve-0 .dot[data-index='6'] .target");
    browser->mouse("mouseMoved", x, y);
    EXPECT_TRUE(shown("img.under", picture_of(6)));
    EXPECT_TRUE(browser->becomes_true("document.querySelector('#curve-0 figcaption').textContent.startsWith('jittered/64: ')"));
    keep("hover");
    browser->mouse("mouseMoved", 2, 2);
    EXPECT_TRUE(shown("img.under", browser->evaluate("report.curves[0].reference.picture")));
    expect_no_complaints();
}

TEST_F(Page, TwoChosenPointsAreComparedWithASeam) {
    open(sample_report());
    click("#curve-0 .dot[data-index='0'] .target");
    click("#curve-0 .dot[data-index='6'] .target");
    EXPECT_TRUE(shown("img.under", picture_of(0)));
    EXPECT_TRUE(shown("img.over", picture_of(6)));
    const std::string cut = "getComputedStyle(document.querySelector('#curve-0 .stage img.over')).clipPath";
    EXPECT_EQ(browser->evaluate(cut), "inset(0px 0px 0px 50%)");
    const auto box = browser->evaluate(
        "(() => { const b = document.querySelector('#curve-0 .stage').getBoundingClientRect(); return [b.x, b.y, b.width]; })()");
    const double x = box[0], y = box[1], width = box[2];
    browser->mouse("mousePressed", x + width / 2, y + 30, true);
    browser->mouse("mouseMoved", x + width / 4, y + 30, true);
    browser->mouse("mouseReleased", x + width / 4, y + 30, true);
    EXPECT_TRUE(browser->becomes_true(cut + " === 'inset(0px 0px 0px 25%)'"));
    browser->evaluate("document.querySelector('#curve-0 input[type=range]').focus()");
    browser->key("ArrowRight");
    EXPECT_TRUE(browser->becomes_true(cut + " === 'inset(0px 0px 0px 25.5%)'"));
    keep("seam");
    expect_no_complaints();
}

TEST_F(Page, WhereTwoChosenPointsDifferIsShown) {
    open(sample_report());
    click("#curve-0 .dot[data-index='0'] .target");
    click("#curve-0 .dot[data-index='6'] .target");
    EXPECT_TRUE(shown("img.under", picture_of(0)) && shown("img.over", picture_of(6)));
    click("#curve-0 .difference button");
    EXPECT_TRUE(browser->becomes_true("document.querySelector('#curve-0 .difference output').textContent === '8 times'"));
    EXPECT_TRUE(browser->evaluate("document.querySelector('#curve-0 .seam').hidden"));
    keep("difference");
    browser->evaluate("document.querySelector('#curve-0 input.gain').focus()");
    for (int i = 0; i < 2; ++i) browser->key("ArrowLeft");
    EXPECT_TRUE(browser->becomes_true("document.querySelector('#curve-0 .difference output').textContent === '2 times'"));
    expect_difference(sample_report().curves[0].points[0].image, sample_report().curves[0].points[6].image, 2);
    click("#curve-0 .difference button");
    EXPECT_FALSE(browser->evaluate("document.querySelector('#curve-0 .seam').hidden"));
    EXPECT_EQ(browser->evaluate("getComputedStyle(document.querySelector('#curve-0 .pair')).filter"), "none");
    expect_no_complaints();
}

TEST_F(Page, PointsAreReachedAndChosenByKeys) {
    open(sample_report());
    browser->evaluate("document.querySelector('#curve-0 .dot').focus()");
    EXPECT_TRUE(shown("img.under", picture_of(0)));
    browser->key("Enter");
    browser->key("Tab");
    browser->key("Enter");
    EXPECT_TRUE(browser->becomes_true("document.querySelectorAll(\"#curve-0 .dot[aria-pressed='true']\").length === 2"));
    browser->key("Escape");
    EXPECT_TRUE(browser->becomes_true("document.querySelectorAll(\"#curve-0 .dot[aria-pressed='true']\").length === 0"));
    expect_no_complaints();
}

TEST_F(Page, SortsItsTablesAndChangesTheMetric) {
    open(sample_report());
    const std::string times =
        "Array.from(document.querySelectorAll('#curve-0 table.sortable tbody tr')).map(r => Number(r.cells[5].dataset.sort))";
    click("#curve-0 table.sortable th:nth-child(6) button");
    EXPECT_TRUE(browser->evaluate(times + ".every((t, i, all) => i === 0 || all[i - 1] <= t)"));
    click("#curve-0 table.sortable th:nth-child(6) button");
    EXPECT_TRUE(browser->evaluate(times + ".every((t, i, all) => i === 0 || all[i - 1] >= t)"));
    EXPECT_EQ(browser->evaluate("document.querySelector('#curve-0 th[aria-sort]').getAttribute('aria-sort')"), "descending");
    browser->evaluate(
        "(() => { const s = document.querySelector('#curve-0 select'); s.value = 'flip'; s.dispatchEvent(new Event('change')); })()");
    EXPECT_TRUE(browser->becomes_true("document.querySelector('#curve-0 .chart svg').textContent.includes('flip (mean, 0 to 1)')"));
    expect_no_complaints();
}

TEST_F(Page, FitsANarrowWindow) {
    browser->resize(420, 900);
    open(sample_report());
    EXPECT_EQ(browser->evaluate("document.documentElement.scrollWidth"), 420);
    keep("narrow");
    expect_no_complaints();
}

TEST_F(Page, APointWithoutAFiniteErrorIsSaidToBeMissing) {
    CostReport report = sample_report();
    report.curves[0].points[2].errors["rmse"] = std::numeric_limits<double>::infinity();
    open(report);
    EXPECT_EQ(browser->evaluate("document.querySelector('#curve-0 .missing').textContent"),
              "not drawn: 1 of 10 points, without a finite rmse");
    EXPECT_EQ(browser->evaluate("document.querySelectorAll('.missing').length"), 1);
    expect_no_complaints();
}

TEST_F(Page, IsDarkWhereThatIsPreferred) {
    browser->prefer_dark();
    open(sample_report());
    EXPECT_EQ(browser->evaluate("getComputedStyle(document.body).backgroundColor"), "rgb(23, 23, 26)");
    middle("#curve-2 .chart");
    keep("dark");
    expect_no_complaints();
}

TEST_F(Page, TextOfTheDataDoesNoHarm) {
    open(hostile_report());
    EXPECT_EQ(browser->evaluate("window.hurt === undefined"), true);
    EXPECT_EQ(browser->evaluate("document.querySelectorAll('section img[src=x], script').length"), 3); // the page's own three scripts
    EXPECT_EQ(browser->evaluate("report.curves[0].points[0].value.startsWith('</script><script>')"), true);
    keep("hostile");
    expect_no_complaints();
}

// The test of the test: what the other tests must not see is seen.
TEST_F(Page, AComplaintOrARequestWouldBeSeen) {
    std::ofstream(folder / "bad.html") << "<img src='http://example.org/a.png'><script>throw new Error('on purpose')</script>";
    browser->open(folder / "bad.html");
    EXPECT_EQ(browser->requests.size(), 2U);
    EXPECT_FALSE(browser->complaints.empty());
}

} // namespace
} // namespace lightbench
