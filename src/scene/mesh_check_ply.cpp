// Checks PLY files: the header by its lines, the body by a walk over every value, in text and in both byte orders.
#include "scene/import_text.h"
#include "scene/limits.h"
#include "scene/mesh_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench::importer {

namespace {

enum class Encoding { text, little, big };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
constexpr std::array<std::size_t, 8> kTypeSizes = {1, 1, 2, 2, 4, 4, 4, 8};

struct Property {
    std::string name;
    Type type = Type::float32;
    std::optional<Type> count_type; // present: a list
};

struct Element {
    std::string name;
    unsigned line = 0;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    std::optional<Encoding> encoding;
    std::vector<Element> elements;
    unsigned lines = 0;
    bool ended = false;
};

std::optional<Type> type_of(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 2>, 8> kNames = {{{"char", "int8"},
                                                                        {"uchar", "uint8"},
                                                                        {"short", "int16"},
                                                                        {"ushort", "uint16"},
                                                                        {"int", "int32"},
                                                                        {"uint", "uint32"},
                                                                        {"float", "float32"},
                                                                        {"double", "float64"}}};
    for (std::size_t i = 0; i < kNames.size(); ++i)
        if (word == kNames[i][0] || word == kNames[i][1]) return static_cast<Type>(i);
    return {};
}

void read_format(Header& header, std::string_view rest, unsigned line, Report& report) {
    const std::string_view name = next_word(rest), version = next_word(rest);
    if (name == "ascii")
        header.encoding = Encoding::text;
    else if (name == "binary_little_endian")
        header.encoding = Encoding::little;
    else if (name == "binary_big_endian")
        header.encoding = Encoding::big;
    else
        report.problem_at(line,
                          fmt::format("format {} is unknown; ascii, binary_little_endian and binary_big_endian are", in_quotes(name)));
    if (version != "1.0") report.problem_at(line, fmt::format("version {} is unknown; 1.0 is", in_quotes(version)));
}

void read_element(Header& header, std::string_view rest, unsigned line, Report& report) {
    const std::string_view name = next_word(rest), word = next_word(rest);
    const auto count = parse_integer(word);
    if (!count || *count < 0 || *count > (1LL << 32))
        report.problem_at(line, fmt::format("element {}: {} is no count that a file can hold", in_quotes(name), in_quotes(word)));
    else
        header.elements.push_back({std::string(name), line, static_cast<std::uint64_t>(*count), {}});
}

void read_property(Header& header, std::string_view rest, unsigned line, Report& report) {
    if (header.elements.empty()) return report.problem_at(line, "property before the first element");
    Property property;
    std::string_view word = next_word(rest);
    if (word == "list") {
        property.count_type = type_of(word = next_word(rest));
        if (!property.count_type || property.count_type >= Type::float32)
            return report.problem_at(line, fmt::format("{} is no type of a list's length", in_quotes(word)));
        word = next_word(rest);
    }
    const auto type = type_of(word);
    if (!type) return report.problem_at(line, fmt::format("{} is no type of a property", in_quotes(word)));
    property.type = *type, property.name = std::string(next_word(rest));
    if (property.name.empty()) return report.problem_at(line, "the property has no name");
    header.elements.back().properties.push_back(std::move(property));
}

// Leaves `lines` at the start of the body.
Header read_header(LineReader& lines, Report& report) {
    Header header;
    lines.next(); // "ply", seen by the caller
    while (auto text = lines.next()) {
        const std::string_view keyword = next_word(*text);
        if (keyword == "format")
            read_format(header, *text, lines.line, report);
        else if (keyword == "element")
            read_element(header, *text, lines.line, report);
        else if (keyword == "property")
            read_property(header, *text, lines.line, report);
        else if (keyword == "end_header")
            header.ended = true;
        else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
            report.remark(fmt::format("header line {} has no meaning in PLY and is skipped: {}", lines.line, in_quotes(keyword)));
        if (header.ended) break;
    }
    if (!header.ended)
        report.problem("its header does not end: \"end_header\" is missing");
    else if (!header.encoding)
        report.problem("its header names no format");
    return header;
}

const Element* find(const Header& header, std::string_view name) {
    const auto found = std::find_if(header.elements.begin(), header.elements.end(), [&](const Element& e) { return e.name == name; });
    return found == header.elements.end() ? nullptr : &*found;
}

bool is_index_list(const Property& p) {
    return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
}

void check_contents(const Header& header, Report& report) {
    const Element *vertex = find(header, "vertex"), *face = find(header, "face");
    if (!vertex || vertex->count == 0) return report.problem("has no vertices");
    for (const std::string_view axis : {"x", "y", "z"})
        if (std::none_of(vertex->properties.begin(), vertex->properties.end(),
                         [&](const Property& p) { return p.name == axis && !p.count_type; }))
            report.problem_at(vertex->line, fmt::format("the vertices have no {}", axis));
    if (find(header, "tristrips")) return report.problem_at(find(header, "tristrips")->line, "triangle strips are not read; store faces");
    if (!face || face->count == 0) return report.problem("has no faces: a cloud of points, which is not drawn");
    if (std::none_of(face->properties.begin(), face->properties.end(), is_index_list))
        report.problem_at(face->line, "the faces have no list vertex_indices");
}

// A walk over the body. Each value is taken as the header says; `failed` once there is none.
struct Walk {
    Encoding encoding;
    std::string_view rest;
    unsigned line;
    bool failed = false;
    std::string why;

