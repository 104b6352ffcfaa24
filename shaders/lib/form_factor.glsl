// The form factor from a point on a surface to a polygon. u = 2^-24.
#ifndef LIGHTBENCH_LIB_FORM_FACTOR
#define LIGHTBENCH_LIB_FORM_FACTOR

// atan(t) for t >= 0, since that of CPU drivers is off by 350 ulp. Halved twice, atan t = 2 atan(t / (1 + sqrt(1 + t^2))), to below
// tan(pi / 8), where seven terms of the series (Gregory 1671) leave less than 0.5 u. Relative error 8 u.
float arc_tangent(float t) {
    bool steep = t > 1.0;
    float s = steep ? 1.0 / t : t;
    float h = s / (1.0 + sqrt(1.0 + s * s)), z = h * h;
    float series = 1.0 - z * (0.33333333 - z * (0.2 - z * (0.14285714 - z * (0.11111111 - z * (0.09090909 - z * (0.07692308 - z * 0.06666667))))));
    float angle = 2.0 * h * series;
    return steep ? 1.5707963 - angle : angle;
}

// Lambert's term of one edge: the angle that it spans, times the cosine between the normal and that of the plane through edge and point.
// a, b relative to the point, not 0. The cross product is taken with the edge itself, so that it is small where the edge is; the angle is
// twice that whose tangent is |a x b| / (|a| |b| + a.b) = (|a| |b| - a.b) / |a x b|, the first for small angles, the second for those near
// pi, so that nothing cancels: an edge that passes close by the point.
float edge_term(vec3 n, vec3 a, vec3 b) {
    vec3 across = cross(a, b - a);
    float size = length(across), product = length(a) * length(b), along = dot(a, b);
    float angle = 2.0 * arc_tangent(along < 0.0 ? (product - along) / size : size / (product + along));
    return size > 0.0 ? angle * dot(n, across) / size : 0.0;
}

// Parts of an edge above the horizon, with where the outline crosses it.
struct HorizonCrossing {
    vec3 down, up; // where it goes below, where it comes back
    bool crosses;
};

float clipped_edge_term(vec3 n, vec3 a, vec3 b, float ha, float hb, inout HorizonCrossing crossing) {
    bool above_a = ha > 0.0, above_b = hb > 0.0;
    vec3 at = a + (b - a) * (ha / (ha == hb ? 1.0 : ha - hb));
    bool goes_down = above_a && !above_b, comes_up = above_b && !above_a;
    if (goes_down) crossing.down = at, crossing.crosses = true;
    if (comes_up) crossing.up = at;
    float term = edge_term(n, above_a ? a : at, above_b ? b : at);
    return above_a || above_b ? term : 0.0;
}

// Lambert 1760, "Photometria"; Baum, Rushmeier, Winget 1989, "Improving radiosity solutions through the use of analytically determined
// form-factors", eq. 7: -1 / (2 pi) times the sum of the edges' terms, of what is above the horizon.
//   n              unit normal at the point
//   q0 ... q3      corners of a convex polygon relative to the point, counter-clockwise as seen from it; two may be equal
//   horizon        what lies less than this above the point's plane counts as below
//   returns the fraction of what leaves the point that arrives, all of it visible; 0 from behind
// Error: absolute 3e-6 (kernel test PointToQuad); 5e-7 where division and square root are rounded. Vulkan adds 4 u and 8 u: 28 u to a tangent,
// whose angle is off by its sine times that, and 22 u to what multiplies the angle; five edges and a full turn of angles make 43 u of it.
float point_to_quad(vec3 n, vec3 q0, vec3 q1, vec3 q2, vec3 q3, float horizon) {
    vec4 h = vec4(dot(n, q0), dot(n, q1), dot(n, q2), dot(n, q3));
    h = mix(h, vec4(-1.0) * abs(h), lessThan(h, vec4(horizon)));
    HorizonCrossing crossing = HorizonCrossing(vec3(0.0), vec3(0.0), false);
    float sum = clipped_edge_term(n, q0, q1, h.x, h.y, crossing) + clipped_edge_term(n, q1, q2, h.y, h.z, crossing) +
                clipped_edge_term(n, q2, q3, h.z, h.w, crossing) + clipped_edge_term(n, q3, q0, h.w, h.x, crossing);
    if (crossing.crosses) sum += edge_term(n, crossing.down, crossing.up);
    return clamp(sum * -0.15915494, 0.0, 1.0);
}

#endif
