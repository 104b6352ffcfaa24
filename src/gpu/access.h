// How passes touch resources, what came before, and the barrier that must stand between. Pure: values in, values out.
#pragma once

#include <optional>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace lightbench::gpu {

// One pass's use of one resource.
struct Access {
    vk::PipelineStageFlags2 stages{};
    vk::AccessFlags2 access{};
    bool writes = false;
    vk::ImageLayout layout = vk::ImageLayout::eUndefined; // images only

    void merge(const Access& other); // of the same pass; the layouts must agree (CHECK)
};

// What was done to a resource since its last write, kept across submits.
struct History {
    vk::PipelineStageFlags2 write_stages{}; // the last write, or the change of layout
    vk::AccessFlags2 write_access{};
    std::vector<Access> readers{}; // those that already see it
    vk::ImageLayout layout = vk::ImageLayout::eUndefined;
};

struct Dependency {
    vk::PipelineStageFlags2 from_stages, to_stages;
    vk::AccessFlags2 from_access, to_access;
    vk::ImageLayout from_layout, to_layout;
};

// The barrier that `next` needs after `history`, if any; the history then includes `next`.
std::optional<Dependency> advance(History& history, const Access& next);

} // namespace lightbench::gpu