    void fail(std::string text) {
        if (!failed) why = std::move(text);
        failed = true;
    }

    double take_binary(Type type) {
        std::array<char, 8> bytes{};
        const std::size_t size = kTypeSizes[static_cast<std::size_t>(type)];
        if (size > rest.size()) return fail("it ends too early"), 0;
        std::copy_n(rest.begin(), size, bytes.begin());
        rest.remove_prefix(size);
        if (encoding == Encoding::big) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        return value_of(bytes, type);
    }

    template <class T> static double as(const std::array<char, 8>& bytes) {
        T value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }

    static double value_of(const std::array<char, 8>& bytes, Type type) {
        switch (type) {
        case Type::int8: return as<std::int8_t>(bytes);
        case Type::uint8: return as<std::uint8_t>(bytes);
        case Type::int16: return as<std::int16_t>(bytes);
        case Type::uint16: return as<std::uint16_t>(bytes);
        case Type::int32: return as<std::int32_t>(bytes);
        case Type::uint32: return as<std::uint32_t>(bytes);
        case Type::float32: return as<float>(bytes);
        case Type::float64: return as<double>(bytes);
        }
        return 0;
    }

    void skip_blanks() {
        for (; !rest.empty() && std::isspace(static_cast<unsigned char>(rest[0])); rest.remove_prefix(1)) line += rest[0] == '\n';
    }

    double take_text() {
        skip_blanks();
        const std::string_view word = next_word(rest);
        const auto value = parse_number(word);
        if (!value) fail(word.empty() ? "it ends too early" : fmt::format("{} is not a number", in_quotes(word)));
        return value.value_or(0);
    }

    double take(Type type) { return encoding == Encoding::text ? take_text() : take_binary(type); }
};

void walk_property(Walk& walk, const Property& property, std::uint64_t vertices) {
    if (!property.count_type) return static_cast<void>(walk.take(property.type));
    const double count = walk.take(*property.count_type);
    if (count < 0 || count > static_cast<double>(limits::kMaxPolygonPoints) || count != std::floor(count))
        return walk.fail(fmt::format("a list of {:g} values; the limit is {}", count, limits::kMaxPolygonPoints));
    const bool indices = is_index_list(property);
    for (double i = 0; i < count && !walk.failed; ++i) {
        const double index = walk.take(property.type);
        if (indices && !walk.failed && (index < 0 || index >= static_cast<double>(vertices) || index != std::floor(index)))
            return walk.fail(fmt::format("vertex {:g} does not exist; there are {}, counted from 0", index, vertices));
    }
}

void walk_element(Walk& walk, const Element& element, std::uint64_t vertices, Report& report) {
    for (std::uint64_t i = 0; i < element.count && !walk.failed; ++i) {
        for (const Property& property : element.properties)
            if (!walk.failed) walk_property(walk, property, vertices);
        if (walk.failed)
            report.problem_at(walk.encoding == Encoding::text ? walk.line : 0,
                              fmt::format("{} {} of {}: {}", element.name, i + 1, element.count, walk.why));
    }
}

// Before anything is allocated or walked: each value takes a byte at least, in text a digit and a blank.
bool counts_fit(const Header& header, std::size_t body, Report& report) {
    for (const Element& element : header.elements) {
        std::size_t least = 0;
        for (const Property& p : element.properties)
            least += *header.encoding == Encoding::text ? 2 : kTypeSizes[static_cast<std::size_t>(p.count_type.value_or(p.type))];
        if (element.properties.empty() ? element.count == 0 : element.count * least <= body + 1) continue;
        report.problem_at(element.line, fmt::format("{} elements {} cannot be in the {} bytes after the header", element.count,
                                                    in_quotes(element.name), body));
        return false;
    }
    return true;
}

} // namespace

void check_ply(ByteView file, Report& report) {
    LineReader lines;
    lines.rest = {reinterpret_cast<const char*>(file.data()), file.size()};
    if (!lines.rest.starts_with("ply\n") && !lines.rest.starts_with("ply\r"))
        return report.problem("is no PLY: its first line is not \"ply\"");
    const Header header = read_header(lines, report);
    if (report.ok()) check_contents(header, report);
    if (!report.ok() || !counts_fit(header, lines.rest.size(), report)) return;
    Walk walk{*header.encoding, lines.rest, lines.line + 1, false, {}};
    for (const Element& element : header.elements)
        if (!walk.failed) walk_element(walk, element, find(header, "vertex")->count, report);
    if (walk.encoding == Encoding::text) walk.skip_blanks();
    if (!walk.failed && !walk.rest.empty()) report.remark(fmt::format("{} bytes after the last element are not read", walk.rest.size()));
}

} // namespace lightbench::importer
