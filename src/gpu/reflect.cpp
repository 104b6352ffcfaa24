// Reflection through SPIRV-Cross' C interface.
#include "gpu/reflect.h"

#include "gpu/check.h"

#include <algorithm>
#include <memory>
#include <spirv_cross/spirv_cross_c.h>

namespace lightbench::gpu {
namespace {

struct ContextDelete {
    void operator()(spvc_context_s* context) const { spvc_context_destroy(context); }
};

struct Reader {
    std::unique_ptr<spvc_context_s, ContextDelete> context;
    spvc_compiler compiler = nullptr;
    spvc_resources resources = nullptr;

    void must(spvc_result result) const {
        CHECK(result == SPVC_SUCCESS, "SPIRV-Cross: {}", spvc_context_get_last_error_string(context.get()));
    }

    explicit Reader(std::span<const std::uint32_t> words) {
        spvc_context raw = nullptr;
        const spvc_result result = spvc_context_create(&raw);
        context.reset(raw);
        must(result);
        spvc_parsed_ir ir = nullptr;
        must(spvc_context_parse_spirv(raw, words.data(), words.size(), &ir));
        must(spvc_context_create_compiler(raw, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler));
        must(spvc_compiler_create_shader_resources(compiler, &resources));
    }

    std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        must(spvc_resources_get_resource_list_for_type(resources, type, &first, &count));
        return {first, count};
    }

    std::string name(const spvc_reflected_resource& r) const {
        const char* own = spvc_compiler_get_name(compiler, r.id);
        return own && *own ? own : r.name;
    }

    std::uint32_t decoration(const spvc_reflected_resource& r, SpvDecoration which) const {
        return spvc_compiler_get_decoration(compiler, r.id, which);
    }

