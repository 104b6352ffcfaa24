#include "app/cost_folder.h"

#include "gpu/errors.h"
#include "image/file_bytes.h"
#include "measure/report_csv.h"
#include "measure/report_html.h"
#include "measure/report_json.h"
#include "measure/report_plots.h"
#include "measure/text.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles[] = {"cost.csv", "cost.json", "report.html"};

// Names in a report are data: what lies elsewhere than in images/ is not touched.
void remove_picture(const std::string& image, const fs::path& folder) {
    const fs::path path(image);
    std::error_code ignored;
    if (path.parent_path() == "images" && path.extension() == ".png") fs::remove(folder / "images" / path.filename(), ignored);
}

void remove_plots(const std::string& knob, const fs::path& folder) {
    std::vector<fs::path> plots;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".svg" && entry.path().filename().string().starts_with(file_word(knob) + "-"))
            plots.push_back(entry.path());
    for (const fs::path& plot : plots) fs::remove(plot, ignored);
}

// Nothing if there is none, or none that this version reads.
CostReport earlier_report(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_regular_file(folder / "cost.json", ignored)) return {};
    try {
        const std::vector<unsigned char> bytes = read_file((folder / "cost.json").string());
        return read_cost_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const ReportError&) {
        return {};
    }
}

void make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw FileError(FileError::Blame::Environment, fmt::format("{}: cannot be made: {}", path.string(), error.message()));
}

void expect_no_folder(const fs::path& file, Problems& problems) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) problems.push_back({"-o", 0, 0, fmt::format("{} is a folder; a file goes there", file.string())});
}

} // namespace

void check_folder(const std::string& typed, Problems& problems) {
    const auto problem = [&](std::string text) { problems.push_back({"-o", 0, 0, std::move(text)}); };
    if (typed.empty()) return problem("is missing: the folder of the report");
    const fs::path whole = fs::absolute(typed).lexically_normal(); // ends in a slash if that was typed
    const fs::path parent = (whole.has_filename() ? whole : whole.parent_path()).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(parent, ignored)) problem(fmt::format("there is no folder {}; it must exist", parent.string()));
    for (const fs::path& folder : {whole, whole / "images"})
        if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
            problem(fmt::format("{} is a file; it must be a folder, or not exist yet", folder.string()));
    for (const char* name : kFiles) expect_no_folder(whole / name, problems);
}

void check_outputs(const std::string& typed, const CostReport& outline, Problems& problems) {
    const fs::path whole = fs::absolute(typed).lexically_normal();
    for (const CostCurve& curve : outline.curves) {
        if (!curve.reference_image.empty()) expect_no_folder(whole / curve.reference_image, problems);
        for (const CostPoint& point : curve.points) expect_no_folder(whole / point.image, problems);
    }
    for (const PlotFile& plot : plot_files(outline)) expect_no_folder(whole / plot.name, problems);
}

void try_folder(const fs::path& path) {
    std::error_code ignored;
    const bool had = fs::exists(path, ignored), had_images = fs::exists(path / "images", ignored);
    make_folder(path / "images");
    const fs::path trial = path / "images" / ".lightbench-trial";
    write_file(trial.string(), "");
    fs::remove(trial, ignored);
    if (!had_images) fs::remove(path / "images", ignored);
    if (!had) fs::remove(path, ignored);
}

void begin_report(ReportFolder& folder) {
    if (folder.fresh) return;
    make_folder(folder.path / "images");
    for (const CostCurve& curve : earlier_report(folder.path).curves) {
        remove_pictures(curve, folder);
        remove_plots(curve.knob, folder.path);
    }
    std::error_code ignored;
    for (const char* name : kFiles) fs::remove(folder.path / name, ignored);
    folder.fresh = true;
}

std::string write_report(const CostReport& report, ReportFolder& folder) {
    begin_report(folder);
    write_file((folder.path / "cost.csv").string(), cost_csv(report));
    write_file((folder.path / "cost.json").string(), cost_json(report));
    write_file((folder.path / "report.html").string(), report_html(report, folder.path));
    try {
        if (folder.plots) write_cost_plots(report, folder.path);
    } catch (const gpu::EnvironmentError& error) {
        folder.plots = false;
        return error.what();
    }
    return "";
}

void remove_pictures(const CostCurve& curve, const ReportFolder& folder) {
    remove_picture(curve.reference_image, folder.path);
    for (const CostPoint& point : curve.points) remove_picture(point.image, folder.path);
}

} // namespace lightbench
