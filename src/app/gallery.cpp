// lightbench gallery -o DIR: the default scene in every shading mode and the known failures of interpolated shading with their cures,
// as pictures and a page that shows them side by side.
#include "app/assets.h"
#include "app/commands.h"
#include "app/errors.h"
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
#include "scene/make.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

struct ShotRow {
    const char* caption;
    const char* file; // without extension
    Shading shading;
    MakeArguments arguments = {};
};

struct ExhibitRow {
    const char* title;
    const char* text;
    const char* kind; // of `make`; null: the default scene
    int reference;    // index of the shot that the others are measured against; -1: none
    std::vector<ShotRow> shots;
};

const std::vector<ExhibitRow>& exhibit_rows() {
    using enum Shading;
    static const std::vector<ExhibitRow> rows = {
        {"Three places to evaluate one model",
         "The same illumination model, evaluated once a polygon (flat), once a vertex (Gouraud) and once a pixel (Phong).",
         nullptr,
         2,
         {{"flat", "default-flat", flat}, {"Gouraud", "default-gouraud", gouraud}, {"Phong", "default-phong", phong}}},
        {"The lost highlight",
         "A highlight in the middle of one large triangle. Gouraud knows the vertices only, where there is none; Phong, or a finer mesh, "
         "finds it.",
         "highlight",
         2,
         {{"flat", "highlight-flat", flat},
          {"Gouraud: lost", "highlight-gouraud", gouraud},
          {"Phong: the cure", "highlight-phong", phong},
          {"Gouraud, each triangle in 256: the other cure", "highlight-fine", gouraud, {{"subdivide", "4"}}}}},
        {"The corrugated sheet",
         "On a regular zigzag the averages of neighbouring normals are all parallel: interpolated shading sees a plane. Strips within each "
         "side keep "
         "the side's own normal.",
         "corrugated",
         3,
         {{"flat", "corrugated-flat", flat},
          {"Gouraud: looks flat", "corrugated-gouraud", gouraud},
          {"Phong: looks flat too", "corrugated-phong", phong},
          {"Phong, 16 strips a side: the cure", "corrugated-fine", phong, {{"subdivide", "16"}}}}},
        {"The crease",
         "Left: normals averaged over every edge, which smears shading across corners. Right: edges sharper than 30 degrees stay edges.",
         "crease",
         3,
         {{"flat", "crease-flat", flat},
          {"Gouraud", "crease-gouraud", gouraud},
          {"Phong", "crease-phong", phong},
          {"Phong, edges kept on both sides: the cure", "crease-kept", phong, {{"left", "30"}}}}},
        {"The quad",
         "Four corner intensities do not say what lies between them. Split along its bright diagonal (left), along its dark one (middle), "
         "interpolated along scan lines (right), as Gouraud did in 1971: that one changes when the quad is turned, the triangles do not.",
         "quads",
         -1,
         {{"Gouraud", "quads-gouraud", gouraud}, {"Gouraud, turned by 30 degrees", "quads-turned", gouraud, {{"turn", "30"}}}}},
        {"Mach bands",
         "Intensity that is linear between vertices has kinks at them, and the eye draws a line at each. Phong bends instead of kinking; "
         "more facets "
         "make the kinks smaller.",
         "mach-band",
         3,
         {{"flat", "mach-band-flat", flat},
          {"Gouraud: bands", "mach-band-gouraud", gouraud},
          {"Phong", "mach-band-phong", phong},
          {"Phong, 256 facets: the cure", "mach-band-fine", phong, {{"facets", "256"}}}}},
    };
    return rows;
}

struct Curator {
    gpu::Device& device;
    Messages messages;
    fs::path folder;
    glm::uvec2 size;
};

// Kinds of `make` are ours: that they exist with these parameters is tested, not hoped.
Scene scene_of(const ExhibitRow& row, const ShotRow& shot) {
    if (row.kind == nullptr) return load_or_throw(find_assets() / "scenes/default.toml");
    auto made = make_scene(row.kind, shot.arguments);
    if (auto* problems = std::get_if<Problems>(&made)) throw UserError(*problems);
    return std::get<Scene>(std::move(made));
}

std::string command_of(const ExhibitRow& row, const ShotRow& shot) {
    const std::string render = fmt::format("--shading {}", name_of(shot.shading));
    if (row.kind == nullptr) return "render default.toml " + render;
    std::string make = fmt::format("make {}", row.kind);
    for (const auto& [name, value] : shot.arguments) make += fmt::format(" --param {}={}", name, value);
    return make + ", render " + render;
}

struct Taken {
    Shown shown;
    Image8 pixels;
};

Taken take(Curator& curator, const ExhibitRow& row, const ShotRow& shot) {
    curator.messages.step(fmt::format("{}: {}", row.title, shot.caption));
    Scene scene = scene_of(row, shot);
    Request request;
    request.shading = shot.shading, request.size = curator.size;
    const Prepared prepared = prepare(scene, request);
    RenderOptions options;
    options.warm_up = true;
    Renderer renderer(curator.device, scene, prepared.geometry, prepared.plan);
    RenderOutput output = renderer.render(prepared.view, options);
    Taken taken;
    taken.shown = {
        shot.caption, std::string(shot.file) + ".png", command_of(row, shot), explain(prepared.plan), output.device_milliseconds, {}, {}};
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
