// Curves of local illumination in double: specular lobes, Fresnel's reflectance, the laws of attenuation (SPEC S3, S4, S6).
#include "measure/plot_kinds.h"
#include "scene/distribution.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <set>

namespace lightbench {
namespace {

using std::numbers::pi;

constexpr int kSteps = 720; // a curve has one point more, a lobe some more

struct Reflectances {
    double s, p; // of the amplitudes across and in the plane of incidence, squared
};

// Fresnel 1823, in the rationalized form of shaders/lib/fresnel.glsl, for which nothing of equal size is subtracted near n = 1.
// n: index of refraction, far side over near side. 1 beyond the critical angle.
Reflectances fresnel_squares(double c, double n) {
    const double m = (n - 1) * (n + 1), k = m + c * c;
    if (m == 0) return {0, 0};
    if (k <= 0) return {1, 1};
    const double g = std::sqrt(k), s = m / ((c + g) * (c + g)), p = m * ((n * n + 1) * c * c - 1) / ((n * n * c + g) * (n * n * c + g));
    return {s * s, p * p};
}

double fresnel_mean(double c, double n) {
    const auto [s, p] = fresnel_squares(c, n);
    return 0.5 * (s + p);
}

// Phong 1975, "Illumination for computer generated pictures", eq. 2. Angles from the normal in radians, light on the left, viewer on the right.
double phong_factor(double incidence, double view, double n) {
    return std::pow(std::max(0.0, std::cos(view - incidence)), n);
}

// Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", eqs. 2 to 4: D G F / (N.V), the factor of ks Ip, D scaled as SPEC S6.
double facet_factor(Distribution kind, double incidence, double view, double m, double index) {
    const double alpha = 0.5 * (view - incidence), nl = std::cos(incidence), nv = std::cos(view), nh = std::cos(alpha);
    const double vh = std::cos(0.5 * (view + incidence)), tangent = std::tan(alpha);
    if (nl <= 0 || nv < 0 || vh <= 0) return 0;
    const double exponent = kind == Distribution::beckmann ? tangent * tangent : alpha * alpha;
    const double widening = kind == Distribution::beckmann ? 1 / (nh * nh * nh * nh) : 1;
    const double d = lobe_factor(kind, m) * widening * std::exp(-exponent / (m * m));
    return d * fresnel_mean(vh, index) * std::min({1 / nv, 2 * nh / vh, 2 * nh * nl / (vh * nv)});
}

// Even steps, and around the mirror direction ever smaller ones, down to 1e-5 degrees: an exponent of 1e6 is 0.07 wide, a slope of 1e-3 0.1.
std::set<double> views_of(double mirror) {
    std::set<double> views{mirror};
    for (int i = 0; i <= kSteps; ++i) views.insert(-90 + 180.0 * i / kSteps);
    for (int i = 0; i <= 120; ++i) {
        const double off = 1e-5 * std::pow(10, i / 20.0);
        for (const double view : {mirror - off, mirror + off})
            if (std::abs(view) < 90) views.insert(view);
    }
    return views;
}

// Between two views around the largest sample. Kiefer 1953, "Sequential minimax search for a maximum": the golden section.
double largest_between(double low, double high, const std::function<double(double)>& f) {
    constexpr double kGolden = 0.6180339887498949;
    for (int i = 0; i < 60; ++i) {
        const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
        (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
    }
    return (low + high) / 2;
}

// A lobe over all directions of view; its name says where it is largest. `mirror`: degrees, where a narrow one is.
PlotLine lobe(const std::string& name, bool over_largest, double mirror, const std::function<double(double)>& factor) {
    const auto at = [&](double degrees) { return factor(degrees * (pi / 180)); };
    std::set<double> views = views_of(mirror);
    const auto best = std::ranges::max_element(views, {}, at);
    const double top_view = *best;
    const double low = best == views.begin() ? top_view : *std::prev(best),
                 high = std::next(best) == views.end() ? top_view : *std::next(best);
    const double found = largest_between(low, high, at);
    glm::dvec2 top(top_view, at(top_view));
    if (at(found) > top.y) top = {found, at(found)}, views.insert(found);
    PlotLine line;
    for (const double view : views) line.points.emplace_back(view, at(view));
    if (over_largest && top.y > 0)
        for (glm::dvec2& p : line.points) p.y /= top.y;
    line.name = fmt::format("{}: largest {:.4g} at {:.4g}\u00b0", name, top.y, top.x);
    return line;
}

void add_lobes(Plot& plot, const PlotValues& values, double degrees, unsigned dash) {
    const double incidence = degrees * (pi / 180), index = values.at("index")[0];
    const bool over_largest = values.at("scale")[0] == 0;
    const std::string light = values.at("incidence").size() > 1 ? fmt::format(", light {:g}\u00b0", degrees) : "";
    unsigned color = 0;
    const auto add = [&](const std::string& name, const std::function<double(double)>& factor) {
        plot.lines.push_back(lobe(name + light, over_largest, degrees, factor));
        plot.lines.back().color = ++color, plot.lines.back().dash = dash;
    };
    for (const double n : values.at("shininess"))
        add(fmt::format("Phong, n = {:g}", n), [&](double view) { return phong_factor(incidence, view, n); });
    for (const double m : values.at("roughness")) {
        for (const auto& [kind, name] : {std::pair(Distribution::gaussian, "Gaussian"), std::pair(Distribution::beckmann, "Beckmann")})
            add(fmt::format("Cook-Torrance, {}, m = {:g}", name, m),
                [&, kind = kind](double view) { return facet_factor(kind, incidence, view, m, index); });
    }
}

PlotLine curve(const std::string& name, double from, double to, bool logarithmic, const std::function<double(double)>& f) {
    PlotLine line{name, {}};
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const double x = i == kSteps ? to : logarithmic ? from * std::pow(to / from, share) : from + (to - from) * share;
        line.points.emplace_back(x, f(x));
    }
    return line;
}

void add_fresnel(Plot& plot, double index, bool inside, unsigned color) {
    const double n = inside ? 1 / index : index;
    const std::string name = fmt::format("index {:g}{}", index, inside ? ", from inside" : "");
    const auto add = [&](const char* what, unsigned dash, const std::function<double(Reflectances)>& part) {
        const auto at = [&](double degrees) { return part(fresnel_squares(degrees == 90 ? 0 : std::cos(degrees * (pi / 180)), n)); };
        plot.lines.push_back(curve(fmt::format("{}: {}", name, what), 0, 90, false, at));
        plot.lines.back().color = color, plot.lines.back().dash = dash;
    };
    add("mean", 1, [](Reflectances r) { return 0.5 * (r.s + r.p); });
    add("s (across the plane)", 2, [](Reflectances r) { return r.s; });
    add("p (in the plane)", 3, [](Reflectances r) { return r.p; });
}

} // namespace

Plot brdf_plot(const PlotValues& values) {
    const bool over_largest = values.at("scale")[0] == 0;
    Plot plot;
    plot.title =
        fmt::format("Specular lobes in the plane of incidence, {}", over_largest ? "each over its largest value" : "as factors of ks Ip");
    plot.notes = {fmt::format(
        "Phong 1975, (R.V)^n; Cook and Torrance 1982, D G F / (N.V), index {:g}. Radius: the light that is seen from that direction.",
        values.at("index")[0])};
    plot.x_key = "view_degrees", plot.y_key = over_largest ? "factor_over_largest" : "factor";
    plot.polar = true, plot.rays = values.at("incidence");
    unsigned dash = 0;
    for (const double degrees : values.at("incidence")) add_lobes(plot, values, degrees, ++dash);
    return plot;
}

Plot fresnel_plot(const PlotValues& values) {
    Plot plot;
    plot.title = "Reflectance of a smooth dielectric";
    plot.notes = {"Fresnel 1823. p vanishes at Brewster's angle; from inside everything is reflected beyond the critical angle."};
    plot.x_key = "incidence_degrees", plot.y_key = "reflectance";
    plot.x_label = "angle of incidence in degrees", plot.y_label = "reflected fraction";
    unsigned color = 0;
    for (const double index : values.at("index"))
        for (const bool inside : {false, true})
            if (values.at("side")[0] == 2 || (values.at("side")[0] == 1) == inside) add_fresnel(plot, index, inside, ++color);
    return plot;
}

Plot attenuation_plot(const PlotValues& values) {
    Plot plot;
    plot.title = "Laws of attenuation with distance";
    plot.notes = {
        "none: 1; linear: 1 / (d + d0), the default, finite at the light; inverse-square: 1 / (4 \u03c0 d\u00b2), the law of nature."};
    plot.x_key = "distance_m", plot.y_key = "factor";
    plot.x_label = "distance d to the light in meters", plot.y_label = "factor of the light's intensity Ip";
    plot.log_x = plot.log_y = true;
    const double from = values.at("from")[0], to = values.at("to")[0];
    plot.lines.push_back(curve("none", from, to, true, [](double) { return 1.0; }));
    for (const double d0 : values.at("d0"))
        plot.lines.push_back(curve(fmt::format("linear, d0 = {:g} m", d0), from, to, true, [&](double d) { return 1 / (d + d0); }));
    plot.lines.push_back(curve("inverse-square", from, to, true, [](double d) { return 1 / (4 * pi * d * d); }));
    unsigned color = 0;
    for (PlotLine& line : plot.lines) line.color = ++color;
    return plot;
}

} // namespace lightbench
