// Both directions of the wire are one list of fields. The structured bindings name every field of a struct: one that is added to scene.h and
// forgotten here does not compile.
#include "scene/import_wire.h"

#include <cerrno>
#include <cstring>
#include <new>
#include <type_traits>
#include <unistd.h>

namespace lightbench::importer {

namespace {

constexpr std::uint64_t kFirst = 0x6c62696d706f7274, kLast = 0x74726f706d69626c;

struct Writer {
    int descriptor;
    std::vector<std::uint8_t> pending;
    static constexpr bool kReads = false;

    void send(const void* data, std::size_t size) {
        for (const auto* at = static_cast<const std::uint8_t*>(data); size > 0;) {
            const ssize_t sent = ::write(descriptor, at, size);
            if (sent < 0 && errno == EINTR) continue;
            if (sent <= 0) throw std::bad_alloc();
            at += sent, size -= static_cast<std::size_t>(sent);
        }
    }
    void flush() {
        send(pending.data(), pending.size());
        pending.clear();
    }
    void bytes(void* data, std::size_t size) {
        constexpr std::size_t kBatch = 1 << 16;
        if (pending.size() + size > kBatch) flush();
        if (size > kBatch) return send(data, size);
        const auto* first = static_cast<const std::uint8_t*>(data);
        pending.insert(pending.end(), first, first + size);
    }
};

struct Reader {
    std::span<const std::uint8_t> rest;
    bool failed = false;
    static constexpr bool kReads = true;

