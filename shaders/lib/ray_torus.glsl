// Rays and the torus of major radius 1 about z, minor radius m. A ray in the space of the shape in, its t out; u = 2^-24.
// m > 1 is the spindle torus without the part inside: its solid is everything within m of the ring x^2 + y^2 = 1, z = 0.
#ifndef LIGHTBENCH_LIB_RAY_TORUS
#define LIGHTBENCH_LIB_RAY_TORUS
#include "lib/local_ray.glsl"

const int kCriticalSteps = 10, kRootSteps = 20; // with 6 pieces and two roots at most: 56 iterations a ray

// What the distance from the ring is made of along a line p + s v: r(s) = |p + s v| in the xy plane.
struct TorusLine {
    vec3 p, v;
    float pv, c, a; // p.v in space and in the plane, |v|^2 in the plane
    float cross2;   // (p x v)^2 in the plane: r'' = cross2 / r^3
};

// Half the derivative of g(s) = (squared distance from the ring) = |p + s v|^2 - 2 r(s) + 1 (x), and of that again (y).
// r is held to 1e-9: on the axis g has a kink, of a size below that.
vec2 torus_slope(TorusLine line, float s) {
    float r = max(length(line.p.xy + s * line.v.xy), 1e-9);
    return vec2(s + line.pv - (line.c + line.a * s) / r, 1.0 - line.cross2 / (r * r * r));
}

// Distance of the point at s from the surface, negative inside.
// Error: 4 u (1 + m) where |p + s v| <= 1 + m.
float torus_distance(TorusLine line, float m, float s) {
    vec3 q = line.p + s * line.v;
    return length(vec2(length(q.xy) - 1.0, q.z)) - m;
}

// One Newton step towards a zero of g', on the side of the inflections where g'' has this sign.
float critical_step(TorusLine line, float s, float low, float high, float sign_of_bend) {
    vec2 slope = torus_slope(line, s);
    float bend = sign_of_bend * max(sign_of_bend * slope.y, 1e-6);
    return clamp(s - slope.x / bend, low, high);
}

// The knots between which g is monotonic and bends one way: minimum, inflection, maximum, inflection, minimum.
struct TorusKnots {
    float low, minimum0, bend0, maximum, bend1, minimum1, high;
};

// r is a hyperbola over s with its vertex at s = -c/a, so g'' = 2 - 2 cross2/r^3 is below 0 on one interval about the vertex at most, where
// r^3 < cross2; there a maximum may be, left and right of it a minimum each. g' is concave left of the vertex and convex right of it (the
// other way round in between), so Newton steps from the asymptotes s = -p.v +- sqrt a, and from the vertex, approach its zeros from one
// side and cannot miss. A minimum or maximum that is not there ends on the inflection. The knots are exact to the root of the error of g,
// which is all that g at a minimum sees.
TorusKnots torus_knots(TorusLine line, float low, float high) {
    float vertex = -line.c / max(line.a, 1e-30), across = sqrt(line.cross2), rest = max(line.a, 1e-30);
    float width2 = (pow(max(across, 1e-30), 1.3333334) - line.cross2 / rest) / rest;
    float width = sqrt(max(width2, 0.0));
    TorusKnots k;
    k.low = low;
    k.high = high;
    k.bend0 = clamp(vertex - width, low, high);
    k.bend1 = clamp(vertex + width, low, high);
    k.maximum = clamp(vertex, low, high);
    k.minimum0 = clamp(-line.pv - sqrt(line.a), low, k.bend0);
    k.minimum1 = clamp(-line.pv + sqrt(line.a), k.bend1, high);
    for (int i = 0; i < kCriticalSteps; ++i) {
        vec3 before = vec3(k.minimum0, k.maximum, k.minimum1);
        k.minimum0 = critical_step(line, k.minimum0, low, k.bend0, 1.0);
        k.maximum = critical_step(line, k.maximum, k.bend0, k.bend1, -1.0);
        k.minimum1 = critical_step(line, k.minimum1, k.bend1, high, 1.0);
        if (all(lessThan(abs(vec3(k.minimum0, k.maximum, k.minimum1) - before), vec3(1e-5)))) break; // the next step would be its square
    }
    k.maximum = torus_slope(line, k.bend1).x > 0.0 ? k.bend1 : (torus_slope(line, k.bend0).x < 0.0 ? k.bend0 : k.maximum);
    return k;
}

