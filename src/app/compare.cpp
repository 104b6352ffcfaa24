// lightbench compare A B: how far two pictures lie apart; A is the reference. With --max-flip a gate: exit code 1 if they differ more.
#include "image/compare.h"
#include "app/commands.h"
#include "app/errors.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using nlohmann::ordered_json;

struct CompareArguments {
    std::string reference, test, difference;
    bool json = false;
    std::optional<double> max_flip;
};

Comparison compare_files(const CompareArguments& arguments) {
    const AnyImage reference = read_image(arguments.reference), test = read_image(arguments.test);
    try {
        return compare(reference, test);
    } catch (const std::invalid_argument& error) {
        throw UserError(fmt::format("{} and {}", arguments.reference, arguments.test), error.what());
    }
}

void print_text(const Comparison& c) {
    fmt::print("rmse   {:.6g} ({})\npsnr   {:.4g} dB\nmax    {:.6g}\nflip   {:.6f} mean, {:.6f} median, {:.6f} worst\n", c.metrics.rmse,
               c.space, c.metrics.psnr, c.metrics.max, c.flip_mean, percentile(c.flip_map, 0.5), percentile(c.flip_map, 1));
    fmt::print("differ {} of {} pixels\n", c.metrics.differing, c.flip_map.error.size());
    if (c.metrics.non_finite_reference + c.metrics.non_finite_test > 0)
        fmt::print("not finite: {} pixels of the reference, {} of the other\n", c.metrics.non_finite_reference, c.metrics.non_finite_test);
}

// JSON has no infinity: the PSNR of equal pictures is null, and RMSE, PSNR and maximum where a pixel is not finite.
ordered_json number(double x) {
    return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

void print_json(const Comparison& c) {
    const ordered_json json = {{"space", c.space},
                               {"rmse", number(c.metrics.rmse)},
                               {"psnr", number(c.metrics.psnr)},
                               {"max", number(c.metrics.max)},
                               {"flip", number(c.flip_mean)},
                               {"flip_median", percentile(c.flip_map, 0.5)},
                               {"flip_max", percentile(c.flip_map, 1)},
                               {"differing", c.metrics.differing},
                               {"pixels", c.flip_map.error.size()},
                               {"non_finite", {{"reference", c.metrics.non_finite_reference}, {"test", c.metrics.non_finite_test}}}};
    fmt::print("{}\n", json.dump(2));
}

// Written so that a NaN would fail the gate.
bool passes(const Comparison& c, std::optional<double> max_flip) {
    if (!max_flip || c.flip_mean <= *max_flip) return true;
    fmt::print(stderr, "lightbench: FLIP is {:.6f}, more than {:g}\n", c.flip_mean, *max_flip);
    return false;
}

bool compare_and_print(const CompareArguments& arguments) {
    if (arguments.max_flip && !(*arguments.max_flip >= 0 && *arguments.max_flip <= 1))
        throw UserError("--max-flip", "it must lie between 0 and 1");
    if (!arguments.difference.empty() && !arguments.difference.ends_with(".png"))
        throw UserError("--diff", "the picture of differences is a .png");
    const Comparison c = compare_files(arguments);
    if (!arguments.difference.empty()) write_png(arguments.difference, difference_picture(c.flip_map));
    arguments.json ? print_json(c) : print_text(c);
    return passes(c, arguments.max_flip);
}

} // namespace

void add_compare(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App* sub = app.add_subcommand("compare", "RMSE, PSNR, largest difference and FLIP of two pictures");
    sub->add_option("A", arguments->reference, "the reference: .png, .exr, .jpg, .hdr")->required();
    sub->add_option("B", arguments->test, "the picture that is judged")->required();
    sub->add_option("--diff", arguments->difference, "write the FLIP map as a picture")->type_name("FILE.png");
    sub->add_flag("--json", arguments->json, "as JSON");
    sub->add_option("--max-flip", arguments->max_flip, "exit code 1 if the mean FLIP is larger")->type_name("X");
    sub->callback([arguments, &exit_code] { exit_code = compare_and_print(*arguments) ? 0 : 1; });
}

} // namespace lightbench
