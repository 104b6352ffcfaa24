// Statement by statement through an NFF file. Words of other writers' dialects are problems that say so.
#include "scene/nff.h"

#include "scene/load_default.h"
#include "scene/nff_parts.h"
#include "scene/paths.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr std::string_view kWords = "v b l f s c p pp and # comments";
constexpr std::string_view kViewWords[] = {"from", "at", "up", "angle", "hither", "resolution"};

// Of the dialects that Assimp's NFF reader and the AFF format of Lext, Assarsson and Moller (2000, "BART") know.
constexpr std::string_view kExtensions[] = {"tess", "hex", "tet",    "dod",  "oct", "ico", "tpp", "tp", "end", "t",
                                            "ttt",  "tt",  "xs",     "fm",   "fs",  "k",   "kp",  "a",  "m",   "i",
                                            "d",    "ch",  "detail", "incl", "n",   "r",   "o",   "{",  "}",   "version"};

constexpr NffField kSphere[] = {{"center x"}, {"center y"}, {"center z"}, {"radius"}};
constexpr NffField kCone[] = {{"base x"}, {"base y"}, {"base z"}, {"base radius"}, {"apex x"}, {"apex y"}, {"apex z"}, {"apex radius"}};
constexpr NffField kPlace[] = {{"x"}, {"y"}, {"z"}};
constexpr NffField kColor[] = {
    {"red", 0, FLT_MAX, kNffNotNegative}, {"green", 0, FLT_MAX, kNffNotNegative}, {"blue", 0, FLT_MAX, kNffNotNegative}};
constexpr double kAny = DBL_MAX;
constexpr NffField kFill[] = {
    {"red", 0, 1, kNffFraction}, {"green", 0, 1, kNffFraction}, {"blue", 0, 1, kNffFraction}, {"Kd", 0, 1, kNffFraction},
    {"Ks", 0, 1, kNffFraction},  {"shine", -kAny, kAny, ""},    {"T", 0, 1, kNffFraction},    {"index of refraction", -kAny, kAny, ""}};

