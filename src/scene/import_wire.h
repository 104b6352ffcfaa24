// A scene between two processes: Scene and Report as bytes. In: what the child found. Out: the same in the parent, or nothing if the bytes
// are not such a result, checked so far that no index in it leads outside.
#pragma once

#include "scene/import_report.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <span>

namespace lightbench::importer {

struct Imported {
    Scene scene;
    Report report;
};

// Throws std::bad_alloc where the descriptor takes no more. The objects are mesh uses: the formats have nothing else.
void write_imported(int descriptor, Imported& imported);
std::optional<Imported> read_imported(std::span<const std::uint8_t> bytes);

} // namespace lightbench::importer
