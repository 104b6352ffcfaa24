// Keeps the references of imported files inside the scene's folder.
#include "scene/import_files.h"

#include <algorithm>
#include <string>

namespace lightbench::importer {
namespace fs = std::filesystem;

namespace {

bool is_inside(const fs::path& file, const fs::path& root) {
    return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

Found find_exactly(const Surroundings& around, const std::string& name) {
    std::error_code error;
    const fs::path folder = fs::canonical(around.folder, error), root = fs::canonical(around.root, error);
    if (error) return {};
    if (!around.allow_outside && !is_inside((folder / name).lexically_normal(), root)) return {Reference::outside, {}};
    const fs::path real = fs::canonical(folder / name, error);
    if (error || !fs::is_regular_file(real, error)) return {};
    if (!around.allow_outside && !is_inside(real, root)) return {Reference::outside, {}};
    return {Reference::found, around.folder / name};
}

} // namespace

Found find_named(const Surroundings& around, std::string_view name) {
    std::string text(name);
    if (text.empty() || text.find('\0') != text.npos) return {};
    const Found found = find_exactly(around, text);
    if (found.reference != Reference::missing || text.find('\\') == text.npos) return found;
    std::replace(text.begin(), text.end(), '\\', '/');
    return find_exactly(around, text);
}

} // namespace lightbench::importer
