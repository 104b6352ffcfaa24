#include "measure/report_data.h"

#include "image/file_bytes.h"
#include "measure/report_svg.h"
#include "measure/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using nlohmann::json;

// Data: URIs by their content: structures that are compared give the same picture many times.
class Pictures {
  public:
    explicit Pictures(std::filesystem::path where) : folder(std::move(where)) {}

    json index_of(const std::string& file) {
        if (file.empty()) return nullptr;
        const std::string path = (folder / file).string();
        const std::vector<unsigned char> bytes = read_file(path);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (!text.starts_with("\x89PNG"))
            throw FileError(FileError::Blame::Input, fmt::format("{}: is no PNG picture, and the report shows only those", path));
        const std::string uri = "data:image/png;base64," + base64(text);
        const auto [place, fresh] = places.try_emplace(uri, places.size());
        if (fresh) uris.push_back(uri);
        return place->second;
    }

    json all() const { return uris; }

  private:
    std::filesystem::path folder;
    std::map<std::string, std::size_t> places;
    json uris = json::array();
};

json errors_of(const Errors& errors) {
    json out = json::object();
    for (const auto& [metric, error] : errors) out[printable(metric)] = error; // one that is not finite becomes null
    return out;
}

json pareto_of(const CostPoint& point) {
    json out = json::array();
    for (const std::string& metric : point.pareto) out.push_back(printable(metric));
    return out;
}

json point_data(const CostPoint& point, std::size_t index, Pictures& pictures) {
    return {{"index", index},
            {"value", printable(point.value)},
            {"errors", errors_of(point.errors)},
            {"ms", point.device_ms},
            {"q1", point.q1_ms},
            {"q3", point.q3_ms},
            {"runs", point.runs},
            {"settled", point.settled},
            {"pareto", pareto_of(point)},
            {"note", printable(point.note)},
            {"picture", pictures.index_of(point.image)}};
}

json curve_data(const CostCurve& curve, Pictures& pictures) {
    json points = json::array(), metrics = json::array(), units = json::object();
    for (std::size_t i = 0; i < curve.points.size(); ++i) points.push_back(point_data(curve.points[i], i, pictures));
    for (const std::string& metric : metrics_of(curve)) metrics.push_back(printable(metric)), units[printable(metric)] = unit_of(metric);
    const json reference = {{"value", "reference"},
                            {"errors", errors_of(curve.reference_error)},
                            {"note", printable(curve.reference)},
                            {"picture", pictures.index_of(curve.reference_image)}};
    return {{"knob", printable(curve.knob)},
            {"metric", printable(curve.metric)},
            {"metrics", metrics},
            {"units", units},
            {"time_only", curve.time_only},
            {"points", points},
            {"reference", reference}};
}

} // namespace

std::string base64(std::string_view bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U; };
        const unsigned word = at(0) << 16 | at(1) << 8 | at(2);
        for (unsigned k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kLetters[word >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::vector<std::string> metrics_of(const CostCurve& curve) {
    std::vector<std::string> metrics;
    const auto add = [&](const std::string& metric) {
        if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) metrics.push_back(metric);
    };
    if (!curve.metric.empty()) add(curve.metric);
    for (const CostPoint& point : curve.points)
        for (const auto& [metric, error] : point.errors) add(metric);
    return metrics;
}

std::string report_data(const CostReport& report, const std::filesystem::path& folder) {
    Pictures pictures(folder);
    json curves = json::array();
    for (const CostCurve& curve : report.curves) curves.push_back(curve_data(curve, pictures));
    const std::string text = json{{"curves", curves}, {"pictures", pictures.all()}}.dump();
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) {
        if (c == '<')
            safe += "\\u003c"; // "<" is there only within strings
        else
            safe += c;
    }
    return safe;
}

} // namespace lightbench
