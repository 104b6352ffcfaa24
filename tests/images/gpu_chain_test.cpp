// The recorder under synchronisation validation: compute feeds compute feeds vertices, indices and fragments feeds compute feeds a copy, over several
// submits and with one resource in many roles; the result is known exactly. And the tests of that test: without a barrier the layers must complain.
#include "images/gpu_fixture.h"

#include "gpu/buffer_state.h"

namespace lightbench::gpu {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;

constexpr vk::Extent2D kSize{24, 16};
constexpr std::uint32_t kCount = 100;
using Texel = std::array<std::uint32_t, 4>;
using Pixel = std::array<float, 4>;
struct SquarePush {
    std::uint32_t count, added;
};

std::vector<Texel> source_values() {
    std::vector<Texel> values(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) values[i] = {i, i + 1, i + 2, i + 3};
    return values;
}

struct Chain {
    Buffer source, squares, vertices, indices, count, readback;
    Image picture, samples, mirrored, depth;
    ComputePipeline square, triangle, mirror;
    GraphicsPipeline draw, draw_samples;

    explicit Chain(Device& d) {
        using U = vk::BufferUsageFlagBits;
        using I = vk::ImageUsageFlagBits;
        constexpr auto kFloat4 = vk::Format::eR32G32B32A32Sfloat;
        source = make_texel_buffer(d, "source", kCount * 16);
        const std::vector<Texel> values = source_values();
        upload(d, source, std::as_bytes(std::span(values)));
        squares = make_buffer(d, "squares", kCount * 16, U::eStorageBuffer);
        vertices = make_buffer(d, "vertices", 6 * 16, U::eStorageBuffer | U::eVertexBuffer);
        indices = make_buffer(d, "indices", 3 * 4, U::eStorageBuffer | U::eIndexBuffer);
        count = make_buffer(d, "count", 4, U::eStorageBuffer);
        readback = make_buffer(d, "readback", kSize.width * kSize.height * 16, {}, Memory::readback);
        picture = make_image(d, "picture", kSize, kFloat4, I::eColorAttachment | I::eSampled);
        samples = make_image(d, "samples", kSize, kFloat4, I::eColorAttachment, 4);
        mirrored = make_image(d, "mirrored", kSize, kFloat4, I::eStorage);
        depth = make_image(d, "depth", kSize, vk::Format::eD32Sfloat, I::eDepthStencilAttachment);
        square = make_compute(d, test_shader("gpu_square.comp"), {}, sizeof(SquarePush));
        triangle = make_compute(d, test_shader("gpu_triangle.comp"), {}, 0);
        mirror = make_compute(d, test_shader("gpu_mirror.comp"), {}, 0);
        draw = make_draw(d, 1, vk::Format::eD32Sfloat);
        draw_samples = make_draw(d, 4, vk::Format::eUndefined);
    }

    static GraphicsPipeline make_draw(Device& d, unsigned samples, vk::Format depth_format) {
        constexpr auto kFloat4 = vk::Format::eR32G32B32A32Sfloat;
        GraphicsDesc desc{
            .name = "triangle", .vertex = test_shader("gpu_triangle.vert"), .fragment = test_shader("gpu_triangle.frag"), .push_size = 4};
        desc.vertex_buffers = {{32, {{0, kFloat4, 0}, {1, kFloat4, 16}}}, {16, {{2, kFloat4, 0}}}};
        desc.color_formats = {kFloat4};
        desc.samples = samples;
        desc.depth_format = depth_format;
        return make_graphics(d, desc);
    }

    Bindings square_bindings() { return {{"source", source}, {"source_storage", source}, {"Squares", squares}}; }

    void record_compute(Recorder& r, std::uint32_t added) {
        r.compute("square", square, square_bindings(), SquarePush{kCount, added}, {(kCount + 63) / 64});
        r.compute("triangle", triangle, {{"Squares", squares}, {"Vertices", vertices}, {"Indices", indices}}, {}, {});
    }

