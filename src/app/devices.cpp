// lightbench devices: the Vulkan devices, and what each lacks, if anything. Exit code 3 if there is none that can be used.
#include "app/commands.h"
#include "gpu/device.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

void print_text(const std::vector<gpu::DeviceDescription>& devices) {
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const gpu::DeviceDescription& d = devices[i];
        fmt::print("{}  {}\n   driver {}, Vulkan {}\n", i, d.info.name, d.info.driver, d.info.version);
        fmt::print("   {}\n", d.lacks.empty() ? "lacks nothing" : "lacks " + joined(d.lacks));
    }
}

void print_json(const std::vector<gpu::DeviceDescription>& devices) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const gpu::DeviceDescription& d = devices[i];
        list.push_back({{"index", i},
                        {"name", d.info.name},
                        {"driver", d.info.driver},
                        {"version", d.info.version},
                        {"cpu", d.info.is_cpu},
                        {"subgroup", d.info.subgroup_size},
                        {"heap", d.info.heap_bytes},
                        {"lacks", d.lacks}});
    }
    fmt::print("{}\n", list.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

void print_devices(bool json) {
    const std::vector<gpu::DeviceDescription> devices = gpu::list_devices();
    json ? print_json(devices) : print_text(devices);
    if (devices.empty()) throw gpu::EnvironmentError("there is no Vulkan driver; Debian's mesa-vulkan-drivers has one that needs no GPU");
    const bool usable = std::any_of(devices.begin(), devices.end(), [](const gpu::DeviceDescription& d) { return d.lacks.empty(); });
    if (!usable) throw gpu::EnvironmentError("no Vulkan device here has all that lightbench needs");
}

} // namespace

void add_devices(CLI::App& app, int&) {
    auto json = std::make_shared<bool>(false);
    CLI::App* sub = app.add_subcommand("devices", "the Vulkan devices, and what each lacks, if anything");
    sub->add_flag("--json", *json, "as JSON");
    sub->callback([json] { print_devices(*json); });
}

} // namespace lightbench
