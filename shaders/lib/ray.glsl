// What rays of every shape share: bounds of rounding, the origin of a ray that leaves a surface, points of shapes in their own space.
// Bounds are of IEEE arithmetic with the division and square root that Vulkan allows; u = 2^-24. Nothing here has a length of its own.
#ifndef LIGHTBENCH_LIB_RAY
#define LIGHTBENCH_LIB_RAY

const float kNoHit = 3.4028235e38; // the t of a ray that meets nothing: the largest float, so that the nearest hit is a minimum
const float kRoundoff = 5.9604645e-8; // u = 2^-24

// Relative error of n roundings in a row. Higham 2002, "Accuracy and stability of numerical algorithms", lemma 3.1.
float gamma(float n) { return n * kRoundoff / (1.0 - n * kRoundoff); }

// A ray that can be traced: finite, with a direction. What is not passes every box, minimum and maximum lose a NaN: ask once a ray (PR-1).
bool traceable(vec3 o, vec3 d) {
    return all(lessThan(abs(o), vec3(kNoHit))) && all(lessThan(abs(d), vec3(kNoHit))) && any(greaterThan(abs(d), vec3(1.17549435e-38)));
}

// The next float above x; bits of positive floats count up, those of negative ones down. Infinities stay.
float next_up(float x) {
    int b = floatBitsToInt(x == 0.0 ? 0.0 : x);
    return abs(x) < kNoHit ? intBitsToFloat(b < 0 ? b - 1 : b + 1) : x;
}

// x moved to the next float in the direction of a number; itself for 0.
float next_towards(float x, float direction) { return direction > 0.0 ? next_up(x) : direction < 0.0 ? -next_up(-x) : x; }

// Where a ray starts that leaves a surface: beyond the error of the point, on the side that it leaves to (SH-1, SH-4, SP-4).
// Pharr, Jakob, Humphreys 2023, "Physically based rendering", 4th ed., sec. 6.8.6: the plane through the corner of the error box that is
// farthest along n, and one float further, since the addition rounds.
//   p, error  a point and how far each of its coordinates may be from the surface
//   n         geometric normal, unit
//   d         direction in which the ray leaves; through the surface if d.n < 0
// Scales with the scene by powers of two, bit for bit (SC-1), above the denormal numbers.
vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    float away = dot(abs(n), error);
    precise vec3 step = n * (dot(d, n) < 0.0 ? -away : away);
    precise vec3 q = p + step;
    return vec3(next_towards(q.x, step.x), next_towards(q.y, step.y), next_towards(q.z, step.z));
}

mat3 magnitudes(mat4x3 m) { return mat3(abs(m[0]), abs(m[1]), abs(m[2])); }

// A point of a shape that is intersected in its own space, brought to the world, with an error that makes offset_origin work for it there.
//   world_from_object, object_from_world  inverses of each other to a rounding of every entry
//   q                                     the point on the shape
//   error                                 of q, in; of the point in the world, out
// Error, three parts: that of q, carried along; the product, gamma(4) (|M| |q| + |t|); and the way back, which the next ray goes: its origin
// is brought to the shape's space with gamma(4) (|W| |p| + |s|), in the world |M| times that. Two roundings more in both for the entries.
vec3 world_point(mat4x3 world_from_object, mat4x3 object_from_world, vec3 q, inout vec3 error) {
    vec3 p = world_from_object * vec4(q, 1.0);
    mat3 there = magnitudes(world_from_object), back = magnitudes(object_from_world);
    vec3 once = gamma(6.0) * (there * abs(q) + abs(world_from_object[3]));
    vec3 again = gamma(6.0) * (back * abs(p) + abs(object_from_world[3]));
    error = there * (error * (1.0 + gamma(6.0)) + again) + once;
    return p;
}

#endif
