#include "image/temporary_folder.h"

#include "image/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <stdlib.h>

namespace lightbench {

TemporaryFolder::TemporaryFolder(std::string_view purpose) {
    const std::filesystem::path where = std::filesystem::temp_directory_path();
    std::string name = (where / fmt::format("lightbench-{}-XXXXXX", purpose)).string();
    if (::mkdtemp(name.data()) == nullptr)
        throw FileError(FileError::Blame::Environment,
                        fmt::format("{}: no folder can be made there: {}", where.string(), std::strerror(errno)));
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

} // namespace lightbench
