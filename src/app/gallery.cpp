// lightbench gallery -o DIR: the exhibits, rendered, and a page that shows their pictures side by side.
#include "app/assets.h"
#include "app/commands.h"
#include "app/errors.h"
#include "app/gallery_exhibits.h"
#include "app/gallery_page.h"
#include "app/messages.h"
#include "app/numbers.h"
#include "app/pictures.h"
#include "app/prepare.h"
#include "app/validation.h"
#include "image/file_bytes.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "plan/explain.h"
#include "render/render.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

struct Curator {
    gpu::Device& device;
    Messages messages;
    fs::path folder;
    glm::uvec2 size;
};

// Kinds of `make` are ours: that they exist with these parameters is tested, not hoped.
Scene scene_of(const ExhibitRow& row, const ShotRow& shot) {
    if (row.source.scene) return load_or_throw(find_assets() / "scenes" / row.source.scene);
    auto made = make_scene(row.source.kind, shot.arguments);
    if (auto* problems = std::get_if<Problems>(&made)) throw UserError(*problems);
    return std::get<Scene>(std::move(made));
}

std::string radiosity_options(const RadiosityShot& shot) {
    std::string options = fmt::format("--method radiosity --shots {}", *shot.shots);
    if (shot.element > 0) options += fmt::format(" --patch {}", 4 * shot.element);
    if (shot.show == Show::patches) options += " --show patches";
    return options;
}

std::string render_options_of(const ShotRow& shot) {
    if (shot.radiosity.shots) return radiosity_options(shot.radiosity);
    if (shot.rays.depth == 0) return fmt::format("--shading {}", name_of(shot.shading));
    std::string options = fmt::format("--method raytrace --depth {}", shot.rays.depth);
    if (shot.rays.cutoff > 0) options += fmt::format(" --cutoff {}", shot.rays.cutoff);
    if (shot.rays.spp > 1) options += fmt::format(" --spp {}", shot.rays.spp);
    return options;
}

std::string command_of(const ExhibitRow& row, const ShotRow& shot) {
    const std::string render = render_options_of(shot);
    if (row.source.scene) return fmt::format("render {} {}", row.source.scene, render);
    std::string make = fmt::format("make {}", row.source.kind);
    for (const auto& [name, value] : shot.arguments) make += fmt::format(" --param {}={}", name, value);
    return make + ", render " + render;
}

struct Taken {
    Shown shown;
    Image8 pixels;
};

Request request_of(const ShotRow& shot, glm::uvec2 size) {
    Request request;
    request.shading = shot.shading, request.size = size;
    if (shot.radiosity.shots) {
        request.method = Method::radiosity;
        request.radiosity.shots = shot.radiosity.shots, request.radiosity.show = shot.radiosity.show;
        request.radiosity.element = shot.radiosity.element, request.radiosity.patch = 4 * shot.radiosity.element;
    }
    if (shot.rays.depth == 0) return request;
    request.method = Method::raytrace;
    request.depth = shot.rays.depth, request.cutoff = shot.rays.cutoff, request.spp = shot.rays.spp;
    return request;
}

RenderOutput render_shot(Curator& curator, const Scene& scene, const Prepared& prepared) {
    RenderOptions options;
    options.warm_up = prepared.plan.method == Method::raster; // drivers compile at the first draw, but before the first dispatch
    return Renderer(curator.device, scene, prepared.geometry, prepared.plan).render(prepared.view, options);
}

std::optional<RayStatistics> count_rays(Curator& curator, Scene& scene, Request request) {
    request.count = true;
    return render_shot(curator, scene, prepare(scene, request)).rays;
}

Taken take(Curator& curator, const ExhibitRow& row, const ShotRow& shot) {
    curator.messages.step(fmt::format("{}: {}", row.title, shot.caption));
    Scene scene = scene_of(row, shot);
    const Request request = request_of(shot, curator.size);
    const Prepared prepared = prepare(scene, request);
    RenderOutput output = render_shot(curator, scene, prepared);
    Taken taken;
    taken.shown = {shot.caption,
                   std::string(shot.file) + ".png",
                   command_of(row, shot),
                   explain(prepared.plan),
                   output.device_milliseconds,
                   {},
                   {},
                   {}};
    if (shot.rays.counted) taken.shown.rays = count_rays(curator, scene, request);
    taken.pixels = std::move(output.pixels.value());
    write_pixels(curator.folder / taken.shown.file, taken.pixels);
    return taken;
}

void measure(std::vector<Taken>& shots, int reference) {
    if (reference < 0) return;
    const Image8& truth = shots[static_cast<std::size_t>(reference)].pixels;
    for (Taken& shot : shots) {
        if (&shot.pixels == &truth) continue;
        shot.shown.peak = metrics(truth, shot.pixels).max;
        shot.shown.flip = mean(flip(truth, shot.pixels));
    }
}

Exhibit exhibit_of(Curator& curator, const ExhibitRow& row) {
    std::vector<Taken> shots;
    for (const ShotRow& shot : row.shots) shots.push_back(take(curator, row, shot));
    measure(shots, row.reference);
    Exhibit exhibit{row.title, row.text, row.reference < 0 ? "" : row.shots[static_cast<std::size_t>(row.reference)].caption, {}};
    for (Taken& shot : shots) exhibit.pictures.push_back(std::move(shot.shown));
    return exhibit;
}

struct GalleryArguments {
    std::string folder, device, size = "640x360";
    bool quiet = false;
};

void make_gallery(const GalleryArguments& arguments) {
    const auto size = parse_size(arguments.size);
    if (!size) throw UserError("--size", fmt::format("\"{}\" must be WIDTHxHEIGHT in pixels, like 640x360", arguments.size));
    std::error_code error;
    fs::create_directories(arguments.folder, error);
    if (!fs::is_directory(arguments.folder))
        throw UserError("-o", fmt::format("the folder {} cannot be made: {}", arguments.folder, error.message()));
    gpu::Device device = gpu::Device::open({arguments.device});
    Curator curator{device, {arguments.quiet, Progress::automatic}, arguments.folder, *size};
    std::vector<Exhibit> exhibits;
    for (const ExhibitRow& row : exhibit_rows()) exhibits.push_back(exhibit_of(curator, row));
    const fs::path page = curator.folder / "index.html";
    write_file(page.string(), gallery_page(device.info().name, exhibits));
    fmt::print("{}\n", page.string());
    close_and_check(std::move(device));
}

} // namespace

void add_gallery(CLI::App& app, int&) {
    auto arguments = std::make_shared<GalleryArguments>();
    CLI::App* sub = app.add_subcommand("gallery", "renders the demonstration gallery: pictures and a page that shows them side by side");
    sub->add_option("-o,--output", arguments->folder, "folder; made if it is missing")->required()->type_name("DIR");
    sub->add_option("--size", arguments->size, "of each picture; default 640x360")->type_name("WxH");
    sub->add_option("--device", arguments->device, "Vulkan device: part of its name, or its index")->type_name("D");
    sub->add_flag("--quiet", arguments->quiet, "no messages but errors");
    sub->callback([arguments] { make_gallery(*arguments); });
}

} // namespace lightbench