    // Half of the picture, in a color of 10 + the squares.
    DrawPass pass(const GraphicsPipeline& pipeline, ColorTarget color, vk::Rect2D area) {
        DrawPass p{
            .pipelines = {&pipeline}, .targets = {{color}, {}, area}, .vertex_buffers = {&vertices, nullptr}, .index_buffer = &indices};
        p.bindings = {{"Squares", squares}, {"Count", count}};
        return p;
    }
};

void draw_triangle(DrawContext& d, float factor) {
    d.push(factor);
    d.draw_indexed(3);
}

const vk::Rect2D kAll{{0, 0}, kSize}, kLeft{{0, 0}, {kSize.width / 2, kSize.height}};

// What the fragment stage computes: squares[1] * factor + squares[0], with squares = source^2 + added.
Pixel expected(std::uint32_t added, float factor) {
    Pixel p{};
    for (std::uint32_t c = 0; c < 4; ++c) p[c] = static_cast<float>((1 + c) * (1 + c) + added) * factor + static_cast<float>(c * c + added);
    return p;
}

class GpuChain : public GpuTest {};

TEST_F(GpuChain, ComputeComputeDrawComputeCopy) {
    Chain c(device());
    Recorder r(device());
    for (std::uint32_t added = 0; added < 3; ++added) { // the second and third time every resource has a past
        r.fill(c.count, 0);
        c.record_compute(r, added);
        DrawPass pass = c.pass(c.draw, {&c.picture, vk::ClearColorValue(std::array{0.5f, 0.f, 0.f, 1.f})}, kAll);
        pass.targets.depth = DepthTarget{&c.depth, 0.0f, false};
        r.draw("triangle", pass, [&](DrawContext& d) {
            d.scissor(kLeft);
            draw_triangle(d, 2);
        });
        r.compute("mirror", c.mirror, {{"picture", c.picture}, {"mirrored", c.mirrored}}, {}, {3, 2});
        r.copy_to_buffer(c.mirrored, c.readback, kAll);
        const Timings times = r.submit_and_wait();
        ASSERT_EQ(times.size(), 6u);
        EXPECT_EQ(times[3].name, "triangle");
        for (const PassTime& t : times) EXPECT_TRUE(t.milliseconds >= 0 && t.milliseconds < 60'000) << t.name;

        const auto pixels = download_all<Pixel>(device(), c.readback);
        for (std::uint32_t y = 0; y < kSize.height; ++y)
            for (std::uint32_t x = 0; x < kSize.width; ++x)
                EXPECT_EQ(pixels[y * kSize.width + x], x < kSize.width / 2 ? (Pixel{0.5f, 0, 0, 1}) : expected(added, 2)) << x << "," << y;
        EXPECT_EQ(download_all<std::uint32_t>(device(), c.count)[0], kSize.width * kSize.height / 2);
    }
}

// Two passes into the same picture, the second on top of the first; then the same through four samples and a resolve.
TEST_F(GpuChain, KeptTargetsAndResolve) {
    Chain c(device());
    Recorder r(device());
    r.fill(c.count, 0);
    c.record_compute(r, 0);
    r.clear(c.picture, vk::ClearColorValue(std::array{7.f, 7.f, 7.f, 7.f}));
    const GraphicsPipeline without_depth = Chain::make_draw(device(), 1, vk::Format::eUndefined);
    r.draw("left", c.pass(without_depth, {&c.picture}, kLeft), [](DrawContext& d) { draw_triangle(d, 1); });
    r.submit_and_wait();
    auto pixels = read_image<Pixel>(device(), c.picture);
    EXPECT_EQ(pixels[0], expected(0, 1));
    EXPECT_EQ(pixels[kSize.width - 1], (Pixel{7, 7, 7, 7}));

    ColorTarget target{&c.samples, vk::ClearColorValue(std::array{1.f, 1.f, 1.f, 1.f}), &c.picture, false};
    r.draw("four samples", c.pass(c.draw_samples, target, kAll), [](DrawContext& d) { draw_triangle(d, 3); });
    r.submit_and_wait();
    EXPECT_THAT(read_image<Pixel>(device(), c.picture), Each(expected(0, 3)));
    EXPECT_EQ(read_image<Pixel>(device(), c.picture, {{3, 2}, {4, 5}}).size(), 20u);
}

TEST_F(GpuChain, APassWithoutPipelinesOnlyClears) {
    Chain c(device());
    Recorder r(device());
    r.draw("clear", {.targets = {{{&c.picture, vk::ClearColorValue(std::array{1.f, 2.f, 3.f, 4.f})}}, {}, kAll}}, [](DrawContext&) {});
    r.submit_and_wait();
    EXPECT_THAT(read_image<Pixel>(device(), c.picture), Each(Pixel{1, 2, 3, 4}));
    EXPECT_TRUE(r.submit_and_wait().empty()) << "nothing recorded, nothing submitted";
}

// More passes than one query pool and more sets than one descriptor pool hold.
TEST_F(GpuChain, ManyPassesInOneSubmit) {
    Chain c(device());
    Recorder r(device());
    for (unsigned round = 0; round < 2; ++round) {
        for (std::uint32_t i = 0; i < 300; ++i) r.compute("square", c.square, c.square_bindings(), SquarePush{kCount, i}, {2});
        EXPECT_EQ(r.submit_and_wait().size(), 300u);
        EXPECT_EQ(download_all<Texel>(device(), c.squares)[9], (Texel{81 + 299, 100 + 299, 121 + 299, 144 + 299}));
    }
}

// The same numbers from a storage buffer, where the device's texel buffers are too small.
TEST_F(GpuChain, StorageInsteadOfTexels) {
    Chain c(device());
    const ComputePipeline storage = make_compute(device(), test_shader("gpu_square.comp"), {{0, 1}}, sizeof(SquarePush));
    EXPECT_EQ(storage.stage().reflection.find("source"), nullptr);
    EXPECT_EQ(c.square.stage().reflection.find("source_storage"), nullptr);
    Recorder r(device());
    r.compute("texels", c.square, c.square_bindings(), SquarePush{kCount, 5}, {2});
    r.submit_and_wait();
    const auto from_texels = download_all<Texel>(device(), c.squares);
    EXPECT_EQ(from_texels[3], (Texel{14, 21, 30, 41}));
    r.fill(c.squares, 0);
    r.compute("storage", storage, c.square_bindings(), SquarePush{kCount, 5}, {2});
    r.submit_and_wait();
    EXPECT_EQ(download_all<Texel>(device(), c.squares), from_texels);
}

// Tests of the test: a history that is forgotten means a barrier that is missing, and the layers must say so.
TEST_F(GpuChain, AMissingBarrierIsReported) {
    expects_messages = true;
    Chain c(device());
    Recorder r(device());
    r.compute("square", c.square, c.square_bindings(), SquarePush{kCount, 0}, {2});
    c.squares.state().history = {};
    r.compute("triangle", c.triangle, {{"Squares", c.squares}, {"Vertices", c.vertices}, {"Indices", c.indices}}, {}, {});
    r.submit_and_wait();
    EXPECT_THAT(device().validation_messages(), Contains(HasSubstr("SYNC-HAZARD-READ-AFTER-WRITE")));
}

TEST_F(GpuChain, AWrongUsageIsReported) {
    expects_messages = true;
    Chain c(device());
    Buffer wrong = make_buffer(device(), "not for storage", kCount * 16, vk::BufferUsageFlagBits::eVertexBuffer);
    Recorder r(device());
    r.compute("square", c.square, {{"source", c.source}, {"Squares", wrong}}, SquarePush{kCount, 0}, {2});
    EXPECT_THAT(device().validation_messages(), Contains(AllOf(HasSubstr("VUID-VkWriteDescriptorSet"), HasSubstr("not for storage"))));
    r.submit_and_wait();
}

class GpuChainDeath : public GpuTest {};

TEST_F(GpuChainDeath, SlipsOfOursAreNamed) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    auto with_chain = [&](auto body) {
        Chain c(device());
        Recorder r(device());
        body(c, r);
    };
    EXPECT_DEATH(with_chain([](Chain& c, Recorder& r) {
                     r.compute("p", c.square, {{"source", c.source}}, SquarePush{}, {});
                 }),
                 "reads the storage buffer \"Squares\", which the pass does not bind");
    EXPECT_DEATH(with_chain([](Chain& c, Recorder& r) {
                     r.compute("p", c.square, {{"source", c.source}, {"Squares", c.squares}, {"sauce", c.source}}, SquarePush{}, {});
                 }),
                 "declares no binding \"sauce\"");
    EXPECT_DEATH(with_chain([](Chain& c, Recorder& r) {
                     r.compute("p", c.square, {{"source", c.squares}, {"Squares", c.squares}}, SquarePush{}, {});
                 }),
                 "\"squares\" has no texel view");
    EXPECT_DEATH(with_chain([](Chain& c, Recorder& r) { r.compute("p", c.square, c.square_bindings(), std::uint32_t{1}, {}); }),
                 "push constants");
    EXPECT_DEATH(make_compute(device(), test_shader("gpu_square.comp"), {}, 12), "8 == 12; push constants of gpu_square.comp");
}

} // namespace
} // namespace lightbench::gpu
