// Files that an imported file names, and the rule which of them the import may read.
#pragma once

#include <filesystem>
#include <string_view>

namespace lightbench::importer {

// Where an imported file may look for the files that it names.
struct Surroundings {
    std::filesystem::path folder; // names are relative to it
    std::filesystem::path root;   // may not be left, links followed, unless allow_outside
    bool allow_outside = false;
};

enum class Reference { found, missing, outside };

struct Found {
    Reference reference = Reference::missing;
    std::filesystem::path file; // as people would type it
};

// A regular file of that name. Backslashes separate folders too, if nothing has that very name: files of other systems are read here. Names
// that lead outside are told apart before the disk is asked, so that a file cannot find out what exists elsewhere.
Found find_named(const Surroundings& around, std::string_view name);

} // namespace lightbench::importer
