// Phong's specular factor as he writes it: a teaching pair of lib/phong.glsl, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_PHONG
#define LIGHTBENCH_LIB_NAIVE_PHONG

// Phong 1975, "Illumination for computer generated pictures", eq. 2: max(R.V, 0)^n.
// Breaks: near 1 a float knows R.V to 2^-24 only, and the power makes n of it; pow(0, 0) is no number; R.V may be above 0 behind a surface.
// GLSL has no power of doubles.
float naive_phong(vec3 n, vec3 l, vec3 v, float shininess) {
    vec3 r = 2.0 * dot(n, l) * n - l;
    return pow(max(dot(r, v), 0.0), shininess);
}

#endif
