// The folder shaders/ while somebody edits it: which entry points depend on which file, and their compilation in a child process. In: the
// folder, functions to put in place of its own. Out: SPIR-V, sliders, errors where they were written.
#pragma once

#include "render/live/shader_error.h"
#include "render/live/sliders.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>

namespace lightbench {

using ShaderModules = std::map<std::string, std::vector<std::uint32_t>, std::less<>>; // by name of the entry point

struct CompiledShaders {
    ShaderModules modules; // that compiled, are valid and fit their place
    std::vector<Slider> sliders;
    ShaderErrors errors;  // empty: all of them did
    bool stopped = false; // and what is above means nothing
};

// Every source by its name: its path below the root; "user/N/NAME" of the Nth replacement, and likewise of what it includes beside it.
struct Sources {
    std::map<std::string, std::string> texts;
    std::map<std::string, std::string> faults; // why a text is empty: "is gone"
    std::map<std::string, std::filesystem::path> user_files;
    bool operator==(const Sources&) const = default;
};

// Of a file that was read: it is read again once one of these is another, or if it was so new then that a later save may have the same.
struct FileStamp {
    std::int64_t changed = 0; // nanoseconds
    std::uint64_t bytes = 0, node = 0;
    bool operator==(const FileStamp&) const = default;
};

class ShaderTree {
  public:
    // `root` is shaders/ of a source tree or of an installation; `replacements` are files with functions that take the place of those of the
    // same name below lib/.
    explicit ShaderTree(std::filesystem::path root, std::vector<std::filesystem::path> replacements = {});

    // Reads what was saved since, and which files it includes. Names of those that changed since the last time, appeared or are gone.
    std::vector<std::string> refresh();
    bool is_stale() const; // refresh() would find something
    // Files of the root that are not as they were when the program was built.
    std::vector<std::string> edited() const;
    // Entry points of the program that include one of these files, however far off, or are one.
    std::set<std::string> dependents(std::span<const std::string> files) const;
    // Entry points that replacements reach.
    std::set<std::string> replaced() const;
    // In a child each, `limit` for all together. Once `stop` is true they are ended. One call at a time, of copies too.
    CompiledShaders compile(const std::set<std::string>& entry_points, std::chrono::milliseconds limit = std::chrono::seconds(20),
                            const std::function<bool()>& stop = {}) const;

  private:
    using Stamps = std::map<std::string, FileStamp>; // by name
    Sources read(Stamps& stamps) const;
    void read_root(Sources& sources, Stamps& stamps) const;
    // What is compiled: sources with functions replaced and sliders made. Notes what is wrong with them, and entry points that need not be
    // compiled because of it.
    std::map<std::string, std::string> stage_texts(CompiledShaders& result, std::set<std::string>& spoilt) const;

    struct Stage;
    static void update(Stage& stage, const std::map<std::string, std::string>& texts);

    std::filesystem::path root_;
    mutable std::shared_ptr<Stage> stage_;                      // of compile(), from its first call on
    std::map<std::string, std::filesystem::path> replacements_; // by their names
    Sources sources_;
    Stamps stamps_;
};

// shaders/ of the source tree that the program was built from, or of the installation. LIGHTBENCH_SHADERS names another. Empty: none is there.
std::filesystem::path find_shader_sources();

} // namespace lightbench