    void bytes(void* data, std::size_t size) {
        failed |= size > rest.size();
        if (failed || size == 0) return;
        std::memcpy(data, rest.data(), size);
        rest = rest.subspan(size);
    }
};

// What travels as its bytes. GLM's vectors are not formally trivial (GLM_FORCE_CTOR_INIT writes their constructors out), but hold numbers only.
template <class T> constexpr bool kPlain = std::is_trivially_copyable_v<T>;
template <glm::length_t N, class T, glm::qualifier Q> constexpr bool kPlain<glm::vec<N, T, Q>> = true;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q> constexpr bool kPlain<glm::mat<C, R, T, Q>> = true;

template <class A, class T>
    requires kPlain<T>
void transfer(A& a, T& value) {
    a.bytes(&value, sizeof value);
}

// Every element takes at least one byte of the wire, so a count beyond the rest is garbage and is never allocated.
template <class A, class C> void transfer_size(A& a, C& container, std::size_t least_bytes) {
    std::uint64_t size = container.size();
    transfer(a, size);
    if constexpr (A::kReads) {
        a.failed |= size > a.rest.size() / least_bytes;
        container.resize(a.failed ? 0 : size);
    }
}

template <class A> void transfer(A& a, std::string& text) {
    transfer_size(a, text, 1);
    a.bytes(text.data(), text.size());
}

template <class A> void transfer(A& a, std::filesystem::path& path) {
    std::string text = path.string();
    transfer(a, text);
    path = text;
}

template <class A, class T> void transfer(A& a, std::vector<T>& list);

template <class A, class T>
    requires(!kPlain<std::optional<T>>)
void transfer(A& a, std::optional<T>& value) {
    std::uint8_t present = value.has_value();
    transfer(a, present);
    if (A::kReads && present != 0) value.emplace();
    if (present != 0) transfer(a, *value);
}

template <class A> void transfer(A& a, Picture& value) {
    auto& [file, encoded] = value;
    transfer(a, file), transfer(a, encoded);
}
template <class A> void transfer(A& a, Problem& value) {
    auto& [file, line, column, text] = value;
    transfer(a, file), transfer(a, line), transfer(a, column), transfer(a, text);
}
template <class A> void transfer(A& a, ProblemLog& value) {
    auto& [max, kept, unlisted] = value;
    transfer(a, max), transfer(a, kept), transfer(a, unlisted);
}
template <class A> void transfer(A& a, Report& value) {
    auto& [file, log, remarks, unlisted_remarks] = value;
    transfer(a, file), transfer(a, log), transfer(a, remarks), transfer(a, unlisted_remarks);
}
template <class A> void transfer(A& a, Camera& value) {
    auto& [name, position, target, up, fov, hither] = value;
    transfer(a, name), transfer(a, position), transfer(a, target), transfer(a, up), transfer(a, fov), transfer(a, hither);
}
template <class A> void transfer(A& a, Environment& value) {
    auto& [background, ambient, map] = value;
    transfer(a, background), transfer(a, ambient), transfer(a, map);
}
template <class A> void transfer(A& a, Light& value) {
    auto& [type, position, direction, intensity, attenuation, d0, angle, softness] = value;
    transfer(a, type), transfer(a, position), transfer(a, direction), transfer(a, intensity);
    transfer(a, attenuation), transfer(a, d0), transfer(a, angle), transfer(a, softness);
}
template <class A> void transfer(A& a, Texture& value) {
    auto& [picture, mapping, scale, wrap_u, wrap_v, alpha] = value;
    transfer(a, picture), transfer(a, mapping), transfer(a, scale), transfer(a, wrap_u), transfer(a, wrap_v), transfer(a, alpha);
}
template <class A> void transfer(A& a, Bump& value) {
    auto& [picture, normal_map, function, amplitude, frequency] = value;
    transfer(a, picture), transfer(a, normal_map), transfer(a, function), transfer(a, amplitude), transfer(a, frequency);
}
template <class A> void transfer(A& a, Material& value) {
    auto& [name, diffuse, specular, shininess, model, distribution, roughness, ior, f0, fresnel, reflection, transmission, scatter,
           dispersion, opacity, emission, two_sided, environment, texture, bump] = value;
    const auto all = [&a](auto&... fields) { (transfer(a, fields), ...); };
    all(name, diffuse, specular, shininess, model, distribution, roughness, ior, f0, fresnel, reflection, transmission, scatter,
        dispersion);
    all(opacity, emission, two_sided, environment, texture, bump);
}
template <class A> void transfer(A& a, Mesh& value) {
    auto& [name, positions, normals, uvs, tangents, corners, face_starts, face_materials] = value;
    transfer(a, name), transfer(a, positions), transfer(a, normals), transfer(a, uvs), transfer(a, tangents);
    transfer(a, corners), transfer(a, face_starts), transfer(a, face_materials);
}
template <class A> void transfer(A& a, Object& value) {
    auto& [shape, material, transform, crease, subdivide] = value;
    if constexpr (A::kReads) shape = MeshUse{};
    transfer(a, std::get<MeshUse>(shape).mesh);
    transfer(a, material), transfer(a, transform), transfer(a, crease), transfer(a, subdivide);
}
template <class A> void transfer(A& a, Scene& value) {
    auto& [name, film, cameras, environment, lights, materials, transforms, meshes, pictures, objects, remarks] = value;
    transfer(a, name), transfer(a, film), transfer(a, cameras), transfer(a, environment), transfer(a, lights), transfer(a, materials);
    transfer(a, transforms), transfer(a, meshes), transfer(a, pictures), transfer(a, objects), transfer(a, remarks);
}

template <class A, class T> void transfer(A& a, std::vector<T>& list) {
    if constexpr (kPlain<T>) {
        transfer_size(a, list, sizeof(T));
        a.bytes(list.data(), list.size() * sizeof(T));
    } else {
        transfer_size(a, list, 1);
        for (T& item : list) transfer(a, item);
    }
}

template <class A> bool transfer_all(A& a, Imported& imported) {
    std::uint64_t first = kFirst, last = kLast;
    transfer(a, first), transfer(a, imported.scene), transfer(a, imported.report), transfer(a, last);
    return first == kFirst && last == kLast;
}

template <class T> bool all_below(const std::vector<T>& indices, std::size_t limit) {
    for (const T index : indices)
        if (index >= limit) return false;
    return true;
}

bool is_sound(const Mesh& mesh, std::size_t materials) {
    const std::size_t vertices = mesh.positions.size(), faces = mesh.face_count();
    const auto fits = [](std::size_t size, std::size_t full) { return size == 0 || size == full; };
    if (!fits(mesh.normals.size(), vertices) || !fits(mesh.uvs.size(), vertices) || !fits(mesh.tangents.size(), vertices)) return false;
    if (!fits(mesh.face_materials.size(), faces)) return false;
    if (mesh.face_starts.empty() || mesh.face_starts.front() != 0 || mesh.face_starts.back() != mesh.corners.size()) return false;
    for (std::size_t face = 0; face < faces; ++face)
        if (mesh.face_starts[face + 1] < mesh.face_starts[face]) return false;
    return all_below(mesh.corners, vertices) && all_below(mesh.face_materials, materials);
}

bool is_sound(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes)
        if (!is_sound(mesh, scene.materials.size())) return false;
    for (const Material& material : scene.materials) {
        if (material.texture && (material.texture->wrap_u > Wrap::mirror || material.texture->wrap_v > Wrap::mirror)) return false;
        if (material.texture && material.texture->picture.value_or(0) >= scene.pictures.size() && material.texture->picture) return false;
        if (material.bump && material.bump->picture.value_or(0) >= scene.pictures.size() && material.bump->picture) return false;
    }
    for (const Object& object : scene.objects) {
        if (std::get<MeshUse>(object.shape).mesh >= scene.meshes.size()) return false;
        if (object.material >= scene.materials.size() || object.transform >= scene.transforms.size()) return false;
    }
    return true;
}

} // namespace

void write_imported(int descriptor, Imported& imported) {
    Writer writer{descriptor, {}};
    transfer_all(writer, imported);
    writer.flush();
}

std::optional<Imported> read_imported(std::span<const std::uint8_t> bytes) {
    Reader reader{bytes};
    Imported imported;
    const bool marked = transfer_all(reader, imported);
    if (!marked || reader.failed || !reader.rest.empty() || !is_sound(imported.scene)) return {};
    return imported;
}

} // namespace lightbench::importer
