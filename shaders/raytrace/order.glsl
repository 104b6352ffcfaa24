// Which of two hits of a ray counts first, and where the ray goes on behind one: one order for all walks. The nearer hit; of two at the same
// distance that of the lower number. But what touches is one thing: of a surface that refracts (S16) and one that does not, the latter counts
// first wherever rounding may have put it behind. Without this, light that leaves a glass through its bottom would start below the floor that
// the glass stands on, or not, as rounding has it. In: the global `ray`. Out: hit, hit_t and hit_number.
#ifndef LIGHTBENCH_RAYTRACE_ORDER_GLSL
#define LIGHTBENCH_RAYTRACE_ORDER_GLSL

#include "raytrace/rays.glsl"
#include "lib/exact.glsl"

struct RayState {
    vec3 o, d, inv_d;
    float after;       // hits farther than that count
    uint after_number; // of the primitive that was passed there, or kNothing
    float after_other; // as `after`, for those that refract if that one does not, and the other way round
    float slack;       // boxes are taken to be larger by this: no hit is farther outside of its box than its rounding
};
RayState ray;
uint hit_number = 0u; // no hit: a miss, which is as far as the limit, must not count as one at the same distance
float hit_t = 0.0;    // where something refracts: the distance of the hit, whose key is hit.t

// Boxes are larger by 64 u (R + max |o|), R = 2 the extent of every frame: lib/ray_box.glsl derives why no box is then missed that holds
// what a ray hits.
float slack_of(vec3 size) { return 3.8146973e-6 * (max(max(size.x, size.y), size.z) + 2.0); }

// What is nearer together than this along a ray touches. Both hits lie within 23 u (R + max |o|) of their surfaces (lib/ray_box.glsl): two
// of one plane are 46/64 of the slack apart across it, which four times the slack holds along rays at 80 degrees from the normal, and far
// beyond in practice, the errors being the worst there are.
const float kTouching = 4.0;

bool refracts(uint number) { return wants_ray(RAY_REFRACTED) && number >= kRefracts; }

// What hits are ordered by. Rounded upwards, t of one that does not refract is below the key of one that does if it is below the sum itself:
// so set_after can tell the same from the other side.
float key_of(float t, uint number) { return refracts(number) ? sum_upwards(t, kTouching * ray.slack) : t; }

// The ray goes on behind a hit at t.
void set_after(float t, uint number) {
    ray.after = t, ray.after_number = number, ray.after_other = t;
    if (!wants_ray(RAY_REFRACTED) || number == kNothing) return;
    float touching = kTouching * ray.slack;
    // t' + touching > t where the latter does not refract; t' >= t + touching, where it does.
    ray.after_other = refracts(number) ? -next_up(-sum_upwards(t, touching)) : max(-sum_upwards(-t, touching), 0.0);
}

// Hits at exactly `after` count for numbers above after_number: how a ray goes on behind a surface that it passed without losing another
// one at the same place.
float after_for(uint number) {
    if (!wants_ray(RAY_STRAIGHT | RAY_CLEAR_SHADOWS)) return ray.after;
    float before = uintBitsToFloat(max(floatBitsToUint(ray.after), 1u) - 1u);
    float after = number > ray.after_number ? before : ray.after;
    return refracts(number) != refracts(ray.after_number) ? ray.after_other : after;
}

// Before this nothing counts.
float first_after() { return wants_ray(RAY_REFRACTED) ? min(ray.after, ray.after_other) : ray.after; }

// A pass that asks only whether anything is there takes the first that it meets, whatever its number and its distance.
#ifndef LIGHTBENCH_ANY_HIT
#define LIGHTBENCH_ANY_HIT false
#endif

// hit.t is the key: walks look no farther. A hit without a ref has no hit_t below its limit.
void offer(inout RayHit hit, float t, uint ref, uint number, float b1, float b2) {
    if (LIGHTBENCH_ANY_HIT) {
        hit.ref = t < hit.t ? ref : hit.ref;
        return;
    }
    float key = key_of(t, number);
    bool nearer = key < hit.t || (key == hit.t && number < hit_number);
    if (wants_ray(RAY_REFRACTED)) {
        nearer = key < hit.t || (key == hit.t && (t < hit_t || (t == hit_t && number < hit_number)));
        hit_t = nearer ? t : hit_t;
    }
    hit.t = nearer ? key : hit.t;
    hit.ref = nearer ? ref : hit.ref;
    hit.b1 = nearer ? b1 : hit.b1;
    hit.b2 = nearer ? b2 : hit.b2;
    hit_number = nearer ? number : hit_number;
}

// The hit as it is handed on.
RayHit at_distance(RayHit hit) {
    if (wants_ray(RAY_REFRACTED)) hit.t = hit_t;
    return hit;
}

#endif
