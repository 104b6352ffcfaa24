// The ray and the torus as a quartic equation, solved by Ferrari's method: a teaching pair of lib/ray_torus.glsl, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_TORUS
#define LIGHTBENCH_LIB_NAIVE_TORUS
#include "lib/naive/real.glsl"

// A root above 0 of z^3 + 2 p z^2 + (p^2 - 4 r) z - q^2, of which any will do: Newton's method, and halves where it leaves the bracket
// between 0 and Cauchy's bound.
real naive_resolvent(real p, real q, real r) {
    real a = 2.0 * p, b = p * p - 4.0 * r, c = -q * q;
    real low = 0.0, high = 1.0 + max(max(abs(a), abs(b)), abs(c)), z = high;
    for (int i = 0; i < 60; ++i) {
        real value = ((z + a) * z + b) * z + c, slope = (3.0 * z + 2.0 * a) * z + b;
        low = value < 0.0 ? z : low;
        high = value < 0.0 ? high : z;
        real next = z - value / slope;
        next = next > low && next < high ? next : 0.5 * (low + high);
        if (next == z) break;
        z = next;
    }
    return z;
}

void naive_keep(real y, real after, inout real first) {
    if (y > after && y < first) first = y;
}

// Both roots of y^2 + b y + c.
void naive_quadratic(real b, real c, real shift, real after, inout real first) {
    real discriminant = b * b - 4.0 * c;
    if (discriminant < 0.0) return;
    naive_keep(0.5 * (-b - sqrt(discriminant)) - shift, after, first);
    naive_keep(0.5 * (-b + sqrt(discriminant)) - shift, after, first);
}

// Torus of radii 1 and m about z: (|p|^2 + 1 - m^2)^2 = 4 (x^2 + y^2) along o + t d. Hanrahan 1989, "A survey of ray-surface intersection
// algorithms", in Glassner, "An Introduction to Ray Tracing", sec. 3.2; Ferrari's method after Cardano 1545, "Ars magna", ch. 39.
// Breaks: the coefficients grow with the fourth power of |o|, and the depressed quartic subtracts them from each other: from 30 radii away
// floats hold nothing of the torus any more (doubles: from some hundred); double roots (tangents) and p^2 = 4 r lose half of the digits at
// any distance.
float naive_torus(vec3 origin, vec3 direction, float minor, float after) {
    real scale = length(real3(direction));
    real3 o = real3(origin), d = real3(direction) / scale;
    real m = minor, od = dot(o, d), k = dot(o, o) + 1.0 - m * m;
    real a = 4.0 * od, b = 2.0 * k + 4.0 * od * od - 4.0 * (d.x * d.x + d.y * d.y);
    real c = 4.0 * od * k - 8.0 * (o.x * d.x + o.y * d.y), e = k * k - 4.0 * (o.x * o.x + o.y * o.y);
    real p = b - 0.375 * a * a, q = c - 0.5 * a * b + 0.125 * a * a * a;
    real r = e - 0.25 * a * c + 0.0625 * a * a * b - 0.01171875 * a * a * a * a;
    real z = naive_resolvent(p, q, r), u = sqrt(z), shift = 0.25 * a, first = real(3.4028235e38);
    real half_sum = 0.5 * (p + z), v = u > 0.0 ? 0.5 * q / u : sqrt(max(half_sum * half_sum - r, real(0.0)));
    naive_quadratic(u, half_sum - v, shift, real(after) * scale, first);
    naive_quadratic(-u, half_sum + v, shift, real(after) * scale, first);
    return first < real(3.4028235e38) ? float(first / scale) : 3.4028235e38;
}

#endif
