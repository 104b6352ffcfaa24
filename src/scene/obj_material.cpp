// Reads MTL libraries.
#include "scene/obj_material.h"

#include "scene/import_text.h"

#include <algorithm>
#include <set>

namespace lightbench::importer {

namespace {

struct Reading {
    std::string file;
    unsigned line = 0;
    Report& report;
    MtlMaterial* current = nullptr;
    std::map<MtlMaterial*, int> illum;
    std::map<MtlMaterial*, glm::vec3> ambient, filter;
    std::set<std::string, std::less<>> unused;

    void problem(std::string text) { report.problem_in(file, line, std::move(text)); }
};

std::optional<double> number(Reading& reading, std::string_view keyword, std::string_view word) {
    const auto value = parse_number(word);
    if (value && std::isfinite(*value)) return value;
    reading.problem(word.empty() ? fmt::format("{} has no value", keyword)
                                 : fmt::format("{}: {} is not a finite number", keyword, in_quotes(word)));
    return {};
}

// One number stands for all three channels; spectral files and CIE colors are not read.
std::optional<glm::vec3> color(Reading& reading, std::string_view keyword, std::string_view rest) {
    const std::string_view first = next_word(rest);
    if (first == "spectral" || first == "xyz") {
        reading.report.remark(fmt::format("{}: {} {} is not read; the default is drawn", reading.file, keyword, first));
        return {};
    }
    const auto r = number(reading, keyword, first);
    if (!r) return {};
    const std::string_view second = next_word(rest);
    if (second.empty()) return glm::vec3(static_cast<float>(*r));
    const auto g = number(reading, keyword, second);
    const auto b = g ? number(reading, keyword, next_word(rest)) : std::nullopt;
    if (!b) return {};
    return glm::vec3(*r, *g, *b);
}

glm::vec3 into_unit_range(Reading& reading, std::string_view keyword, const glm::vec3& value) {
    const glm::vec3 inside = glm::clamp(value, 0.0f, 1.0f);
    if (inside != value)
        reading.report.remark(fmt::format("{}:{}: {} lies outside 0 to 1 and is clamped", reading.file, reading.line, keyword));
    return inside;
}

bool set_color(Reading& reading, std::string_view keyword, std::string_view rest) {
    Material& m = reading.current->material;
    const bool known = keyword == "Kd" || keyword == "Ks" || keyword == "Ke" || keyword == "Ka" || keyword == "Tf";
    const auto value = known ? color(reading, keyword, rest) : std::nullopt;
    if (!value) return known;
    if (keyword == "Kd") m.diffuse = into_unit_range(reading, keyword, *value);
    if (keyword == "Ks") m.specular = into_unit_range(reading, keyword, *value);
    if (keyword == "Tf") reading.filter[reading.current] = into_unit_range(reading, keyword, *value);
    if (keyword == "Ke") m.emission = glm::max(*value, 0.0f);
    if (keyword == "Ka") reading.ambient[reading.current] = *value;
    return true;
}

void set_scalar(Reading& reading, std::string_view keyword, double value) {
    Material& m = reading.current->material;
    const auto v = static_cast<float>(value);
    if (keyword == "illum") reading.illum[reading.current] = static_cast<int>(std::clamp(value, 0.0, 10.0));
    if (keyword == "d") m.opacity = into_unit_range(reading, keyword, glm::vec3(v));
    if (keyword == "Tr") m.opacity = into_unit_range(reading, keyword, glm::vec3(1 - v));
    if (keyword == "Ns" && (value < 0 || !std::isfinite(v)))
        reading.problem(fmt::format("Ns is {:g}; the exponent must be 0 or more", value));
    if (keyword == "Ns") m.shininess = std::max(v, 0.0f);
    if (keyword != "Ni") return;
    if (v > 0 && std::isfinite(v))
        m.ior = glm::vec3(v);
    else
        reading.report.remark(
            fmt::format("{}:{}: Ni is {:g}, no index of refraction; {:g} is taken", reading.file, reading.line, value, m.ior.x));
}

bool set_number(Reading& reading, std::string_view keyword, std::string_view rest) {
    if (keyword != "Ns" && keyword != "Ni" && keyword != "d" && keyword != "Tr" && keyword != "illum") return false;
    std::string_view word = next_word(rest);
    if (keyword == "d" && word == "-halo") {
        reading.report.remark(fmt::format("{}: d -halo is taken as d", reading.file));
        word = next_word(rest);
    }
    if (const auto value = number(reading, keyword, word)) set_scalar(reading, keyword, *value);
    return true;
}

// Options come before the file's name, which may hold blanks: it is the rest of the line.
std::optional<MtlMap> map_of(Reading& reading, std::string_view keyword, std::string_view rest) {
    MtlMap map;
    rest = trimmed(rest);
    while (rest.starts_with('-')) {
        const std::string_view option = next_word(rest);
        const bool triple = option == "-s" || option == "-o" || option == "-t";
        std::vector<double> values;
        for (std::size_t most = triple ? 3 : option == "-mm" ? 2 : 1; values.size() < most;) {
            std::string_view after = rest;
            const auto value = parse_number(next_word(after));
            if (!value || !std::isfinite(*value)) break;
            values.push_back(*value), rest = after;
        }
        const std::string_view word = values.empty() ? next_word(rest) : std::string_view(); // -clamp on, -imfchan l, -type sphere
        if (option == "-bm" && !values.empty())
            map.strength = values[0];
        else if (option == "-s" && !values.empty())
            map.scale = {values[0], values.size() > 1 ? values[1] : 1.0};
        else if (option == "-clamp" && (word == "on" || word == "off") && keyword == "map_Kd")
            map.clamp = word == "on";
        else
            reading.report.remark(fmt::format("{}: {} {} is not used", reading.file, keyword, clean_name(option)));
        rest = trimmed(rest);
    }
    map.file = std::string(rest);
    if (!map.file.empty()) return map;
    reading.problem(fmt::format("{} names no file", keyword));
    return {};
}

bool set_map(Reading& reading, std::string_view keyword, std::string_view rest) {
    const bool bump = keyword == "map_bump" || keyword == "map_Bump" || keyword == "bump" || keyword == "norm" || keyword == "map_Kn";
    if (keyword != "map_Kd" && !bump) return false;
    auto map = map_of(reading, keyword, rest);
    if (map) map->normal_map = keyword == "norm" || keyword == "map_Kn";
    (bump ? reading.current->bump_map : reading.current->diffuse_map) = map;
    return true;
}

void begin_material(Reading& reading, std::string_view name, MtlLibrary& into) {
    reading.current = &into[std::string(name)];
    reading.illum.erase(reading.current), reading.ambient.erase(reading.current), reading.filter.erase(reading.current);
    *reading.current = {};
    reading.current->material.name = clean_name(name);
}

void read_line(Reading& reading, std::string_view line, MtlLibrary& into) {
    const std::string_view keyword = next_word(line);
    if (keyword.empty() || keyword[0] == '#') return;
    if (keyword == "newmtl") return begin_material(reading, trimmed(line), into);
    if (!reading.current) return reading.problem(fmt::format("{} before the first newmtl", in_quotes(keyword)));
    if (!set_color(reading, keyword, line) && !set_number(reading, keyword, line) && !set_map(reading, keyword, line))
        reading.unused.insert(clean_name(keyword.substr(0, 20)));
}

// The table is in obj_material.h.
void apply_illum(Reading& reading, MtlMaterial& entry) {
    Material& m = entry.material;
    const auto found = reading.illum.find(&entry);
    const int illum = found == reading.illum.end() ? 2 : found->second;
    const auto given = reading.filter.find(&entry);
    const bool filtered = given != reading.filter.end(), glass = illum == 4 || illum == 9;
    if (illum == 0) reading.report.remark(fmt::format("{}: illum 0 (color without light) is drawn lit", reading.file));
    if (illum < 2) m.specular = glm::vec3(0);
    if (illum < 3 || illum == 10) m.reflection = glm::vec3(0);
    m.fresnel = illum == 5 || illum == 7;
    if (illum == 6 || illum == 7) m.transmission = filtered ? given->second : glm::vec3(1);
    if (glass && filtered && given->second != glm::vec3(0)) m.opacity = 1.0f - (1.0f - m.opacity) * given->second;
}

} // namespace

void read_mtl(std::string_view text, const std::string& file, MtlLibrary& into, Report& report) {
    Reading reading{file, 0, report, nullptr, {}, {}, {}, {}};
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    LineReader lines;
    lines.rest = text;
    MtlLibrary own;
    while (const auto line = lines.next()) {
        reading.line = lines.line;
        read_line(reading, *line, own);
    }
    for (auto& [name, entry] : own) apply_illum(reading, entry);
    const auto differs = [&](const auto& entry) { return entry.second != entry.first->material.diffuse; };
    if (std::any_of(reading.ambient.begin(), reading.ambient.end(), differs))
        report.remark(fmt::format("{}: Ka is not used: ambient light is weighted by Kd", file));
    if (!reading.unused.empty()) report.remark(fmt::format("{}: not used: {}", file, fmt::join(reading.unused, ", ")));
    for (auto& [name, entry] : own) into[name] = std::move(entry);
}

} // namespace lightbench::importer
