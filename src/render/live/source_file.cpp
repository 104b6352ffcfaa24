#include "render/live/source_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace lightbench {

namespace fs = std::filesystem;

SourceFile read_source(const fs::path& file) {
    constexpr std::uintmax_t largest = 4u << 20;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) return {"", "is gone"};
    if (fs::is_directory(status)) return {"", "is a folder; it must be a file"};
    if (!fs::is_regular_file(status)) return {"", "is no regular file"};
    if (const auto size = fs::file_size(file, error); !error && size > largest) return {"", "is larger than 4 MiB"};
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (const std::size_t zero = text.find('\0'); zero != text.npos)
        return {"", fmt::format("is not text: there is a zero byte in line {}",
                                1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n'))};
    return {std::move(text), ""};
}

} // namespace lightbench
