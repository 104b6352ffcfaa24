// The file: a magic word with the version, key, shots, number of elements, then the state's arrays, then zlib's CRC-32 of all before it.
#include "render/radiosity/solution.h"

#include "image/file_bytes.h"

#include <cstring>
#include <fmt/format.h>
#include <zlib.h>

namespace lightbench {
namespace {

constexpr char kMagic[8] = {'l', 'b', 'r', 'a', 'd', '0', '0', '1'}; // the last three: the version
struct Header {
    char magic[8];
    std::uint64_t key, shots, elements;
    double escaped[3];
};

std::uint32_t checksum(std::span<const unsigned char> bytes) {
    uLong crc = crc32(0, nullptr, 0);
    for (std::size_t at = 0; at < bytes.size(); at += 1u << 30) // zlib counts in 32 bits
        crc = crc32(crc, bytes.data() + at, static_cast<uInt>(std::min<std::size_t>(bytes.size() - at, 1u << 30)));
    return static_cast<std::uint32_t>(crc);
}

// Every array of a state, in the order of the file.
template <class State, class Visit> void each_array(State& state, Visit&& visit) {
    for (auto* values : {&state.radiosity, &state.unshot, &state.received, &state.unshot_carry, &state.received_carry}) visit(*values);
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw FileError(FileError::Blame::Input, fmt::format("{}: {}", path, why));
}

Header header_of(const std::string& path, std::span<const unsigned char> bytes) {
    Header header{};
    if (bytes.size() < sizeof(header) + 4 || std::memcmp(bytes.data(), kMagic, 5) != 0)
        refuse(path, "is no solution of radiosity; --solution writes one");
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (std::memcmp(header.magic, kMagic, 8) != 0) refuse(path, "is a solution of another version of this program");
    return header;
}

} // namespace

void write_solution(const std::string& path, const RadiositySolution& solution) {
    Header header{{}, solution.key, solution.state.shots, solution.state.radiosity.size(), {}};
    for (int c = 0; c < 3; ++c) header.escaped[c] = solution.state.escaped[c];
    std::memcpy(header.magic, kMagic, 8);
    std::vector<unsigned char> bytes;
    const auto append = [&](const void* from, std::size_t n) {
        const auto* first = static_cast<const unsigned char*>(from);
        bytes.insert(bytes.end(), first, first + n);
    };
    append(&header, sizeof(header));
    each_array(solution.state, [&](const auto& values) { append(values.data(), values.size() * sizeof(values[0])); });
    const std::uint32_t sum = checksum(bytes);
    append(&sum, sizeof(sum));
    write_file(path, bytes);
}

RadiositySolution read_solution(const std::string& path) {
    const std::vector<unsigned char> bytes = read_file(path);
    const Header header = header_of(path, bytes);
    const std::size_t body = bytes.size() - 4;
    std::uint32_t sum = 0;
    std::memcpy(&sum, bytes.data() + body, 4);
    RadiositySolution solution{header.key, {}};
    std::size_t need = sizeof(header);
    each_array(solution.state, [&](auto& values) { need += header.elements * sizeof(values[0]); });
    if (header.elements > bytes.size() || need != body || sum != checksum(std::span(bytes).first(body)))
        refuse(path, "is truncated or was changed: its checksum does not agree");
    std::size_t at = sizeof(header);
    each_array(solution.state, [&](auto& values) {
        values.resize(header.elements);
        const std::span<std::byte> to = std::as_writable_bytes(std::span(values));
        std::memcpy(to.data(), bytes.data() + at, to.size());
        at += to.size();
    });
    solution.state.shots = header.shots;
    for (int c = 0; c < 3; ++c) solution.state.escaped[c] = header.escaped[c];
    return solution;
}

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t before) {
    for (const std::byte b : bytes) before = (before ^ static_cast<std::uint64_t>(b)) * 0x100000001b3u;
    return before;
}

} // namespace lightbench
