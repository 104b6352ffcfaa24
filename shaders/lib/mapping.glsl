// From points of mapping space, [-1, 1]^3 with the polar axis z, to texture coordinates, and their gradients there. u = 2^-24.
#ifndef LIGHTBENCH_LIB_MAPPING
#define LIGHTBENCH_LIB_MAPPING

const float kInvTwoPi = 0.15915494;
const float kInvPi = 0.31830989;

// Angle of (x, y) from the x axis towards the y axis, in turns: octants are then exact, and so are additions of them.
// atan t / (2 pi) for |t| <= tan(pi/8) by a polynomial of absolute error 0.04 u (Chebyshev nodes). The built-in atan(y, x) may be off by 4096
// ulp (Vulkan 1.3, "Precision and operation of SPIR-V instructions") and is undefined at (0, 0) (TX-3, TX-4).
//   y, x     the larger magnitude in [1e-37, 1e38], or both 0
//   returns a number in [0, 1); 0 at (0, 0)
// Error: absolute 1.5 u (kernel test Turns), where 1 is as far from 0 as 0 is; a leg below 2^-126 may count as 0.
float turns(float y, float x) {
    float ax = abs(x), ay = abs(y), low = min(ax, ay), high = max(ax, ay);
    bool wide = low > 0.41421356 * high;
    float t = (wide ? low - high : low) / (wide ? low + high : max(high, 1e-37));
    float w = t * t;
    float a = t * (0.1591549367 + w * (-0.05305077508 + w * (0.03178973868 + w * (-0.02204055712 + w * 0.01269466244))));
    a = wide ? 0.125 + a : a;
    a = ay > ax ? 0.25 - a : a;
    a = x < 0.0 ? 0.5 - a : a;
    a = y < 0.0 ? 1.0 - a : a;
    return a >= 1.0 ? 0.0 : a;
}

// Height of a direction over the sphere: 1 at the pole +z, 0 at -z, linear in the polar angle.
// atan of both legs: acos(z) would be off by 1.6e-4 rad (TX-4). distance: from the polar axis.
float polar_height(float distance, float z) { return 1.0 - 2.0 * turns(distance, z); }

// Spherical mapping: u the azimuth in [0, 1), v = 1 - polar angle / pi. Blinn, Newell 1976, "Texture and reflection in computer generated images".
//   p        |p| in [1e-15, 1e18]; at the poles u is 0, at the centre (0, 1)
// Error: absolute 1.5 u in u, 4 u in v (kernel test MapSpherical).
vec2 map_spherical(vec3 p) { return vec2(turns(p.y, p.x), polar_height(sqrt(p.x * p.x + p.y * p.y), p.z)); }

// Cylindrical mapping: u the azimuth, v from 0 at z = -1 to 1 at z = 1.
// Error: absolute 1.5 u in u, 2 u in v for |z| <= 1 (kernel test MapCylindrical).
vec2 map_cylindrical(vec3 p) { return vec2(turns(p.y, p.x), 0.5 * p.z + 0.5); }

// Planar mapping along z: [-1, 1]^2 becomes [0, 1]^2.
vec2 map_planar(vec3 p) { return 0.5 * p.xy + 0.5; }

// r^2 and distance^2 from the polar axis, where one divides by them: the first is never below 2^-60, far below the rounding of points of a
// box that is [-1, 1]; the second never below 2^-46 r^2: nearer to the axis, azimuths are the rounding of p (2^-24 of each coordinate).
vec2 safe_squares(vec3 p) {
    float r2 = max(dot(p, p), 8.6736174e-19);
    return vec2(r2, max(dot(p.xy, p.xy), 1.4210855e-14 * r2));
}

// Gradient of the azimuth in turns: (-y, x, 0) / (2 pi distance^2); 0 on the axis.
vec3 azimuth_gradient(vec3 p, vec2 squares) { return vec3(-p.y, p.x, 0.0) * (kInvTwoPi / squares.y); }

// Gradients of u and v over mapping space.
//   p        |p| in [1e-6, 1e15]
// Error: relative 8 u of their lengths; at the poles both are 0 (no direction is steepest), near them finite (kernel test MapGradients).
void map_spherical_gradients(vec3 p, out vec3 du, out vec3 dv) {
    vec2 squares = safe_squares(p);
    float distance = sqrt(squares.y);
    du = azimuth_gradient(p, squares);
    dv = vec3(p.xy * (-p.z / distance), distance) * (kInvPi / squares.x);
    dv = p.x == 0.0 && p.y == 0.0 ? vec3(0.0) : dv;
}

void map_cylindrical_gradients(vec3 p, out vec3 du, out vec3 dv) {
    du = azimuth_gradient(p, safe_squares(p));
    dv = vec3(0.0, 0.0, 0.5);
}

void map_planar_gradients(vec3 p, out vec3 du, out vec3 dv) {
    du = vec3(0.5, 0.0, 0.0);
    dv = vec3(0.0, 0.5, 0.0);
}

// The derivative of spherical or cylindrical coordinates over a pixel, without the jump of u where the seam runs through it (TX-5).
// Exact; a pixel that sees more than half the picture takes the shorter way round.
vec2 wrapped(vec2 duv) { return vec2(duv.x - roundEven(duv.x), duv.y); }

#endif
