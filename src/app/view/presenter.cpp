#include "app/view/presenter.h"

#include "app/view/picture.h"
#include "app/view/swapchain.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

namespace lightbench::view {

struct PresenterParts {
    GLFWwindow* window;
    Screen screen;
    vk::raii::RenderPass pass;
    vk::raii::DescriptorPool descriptors{nullptr};
    Swapchain chain{};
    bool vsync = true, stale = true; // stale: the chain does not fit the window any more
    std::array<PictureOnScreen, 2> pictures{};
    std::array<std::shared_ptr<const Image8>, 2> keep{}; // until it is copied
    struct Frame {
        vk::raii::CommandPool pool{nullptr};
        vk::raii::CommandBuffers commands{nullptr};
        vk::raii::Fence done{nullptr};
        vk::raii::Semaphore acquired{nullptr};
    };
    std::array<Frame, kFramesInFlight> frames{};
    unsigned frame = 0;
};

namespace {

// Nanoseconds of each wait of a frame, for the screen and for the driver, which compiles what is new: then hands have their turn. Hidden windows may
// get no image at all.
constexpr std::uint64_t kPatience = 20'000'000;
constexpr std::array<float, 4> kBackground = {0.09f, 0.09f, 0.1f, 1};

void check_backend(VkResult result) {
    if (result < 0) throw gpu::EnvironmentError(fmt::format("the interface could not be drawn: {}", vk::to_string(vk::Result(result))));
}

void make_frames(PresenterParts& p) {
    for (PresenterParts::Frame& f : p.frames) {
        f.pool = {p.screen.device,
                  vk::CommandPoolCreateInfo{.flags = vk::CommandPoolCreateFlagBits::eTransient, .queueFamilyIndex = p.screen.family}};
        f.commands = {p.screen.device, vk::CommandBufferAllocateInfo{.commandPool = *f.pool, .commandBufferCount = 1}};
        f.done = {p.screen.device, vk::FenceCreateInfo{.flags = vk::FenceCreateFlagBits::eSignaled}};
        f.acquired = {p.screen.device, vk::SemaphoreCreateInfo{}};
    }
}

void upload_fonts(PresenterParts& p) {
    const vk::raii::CommandBuffer& commands = p.frames[0].commands[0];
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    ImGui_ImplVulkan_CreateFontsTexture(*commands);
    commands.end();
    const vk::CommandBuffer handle = *commands;
    p.screen.queue.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &handle});
    p.screen.queue.waitIdle();
    p.frames[0].pool.reset();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

void start_backend(PresenterParts& p) {
    const vk::DescriptorPoolSize size{vk::DescriptorType::eCombinedImageSampler, 1};
    p.descriptors = {p.screen.device, vk::DescriptorPoolCreateInfo{.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                                   .maxSets = 1,
                                                                   .poolSizeCount = 1,
                                                                   .pPoolSizes = &size}};
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = *p.screen.instance, info.PhysicalDevice = *p.screen.physical, info.Device = *p.screen.device;
    info.QueueFamily = p.screen.family, info.Queue = *p.screen.queue, info.DescriptorPool = *p.descriptors;
    // Of these only the second counts: a ring of as many vertex buffers, of which no more are in use than there are frames in flight.
    info.MinImageCount = kFramesInFlight, info.ImageCount = kFramesInFlight;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT, info.CheckVkResultFn = check_backend;
    ImGui_ImplGlfw_InitForVulkan(p.window, true);
    ImGui_ImplVulkan_Init(&info, *p.pass);
    upload_fonts(p);
}

// False: no area.
bool renew_chain(PresenterParts& p) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(p.window, &width, &height);
    if (width <= 0 || height <= 0) return false;
    p.screen.device.waitIdle();
    const vk::Extent2D size{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    p.stale = !remake(p.chain, p.screen, *p.pass, size, p.vsync);
    return !p.stale;
}

std::optional<std::uint32_t> acquire(PresenterParts& p) {
    try {
        const auto [result, image] = p.chain.chain.acquireNextImage(kPatience, *p.frames[p.frame].acquired, nullptr);
        if (result == vk::Result::eTimeout || result == vk::Result::eNotReady) return std::nullopt; // a frame later
        p.stale = result == vk::Result::eSuboptimalKHR;
        return image;
    } catch (const vk::OutOfDateKHRError&) {
        p.stale = true;
        return std::nullopt;
    }
}

void record_pictures(PresenterParts& p, const vk::raii::CommandBuffer& commands, vk::Image target, std::span<const Placement> placements) {
    using At = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    using Layout = vk::ImageLayout;
    for (std::size_t i = 0; i < p.pictures.size(); ++i) record_upload(p.pictures[i], commands, p.frame), p.keep[i].reset();
    const ImageUse copied{Layout::eTransferDstOptimal, At::eTransfer, Access::eTransferWrite};
    record_change(commands, target, {Layout::eUndefined, At::eTransfer, {}}, copied);
    commands.clearColorImage(target, Layout::eTransferDstOptimal, vk::ClearColorValue{kBackground}, kWholeImage);
    record_change(commands, target, copied, copied); // the pictures come after the background
    for (const Placement& at : placements)
        if (const PictureOnScreen& picture = p.pictures.at(at.picture); *picture.image)
            record_blit(picture, commands, target, p.chain.extent, {at.from_x0, at.from_y0, at.from_x1, at.from_y1},
                        {at.to_x0, at.to_y0, at.to_x1, at.to_y1});
    record_change(
        commands, target, copied,
        {Layout::eColorAttachmentOptimal, At::eColorAttachmentOutput, Access::eColorAttachmentRead | Access::eColorAttachmentWrite});
}

void record(PresenterParts& p, std::uint32_t image, std::span<const Placement> placements) {
    const vk::raii::CommandBuffer& commands = p.frames[p.frame].commands[0];
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record_pictures(p, commands, p.chain.images[image], placements);
    commands.beginRenderPass({.renderPass = *p.pass, .framebuffer = *p.chain.framebuffers[image], .renderArea = {{0, 0}, p.chain.extent}},
                             vk::SubpassContents::eInline);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
    commands.endRenderPass();
    commands.end();
}

void submit(PresenterParts& p, std::uint32_t image) {
    const PresenterParts::Frame& f = p.frames[p.frame];
    const vk::PipelineStageFlags wait = vk::PipelineStageFlagBits::eTransfer;
    const vk::CommandBuffer commands = *f.commands[0];
    const vk::Semaphore acquired = *f.acquired, drawn = *p.chain.drawn[image];
    p.screen.queue.submit(vk::SubmitInfo{.waitSemaphoreCount = 1,
                                         .pWaitSemaphores = &acquired,
                                         .pWaitDstStageMask = &wait,
                                         .commandBufferCount = 1,
                                         .pCommandBuffers = &commands,
                                         .signalSemaphoreCount = 1,
                                         .pSignalSemaphores = &drawn},
                          *f.done);
    const vk::SwapchainKHR chain = *p.chain.chain;
    try {
        const vk::Result result = p.screen.queue.presentKHR(
            {.waitSemaphoreCount = 1, .pWaitSemaphores = &drawn, .swapchainCount = 1, .pSwapchains = &chain, .pImageIndices = &image});
        p.stale = p.stale || result == vk::Result::eSuboptimalKHR;
    } catch (const vk::OutOfDateKHRError&) {
        p.stale = true;
    }
}

bool show(PresenterParts& p, std::span<const Placement> placements) {
    if (p.stale && !renew_chain(p)) return false;
    PresenterParts::Frame& f = p.frames[p.frame];
    if (p.screen.device.waitForFences(*f.done, true, kPatience) == vk::Result::eTimeout) return false;
    std::optional<std::uint32_t> image = acquire(p);
    if (!image && p.stale && renew_chain(p)) image = acquire(p);
    if (!image) return false;
    p.screen.device.resetFences(*f.done);
    f.pool.reset();
    record(p, *image, placements);
    submit(p, *image);
    p.frame = (p.frame + 1) % kFramesInFlight;
    return true;
}

} // namespace

