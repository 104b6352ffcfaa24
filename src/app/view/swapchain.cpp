#include "app/view/swapchain.h"

#include <algorithm>

namespace lightbench::view {
namespace {

// A driver on the CPU copies into the window: there is no screen to wait for, and Mesa 22.3.6's queue for waiting may never give an image back.
// Without vsync: the newest picture replaces the one that waits, else tearing, else vsync all the same (which alone is always there).
vk::PresentModeKHR present_mode(const Screen& screen, bool vsync) {
    const bool cpu = screen.physical.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
    if (vsync && !cpu) return vk::PresentModeKHR::eFifo;
    const auto modes = screen.physical.getSurfacePresentModesKHR(*screen.surface);
    for (const auto mode : {cpu ? vk::PresentModeKHR::eImmediate : vk::PresentModeKHR::eMailbox, vk::PresentModeKHR::eImmediate})
        if (std::ranges::find(modes, mode) != modes.end()) return mode;
    return vk::PresentModeKHR::eFifo;
}

vk::Extent2D extent_for(const vk::SurfaceCapabilitiesKHR& can, vk::Extent2D framebuffer) {
    if (can.currentExtent.width != 0xffffffffu) return can.currentExtent;
    return {std::clamp(framebuffer.width, can.minImageExtent.width, can.maxImageExtent.width),
            std::clamp(framebuffer.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

std::uint32_t image_count(const vk::SurfaceCapabilitiesKHR& can) {
    const std::uint32_t wanted = std::max(can.minImageCount + 1, 2u);
    return can.maxImageCount > 0 ? std::min(wanted, can.maxImageCount) : wanted;
}

vk::CompositeAlphaFlagBitsKHR alpha_of(const vk::SurfaceCapabilitiesKHR& can) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    for (const Alpha alpha : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied})
        if (can.supportedCompositeAlpha & alpha) return alpha;
    return Alpha::ePostMultiplied;
}

void make_targets(Swapchain& c, const Screen& screen, vk::RenderPass pass) {
    c.framebuffers.clear(), c.views.clear(), c.drawn.clear();
    c.images.clear();
    for (const auto image : c.chain.getImages()) c.images.push_back(vk::Image(image));
    for (const vk::Image image : c.images) {
        c.views.emplace_back(screen.device, vk::ImageViewCreateInfo{.image = image,
                                                                    .viewType = vk::ImageViewType::e2D,
                                                                    .format = c.format,
                                                                    .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}});
        const vk::ImageView view = *c.views.back();
        c.framebuffers.emplace_back(screen.device, vk::FramebufferCreateInfo{.renderPass = pass,
                                                                             .attachmentCount = 1,
                                                                             .pAttachments = &view,
                                                                             .width = c.extent.width,
                                                                             .height = c.extent.height,
                                                                             .layers = 1});
        c.drawn.emplace_back(screen.device, vk::SemaphoreCreateInfo{});
    }
}

} // namespace

vk::SurfaceFormatKHR surface_format(const Screen& screen) {
    const auto formats = screen.physical.getSurfaceFormatsKHR(*screen.surface);
    for (const auto wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm})
        for (const vk::SurfaceFormatKHR& format : formats)
            if (format.format == wanted) return format;
    throw gpu::EnvironmentError("the window offers no 8-bit format without conversion");
}

vk::raii::RenderPass make_interface_pass(const Screen& screen, vk::Format format) {
    using Layout = vk::ImageLayout;
    const vk::AttachmentDescription color{.format = format,
                                          .samples = vk::SampleCountFlagBits::e1,
                                          .loadOp = vk::AttachmentLoadOp::eLoad,
                                          .storeOp = vk::AttachmentStoreOp::eStore,
                                          .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
                                          .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
                                          .initialLayout = Layout::eColorAttachmentOptimal,
                                          .finalLayout = Layout::ePresentSrcKHR};
    const vk::AttachmentReference reference{0, Layout::eColorAttachmentOptimal};
    const vk::SubpassDescription subpass{
        .pipelineBindPoint = vk::PipelineBindPoint::eGraphics, .colorAttachmentCount = 1, .pColorAttachments = &reference};
    return {screen.device,
            vk::RenderPassCreateInfo{.attachmentCount = 1, .pAttachments = &color, .subpassCount = 1, .pSubpasses = &subpass}};
}

bool remake(Swapchain& c, const Screen& screen, vk::RenderPass pass, vk::Extent2D framebuffer, bool vsync) {
    const vk::SurfaceCapabilitiesKHR can = screen.physical.getSurfaceCapabilitiesKHR(*screen.surface);
    const vk::Extent2D extent = extent_for(can, framebuffer);
    if (extent.width == 0 || extent.height == 0) return false;
    if (!(can.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferDst))
        throw gpu::EnvironmentError("pictures cannot be copied into this window");
    const vk::SurfaceFormatKHR format = surface_format(screen);
    c.extent = extent, c.format = format.format, c.vsync = vsync, c.least_images = std::max(can.minImageCount, 2u);
    vk::raii::SwapchainKHR old = std::move(c.chain);
    c.chain = {screen.device,
               vk::SwapchainCreateInfoKHR{.surface = *screen.surface,
                                          .minImageCount = image_count(can),
                                          .imageFormat = format.format,
                                          .imageColorSpace = format.colorSpace,
                                          .imageExtent = extent,
                                          .imageArrayLayers = 1,
                                          .imageUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst,
                                          .imageSharingMode = vk::SharingMode::eExclusive,
                                          .preTransform = can.currentTransform,
                                          .compositeAlpha = alpha_of(can),
                                          .presentMode = present_mode(screen, vsync),
                                          .clipped = true,
                                          .oldSwapchain = *old}};
    make_targets(c, screen, pass);
    return true;
}

} // namespace lightbench::view
