// See ray_reference.h.
#include "images/ray_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace lightbench::testing {
namespace {

using glm::dvec3;

// Scenes here are a few metres large; in double a point is off by less than 1e-12 of that.
constexpr double kNear = 1e-9;

struct Hit {
    double t = 1e300;
    dvec3 n{0}; // outwards, of the shape's own space until `nearest` has turned it
    std::size_t object = 0;
};

struct Line3 {
    dvec3 o, d;
};

void offer(Hit& hit, double t, const dvec3& n) {
    if (t > kNear && t < hit.t) hit.t = t, hit.n = n;
}

void meet(const Sphere& s, const Line3& ray, Hit& hit) {
    const dvec3 oc = ray.o - s.center;
    const double a = glm::dot(ray.d, ray.d), b = glm::dot(oc, ray.d), c = glm::dot(oc, oc) - s.radius * s.radius, k = b * b - a * c;
    if (k < 0) return;
    for (const double t : {(-b - std::sqrt(k)) / a, (-b + std::sqrt(k)) / a}) offer(hit, t, oc + t * ray.d);
}

// Shimrat 1962, "Algorithm 112": a point is inside if a ray from it crosses the outline an odd number of times.
bool inside(const Polygon& polygon, const dvec3& p, int x, int y) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.points.size() - 1; i < polygon.points.size(); j = i++) {
        const dvec3 &a = polygon.points[i], &b = polygon.points[j];
        if ((a[y] > p[y]) != (b[y] > p[y]) && p[x] < a[x] + (b[x] - a[x]) * (p[y] - a[y]) / (b[y] - a[y])) in = !in;
    }
    return in;
}

void meet(const Polygon& polygon, const Line3& ray, Hit& hit) {
    const dvec3 n = glm::cross(polygon.points[1] - polygon.points[0], polygon.points[2] - polygon.points[0]), size = glm::abs(n);
    const double t = glm::dot(polygon.points[0] - ray.o, n) / glm::dot(ray.d, n);
    const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    if (std::isfinite(t) && inside(polygon, ray.o + t * ray.d, (z + 1) % 3, (z + 2) % 3)) offer(hit, t, n);
}

void meet(const Box& box, const Line3& ray, Hit& hit) {
    double enter = -1e300, leave = 1e300;
    dvec3 n_enter(0), n_leave(0);
    for (int i = 0; i < 3; ++i) {
        if (ray.d[i] == 0) {
            if (ray.o[i] < box.min[i] || ray.o[i] > box.max[i]) return;
            continue;
        }
        const double sign = ray.d[i] > 0 ? 1 : -1;
        const double near = ((sign > 0 ? box.min : box.max)[i] - ray.o[i]) / ray.d[i],
                     far = ((sign > 0 ? box.max : box.min)[i] - ray.o[i]) / ray.d[i];
        if (near > enter) enter = near, n_enter = dvec3(0), n_enter[i] = -sign;
        if (far < leave) leave = far, n_leave = dvec3(0), n_leave[i] = sign;
    }
    if (enter > leave) return;
    offer(hit, enter, n_enter), offer(hit, leave, n_leave);
}

// Other shapes are not for this reference.
void meet(const auto&, const Line3&, Hit&) {
    std::abort();
}

Hit nearest(const Scene& scene, const Line3& ray) {
    Hit best;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const glm::dmat4 to_object = glm::inverse(scene.transforms[object.transform]);
        const Line3 local{dvec3(to_object * glm::dvec4(ray.o, 1)), glm::dmat3(to_object) * ray.d};
        Hit hit{best.t, {}, i};
        std::visit([&](const auto& shape) { meet(shape, local, hit); }, object.shape);
        if (hit.t < best.t) best = hit, best.n = glm::normalize(glm::transpose(glm::dmat3(to_object)) * hit.n);
    }
    return best;
}

const Material& material_of(const Scene& scene, const Hit& hit) {
    return scene.materials[scene.objects[hit.object].material];
}

