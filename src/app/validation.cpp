#include "app/validation.h"

#include <fmt/format.h>
#include <optional>

namespace lightbench {

void close_and_check(gpu::Device device) {
    std::optional<gpu::Device> last(std::move(device));
    const auto log = last->validation_log();
    last.reset();
    if (!log) return;
    const std::vector<std::string> messages = messages_of(*log);
    for (const std::string& message : messages) fmt::print(stderr, "validation: {}\n", message);
    if (!messages.empty()) throw gpu::EnvironmentError(fmt::format("the validation layers had {} messages", messages.size()));
}

} // namespace lightbench