bool begins_number(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

bool is_first_on_line(const NffScanner& s) {
    return std::all_of(s.line_start, s.at, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
}

bool room_for(NffLoad& load, std::size_t have, std::size_t limit, std::string_view what) {
    if (have < limit) return true;
    fault_here(load, "more than {} {}", limit, what);
    load.stopped = true;
    return false;
}

// --- statements: each returns whether it could be read; what it holds may be reported all the same -----------------------------------

bool read_background(NffLoad& load) {
    double c[3];
    if (!read_numbers(load, "b", kColor, c)) return false;
    load.scene.environment.background = {c[0], c[1], c[2]};
    return true;
}

bool read_light(NffLoad& load) {
    double p[3], c[3] = {1, 1, 1};
    if (!room_for(load, load.scene.lights.size(), limits::kMaxLights, "lights (limit kMaxLights)")) return false;
    if (!read_numbers(load, "l", kPlace, p)) return false;
    const bool colored = skip_to_word_in_line(load.in);
    if (colored && !read_numbers(load, "l", kColor, c)) return false;
    if (!colored) load.plain_lights.push_back(load.scene.lights.size());
    Light light;
    light.position = {p[0], p[1], p[2]};
    light.intensity = {c[0], c[1], c[2]};
    light.attenuation = Attenuation::none;
    load.scene.lights.push_back(light);
    return true;
}

// kd = color * Kd, ks = kr = Ks, kt = T. Real files hold 100000 as the shine of what has no highlight, and 0 as the index of what is
// opaque: both count only where they can be seen (RULINGS).
Material material_of(const std::array<double, 8>& f, unsigned line) {
    Material m;
    m.name = fmt::format("f at line {}", line);
    m.diffuse = glm::vec3(glm::dvec3(f[0], f[1], f[2]) * f[3]);
    m.specular = glm::vec3(static_cast<float>(f[4]));
    if (f[4] > 0) m.shininess = static_cast<float>(f[5]), m.reflection = m.specular;
    m.transmission = glm::vec3(static_cast<float>(f[6]));
    if (f[6] > 0) m.ior = glm::vec3(static_cast<float>(f[7]));
    return m;
}

bool check_fill(NffLoad& load, const std::array<double, 8>& f) {
    const bool shine = f[4] == 0 || (f[5] >= 0 && f[5] <= FLT_MAX);
    const bool index = f[6] == 0 || (f[7] >= FLT_MIN && f[7] <= FLT_MAX);
    if (!shine) fault_word(load, "f: shine is {}; it must be 0 or greater where Ks is not 0", f[5]);
    if (!index) fault_word(load, "f: index of refraction is {}; it must be greater than 0 where T is not 0", f[7]);
    return shine && index;
}

bool read_fill(NffLoad& load) {
    std::array<double, 8> f;
    if (!read_numbers(load, "f", kFill, f) || !check_fill(load, f)) return false;
    if (load.material && f == load.fill) return true;
    const auto [entry, added] = load.fills.try_emplace(f, static_cast<std::uint32_t>(load.scene.materials.size()));
    if (added) {
        if (!room_for(load, load.scene.materials.size(), limits::kMaxMaterials, "materials (limit kMaxMaterials)")) return false;
        load.scene.materials.push_back(material_of(f, load.word_line));
    }
    load.fill = f;
    load.material = entry->second;
    return true;
}

bool read_sphere(NffLoad& load) {
    double n[4];
    if (!read_numbers(load, "s", kSphere, n)) return false;
    if (n[3] < 0)
        fault_last(load, "s: a negative radius (seen from inside only) is not supported; it must be greater than 0");
    else if (n[3] == 0)
        fault_last(load, "s: radius is 0; it must be greater than 0");
    else
        add_object(load, Sphere{{n[0], n[1], n[2]}, n[3]});
    return true;
}

bool check_cone(NffLoad& load, const double* n) {
    std::string_view wrong;
    if (n[3] < 0 || n[7] < 0)
        wrong = "a negative radius (seen from inside only) is not supported; it must be 0 or greater";
    else if (n[3] == 0 && n[7] == 0)
        wrong = "both radii are 0; one must be greater";
    else if (n[0] == n[4] && n[1] == n[5] && n[2] == n[6])
        wrong = "base and apex are the same point; they must differ";
    if (!wrong.empty()) fault_word(load, "c: {}", wrong);
    return wrong.empty();
}

bool read_cone(NffLoad& load) {
    double n[8];
    if (!read_numbers(load, "c", kCone, n)) return false;
    if (!check_cone(load, n)) return true;
    const glm::dvec3 base(n[0], n[1], n[2]), apex(n[4], n[5], n[6]);
    if (n[3] == n[7])
        add_object(load, Cylinder{base, apex, n[3], false});
    else
        add_object(load, Cone{base, apex, n[3], n[7], false});
    return true;
}

bool unknown_word(NffLoad& load, std::string_view word) {
    if (full(load.log)) return fault_here(load, ""), false; // counted
    const auto is = [&](std::span<const std::string_view> words) { return std::find(words.begin(), words.end(), word) != words.end(); };
    if (is(kViewWords))
        fault_here(load, "{} stands outside a view; it belongs behind v", in_quotes(word));
    else if (is(kExtensions))
        fault_here(load, "{} is an extension of other writers and not supported; NFF has {}", in_quotes(word), kWords);
    else if (begins_number(word[0]))
        fault_here(load, "{} belongs to no statement; NFF has {}", in_quotes(word), kWords);
    else
        fault_here(load, "unknown statement {}; NFF has {}", in_quotes(word), kWords);
    return false;
}

bool read_statement(NffLoad& load, std::string_view word) {
    if (word == "s") return read_sphere(load);
    if (word == "p" || word == "pp") return read_polygon(load, word == "pp");
    if (word == "c") return read_cone(load);
    if (word == "f") return read_fill(load);
    if (word == "l") return read_light(load);
    return read_background(load);
}

void next_statement(NffLoad& load) {
    load.word_line = load.in.line, load.word_column = load.in.column();
    const std::string_view word = peek_word(load.in);
    constexpr std::string_view kStatements[] = {"s", "p", "pp", "c", "f", "l", "b"};
    if (word == "v") {
        take(load.in, word);
        read_view(load);
    } else if (std::find(std::begin(kStatements), std::end(kStatements), word) == std::end(kStatements)) {
        unknown_word(load, word);
        take(load.in, word);
        end_statement(load, word, false);
    } else {
        take(load.in, word);
        end_statement(load, word, read_statement(load, word));
    }
}

// --- after the last line ---------------------------------------------------------------------------------------------------------------

void remark(NffLoad& load, const NffCount& c, std::string_view what) {
    if (c.count > 0)
        load.scene.remarks.push_back(
            fmt::format("{} polygon{} {} (the first at line {})", c.count, c.count == 1 ? "" : "s", what, c.first_line));
}

void finish(NffLoad& load) {
    Scene& scene = load.scene;
    // Haines 1987: "if no color is given, white with the intensity 1 / sqrt(number of lights)".
    const auto lights = static_cast<float>(scene.lights.size());
    for (std::size_t i : load.plain_lights) scene.lights[i].intensity = glm::vec3(1 / std::sqrt(lights));
    if (scene.materials.empty()) scene.materials.push_back(default_material());
    remark(load, load.without_area, "without area left out");
    remark(load, load.cut, "not planar, cut into triangles");
    remark(load, load.without_normals, "with normals of length 0 take the face normal");
}

} // namespace

bool read_numbers(NffLoad& load, std::string_view statement, std::span<const NffField> fields, std::span<double> out) {
    bool fine = true;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const NffField& field = fields[i];
        if (!skip_to_word(load.in)) {
            fault_here(load, "{}: the file ends where the {} should be", statement, field.name);
            return false;
        }
        load.last_line = load.in.line, load.last_column = load.in.column();
        const auto value = take_number(load.in);
        if (!value) {
            fault_here(load, "{}: {} where a number should be, the {}", statement, in_quotes(peek_word(load.in)), field.name);
            return false;
        }
        out[i] = *value;
        const bool finite = std::isfinite(*value);
        if (finite && *value >= field.low && *value <= field.high) continue;
        if (finite)
            fault_last(load, "{}: {} is {}; {}", statement, field.name, *value, field.text);
        else
            fault_last(load, "{}: {} is not a finite number; it must be one", statement, field.name);
        fine = false;
    }
    return fine;
}

