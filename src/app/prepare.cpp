#include "app/prepare.h"

#include "app/errors.h"
#include "render/render.h"
#include "scene/check.h"

namespace lightbench {

Scene load_or_throw(const std::filesystem::path& file, bool allow_outside) {
    LoadOptions options;
    options.allow_outside = allow_outside;
    Loaded loaded = load_scene(file, options);
    if (!loaded.scene) throw UserError(problem_lines(loaded, file));
    return std::move(*loaded.scene);
}

Prepared prepare(Scene& scene, Request request) {
    CompleteResult result = complete(scene, request);
    if (!result.completed) throw UserError(result.problems);
    const View view = result.completed->view;
    request.size = view.size;
    Facts facts = gather_facts(scene);
    facts.headlight = result.completed->headlight;
    add_view(facts, scene, view);
    const Plan first = decide(facts, request);
    Prepared prepared{view, {}, tessellate(scene, tessellation_for(first, view))};
    add_geometry(facts, prepared.geometry);
    prepared.plan = decide(facts, request, std::move(result.completed->notes));
    return prepared;
}

} // namespace lightbench
