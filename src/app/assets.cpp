#include "app/assets.h"

#include "gpu/errors.h"

#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace lightbench {

namespace fs = std::filesystem;

fs::path find_assets() {
    std::vector<fs::path> places;
    if (const char* named = std::getenv("LIGHTBENCH_ASSETS")) places.emplace_back(named);
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) places.push_back(program.parent_path().parent_path() / "share/lightbench/assets");
    places.emplace_back(LIGHTBENCH_SOURCE "/assets");
    std::string looked;
    for (const fs::path& place : places) {
        if (fs::is_directory(place, ignored)) return place;
        looked += fmt::format("{}{}", looked.empty() ? "" : ", ", place.string());
    }
    throw gpu::EnvironmentError(
        fmt::format("the program's own scenes are missing; looked in {} (LIGHTBENCH_ASSETS names another place)", looked));
}

} // namespace lightbench
