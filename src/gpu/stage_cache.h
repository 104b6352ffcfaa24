// Modules that were specialised, on disk beside the driver's pipelines: SPIRV-Tools took four fifths of the start of a program whose
// pipelines are cached. In: what a module is made from. Out: the module, from its file, or else made and kept.
#pragma once

#include "gpu/specialize.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lightbench::gpu {

using Words = std::vector<std::uint32_t>;

class StageCache {
  public:
    explicit StageCache(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {} // none: nothing is kept

    // specialize() and drop_unread_outputs(). A file that is damaged, or cannot be written, costs time and nothing else.
    Words specialized(const ShaderCode& code, const Constants& constants);
    Words without_unread_outputs(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment);

  private:
    Words kept(std::string_view step, std::span<const std::span<const std::uint32_t>> from, const std::function<Words()>& make);

    std::optional<std::filesystem::path> folder_;
};

} // namespace lightbench::gpu
