// Specular factors of Cook and Torrance's illumination model. Unit vectors in, the factor of ks Ip out; u = 2^-24.
// Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", eqs. 2 to 4: pi (N.L) D G F / (pi (N.V)(N.L)), D scaled so that the
// integral of D (N.H) over the hemisphere is pi/4. A NaN goes in and comes out.
#ifndef LIGHTBENCH_LIB_COOK_TORRANCE
#define LIGHTBENCH_LIB_COOK_TORRANCE
#include "lib/fresnel.glsl"
#include "lib/power.glsl"

// What both distributions need of the half vector H = L + V, which is not made unit.
struct Facet {
    float nl, nv;  // N.L, N.V
    float nh;      // N.H
    float across2; // |N x H|^2
    float h2;      // |H|^2 = (2 V.H)^2: L and V make the angle with H that has the cosine |H|/2, however small it is
};

// |N x H|^2 without the rounding of H and of the products, each of which would tilt H by u: 2 u tan(alpha)/m^2 of D, 1e-3 for m = 1e-3.
// N x H = N x (H - k N) for every k; with 12 bits of k ~ N.H the products are exact (Dekker 1971, sec. 5), what H rounds off is added
// (Knuth, TAOCP 2, 4.2.2), and the difference is 2^-11 + tan(alpha) of H at most: so is its error, in u.
float across_squared(vec3 n, vec3 l, vec3 v, float nh) {
    precise vec3 h = l + v;
    precise vec3 shift = h - l;
    precise vec3 rest = (l - (h - shift)) + (v - shift);
    precise float k = uintBitsToFloat(floatBitsToUint(nh) & 0xfffff000u);
    precise vec3 high = uintBitsToFloat(floatBitsToUint(n) & 0xfffff000u);
    precise vec3 low = n - high;
    precise vec3 d = ((h - k * high) - k * low) + rest;
    vec3 c = cross(n, d);
    return dot(c, c);
}

Facet make_facet(vec3 n, vec3 l, vec3 v) {
    vec3 h = l + v;
    float nl = dot(n, l), nv = dot(n, v), nh = nl + nv;
    return Facet(nl, nv, nh, across_squared(n, l, v, nh), dot(h, h));
}

// F min(1/(N.V), 2 (N.H)/(V.H), 2 (N.H)(N.L)/((V.H)(N.V))) D: G with its divisor, so that nothing is 0/0 at grazing angles. What changes
// when L and V change places comes last: the BRDF is reciprocal within 6 u (4 u is the most
// that was seen: kernel test CookTorranceIsReciprocal).
// No light leaks through from behind: 0 unless N.L and N.V are normal numbers above 0. Where |L + V|^2 < 1e-12 there is no half vector:
// L = -V up to the rounding of unit vectors, and the plane that both graze sees neither.
vec3 facet_factor(Facet f, float d, vec3 ior) {
    const float least = 1.17549435e-38; // below it 1/(N.V) may overflow, and devices may flush
    float nearest = f.nl < f.nv ? f.nl : f.nv, open = 4.0 * f.nh / f.h2;
    bool whole = open * nearest > 1.0; // G = 1
    vec3 factor = (whole ? d : d * open) * fresnel_dense(0.5 * sqrt(f.h2), ior) * ((whole ? 1.0 : nearest) / f.nv);
    return f.nl < least || f.nv < least || f.h2 < 1e-12 ? vec3(0.0) : factor;
}

// alpha^2, alpha the angle between N and H, |N| = 1: alpha = 2 atan(q), q = tan(alpha/2) = |N x H|/(N.H + |H|) <= 1, and (atan(q)/q)^2 is
// a polynomial in q^2 of relative error 0.7 u (Remez exchange on [0, 1]). GLSL's acos() and atan() may be off by 2^-11 and 4096 ulp.
// Error: relative 16 u besides that of |N x H|^2.
float squared_angle(Facet f) {
    float half_secant = f.nh + sqrt(f.h2);
    float w = f.across2 / (half_secant * half_secant);
    float a = 0.20271359384059906 + w * (-0.11062570661306381 + w * (0.03888706490397453 + w * -0.006382887717336416));
    a = -0.4180884063243866 + w * (0.35071027278900146 + w * (-0.28473925590515137 + w * a));
    return 4.0 * w * (1.0 + w * (-0.6666646003723145 + w * (0.511040210723877 + w * a)));
}

// tan^2(alpha) = |N x H|^2/(N.H)^2: 1 - cos^2 loses every digit where highlights are. Held to 1e12, where every D of the domain is 0
// and its factors are not infinite.
float squared_tangent(Facet f) {
    float nh2 = f.nh * f.nh, least = 1e-12 * f.h2;
    return f.across2 / (nh2 < least ? least : nh2);
}

// D Gaussian, lobe exp(-(alpha/m)^2).
// Torrance and Sparrow 1967, "Theory for off-specular reflection from roughened surfaces", eq. 11, in the angle.
//   n, l, v  unit vectors to 6 u; H is the direction of L + V as they are given
//   m        rms slope, in [1e-3, 1e3]
//   lobe     c, from lobe_factor() of scene/distribution.h
//   ior      index of refraction, >= 1 (below 1: fresnel_dense)
// Error: see cook_torrance_beckmann (kernel test CookTorranceGaussian).
vec3 cook_torrance_gaussian(vec3 n, vec3 l, vec3 v, float m, float lobe, vec3 ior) {
    Facet f = make_facet(n, l, v);
    return facet_factor(f, lobe * exp_negative(-squared_angle(f) / (m * m)), ior);
}

// D Beckmann, exp(-tan^2(alpha)/m^2) / (4 m^2 cos^4(alpha)).
// Beckmann and Spizzichino 1963, "The scattering of electromagnetic waves from rough surfaces", sec. 5.3; 1/cos^2 = 1 + tan^2.
//   lobe     1/(4 m^2), from lobe_factor()
// Error: relative (13 + 8 E + sqrt(E)/(500 m) + (1 + 2 E) e) u, E the exponent and e u the larger relative error of N.L and N.V: 3 u where
// the normal is an axis, at most 3 u/min(N.L, N.V) elsewhere. 0 for E > 87.3; either side where N.L or N.V is 0 but for its rounding
// (kernel tests CookTorranceBeckmann, CookTorranceGrazing).
vec3 cook_torrance_beckmann(vec3 n, vec3 l, vec3 v, float m, float lobe, vec3 ior) {
    Facet f = make_facet(n, l, v);
    float t = squared_tangent(f), secant2 = 1.0 + t;
    return facet_factor(f, lobe * (secant2 * secant2) * exp_negative(-t / (m * m)), ior);
}

#endif
