// What a click on the picture asks, and whether its answer is still of what is shown.
#include "app/view/viewer.h"

namespace lightbench::view {
namespace {

// One ray through the middle of the pixel.
Request inspected(Request request) {
    request.crop.reset(), request.output = Output::radiance, request.sampling = Sampling::none, request.spp = 1;
    return request;
}

// From wherever one looks: the rays stay where they are.
Request from_anywhere(Request request) {
    request = inspected(std::move(request));
    request.placed.reset(), request.size.reset();
    return request;
}

} // namespace

// Of radiosity its patch: no ray of a ray tree is traced there.
void Viewer::inspect(glm::uvec2 pixel) {
    const Request shown = request_of(state_, state_.active, size_);
    if (shown.crop) pixel += shown.crop->offset;
    log_.say("click {},{}", pixel.x, pixel.y);
    RadiosityParameters& radiosity = state_.side().radiosity;
    if (shown.method == Method::radiosity) {
        radiosity.pick = pixel;
        if (radiosity.show == Show::light || radiosity.show == Show::patches) radiosity.show = Show::form_factors;
        return;
    }
    Request request = inspected(shown);
    request.crop = Rect{pixel, {1, 1}};
    worker_->ask({{opened_.scene, opened_.version}, request, pixel});
}

std::shared_ptr<const Answer> Viewer::answer() const {
    if (!news_.answer || news_.answer->question.scene.version != opened_.version) return nullptr;
    const bool same = from_anywhere(news_.answer->question.request) == from_anywhere(request_of(state_, state_.active, size_));
    return same ? news_.answer : nullptr;
}

} // namespace lightbench::view
