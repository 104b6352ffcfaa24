// Derives barriers.
#include "gpu/access.h"

#include "gpu/check.h"

#include <algorithm>

namespace lightbench::gpu {

void Access::merge(const Access& other) {
    CHECK(layout == other.layout, "one pass needs the image in two layouts");
    stages |= other.stages;
    access |= other.access;
    writes |= other.writes;
}

namespace {

bool covers(const Access& seen, const Access& next) {
    return (seen.stages & next.stages) == next.stages && (seen.access & next.access) == next.access;
}

// A write waits for the last write and for all who read since; reads have nothing to make available.
Dependency before_write(const History& history, const Access& next) {
    Dependency d{history.write_stages, next.stages, history.write_access, next.access, history.layout, next.layout};
    for (const Access& reader : history.readers) d.from_stages |= reader.stages;
    return d;
}

} // namespace

std::optional<Dependency> advance(History& history, const Access& next) {
    const bool moves = history.layout != next.layout;
    if (next.writes || moves) {
        const Dependency d = before_write(history, next);
        // After a mere change of layout the readers to come wait for the stages that waited for it (a chain of dependencies).
        history = {next.stages, next.access, {}, next.layout};
        if (!next.writes) history.readers.push_back(next);
        return d.from_stages || moves ? std::optional(d) : std::nullopt;
    }
    const bool seen = std::ranges::any_of(history.readers, [&](const Access& reader) { return covers(reader, next); });
    if (seen) return {};
    history.readers.push_back(next);
    if (!history.write_stages) return {};
    return Dependency{history.write_stages, next.stages, history.write_access, next.access, history.layout, next.layout};
}

} // namespace lightbench::gpu