struct Branch {
    Line3 ray;
    unsigned level = 1;
    std::vector<std::size_t> inside; // objects, the innermost last
};

// What is seen of a surface, on the side that is seen.
struct Point {
    dvec3 p, n, v;
    const Material& m;
};

double law(const Light& light, double d) {
    if (light.attenuation == Attenuation::linear) return 1 / (d + light.d0);
    if (light.attenuation == Attenuation::inverse_square) return 1 / (4 * std::numbers::pi * d * d);
    return 1;
}

// S15. Every surface on the way lets through what it does not stop: 1 - t goes straight on, t kt is transmitted.
dvec3 visibility(const Reference& r, const dvec3& p, const dvec3& l, double limit) {
    dvec3 clear(1);
    double gone = 0;
    for (Hit hit = nearest(r.scene, {p, l}); gone + hit.t < limit; hit = nearest(r.scene, {p + gone * l, l})) {
        if (!r.clear_shadows) return dvec3(0);
        const Material& m = material_of(r.scene, hit);
        const dvec3 t(m.opacity);
        clear *= 1.0 - t + t * dvec3(m.transmission);
        if (clear == dvec3(0)) break;
        gone += hit.t;
    }
    return clear;
}

dvec3 from_light(const Reference& r, const Point& s, const Light& light) {
    const bool far = light.type == LightType::directional;
    const dvec3 way = far ? -light.direction : light.position - s.p;
    const double d = glm::length(way);
    const dvec3 l = way / d;
    const double nl = glm::dot(s.n, l);
    if (nl <= 0) return dvec3(0);
    const double rv = glm::dot(2 * nl * s.n - l, s.v);
    const dvec3 factor = dvec3(s.m.diffuse) * nl + dvec3(s.m.specular) * (rv > 0 ? std::pow(rv, double(s.m.shininess)) : 0);
    const dvec3 arriving = dvec3(light.intensity) * (far ? 1 : law(light, d));
    return factor * arriving * (r.shadows ? visibility(r, s.p, l, far ? 1e299 : d * (1 - 1e-9)) : dvec3(1));
}

double index_of(const Scene& scene, const std::vector<std::size_t>& inside) {
    return inside.empty() ? 1 : double(scene.materials[scene.objects[inside.back()].material].ior.x);
}

// Fresnel's sines and tangents by the angles themselves, which are not 0.
double reflectance(double in, double out) {
    const double s = std::sin(in - out) / std::sin(in + out), t = std::tan(in - out) / std::tan(in + out);
    return 0.5 * (s * s + t * t);
}

dvec3 follow(const Reference& r, const Branch& b);

struct Bent {
    double n1 = 1, n2 = 1;
    std::vector<std::size_t> inside; // behind the surface
};

Bent media_at(const Scene& scene, const Branch& b, const Hit& hit) {
    Bent out;
    std::vector<std::size_t> before = b.inside;
    out.inside = before;
    if (glm::dot(b.ray.d, hit.n) < 0) {
        out.inside.push_back(hit.object);
    } else {
        auto last = std::find(before.rbegin(), before.rend(), hit.object);
        if (last == before.rend()) before.push_back(hit.object), out.inside = before, last = before.rbegin();
        out.inside.erase(out.inside.begin() + (before.rend() - last - 1));
    }
    out.n1 = index_of(scene, before), out.n2 = index_of(scene, out.inside);
    return out;
}

