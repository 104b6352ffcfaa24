// A solution of radiosity as a file: versioned, for one mesh and one set of parameters, with a checksum. In and out: RadiositySolution.
#pragma once

#include "render/radiosity/solver.h"

#include <string>

namespace lightbench {

struct RadiositySolution {
    std::uint64_t key = 0; // of the elements, their materials and the parameters that it is for
    RadiosityState state;
};

// Whole or not at all. Throws FileError.
void write_solution(const std::string& path, const RadiositySolution& solution);

// Throws FileError, the user's: no solution, of another version, truncated or changed.
RadiositySolution read_solution(const std::string& path);

// FNV-1a, 64 bits: of bytes, after what was hashed before.
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t before = 0xcbf29ce484222325u);

} // namespace lightbench
