// A JSON value with its place, read with its type checked. In: what a glTF file holds. Out: numbers, texts, parts, or the default after a
// problem that names the place ("materials[2].alphaMode"): the JSON library keeps no lines.
#pragma once

#include "scene/import_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace lightbench::importer {

using Json = nlohmann::json;

struct GltfValue {
    const Json* json = nullptr; // none: absent
    std::string place;
    Report* report = nullptr;

    explicit operator bool() const { return json != nullptr; }
    bool has(const char* key) const { return json && json->contains(key); }
    std::size_t size() const { return json ? json->size() : 0; }

    void problem(const std::string& text) const { report->problem(place.empty() ? text : place + ": " + text); }

    GltfValue member(const char* key, Json::value_t type, const char* what) const {
        GltfValue value{nullptr, place.empty() ? key : place + "." + key, report};
        if (!has(key)) return value;
        const Json& found = (*json)[key];
        if (found.type() == type)
            value.json = &found;
        else
            value.problem(fmt::format("must be {}, not {}", what, found.type_name()));
        return value;
    }
    GltfValue object(const char* key) const { return member(key, Json::value_t::object, "an object"); }
    GltfValue array(const char* key) const { return member(key, Json::value_t::array, "an array"); }

    GltfValue item(std::size_t i) const {
        GltfValue value{nullptr, fmt::format("{}[{}]", place, i), report};
        if (i >= size()) return value;
        if ((*json)[i].is_object())
            value.json = &(*json)[i];
        else
            value.problem(fmt::format("must be an object, not {}", (*json)[i].type_name()));
        return value;
    }

    GltfValue extension(const char* name) const { return object("extensions").object(name); }

    double number(const char* key, double fallback) const {
        if (!has(key)) return fallback;
        const Json& found = (*json)[key];
        if (found.is_number() && std::isfinite(found.get<double>())) return found.get<double>();
        problem(fmt::format("{} must be a finite number, not {}", key, found.type_name()));
        return fallback;
    }

    // A number of things or of bytes: at most 2^53, so that sums of a few cannot overflow.
    std::uint64_t count(const char* key, std::uint64_t fallback) const {
        if (!has(key)) return fallback;
        const Json& found = (*json)[key];
        if (found.is_number_unsigned() && found.get<std::uint64_t>() <= (std::uint64_t{1} << 53)) return found.get<std::uint64_t>();
        problem(fmt::format("{} must be a whole number of 0 or more", key));
        return fallback;
    }

    // An index into a list of `limit` things.
    std::optional<std::size_t> index(const char* key, std::size_t limit) const {
        if (!has(key)) return {};
        const Json& found = (*json)[key];
        if (found.is_number_unsigned() && found.get<std::uint64_t>() < limit) return found.get<std::size_t>();
        problem(fmt::format("{} is {}; there are {}, counted from 0", key, found.is_number() ? found.dump() : found.type_name(), limit));
        return {};
    }

    std::string text(const char* key) const {
        const GltfValue found = member(key, Json::value_t::string, "a string");
        return found ? found.json->get<std::string>() : std::string();
    }

    bool flag(const char* key, bool fallback) const {
        const GltfValue found = member(key, Json::value_t::boolean, "true or false");
        return found ? found.json->get<bool>() : fallback;
    }

    template <class V> V numbers(const char* key, V fallback) const {
        const GltfValue found = array(key);
        if (!found) return fallback;
        V value = fallback;
        bool fine = found.size() == static_cast<std::size_t>(V::length());
        for (std::size_t i = 0; fine && i < found.size(); ++i) {
            fine = (*found.json)[i].is_number() && std::isfinite((*found.json)[i].get<double>());
            if (fine) value[static_cast<int>(i)] = (*found.json)[i].get<typename V::value_type>();
        }
        if (!fine) found.problem(fmt::format("must be {} finite numbers", V::length()));
        return fine ? value : fallback;
    }
};

} // namespace lightbench::importer