// kr Ir + kt It.
dvec3 sent_on(const Reference& r, const Branch& b, const Hit& hit, const Point& s) {
    if (b.level >= r.depth) return dvec3(0);
    dvec3 kr(s.m.reflection.value_or(s.m.specular)), kt(s.m.transmission);
    const double cosine = std::clamp(glm::dot(s.n, s.v), 0.0, 1.0), in = std::acos(cosine);
    const bool transmits = kt != dvec3(0);
    const Bent bent = media_at(r.scene, b, hit);
    const double n1 = transmits ? bent.n1 : 1, n2 = transmits ? bent.n2 : double(s.m.ior.x), sine = n1 / n2 * std::sin(in);
    if (transmits || s.m.fresnel) {
        const dvec3 all = kr + kt;
        const double normal = (n1 - n2) / (n1 + n2);
        const double share = sine >= 1 ? 1 : in < 1e-6 || n1 == n2 ? normal * normal : reflectance(in, std::asin(sine));
        if (s.m.fresnel) kr = all * share, kt = transmits ? all * (1 - share) : dvec3(0);
        if (sine >= 1) kr = all, kt = dvec3(0);
    }
    dvec3 sum(0);
    if (kr != dvec3(0)) sum += kr * follow(r, {{s.p, 2 * cosine * s.n - s.v}, b.level + 1, b.inside});
    if (kt == dvec3(0)) return sum;
    const dvec3 across = cosine * s.n - s.v; // of length sin in
    const double out = std::asin(sine);
    const dvec3 way = in == 0 ? -s.n : std::sin(out) * glm::normalize(across) - std::cos(out) * s.n;
    return sum + kt * follow(r, {{s.p, way}, b.level + 1, bent.inside});
}

dvec3 follow(const Reference& r, const Branch& b) {
    const Hit hit = nearest(r.scene, b.ray);
    if (hit.t > 1e299) return dvec3(r.scene.environment.background);
    const Material& m = material_of(r.scene, hit);
    const Point s{b.ray.o + hit.t * b.ray.d, glm::dot(hit.n, b.ray.d) < 0 ? hit.n : -hit.n, -b.ray.d, m};
    dvec3 color = dvec3(m.emission) + dvec3(m.diffuse) * dvec3(r.scene.environment.ambient);
    for (const Light& light : r.scene.lights) color += from_light(r, s, light);
    color += sent_on(r, b, hit, s);
    const dvec3 t(m.opacity);
    color *= t;
    if (t != dvec3(1)) color += (1.0 - t) * follow(r, {{s.p, b.ray.d}, b.level, b.inside});
    return color;
}

double largest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

dvec3 Reference::radiance(const dvec3& origin, const dvec3& direction) const {
    return follow(*this, {{origin, glm::normalize(direction)}, 1, {}});
}

Request ray_request(glm::uvec2 size, unsigned depth) {
    Request request = radiance_request(Shading::phong, size);
    request.method = Method::raytrace, request.depth = depth;
    return request;
}

Agreement compare_to_reference(const Scene& scene, const Rendered& r, const Reference& reference, double tolerance, double still) {
    Agreement out;
    double brightest = largest(dvec3(scene.environment.background));
    for (unsigned y = 0; y < r.plan.size.y; ++y)
        for (unsigned x = 0; x < r.plan.size.x; ++x) brightest = std::max(brightest, largest(pixel(*r.output.radiance, x, y)));
    const auto at = [&](double x, double y) { return reference.radiance(r.view.eye, r.view.direction_through({x + 0.5, y + 0.5})); };
    for (unsigned y = 0; y < r.plan.size.y; ++y)
        for (unsigned x = 0; x < r.plan.size.x; ++x) {
            const dvec3 want = at(x, y), got = pixel(*r.output.radiance, x, y);
            double moves = 0;
            for (const double step : {-1e-3, 1e-3}) {
                moves = std::max(moves, largest(at(x + step, y) - want));
                moves = std::max(moves, largest(at(x, y + step) - want));
            }
            if (!(moves < still * brightest)) {
                ++out.unsure;
                continue;
            }
            ++out.sure;
            const double off = largest(got - want) / brightest;
            const bool differs = !(off <= tolerance + moves / brightest);
            out.differ += differs;
            if (differs && !(off <= out.worst)) out.worst = off, out.where = {x, y};
        }
    return out;
}

} // namespace lightbench::testing
