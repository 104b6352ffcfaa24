// Finds the golden that a picture is held against, judges, and keeps what failed; all that cannot be read is a failed verdict.
#include "images/golden.h"
#include "image/compare.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <optional>
#include <stdexcept>
#include <toml++/toml.h>

namespace fs = std::filesystem;

namespace lightbench {
namespace {

double required_number(const toml::table& table, const char* key) {
    auto value = table[key].value<double>();
    if (!value || !(*value >= 0)) throw std::runtime_error(fmt::format("tolerance.toml: {} must be a number of at least 0", key));
    return *value;
}

// Strict: a tolerance that is misspelt would be a gate that stands open.
Tolerance read_tolerance(const fs::path& file) {
    toml::table table = toml::parse_file(file.string());
    auto pinned = table["pinned"].value<std::string>();
    if (!pinned || table.size() != 5)
        throw std::runtime_error("tolerance.toml: pinned, max_channel, fraction, flip_mean, flip_p99, no more");
    return {.pinned = *pinned,
            .max_channel = static_cast<unsigned>(required_number(table, "max_channel")),
            .fraction = required_number(table, "fraction"),
            .flip_mean = required_number(table, "flip_mean"),
            .flip_p99 = required_number(table, "flip_p99")};
}

void write_tolerance(const fs::path& file, const Tolerance& t) {
    write_file(file.string(), fmt::format("pinned = \"{}\" # whose picture stands for drivers that have none of their own\n"
                                          "max_channel = {} # 255ths; a pixel is off when a channel differs by more\n"
                                          "fraction = {} # of the pixels that may be off\n"
                                          "flip_mean = {} # for other drivers\n"
                                          "flip_p99 = {}\n",
                                          t.pinned, t.max_channel, t.fraction, t.flip_mean, t.flip_p99));
}

Image8 read_golden(const fs::path& file) {
    return std::get<Image8>(read_image(file.string()));
}

// Leaves the picture and its difference where a person can open them; returns a note of where.
std::string keep_failure(const GoldenStore& store, const std::string& name, const Image8& golden, const Image8& image) {
    fs::path folder = store.failures / name;
    fs::create_directories(folder);
    write_png((folder / "rendered.png").string(), image);
    if (golden.width == image.width && golden.height == image.height)
        write_png((folder / "difference.png").string(), difference_picture(flip(golden, image)));
    return fmt::format("; pictures in {}", folder.string());
}

struct Found {
    Image8 picture;
    bool own; // drawn by the same driver
};

std::optional<Found> find_golden(const fs::path& folder, const std::string& key) {
    fs::path own = folder / (key + ".png");
    if (fs::exists(own)) return Found{.picture = read_golden(own), .own = true};
    if (!fs::exists(folder / "tolerance.toml")) return {};
    return Found{.picture = read_golden(folder / (read_tolerance(folder / "tolerance.toml").pinned + ".png")), .own = false};
}

Verdict update(const fs::path& folder, const std::string& key, const Image8& image) {
    fs::create_directories(folder);
    if (!fs::exists(folder / "tolerance.toml")) write_tolerance(folder / "tolerance.toml", {.pinned = key});
    fs::path file = folder / (key + ".png");
    std::string before = "there was none before";
    if (fs::exists(file)) {
        Tolerance exact{.pinned = key, .max_channel = 0, .fraction = 0, .flip_mean = 0, .flip_p99 = 0};
        before = "against the one before: " + judge_same_driver(read_golden(file), image, exact).report;
    }
    write_png(file.string(), image);
    return {.pass = true, .report = fmt::format("golden {} written; {}", file.string(), before)};
}

Verdict sizes_differ(const Image8& golden, const Image8& image) {
    return {.pass = false,
            .report =
                fmt::format("the golden has {} x {} pixels, the picture {} x {}", golden.width, golden.height, image.width, image.height)};
}

} // namespace

std::string driver_key(std::string_view driver, std::string_view version, unsigned subgroup_size) {
    std::string key;
    for (char c : fmt::format("{} {} {}", driver, version, subgroup_size * 32)) {
        bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
        if (plain)
            key += c;
        else if (!key.empty() && key.back() != '-')
            key += '-';
    }
    return key;
}

Verdict judge_same_driver(const Image8& golden, const Image8& image, const Tolerance& tolerance) {
    if (golden.width != image.width || golden.height != image.height) return sizes_differ(golden, image);
    std::size_t off = 0, pixels = std::size_t{golden.width} * golden.height;
    int largest = 0;
    for (std::size_t i = 0; i < golden.rgba.size(); i += 4) {
        int worst = 0; // of the four channels: a golden knows its alpha too
        for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::abs(golden.rgba[i + c] - image.rgba[i + c]));
        off += worst > static_cast<int>(tolerance.max_channel);
        largest = std::max(largest, worst);
    }
    double fraction = static_cast<double>(off) / static_cast<double>(pixels);
    return {.pass = fraction <= tolerance.fraction,
            .report = fmt::format("{:.4f} % of the pixels differ by more than {}/255 (allowed {:.4f} %), at most by {}/255, FLIP {:.5f}",
                                  100 * fraction, tolerance.max_channel, 100 * tolerance.fraction, largest, mean(flip(golden, image)))};
}

Verdict judge_other_driver(const Image8& golden, const Image8& image, const Tolerance& tolerance) {
    if (golden.width != image.width || golden.height != image.height) return sizes_differ(golden, image);
    FlipMap map = flip(golden, image);
    double average = mean(map), p99 = percentile(map, 0.99);
    return {.pass = average <= tolerance.flip_mean && p99 <= tolerance.flip_p99,
            .report = fmt::format("another driver's golden: FLIP {:.5f} (allowed {:.5f}), 99th percentile {:.5f} (allowed {:.5f})", average,
                                  tolerance.flip_mean, p99, tolerance.flip_p99)};
}

GoldenStore golden_store() {
    const char* update = std::getenv("LIGHTBENCH_UPDATE_GOLDEN");
    return {.folder = fs::path(LIGHTBENCH_SOURCE) / "tests/images/golden",
            .failures = fs::current_path() / "golden-failures",
            .update = update ? update : ""};
}

Verdict check_golden(const GoldenStore& store, const std::string& name, const std::string& key, const Image8& image) {
    fs::path folder = store.folder / name;
    try {
        if (!name.empty() && store.update == name) return update(folder, key, image);
        std::optional<Found> golden = find_golden(folder, key);
        if (!golden) return {.pass = false, .report = fmt::format("there is no golden; ./run test --update-golden {} writes it", name)};
        Tolerance tolerance = read_tolerance(folder / "tolerance.toml");
        Verdict verdict =
            golden->own ? judge_same_driver(golden->picture, image, tolerance) : judge_other_driver(golden->picture, image, tolerance);
        if (!verdict.pass) verdict.report += keep_failure(store, name, golden->picture, image);
        return verdict;
    } catch (const std::exception& error) { // a golden or a tolerance that cannot be read is a failure of the test, told with the file
        return {.pass = false, .report = fmt::format("{}: {}", folder.string(), error.what())};
    }
}

void expect_golden(const std::string& name, const std::string& key, const Image8& image) {
    GoldenStore store = golden_store();
    Verdict verdict = check_golden(store, name, key, image);
    EXPECT_TRUE(verdict.pass) << "golden picture " << name << ": " << verdict.report;
    if (store.update == name) fmt::print("{}\n", verdict.report);
}

} // namespace lightbench
