// One Assimp importer over files in memory.
#include "scene/import_assimp.h"

#include <algorithm>
#include <assimp/BaseImporter.h>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/importerdesc.h>
#include <cstring>
#include <new>
#include <string_view>

namespace lightbench::importer {

namespace {

class MemoryStream final : public Assimp::IOStream {
  public:
    explicit MemoryStream(std::span<const std::uint8_t> content) : content_(content) {}
    size_t Read(void* buffer, size_t size, size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (content_.size() - at_) / size);
        if (whole > 0) std::memcpy(buffer, content_.data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : content_.size();
        if (offset > content_.size() - base) return aiReturn_FAILURE;
        at_ = base + offset;
        return aiReturn_SUCCESS;
    }
    size_t Tell() const override { return at_; }
    size_t FileSize() const override { return content_.size(); }
    void Flush() override {}

  private:
    std::span<const std::uint8_t> content_;
    std::size_t at_ = 0;
};

class MemorySystem final : public Assimp::IOSystem {
  public:
    explicit MemorySystem(const MemoryFiles& files) : files_(files) {}
    bool Exists(const char* path) const override { return files_.contains(name_of(path)); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* path, const char*) override {
        const auto found = files_.find(name_of(path));
        return found == files_.end() ? nullptr : new MemoryStream(found->second); // Assimp's Close deletes it
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

  private:
    const MemoryFiles& files_;
    static std::string name_of(std::string_view path) { return std::string(path.substr(path.find_last_of('/') + 1)); }
};

std::string_view importer_name(ImportFormat format) {
    switch (format) {
    case ImportFormat::obj: return "Wavefront Object Importer";
    case ImportFormat::gltf: return "glTF2 Importer";
    case ImportFormat::ply: return "Stanford Polygon Library (PLY) Importer";
    case ImportFormat::stl: return "Stereolithography (STL) Importer";
    }
    return {};
}

void keep_only(Assimp::Importer& importer, std::string_view name) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        Assimp::BaseImporter* candidate = importer.GetImporter(i);
        if (candidate->GetInfo()->mName == name) continue;
        importer.UnregisterLoader(candidate);
        delete candidate; // unregistering hands it back
    }
}

} // namespace

std::variant<AssimpScene, std::string> read_with_assimp(ImportFormat format, const std::string& main, const MemoryFiles& files) {
    AssimpScene read{std::make_unique<Assimp::Importer>(), nullptr};
    keep_only(*read.importer, importer_name(format));
    if (read.importer->GetImporterCount() != 1) return "cannot be read: this Assimp has no reader for its format";
    read.importer->SetIOHandler(new MemorySystem(files)); // the importer owns it
    read.scene = read.importer->ReadFile(main, 0);
    if (read.scene) return read;
    const std::string why = read.importer->GetErrorString();
    if (why.find("bad_alloc") != why.npos) throw std::bad_alloc();
    return why.empty() ? "cannot be read" : why;
}

} // namespace lightbench::importer
