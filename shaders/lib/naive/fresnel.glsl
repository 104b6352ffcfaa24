// Fresnel's reflectance from his sines and tangents: a teaching pair of lib/fresnel.glsl, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_FRESNEL
#define LIGHTBENCH_LIB_NAIVE_FRESNEL
#include "lib/naive/real.glsl"

// Fresnel 1823: F = (sin^2(phi - theta) / sin^2(phi + theta) + tan^2(phi - theta) / tan^2(phi + theta)) / 2, sin(theta) = sin(phi) / n.
// Breaks: 0/0 at normal incidence and for n = 1; near both, and towards grazing angles, the difference of the angles is their rounding.
// GLSL has neither sines nor arcs of doubles: there the sines and tangents of the sum and the difference are taken by the addition theorems.
float naive_fresnel(float c, float n) {
#ifdef LIGHTBENCH_FLOAT64
    double sine = sqrt(1.0 - double(c) * double(c)), bent = sine / double(n);
    if (bent >= 1.0) return 1.0;
    double cosine = sqrt(1.0 - bent * bent), rise = sine * cosine, run = double(c) * bent;
    double sine_less = rise - run, sine_more = rise + run, cosine_less = double(c) * cosine + sine * bent,
           cosine_more = double(c) * cosine - sine * bent;
    double s = sine_less / sine_more, p = (sine_less * cosine_more) / (cosine_less * sine_more);
    return float(0.5 * (s * s + p * p));
#else
    float phi = acos(c), bent = sin(phi) / n;
    if (bent >= 1.0) return 1.0;
    float theta = asin(bent);
    float s = sin(phi - theta) / sin(phi + theta), p = tan(phi - theta) / tan(phi + theta);
    return 0.5 * (s * s + p * p);
#endif
}

#endif