Presenter::Presenter(GLFWwindow* window, const std::string& device) {
    Screen screen = open_screen(window, device);
    shown("preparing the window", [&] {
        vk::raii::RenderPass pass = make_interface_pass(screen, surface_format(screen).format);
        parts_.reset(new PresenterParts{window, std::move(screen), std::move(pass)});
        make_frames(*parts_);
        start_backend(*parts_);
    });
}

Presenter::~Presenter() {
    (*parts_->screen.device).waitIdle(*parts_->screen.device.getDispatcher());
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
}

void Presenter::set_picture(unsigned slot, std::shared_ptr<const Image8> picture) {
    parts_->keep.at(slot) = std::move(picture);
    shown("taking up a picture", [&] { view::set_picture(parts_->pictures[slot], parts_->screen, *parts_->keep[slot]); });
}

void Presenter::set_vsync(bool on) {
    parts_->stale = parts_->stale || on != parts_->vsync;
    parts_->vsync = on;
}

void Presenter::begin_frame() {
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

bool Presenter::present(std::span<const Placement> pictures) {
    return shown("showing a frame", [&] { return show(*parts_, pictures); });
}

std::shared_ptr<const gpu::ValidationLog> Presenter::validation_log() const {
    return parts_->screen.log;
}

bool Presenter::waits_for_screen() const {
    return parts_->screen.physical.getProperties().deviceType != vk::PhysicalDeviceType::eCpu;
}

} // namespace lightbench::view
