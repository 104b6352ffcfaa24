// Margins of wide filters; bands and levels of adaptive sampling.
#include "render/sampling.h"

#include "render/raster.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;

struct Band {
    glm::uvec2 corner{0}, size{0}; // pixels
};

class BandTracer {
  public:
    BandTracer(RayTracer& tracer, const RayWork& work, const RayFrame& frame, Lattice& lattice)
        : tracer_(tracer), work_(work), frame_(frame), lattice_(lattice) {}
    // `continues`: the band before ended with this one's first row of points. False: stopped early; of what was traced the whole levels
    // become pixels.
    bool trace(const Band& band, bool continues, gpu::Image& image);

  private:
    LatticePush push_for(const Band& band, std::uint32_t level, glm::uvec2 invocations) const;
    void begin(const Band& band, bool continues);
    void write(const Band& band, std::uint32_t level, gpu::Image& image);
    void keep_last_row(const Band& band);
    std::uint32_t list(const Band& band, std::uint32_t level);
    void record(const char* name, const gpu::ComputePipeline& pipeline, const gpu::Bindings& bindings, const LatticePush& push);
    vk::DeviceSize row(const Band& band) const { return (vk::DeviceSize{band.size.x} << lattice_.levels) + 1; }

    RayTracer& tracer_;
    const RayWork& work_;
    const RayFrame& frame_;
    Lattice& lattice_;
};

LatticePush BandTracer::push_for(const Band& band, std::uint32_t level, glm::uvec2 invocations) const {
    LatticePush push{};
    push.corner = band.corner, push.size = band.size, push.levels = lattice_.levels, push.level = level;
    push.count = invocations.x * invocations.y, push.seed = work_.plan.seed, push.contrast = work_.plan.contrast;
    return push;
}

void BandTracer::record(const char* name, const gpu::ComputePipeline& pipeline, const gpu::Bindings& bindings, const LatticePush& push) {
    work_.recorder.compute(name, pipeline, bindings, push, groups_for(push.count));
}

void BandTracer::begin(const Band& band, bool continues) {
    work_.recorder.fill(lattice_.states, 0);
    if (!continues) return;
    work_.recorder.copy(lattice_.row_states, lattice_.states, row(band) * sizeof(std::uint32_t));
    work_.recorder.copy(lattice_.row_radiance, lattice_.radiance, row(band) * sizeof(glm::vec4));
}

// Pixels of the cells down to this level.
void BandTracer::write(const Band& band, std::uint32_t level, gpu::Image& image) {
    record("lattice-pixels", lattice_.pixels, {{"Lattice", lattice_.radiance}, {"States", lattice_.states}, {"frame", image}},
           push_for(band, level, band.size));
}

void BandTracer::keep_last_row(const Band& band) {
    const vk::DeviceSize last = (vk::DeviceSize{band.size.y} << lattice_.levels) * row(band);
    work_.recorder.copy(lattice_.states, lattice_.row_states, row(band) * sizeof(std::uint32_t), last * sizeof(std::uint32_t));
    work_.recorder.copy(lattice_.radiance, lattice_.row_radiance, row(band) * sizeof(glm::vec4), last * sizeof(glm::vec4));
}

// Returns how many points there are to trace.
std::uint32_t BandTracer::list(const Band& band, std::uint32_t level) {
    if (level > 0)
        record("split-cells", lattice_.split, {{"Lattice", lattice_.radiance}, {"States", lattice_.states}},
               push_for(band, level - 1, band.size << (level - 1)));
    work_.recorder.fill(lattice_.listed, 0);
    record("list-points", lattice_.list, {{"States", lattice_.states}, {"Points", lattice_.points}, {"Listed", lattice_.listed}},
           push_for(band, level, (band.size << level) + 1u));
    const auto times = work_.recorder.submit_and_wait();
    work_.times.insert(work_.times.end(), times.begin(), times.end());
    return gpu::download_all<std::uint32_t>(work_.device, lattice_.listed).front();
}

bool BandTracer::trace(const Band& band, bool continues, gpu::Image& image) {
    begin(band, continues);
    for (std::uint32_t level = 0; level <= lattice_.levels; ++level) {
        const std::uint32_t count = list(band, level);
        if (!trace_points(tracer_, work_, frame_, count, image)) {
            if (level > 0) write(band, level - 1, image);
            return false;
        }
        if (count == 0 && level > 0) break; // nothing was split
    }
    write(band, lattice_.levels, image);
    keep_last_row(band);
    return true;
}

} // namespace

