// Functions of space that bumps are made of: gradient noise, smooth waves. A point in; gradient (xyz) and value (w) out; u = 2^-24.
// From integer and float arithmetic alone, without tables and built-in functions: the same on every device.
#ifndef LIGHTBENCH_LIB_NOISE
#define LIGHTBENCH_LIB_NOISE

const float kTwoPi = 6.2831853;
// Largest value of Perlin's noise with any choice of gradients is 1.03623 (a search over the cell, kernel test GradientNoiseIsInRange).
const float kNoiseScale = 0.96;

// Jarzynski, Olano 2020, "Hash functions for GPU rendering", JCGT 9(3), pcg3d; the first of its three numbers.
uint hash_point(uvec3 p) {
    uvec3 v = p * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return v.x;
}

// One of the 12 directions to the edges of a cube (Perlin 2002).
vec3 lattice_gradient(uvec3 point) {
    uint k = ((hash_point(point) >> 16u) * 12u) >> 16u; // 0 to 11
    float a = (k & 1u) != 0u ? -1.0 : 1.0, b = (k & 2u) != 0u ? -1.0 : 1.0;
    return vec3(k >= 8u ? 0.0 : a, k < 4u ? b : (k < 8u ? 0.0 : a), k < 4u ? 0.0 : b);
}

// Gradient and value of the plane that a lattice point contributes.
//   first, next  the lattice points of the cell's lower and upper corners
//   f            from the lower corner to the place, in [0, 1]^3
//   corner       which of the eight: 0 or 1 an axis
vec4 lattice_plane(uvec3 first, uvec3 next, vec3 f, uvec3 corner) {
    vec3 g = lattice_gradient(mix(first, next, equal(corner, uvec3(1u))));
    return vec4(g, dot(g, f - vec3(corner)));
}

// a and b blended by s, where s has the gradient ds.
vec4 blend(vec4 a, vec4 b, float s, vec3 ds) { return a + s * (b - a) + vec4((b.w - a.w) * ds, 0.0); }

// Gradient noise.
// Perlin 2002, "Improving noise": gradients at lattice points, blended by 6 t^5 - 15 t^4 + 10 t^3, whose first two derivatives vanish on
// the lattice: value and gradient are continuous. The lattice repeats every 2^16 cells.
//   q        anything finite; from 2^23 on every q is a lattice point, and the value 0
//   returns the gradient d value / d q and the value, in [-1, 1]
// Error: absolute 8 u in the value, 24 u in the gradient, of the given q: its whole part is taken off exactly (kernel test GradientNoise).
vec4 gradient_noise(vec3 q) {
    vec3 low = floor(q), f = q - low;
    uvec3 i = uvec3(clamp(low - 65536.0 * floor(low * 1.52587890625e-5), 0.0, 65535.0)), next = i + 1u & 65535u;
    vec3 g = f - 0.5, g2 = g * g;
    vec3 s = 0.5 + g * (1.875 + g2 * (6.0 * g2 - 5.0)); // the same about the middle, where no large terms cancel
    vec3 ds = 30.0 * f * f * ((f - 1.0) * (f - 1.0));
    vec3 dx = vec3(ds.x, 0.0, 0.0), dy = vec3(0.0, ds.y, 0.0), dz = vec3(0.0, 0.0, ds.z);
    vec4 layer[2];
    for (uint z = 0u; z < 2u; ++z) {
        vec4 a = lattice_plane(i, next, f, uvec3(0u, 0u, z)), b = lattice_plane(i, next, f, uvec3(1u, 0u, z));
        vec4 c = lattice_plane(i, next, f, uvec3(0u, 1u, z)), d = lattice_plane(i, next, f, uvec3(1u, 1u, z));
        layer[z] = blend(blend(a, b, s.x, dx), blend(c, d, s.x, dx), s.y, dy);
    }
    return kNoiseScale * blend(layer[0], layer[1], s.z, dz);
}

// sin(2 pi t) by a polynomial of absolute error 0.6 u (Chebyshev nodes), |t| <= 1/4.
float sine_of_turns(float t) {
    float w = t * t;
    return t * (6.283185482 + w * (-41.34168243 + w * (81.60247803 + w * (-76.58116913 + w * 39.75982666))));
}

// sin and cos of t turns; t - roundEven(t) is exact.
// Error: absolute 4 u for any finite t (kernel test SineCosine); the built-in ones may be off by 2^-11, and beyond [-pi, pi] by anything.
vec2 sine_cosine(float t) {
    float r = t - roundEven(t), a = abs(r);
    float quarter = a > 0.25 ? 0.5 - a : a;
    return vec2((r < 0.0 ? -1.0 : 1.0) * sine_of_turns(quarter), sine_of_turns(0.25 - a));
}

// Smooth waves: the mean of three sine waves along (1, 1, 0), (0, 1, 1) and (1, 0, 1), one cycle a unit of q along each axis.
// Blinn 1978, "Simulation of wrinkled surfaces", sec. 5 (bumps by analytic functions). Whole wave numbers: q can be reduced to its fraction
// before anything is rounded, and the bound holds for every q.
//   q        cycles; anything finite
//   returns the gradient d value / d q and the value, in [-1, 1]
// Error of the given q: absolute 5 u in the value, 24 u in the gradient (kernel test Waves). A q that was computed in float is itself off by
// 2^-25 |q| or more, which at |q| = 10^4 moves the value by 0.003.
vec4 waves(vec3 q) {
    vec3 r = q - roundEven(q);
    vec2 a = sine_cosine(r.x + r.y), b = sine_cosine(r.y + r.z), c = sine_cosine(r.x + r.z);
    return vec4(kTwoPi * vec3(a.y + c.y, a.y + b.y, b.y + c.y), a.x + b.x + c.x) * (1.0 / 3.0);
}

#endif
