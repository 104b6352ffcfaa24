// One ray against one primitive, whatever walks the structure: so that all structures find the same hit to the last bit (no device may round
// this otherwise in another walk's shader: src/gpu/float_rules.h). In: the global `ray`. Out: hit and its number.
#ifndef LIGHTBENCH_RAYTRACE_INTERSECT_GLSL
#define LIGHTBENCH_RAYTRACE_INTERSECT_GLSL

#include "raytrace/order.glsl"
#include "lib/ray.glsl"
#include "lib/ray_box.glsl"
#include "lib/ray_cone.glsl"
#include "lib/ray_sphere.glsl"
#include "lib/ray_torus.glsl"
#include "lib/ray_triangle.glsl"

FETCH_TABLE(triangles, FETCH_TRIANGLES, 8)
FETCH_TABLE(spheres, FETCH_SPHERES, 10)
FETCH_TABLE(shapes, FETCH_SHAPES, 12)

RayShear shear;
uint tested_triangles = 0u, tested_spheres = 0u, tested_boxes = 0u, tested_balls = 0u, tested_cones = 0u, tested_tori = 0u;
uint count_nodes = 0u, count_voxels = 0u;

void start_ray(Ray r) {
    ray.o = r.origin, ray.d = r.direction;
    ray.inv_d = safe_inverse(r.direction);
    ray.slack = slack_of(abs(r.origin));
    set_after(r.after, r.after_number);
    if (wants_ray(RAY_TRIANGLES)) shear = shear_of(r.direction);
}

void test_triangle(uint index, inout RayHit hit) {
    uvec4 a = fetch_triangles(kTriangleTexels * index), b = fetch_triangles(kTriangleTexels * index + 1u),
          c = fetch_triangles(kTriangleTexels * index + 2u);
    vec2 weights;
    float t = ray_triangle(shear, ray.o, uintBitsToFloat(a.xyz), uintBitsToFloat(b.xyz), uintBitsToFloat(c.xyz), after_for(a.w), weights);
    offer(hit, t, kTypeTriangle << kRefType | index, a.w, weights.x, weights.y);
    if (wants_ray(RAY_COUNT)) ++tested_triangles;
}

void test_sphere(uint index, inout RayHit hit) {
    uvec4 a = fetch_spheres(kSphereTexels * index), b = fetch_spheres(kSphereTexels * index + 1u);
    float t = ray_sphere(ray.o, ray.d, uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), after_for(b.x));
    offer(hit, t, kTypeSphere << kRefType | index, b.x, 0.0, 0.0);
    if (wants_ray(RAY_COUNT)) ++tested_spheres;
}

void test_shape(uint index, inout RayHit hit) {
    uint at = kShapeTexels * index;
    uvec4 x = fetch_shapes(at), y = fetch_shapes(at + 1u), z = fetch_shapes(at + 2u), k = fetch_shapes(at + 3u);
    uint number = fetch_shapes(at + 4u).x;
    vec3 p = ray.o - uintBitsToFloat(uvec3(x.w, y.w, z.w)), rx = uintBitsToFloat(x.xyz), ry = uintBitsToFloat(y.xyz),
         rz = uintBitsToFloat(z.xyz), parameters = uintBitsToFloat(k.yzw);
    vec3 o = vec3(dot(rx, p), dot(ry, p), dot(rz, p)), d = vec3(dot(rx, ray.d), dot(ry, ray.d), dot(rz, ray.d));
    float after = after_for(number), t = kNoHit;
    uint part = 0u;
    if (wants_ray(RAY_BOXES))
        if (k.x == kShapeBox) {
            t = ray_cube(o, d, after, part);
            if (wants_ray(RAY_COUNT)) ++tested_boxes;
        }
    if (wants_ray(RAY_BALLS))
        if (k.x == kShapeBall) {
            t = ray_ball(o, d, after);
            if (wants_ray(RAY_COUNT)) ++tested_balls;
        }
    if (wants_ray(RAY_CONES))
        if (k.x == kShapeCone) {
            t = ray_cone(o, d, parameters.x, parameters.y, parameters.z != 0.0, after, part);
            if (wants_ray(RAY_COUNT)) ++tested_cones;
        }
    if (wants_ray(RAY_TORI))
        if (k.x == kShapeTorus) {
            t = ray_torus(o, d, parameters.x, after);
            if (wants_ray(RAY_COUNT)) ++tested_tori;
        }
    offer(hit, t, kTypeShape << kRefType | index, number, uintBitsToFloat(part), 0.0);
}

uint type_of(uint ref) { return (ref >> kRefType) & 3u; }
uint index_of(uint ref) { return ref & kRefIndex; }

// A single primitive.
void test_reference(uint ref, inout RayHit hit) {
    uint type = type_of(ref);
    if (wants_ray(RAY_TRIANGLES))
        if (type == kTypeTriangle) test_triangle(index_of(ref), hit);
    if (wants_ray(RAY_SPHERES))
        if (type == kTypeSphere) test_sphere(index_of(ref), hit);
    if (wants_ray(RAY_SHAPES))
        if (type == kTypeShape) test_shape(index_of(ref), hit);
}

uint number_of(uint ref) {
    uint type = type_of(ref), index = index_of(ref);
    if (ref == kNothing) return 0u;
    if (wants_ray(RAY_TRIANGLES) && type == kTypeTriangle) return fetch_triangles(kTriangleTexels * index).w;
    if (wants_ray(RAY_SPHERES) && type == kTypeSphere) return fetch_spheres(kSphereTexels * index + 1u).x;
    if (wants_ray(RAY_SHAPES)) return fetch_shapes(kShapeTexels * index + 4u).x;
    return 0u;
}

void add_counts() {
    if (!wants_ray(RAY_COUNT)) return;
    atomicAdd(counters.triangles, tested_triangles);
    atomicAdd(counters.spheres, tested_spheres);
    atomicAdd(counters.boxes, tested_boxes);
    atomicAdd(counters.balls, tested_balls);
    atomicAdd(counters.cones, tested_cones);
    atomicAdd(counters.tori, tested_tori);
    atomicAdd(counters.nodes, count_nodes);
    atomicAdd(counters.voxels, count_voxels);
}

#endif