// The root of g - m^2 between an extremum of g and a point on the other side of the surface, where g is monotonic and bends one way.
// Newton's method from the root of the parabola at the extremum: at most one step leads away, to the side from which the others approach
// without crossing. g - m^2 is taken as the product of distance and distance + 2 m, whose digits do not cancel (TO-1). Where the line is all
// but tangent, the distance is its own rounding before steps are short: below u (1 + m) the search ends, and its ends close in by signs.
float torus_root(TorusLine line, float m, float extremum, float other) {
    float d = torus_distance(line, m, extremum), bend = abs(torus_slope(line, extremum).y);
    float guess = sqrt(abs(d * (d + 2.0 * m)) / max(bend, 1e-6));
    float low = min(extremum, other), high = max(extremum, other);
    float s = clamp(extremum + (other < extremum ? -guess : guess), low, high);
    float least = 5.9604645e-08 * (1.0 + m);
    bool done = false;
    for (int i = 0; i < kRootSteps && !done; ++i) {
        vec3 q = line.p + s * line.v;
        float r = length(q.xy), ring = length(vec2(r - 1.0, q.z)), f = ring - m;
        float slope = 2.0 * ((r - 1.0) * dot(q.xy, line.v.xy) / max(r, 1e-9) + q.z * line.v.z);
        float next = slope == 0.0 ? s : s - f * (ring + m) / slope;
        bool beyond = (f <= 0.0) != (d <= 0.0);
        other = beyond ? s : other;
        extremum = beyond ? extremum : s;
        low = min(extremum, other);
        high = max(extremum, other);
        done = abs(f) <= least || abs(next - s) <= least;
        s = done ? s : clamp(next, low, high);
    }
    return s;
}

// The piece of a line between two neighbouring knots; first: the extremum is the earlier one.
struct TorusPiece {
    float begin, end;
    bool first;
};

TorusPiece torus_piece(TorusKnots k, int i) {
    if (i == 0) return TorusPiece(k.low, k.minimum0, false);
    if (i == 1) return TorusPiece(k.minimum0, k.bend0, true);
    if (i == 2) return TorusPiece(k.bend0, k.maximum, false);
    if (i == 3) return TorusPiece(k.maximum, k.bend1, true);
    if (i == 4) return TorusPiece(k.bend1, k.minimum1, false);
    return TorusPiece(k.minimum1, k.high, true);
}

// The smallest t > after at which o + t d is on the surface, else kNoHit.
// Monotonic pieces hold one root or none, told by the signs at their ends: neither double roots (TO-2) nor a root at the start (TO-4) can
// be lost or doubled by more than the rounding of the distance. At most two roots are searched for: that of the piece with `after`, and
// the next one.
//   o, d     as for local_ray
//   m        in [0, 1e4]
// Error: the surface would have to be moved by 6 u (1 + m + |o|) for o + t d to be on it, and for any other part of the ray to be on the
// other side (kernel tests RayTorus...).
float ray_torus(vec3 o, vec3 d, float m, float after) {
    LocalRay ray = local_ray(o, d, 1.0 + m);
    float pv = dot(ray.p, ray.v), across = ray.p.x * ray.v.y - ray.p.y * ray.v.x;
    TorusLine line = TorusLine(ray.p, ray.v, pv, dot(ray.p.xy, ray.v.xy), dot(ray.v.xy, ray.v.xy), across * across);
    vec3 nearest = ray.p - pv * ray.v;
    float reach = 1.001 * (1.0 + m), half2 = reach * reach - dot(nearest, nearest); // 0.001: the ends are outside whatever is rounded
    float t = kNoHit;
    if (!ray.close || !(half2 >= 0.0)) return t;
    float around = sqrt(half2);
    TorusKnots knots = torus_knots(line, -pv - around, -pv + around);
    float before = 1.0;
    for (int i = 0; i < 6 && t == kNoHit; ++i) {
        TorusPiece piece = torus_piece(knots, i);
        float beyond = i == 5 ? 1.0 : torus_distance(line, m, piece.end);
        if ((before <= 0.0) != (beyond <= 0.0) && t_of(ray, piece.end) > after) {
            float s = torus_root(line, m, piece.first ? piece.begin : piece.end, piece.first ? piece.end : piece.begin);
            t = t_of(ray, s) > after ? t_of(ray, s) : kNoHit;
        }
        before = beyond;
    }
    return t;
}

// Nearest point of the ring; any one for a point of the axis.
vec2 torus_ring(vec3 p, out float r) {
    r = safe_length(vec3(p.xy, 0.0));
    return r > 0.0 ? p.xy / r : vec2(1.0, 0.0);
}

// A computed point of a hit put back onto the surface, away from the ring.
//   p        anything finite but the ring
// Error: 4 u (1 + m) from the surface (kernel test TorusPoint).
vec3 torus_point(vec3 p, float m) {
    float r;
    vec2 ring = torus_ring(p, r), off = vec2(r - 1.0, p.z);
    off = safe_normalize(vec3(off, 0.0), vec3(1.0, 0.0, 0.0)).xy * m;
    off = off.x < -1.0 ? vec2(-1.0, sqrt((m - 1.0) * (m + 1.0)) * (p.z < 0.0 ? -1.0 : 1.0)) : off; // a spindle ends on the axis
    return vec3(ring * (1.0 + off.x), off.y);
}

// Outward unit normal at a point of the surface: away from the ring. On the axis, where a spindle has a dimple, along the axis.
// Error: 4 u (1 + m) / m of the given point, whose distance from the ring is all that there is (kernel test TorusNormal).
vec3 torus_normal(vec3 p, float m) {
    float r;
    vec2 ring = torus_ring(p, r);
    vec3 along = vec3(0.0, 0.0, p.z < 0.0 ? -1.0 : 1.0);
    return r == 0.0 ? along : safe_normalize(vec3(ring * (r - 1.0), p.z), along);
}

#endif