WideFilter make_wide_filter(gpu::Device& device, const Plan& plan) {
    WideFilter filter;
    filter.margin = static_cast<std::uint32_t>(std::ceil(plan.filter_width));
    const glm::uvec2 size = plan.crop.size + 2 * filter.margin;
    filter.frame = gpu::make_image(device, "samples", {size.x, size.y}, vk::Format::eR32G32B32A32Sfloat, vk::ImageUsageFlagBits::eStorage);
    filter.pipeline = gpu::make_compute(device, find_shader("raytrace/filter.comp"),
                                        {{CONSTANT_RAY_EFFECTS, plan.jittered ? RAY_JITTER : 0}}, sizeof(FilterPush));
    return filter;
}

bool trace_filtered(RayTracer& tracer, const RayWork& work, RayFrame frame, WideFilter& filter, gpu::Image& sum) {
    const Rect& crop = work.plan.crop;
    frame.area = {glm::uvec2(0), crop.size + 2 * filter.margin};
    frame.origin = glm::ivec2(crop.offset) - static_cast<int>(filter.margin);
    work.recorder.clear(filter.frame, {});
    const bool whole = trace_frame(tracer, work, frame, filter.frame);
    FilterPush push{};
    push.corner = crop.offset, push.size = crop.size;
    push.shift = frame.shift, push.cell = frame.cell, push.seed = work.plan.seed, push.sample_index = frame.sample;
    push.radius = work.plan.filter_width, push.sigma = work.plan.filter_sigma, push.margin = filter.margin;
    push.first = frame.sample == 0;
    work.recorder.compute("filter", filter.pipeline, {{"frame", filter.frame}, {"sum", sum}}, push,
                          {(crop.size.x + 15) / 16, (crop.size.y + 3) / 4});
    return whole;
}

Lattice make_lattice(gpu::Device& device, const Plan& plan, RayTracer& tracer, std::uint64_t room) {
    Lattice l;
    l.levels = plan.max_level;
    const std::uint64_t side = std::uint64_t{1} << l.levels;
    l.width = static_cast<std::uint32_t>(std::clamp<std::uint64_t>((room / (side + 1) - 1) / side, 1, plan.crop.size.x));
    const std::uint64_t row = l.width * side + 1;
    l.rows = static_cast<std::uint32_t>(std::clamp<std::uint64_t>((room / row - 1) / side, 1, plan.crop.size.y));
    const std::uint64_t points = row * (l.rows * side + 1);
    l.radiance = gpu::make_buffer(device, "lattice", points * sizeof(glm::vec4), kStorage);
    l.states = gpu::make_buffer(device, "lattice-states", points * sizeof(std::uint32_t), kStorage);
    l.points = gpu::make_texel_buffer(device, "lattice-points", points * sizeof(uvec4));
    l.listed = gpu::make_buffer(device, "lattice-listed", sizeof(std::uint32_t), kStorage, gpu::Memory::readback);
    l.row_radiance = gpu::make_buffer(device, "lattice-row", row * sizeof(glm::vec4), kStorage);
    l.row_states = gpu::make_buffer(device, "lattice-row-states", row * sizeof(std::uint32_t), kStorage);
    const auto pass = [&](const char* shader) { return gpu::make_compute(device, find_shader(shader), {}, sizeof(LatticePush)); };
    l.split = pass("raytrace/lattice_split.comp"), l.list = pass("raytrace/lattice_list.comp");
    l.pixels = pass("raytrace/lattice_pixels.comp");
    if (!l.points.as_texel()) tracer.scene.fetch_storage |= FETCH_EYE_POINTS;
    return l;
}

bool trace_adaptive(RayTracer& tracer, const RayWork& work, RayFrame frame, Lattice& lattice, gpu::Image& image) {
    const Rect& crop = work.plan.crop;
    frame.points = &lattice.points, frame.lattice = &lattice.radiance;
    BandTracer bands(tracer, work, frame, lattice);
    for (std::uint32_t x = 0; x < crop.size.x; x += lattice.width)
        for (std::uint32_t y = 0; y < crop.size.y; y += lattice.rows) {
            const glm::uvec2 at(x, y);
            const Band band{crop.offset + at, glm::min(glm::uvec2(lattice.width, lattice.rows), crop.size - at)};
            if (!bands.trace(band, y > 0, image)) return false;
            const double strips = std::ceil(double(crop.size.x) / lattice.width), strip = x / lattice.width;
            if (work.progress) work.progress((strip + double(y + band.size.y) / crop.size.y) / strips);
        }
    return true;
}

} // namespace lightbench
