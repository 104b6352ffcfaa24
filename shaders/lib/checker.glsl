// The checkerboard, averaged over a pixel. Texture coordinates and their derivatives in, a number in [0, 1] out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_CHECKER
#define LIGHTBENCH_LIB_CHECKER

// Integral from 0 of the square wave of period 1 that is 1 on [0, 1/2) and -1 on [1/2, 1): a triangle of height 1/2.
float square_integral(float x) { return 0.5 - abs(x - floor(x) - 0.5); }

// Mean of that wave over [x - width / 2, x + width / 2]; the wave itself where width is 0.
// Up to half a period there is one edge at most, and the mean follows from the distance to it: no difference of integrals, which would
// lose the digits of a small width.
// Error: absolute 8 u, for any finite x and width (kernel test Checker).
float square_mean(float x, float width) {
    float w = width <= 1048576.0 ? width : 1048576.0; // wider, the mean is below 2^-21; a NaN is grey
    float f = x - roundEven(x);                       // in [-1/2, 1/2]; exact, as all that follows up to the division
    float sharp = f >= 0.0 && f < 0.5 ? 1.0 : -1.0;
    float to_edge = min(abs(f), 0.5 - abs(f));
    float narrow = (f < 0.0 ? -1.0 : 1.0) * min(2.0 * to_edge / max(w, 1e-30), 1.0);
    float wide = (square_integral(f + 0.5 * w) - square_integral(f - 0.5 * w)) / max(w, 0.5);
    float mean = w > 0.5 ? wide : narrow;
    return w > 0.0 ? mean : sharp;
}

// Two squares for each unit of u and of v: 0 on [0, 1/2)^2, its neighbours 1; box-filtered over the bounding box of the pixel.
// The product of the waves of u and v, whose means over a box are independent. Quilez 2013, "Filtering the checkerboard pattern" (the idea).
//   duv_dx, duv_dy  derivatives of uv over the pixel, seams taken out
float checker(vec2 uv, vec2 duv_dx, vec2 duv_dy) {
    vec2 width = abs(duv_dx) + abs(duv_dy);
    return 0.5 - 0.5 * square_mean(uv.x, width.x) * square_mean(uv.y, width.y);
}

#endif