void end_statement(NffLoad& load, std::string_view statement, bool good) {
    if (good && skip_to_word_in_line(load.in)) {
        const std::string_view rest = peek_word(load.in);
        const std::string_view what = begins_number(rest[0]) ? "one number too many"
                                      : statement == "f"     ? "a texture is an extension that is not supported"
                                                             : "nothing may follow here";
        fault_here(load, "{}: {} after the last number; {}", statement, in_quotes(rest), what);
        skip_line(load.in);
    }
    // A statement that went wrong: its numbers are not to be taken for statements. A word at the head of a line is the next one.
    while (!good && skip_to_word(load.in)) {
        const bool number = begins_number(*load.in.at);
        if (is_first_on_line(load.in) && !number) return;
        skip_line(load.in);
    }
}

void add_object(NffLoad& load, Shape shape) {
    if (!room_for(load, load.scene.objects.size(), limits::kMaxObjects, "objects (limit kMaxObjects)")) return;
    if (!load.material) {
        load.material = static_cast<std::uint32_t>(load.scene.materials.size());
        load.scene.materials.push_back(default_material());
        load.scene.remarks.push_back(fmt::format("line {}: objects before the first f line have the default material", load.in.line));
    }
    Object object;
    object.shape = std::move(shape);
    object.material = *load.material;
    load.scene.objects.push_back(std::move(object));
}

Loaded load_nff_text(std::string_view text, const std::filesystem::path& file, const LoadOptions& options) {
    NffLoad load;
    load.file = file.string();
    load.in = nff_scanner(text);
    load.log.max = options.max_problems;
    load.scene.name = file.filename().string();
    while (!load.stopped && skip_to_word(load.in)) next_statement(load);
    finish(load);
    if (!load.log.empty()) return {std::nullopt, listed(load.log, load.file), load.log.unlisted};
    return {std::move(load.scene), {}, 0};
}

Loaded load_nff(const std::filesystem::path& file, const LoadOptions& options) {
    const Bytes bytes = read_file(file, limits::kMaxFileBytes, "kMaxFileBytes");
    if (!bytes.text) return {std::nullopt, {{file.string(), 0, 0, bytes.why}}, 0};
    return load_nff_text(*bytes.text, file, options);
}

} // namespace lightbench
