// How a spot light fades between the inner and the outer cone. Cosines in, factor in [0, 1] out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_SPOT
#define LIGHTBENCH_LIB_SPOT

// Spot with a soft edge.
// Warn 1983, "Lighting controls for synthetic images", sec. 3 (the cone); the edge is the cubic Hermite step 3 t^2 - 2 t^3 in the cosine.
//   cos_angle  cosine between the spot's axis and the direction to the point
//   cos_outer  cosine of the half-angle of the cone
//   cos_inner  cosine where the fading begins, >= cos_outer; equal: a hard edge, and the edge itself is lit
//   returns 1 inside the inner cone, 0 outside the outer one, exactly; NaN for a NaN angle
// Error: absolute 8 u (kernel test SpotFalloff).
float spot_falloff(float cos_angle, float cos_outer, float cos_inner) {
    float t = (cos_angle - cos_outer) / (cos_inner - cos_outer); // not chosen below where it is 0/0
    float edge = t * t * (3.0 - 2.0 * t);
    float outside = cos_angle <= cos_outer ? 0.0 : edge;
    return cos_angle >= cos_inner ? 1.0 : outside;
}

#endif
