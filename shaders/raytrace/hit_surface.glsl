// What a hit is a hit of: the point, put back onto its surface, with its error; normals; where pictures lie. In: a ray and its hit.
#ifndef LIGHTBENCH_RAYTRACE_HIT_SURFACE_GLSL
#define LIGHTBENCH_RAYTRACE_HIT_SURFACE_GLSL

#include "raytrace/intersect.glsl"
#include "detail.glsl"

FETCH_TABLE(corners, FETCH_CORNERS, 16)
FETCH_TABLE(normals, FETCH_POINTS, 18)
FETCH_TABLE(detail, FETCH_DETAIL, 20)

struct HitSurface {
    vec3 position, error; // frame; each coordinate is off the surface by at most `error`
    vec3 face;            // unit, outwards: the geometric normal
    vec3 normal;          // unit, outwards: interpolated where a mesh has normals
    uint surface, number; // index into materials; of the primitive, with kRefracts
    Detail detail;
};

vec3 interpolated(vec3 a, vec3 b, vec3 c, vec2 w) { return a * (1.0 - w.x - w.y) + (b * w.x + c * w.y); }

vec3 corner_normal(uint vertex) { return uintBitsToFloat(fetch_normals(vertex).xyz); }

void smooth_triangle(inout HitSurface h, uvec3 v, vec2 b) {
    vec3 n = interpolated(corner_normal(v.x), corner_normal(v.y), corner_normal(v.z), b);
    // 2^-40: shorter than that, the rounding of three unit normals' mean is what the vector consists of (NI-1).
    bool vanishes = dot(n, n) < 9.094947e-13;
    h.normal = vanishes ? h.face : n * inversesqrt(max(dot(n, n), kLeastNormal));
    // The file's normals say which side is outside; its winding may not.
    h.face = dot(h.face, h.normal) < 0.0 ? -h.face : h.face;
}

vec3 detail_word(uvec3 v, uint word, vec2 b) {
    return interpolated(uintBitsToFloat(fetch_detail(3u * v.x + word).xyz), uintBitsToFloat(fetch_detail(3u * v.y + word).xyz),
                        uintBitsToFloat(fetch_detail(3u * v.z + word).xyz), b);
}

void triangle_surface(inout HitSurface h, uint index, vec2 b) {
    uint at = kTriangleTexels * index;
    uvec4 p0 = fetch_triangles(at), p1 = fetch_triangles(at + 1u), p2 = fetch_triangles(at + 2u);
    vec3 v0 = uintBitsToFloat(p0.xyz), v1 = uintBitsToFloat(p1.xyz), v2 = uintBitsToFloat(p2.xyz);
    h.position = triangle_point(v0, v1, v2, b, h.error);
    h.face = safe_normalize(cross(v1 - v0, v2 - v0), vec3(0.0, 0.0, 1.0));
    h.normal = h.face, h.number = p0.w, h.surface = p1.w;
    if (!wants_ray(RAY_SMOOTH | RAY_UV)) return;
    uvec3 v = fetch_corners(wants_ray(RAY_REFRACTED) ? h.number & ~kRefracts : h.number).xyz;
    if (wants_ray(RAY_SMOOTH)) smooth_triangle(h, v, b);
    if (!wants_ray(RAY_UV)) return;
    h.detail.uv = detail_word(v, 0u, b).xy;
    h.detail.u_gradient = detail_word(v, 1u, b), h.detail.v_gradient = detail_word(v, 2u, b);
}

void sphere_surface(inout HitSurface h, uint index, float t) {
    uvec4 a = fetch_spheres(kSphereTexels * index), b = fetch_spheres(kSphereTexels * index + 1u);
    h.position = sphere_point(ray.o, ray.d, t, uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), h.face, h.error);
    h.normal = h.face, h.number = b.x, h.surface = b.y;
}

// The point in object space, and the outward normal there.
void shape_point(uvec4 kind, vec3 o, vec3 d, float t, uint part, out vec3 q, out vec3 n, out vec3 error) {
    vec3 parameters = uintBitsToFloat(kind.yzw);
    q = o + t * d, n = q, error = vec3(0.0);
    if (wants_ray(RAY_BOXES) && kind.x == kShapeBox) q = cube_point(o, d, t, part), n = cube_normal(part), error = gamma(3.0) * abs(q);
    if (wants_ray(RAY_BALLS) && kind.x == kShapeBall) q = ball_point(o, d, t, error), n = q;
    if (wants_ray(RAY_CONES) && kind.x == kShapeCone)
        q = cone_point(q, parameters.x, parameters.y, part), n = cone_normal(q, parameters.x, parameters.y, part), error = vec3(kConeClearance);
    if (wants_ray(RAY_TORI) && kind.x == kShapeTorus)
        q = torus_point(q, parameters.x), n = torus_normal(q, parameters.x), error = vec3(gamma(8.0) * (1.0 + parameters.x));
}

// Besides the error of the point in its own space: that of bringing it to the frame, and that with which the next ray's origin is brought
// to the object's space and so may seem to lie on the other side; both gamma(5) of the products' magnitudes, with two roundings for entries.
void shape_surface(inout HitSurface h, uint index, float t, uint part) {
    uint at = kShapeTexels * index;
    uvec4 x = fetch_shapes(at), y = fetch_shapes(at + 1u), z = fetch_shapes(at + 2u), kind = fetch_shapes(at + 3u), ids = fetch_shapes(at + 4u),
          u = fetch_shapes(at + 5u), v = fetch_shapes(at + 6u), w = fetch_shapes(at + 7u);
    vec3 center = uintBitsToFloat(uvec3(x.w, y.w, z.w)), p = ray.o - center, q, n, error;
    mat3 there = transpose(mat3(uintBitsToFloat(x.xyz), uintBitsToFloat(y.xyz), uintBitsToFloat(z.xyz))); // object from frame
    mat3 back = transpose(mat3(uintBitsToFloat(u.xyz), uintBitsToFloat(v.xyz), uintBitsToFloat(w.xyz)));
    shape_point(kind, there * p, there * ray.d, t, part, q, n, error);
    vec3 from_center = back * q;
    h.position = from_center + center;
    mat3 back_size = mat3(abs(back[0]), abs(back[1]), abs(back[2])), there_size = mat3(abs(there[0]), abs(there[1]), abs(there[2]));
    h.error = back_size * (error + gamma(7.0) * (abs(q) + there_size * abs(from_center))) + gamma(2.0) * abs(h.position);
    h.face = safe_normalize(n * there, vec3(0.0, 0.0, 1.0)); // normals go by the transpose
    h.normal = h.face, h.number = ids.x, h.surface = ids.y;
}

HitSurface hit_surface(RayHit hit) {
    HitSurface h = HitSurface(vec3(0.0), vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), 0u, 0u, kNoDetail);
    uint type = type_of(hit.ref), index = index_of(hit.ref);
    if (wants_ray(RAY_TRIANGLES))
        if (type == kTypeTriangle) triangle_surface(h, index, vec2(hit.b1, hit.b2));
    if (wants_ray(RAY_SPHERES))
        if (type == kTypeSphere) sphere_surface(h, index, hit.t);
    if (wants_ray(RAY_SHAPES))
        if (type == kTypeShape) shape_surface(h, index, hit.t, floatBitsToUint(hit.b1));
    return h;
}

#endif
