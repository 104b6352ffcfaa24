// lightbench probe SCENE X,Y: the illumination equation of a pixel with its numbers, and its ray tree with the reason of every end.
// The terms are computed in double on the host, held against what the device made of the same hit. --json: the keys are those of json_of().
#include "app/commands.h"
#include "app/errors.h"
#include "app/numbers.h"
#include "app/options.h"
#include "app/prepare.h"
#include "app/probe_tree.h"
#include "app/validation.h"
#include "plan/explain.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using glm::dvec3;
using nlohmann::ordered_json;

constexpr double kAgree = 1e-4; // of radiance: host and device are both printed if they differ by more

struct ProbeArguments {
    Given given;
    std::string pixel;
    bool json = false;
};

struct Probed {
    std::string scene, method;
    glm::uvec2 pixel{0};
    dvec3 radiance{0}; // of the pixel, by the method that was asked for
    Probe tree;
};

constexpr const char* kLightTypes[] = {"point", "directional", "spot"};

double apart(const dvec3& a, const dvec3& b) {
    const dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

std::string text_of(const dvec3& v) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

ordered_json json_of(const dvec3& v) {
    return ordered_json::array({v.x, v.y, v.z});
}

// l, r: towards the light, and its mirror direction; nl = N.L, rv = R.V; distance in metres, null for a directional light; intensity: Ip;
// shadow: what of it arrives; diffuse, specular: radiance, all factors in it.
ordered_json json_of(const ProbedLight& light, std::size_t number) {
    return {{"light", number},
            {"type", kLightTypes[static_cast<std::size_t>(light.type)]},
            {"l", json_of(light.l)},
            {"r", json_of(light.r)},
            {"nl", light.nl},
            {"rv", light.rv},
            {"distance", light.type == LightType::directional ? ordered_json(nullptr) : ordered_json(light.distance)},
            {"attenuation", light.attenuation},
            {"spot", light.spot},
            {"intensity", json_of(light.intensity)},
            {"shadow", json_of(light.shadow)},
            {"diffuse", json_of(light.diffuse)},
            {"specular", json_of(light.specular)}};
}

// sum: opacity (emission + ambient + what the lights add), in double; device: the same by the device.
ordered_json json_of(const ProbedHit& hit, const Scene& scene) {
    ordered_json lights = ordered_json::array();
    for (std::size_t i = 0; i < hit.lights.size(); ++i) lights.push_back(json_of(hit.lights[i], i));
    return {{"object", hit.object},
            {"material", scene.materials[hit.material].name},
            {"distance", hit.distance},
            {"position", json_of(hit.position)},
            {"normal", json_of(hit.normal)},
            {"face_normal", json_of(hit.face)},
            {"viewer", json_of(hit.viewer)},
            {"kd", json_of(hit.kd)},
            {"opacity", json_of(hit.opacity)},
            {"emission", json_of(hit.emission)},
            {"ambient", json_of(hit.ambient)},
            {"lights", lights},
            {"sum", json_of(hit.sum)},
            {"device", json_of(hit.device)},
            {"agrees", apart(hit.sum, hit.device) <= kAgree}};
}

// children: indices into "rays"; weight: of this ray in its parent's sum; hit: null if the ray leaves the scene; stops: the branches that
// were not followed, each with its reason.
ordered_json json_of(const ProbedRay& ray, const Scene& scene) {
    ordered_json stops = ordered_json::array();
    for (const ProbedStop& stop : ray.stops) stops.push_back({{"branch", stop.branch}, {"reason", stop.reason}});
    if (!ray.hit) stops.push_back({{"branch", ray.kind}, {"reason", "it leaves the scene"}});
    return {{"kind", ray.kind},
            {"level", ray.level},
            {"weight", json_of(ray.weight)},
            {"origin", json_of(ray.origin)},
            {"direction", json_of(ray.direction)},
            {"radiance", json_of(ray.radiance)},
            {"hit", ray.hit ? json_of(*ray.hit, scene) : ordered_json(nullptr)},
            {"children", ray.children},
            {"stops", stops}};
}

ordered_json json_of(const Probed& probed, const Scene& scene) {
    ordered_json rays = ordered_json::array();
    for (const ProbedRay& ray : probed.tree.rays) rays.push_back(json_of(ray, scene));
    return {{"scene", probed.scene},
            {"method", probed.method},
            {"pixel", {probed.pixel.x, probed.pixel.y}},
            {"radiance", json_of(probed.radiance)},
            {"rays", rays}};
}

void print_light(const std::string& in, const ProbedLight& light, std::size_t number) {
    fmt::print("{}light {}, {}: Ip {}, shadow {}\n", in, number, kLightTypes[static_cast<std::size_t>(light.type)],
               text_of(light.intensity), text_of(light.shadow));
    fmt::print("{}  L {}, N.L {:.6g}, R {}, R.V {:.6g}\n", in, text_of(light.l), light.nl, text_of(light.r), light.rv);
    if (light.type != LightType::directional)
        fmt::print("{}  distance {:.6g} m, attenuation {:.6g}", in, light.distance, light.attenuation);
    if (light.type == LightType::spot) fmt::print(", spot {:.6g}", light.spot);
    if (light.type != LightType::directional) fmt::print("\n");
    fmt::print("{}  diffuse {}, specular {}\n", in, text_of(light.diffuse), text_of(light.specular));
}

void print_hit(const std::string& in, const ProbedHit& hit, const Scene& scene) {
    fmt::print("{}meets object {}, material \"{}\", after {:.6g} m at {}\n", in, hit.object, scene.materials[hit.material].name,
               hit.distance, text_of(hit.position));
    fmt::print("{}N {}, V {}\n", in, text_of(hit.normal), text_of(hit.viewer));
    fmt::print("{}kd {}, opacity {}\n", in, text_of(hit.kd), text_of(hit.opacity));
    if (hit.emission != dvec3(0)) fmt::print("{}emission {}\n", in, text_of(hit.emission));
    fmt::print("{}ambient {}\n", in, text_of(hit.ambient));
    for (std::size_t i = 0; i < hit.lights.size(); ++i) print_light(in, hit.lights[i], i);
    fmt::print("{}opacity (emission + ambient + lights) = {}\n", in, text_of(hit.sum));
    if (apart(hit.sum, hit.device) > kAgree)
        fmt::print("{}the device has {}: off by {:.2g}, which is what the environment's mirror image adds, or rounding\n", in,
                   text_of(hit.device), apart(hit.sum, hit.device));
}

void print_ray(const Probe& tree, std::size_t index, const Scene& scene, std::size_t depth) {
    const ProbedRay& ray = tree.rays[index];
    const std::string in(2 * depth, ' ');
    fmt::print("{}{} ray, level {}, weight {}, radiance {}\n", in, ray.kind, ray.level, text_of(ray.weight), text_of(ray.radiance));
    fmt::print("{}  from {} along {}\n", in, text_of(ray.origin), text_of(ray.direction));
    if (!ray.hit) fmt::print("{}  stops: it leaves the scene\n", in);
    if (ray.hit) print_hit(in + "  ", *ray.hit, scene);
    for (const ProbedStop& stop : ray.stops) fmt::print("{}  no {} ray: {}\n", in, stop.branch, stop.reason);
    for (const std::size_t child : ray.children) print_ray(tree, child, scene, depth + 1);
}

glm::uvec2 parse_pixel(const std::string& text, Problems& problems) {
    const auto comma = std::min(text.find(','), text.size());
    const auto x = parse_whole<std::uint32_t>(std::string_view(text).substr(0, comma)),
               y = parse_whole<std::uint32_t>(std::string_view(text).substr(std::min(comma + 1, text.size())));
    if (!x || !y) problems.push_back({"PIXEL", 0, 0, fmt::format("\"{}\" is not a pixel; right would be X,Y like 320,240", text)});
    return {x.value_or(0), y.value_or(0)};
}

void check_options(const SceneOptions& options, Problems& problems) {
    if (options.frames) problems.push_back({"--frames", 0, 0, "a pixel is of one frame; --frame N chooses it"});
    if (!options.stats.empty()) problems.push_back({"--stats", 0, 0, "there is no run to tell of; --json prints the pixel"});
    if (options.request.crop) problems.push_back({"--crop", 0, 0, "a pixel is named in the whole image"});
}

dvec3 drawn_radiance(gpu::Device& device, Scene scene, const Request& request) {
    const Prepared prepared = prepare(scene, request);
    Renderer renderer(device, scene, prepared.geometry, prepared.plan);
    const RenderOutput output = renderer.render(prepared.view);
    const float* p = output.radiance.value().at(0, 0);
    return {p[0], p[1], p[2]};
}

void probe(const ProbeArguments& arguments) {
    Problems problems;
    SceneOptions options = parse_scene_options(arguments.given, problems);
    const glm::uvec2 pixel = parse_pixel(arguments.pixel, problems);
    check_options(options, problems);
    if (!problems.empty()) throw UserError(problems);
    Request& request = options.request;
    request.output = Output::radiance, request.terms = false, request.count = false, request.sampling = Sampling::none, request.spp = 1;
    request.crop = Rect{pixel, {1, 1}};
    const Scene scene = load_or_throw(options.scene, options.allow_outside);
    Scene completed = scene;
    const std::string method(name_of(prepare(completed, request).plan.method)); // problems before a device is opened
    gpu::Device device = gpu::Device::open({options.device});
    Probed probed{options.scene.string(), method, pixel, {}, probe_tree(device, scene, request, pixel)};
    probed.radiance = request.method == Method::raster ? drawn_radiance(device, scene, request) : probed.tree.rays.front().radiance;
    if (arguments.json) {
        fmt::print("{}\n", json_of(probed, completed).dump(2));
    } else {
        fmt::print("pixel {}, {} of {}, {}: radiance {}\n", pixel.x, pixel.y, probed.scene, method, text_of(probed.radiance));
        print_ray(probed.tree, 0, completed, 0);
    }
    close_and_check(std::move(device));
}

} // namespace

void add_probe(CLI::App& app, int&) {
    auto arguments = std::make_shared<ProbeArguments>();
    CLI::App* sub = app.add_subcommand("probe", "a pixel explained: its equation term by term, and its ray tree");
    declare_scene_options(*sub, arguments->given);
    sub->add_option("PIXEL", arguments->pixel, "the pixel; 0,0 is the upper left one")->required()->type_name("X,Y");
    sub->add_flag("--json", arguments->json, "as JSON");
    sub->callback([arguments] { probe(*arguments); });
}

} // namespace lightbench