    std::uint32_t struct_size(spvc_type type) const {
        std::size_t size = 0;
        must(spvc_compiler_get_declared_struct_size(compiler, type, &size));
        return static_cast<std::uint32_t>(size);
    }
};

vk::ShaderStageFlagBits stage_of(const Reader& reader) {
    switch (spvc_compiler_get_execution_model(reader.compiler)) {
    case SpvExecutionModelVertex: return vk::ShaderStageFlagBits::eVertex;
    case SpvExecutionModelFragment: return vk::ShaderStageFlagBits::eFragment;
    case SpvExecutionModelGLCompute: return vk::ShaderStageFlagBits::eCompute;
    default: CHECK(false, "a stage that no pipeline of ours has"); return {};
    }
}

// `readonly` and `writeonly`: of all members for blocks, of the variable for images.
void read_access(const Reader& reader, const spvc_reflected_resource& r, ReflectedBinding& b) {
    if (b.kind != BindingKind::storage_buffer) {
        const bool storage = b.kind == BindingKind::storage_image || b.kind == BindingKind::storage_texel;
        b.written = storage && !spvc_compiler_has_decoration(reader.compiler, r.id, SpvDecorationNonWritable);
        b.read = !spvc_compiler_has_decoration(reader.compiler, r.id, SpvDecorationNonReadable);
        return;
    }
    const SpvDecoration* first = nullptr;
    std::size_t count = 0;
    reader.must(spvc_compiler_get_buffer_block_decorations(reader.compiler, r.id, &first, &count));
    const std::span decorations(first, count);
    b.written = std::ranges::find(decorations, SpvDecorationNonWritable) == decorations.end();
    b.read = std::ranges::find(decorations, SpvDecorationNonReadable) == decorations.end();
}

void read_block(const Reader& reader, spvc_type type, ReflectedBinding& b) {
    b.block_size = reader.struct_size(type);
    const unsigned last = spvc_type_get_num_member_types(type) - 1;
    const spvc_type member = spvc_compiler_get_type_handle(reader.compiler, spvc_type_get_member_type(type, last));
    const unsigned dimensions = spvc_type_get_num_array_dimensions(member);
    // The outermost dimension comes last; a run-time array has the length 0.
    if (dimensions == 0 || spvc_type_get_array_dimension(member, dimensions - 1) != 0) return;
    reader.must(spvc_compiler_type_struct_member_array_stride(reader.compiler, type, last, &b.array_stride));
}

ReflectedBinding read_binding(const Reader& reader, const spvc_reflected_resource& r, BindingKind kind) {
    ReflectedBinding b{.name = reader.name(r),
                       .set = reader.decoration(r, SpvDecorationDescriptorSet),
                       .binding = reader.decoration(r, SpvDecorationBinding),
                       .kind = kind};
    const spvc_type type = spvc_compiler_get_type_handle(reader.compiler, r.type_id);
    if (spvc_type_get_num_array_dimensions(type) > 0) b.count = spvc_type_get_array_dimension(type, 0);
    read_access(reader, r, b);
    if (kind == BindingKind::storage_buffer || kind == BindingKind::uniform_buffer)
        read_block(reader, spvc_compiler_get_type_handle(reader.compiler, r.base_type_id), b);
    return b;
}

// A texel buffer is an image of dimension "buffer".
BindingKind image_kind(const Reader& reader, const spvc_reflected_resource& r, BindingKind image, BindingKind texel) {
    const spvc_type type = spvc_compiler_get_type_handle(reader.compiler, r.base_type_id);
    return spvc_type_get_image_dimension(type) == SpvDimBuffer ? texel : image;
}

std::vector<ReflectedBinding> read_bindings(const Reader& reader) {
    struct Row {
        spvc_resource_type type;
        BindingKind kind, texel;
    };
    using K = BindingKind;
    constexpr Row rows[] = {{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, K::uniform_buffer, K::uniform_buffer},
                            {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, K::storage_buffer, K::storage_buffer},
                            {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, K::storage_image, K::storage_texel},
                            {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, K::combined_image_sampler, K::uniform_texel},
                            {SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, K::sampled_image, K::uniform_texel},
                            {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, K::sampler, K::sampler}};
    std::vector<ReflectedBinding> bindings;
    for (const Row& row : rows)
        for (const spvc_reflected_resource& r : reader.list(row.type))
            bindings.push_back(read_binding(reader, r, row.kind == row.texel ? row.kind : image_kind(reader, r, row.kind, row.texel)));
    std::ranges::sort(bindings, {}, [](const ReflectedBinding& b) { return std::pair(b.set, b.binding); });
    return bindings;
}

vk::Format format_of(spvc_type type) {
    using F = vk::Format;
    constexpr F floats[] = {F::eR32Sfloat, F::eR32G32Sfloat, F::eR32G32B32Sfloat, F::eR32G32B32A32Sfloat};
    constexpr F ints[] = {F::eR32Sint, F::eR32G32Sint, F::eR32G32B32Sint, F::eR32G32B32A32Sint};
    constexpr F uints[] = {F::eR32Uint, F::eR32G32Uint, F::eR32G32B32Uint, F::eR32G32B32A32Uint};
    const unsigned last = spvc_type_get_vector_size(type) - 1;
    switch (spvc_type_get_basetype(type)) {
    case SPVC_BASETYPE_FP32: return floats[last];
    case SPVC_BASETYPE_INT32: return ints[last];
    case SPVC_BASETYPE_UINT32: return uints[last];
    default: return F::eUndefined;
    }
}

std::vector<ReflectedVariable> read_variables(const Reader& reader, spvc_resource_type which) {
    std::vector<ReflectedVariable> variables;
    for (const spvc_reflected_resource& r : reader.list(which))
        variables.push_back({reader.decoration(r, SpvDecorationLocation),
                             format_of(spvc_compiler_get_type_handle(reader.compiler, r.base_type_id)), reader.name(r)});
    std::ranges::sort(variables, {}, &ReflectedVariable::location);
    return variables;
}

} // namespace

const char* to_string(BindingKind kind) {
    switch (kind) {
    case BindingKind::uniform_texel: return "uniform texel buffer";
    case BindingKind::storage_texel: return "storage texel buffer";
    case BindingKind::storage_buffer: return "storage buffer";
    case BindingKind::uniform_buffer: return "uniform buffer";
    case BindingKind::combined_image_sampler: return "combined image sampler";
    case BindingKind::sampled_image: return "sampled image";
    case BindingKind::storage_image: return "storage image";
    case BindingKind::sampler: return "sampler";
    }
    return "?";
}

const ReflectedBinding* Reflection::find(std::string_view name) const {
    const auto found = std::ranges::find(bindings, name, &ReflectedBinding::name);
    return found == bindings.end() ? nullptr : &*found;
}

Reflection reflect(std::span<const std::uint32_t> words) {
    const Reader reader(words);
    Reflection r{.stage = stage_of(reader), .bindings = read_bindings(reader)};
    for (const spvc_reflected_resource& push : reader.list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
        r.push_size = reader.struct_size(spvc_compiler_get_type_handle(reader.compiler, push.base_type_id));
    r.inputs = read_variables(reader, SPVC_RESOURCE_TYPE_STAGE_INPUT);
    r.outputs = read_variables(reader, SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
    if (r.stage == vk::ShaderStageFlagBits::eCompute)
        for (unsigned i = 0; i < 3; ++i)
            r.local_size[i] = spvc_compiler_get_execution_mode_argument_by_index(reader.compiler, SpvExecutionModeLocalSize, i);
    return r;
}

} // namespace lightbench::gpu
