#include "render/radiosity/feed.h"

#include "render/radiosity/hemicube_state.h"
#include "render/raster.h"
#include "render/shaders.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kArriving = EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_NONE |
                                    EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE;

gpu::ComputePipeline pipeline_for(HemicubeState& s, const Plan& plan, const GpuScene& scene) {
    gpu::Constants constants = s.constants();
    constants[CONSTANT_FETCH_STORAGE] |= scene.fetch_storage;
    constants[CONSTANT_EFFECTS] = plan.effects & kArriving;
    constants[CONSTANT_SHADING] = SHADING_PHONG, constants[CONSTANT_OUTPUT] = OUTPUT_RADIANCE;
    return gpu::make_compute(s.device, find_shader("radiosity/feed.comp"), constants, sizeof(gpu_layout::RayPush));
}

} // namespace

// One dispatch a light: each ends, however many lights there are, and sums are in their order.
std::vector<glm::vec3> feed(gpu::Device& device, gpu::Recorder& recorder, Hemicubes& hemicubes, std::size_t count, const Plan& plan,
                            GpuScene& scene, gpu::Timings& times) {
    HemicubeState& s = hemicubes.state();
    const gpu::ComputePipeline pipeline = pipeline_for(s, plan, scene);
    gpu::Buffer irradiance = gpu::make_buffer(device, "irradiance", count * sizeof(glm::vec4), vk::BufferUsageFlagBits::eStorageBuffer);
    recorder.fill(irradiance, 0);
    for (std::uint32_t light = 0; light < scene.light_count; ++light) {
        gpu::Bindings bindings = s.with_structure({{"Irradiance", irradiance}, {"Counters", s.counters}});
        offer_table(bindings, "receivers", s.receivers);
        offer_table(bindings, "lights", scene.lights);
        gpu_layout::RayPush push{};
        push.count = s.elements, push.first_light = light, push.end_light = light + 1;
        recorder.compute("feed", pipeline, bindings, push, groups_for(s.elements));
        s.expected += s.elements;
    }
    const gpu::Timings now = recorder.submit_and_wait();
    times.insert(times.end(), now.begin(), now.end());
    hemicubes.check();
    const auto words = gpu::download_all<float>(device, irradiance);
    std::vector<glm::vec3> out;
    for (std::size_t i = 0; i < words.size(); i += 4) out.emplace_back(words[i], words[i + 1], words[i + 2]);
    return out;
}

} // namespace lightbench
