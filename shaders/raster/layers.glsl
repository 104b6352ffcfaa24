// Lists of translucent fragments (S13; after Carpenter 1984, "The A-buffer, an Antialiased Hidden Surface Method", with exact lists in place
// of masks). Each pixel of a tile has a run of records: offsets[i] is where the run of pixel i begins, offsets[i + 1] where it ends.
#ifndef LIGHTBENCH_LAYERS_GLSL
#define LIGHTBENCH_LAYERS_GLSL

// Two uvec4 a record: (bits of the depth, tie, t.x, t.y), (t.z, radiance).
const uint kRecordWords = 2u;

uint tile_pixel(uvec2 pixel, uint origin, uint width) {
    uvec2 at = pixel - uvec2(origin & 0xffffu, origin >> 16u);
    return at.y * width + at.x;
}

// Coincident fragments are ordered by what they look like, never by who drew first (TR-4): a hash of the bits of t and radiance
// (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", PCG). Different looks share a value once in 2^32 pairs.
uint tie_of(vec3 t, vec3 radiance) {
    uvec3 a = floatBitsToUint(t), b = floatBitsToUint(radiance);
    uint words[6] = uint[6](a.x, a.y, a.z, b.x, b.y, b.z);
    uint h = 0u;
    for (uint i = 0u; i < 6u; ++i) {
        uint x = (h ^ words[i]) * 747796405u + 2891336453u;
        x = ((x >> ((x >> 28u) + 4u)) ^ x) * 277803737u;
        h = (x >> 22u) ^ x;
    }
    return h;
}

// Whether key a (depth, tie, ...) lies before b. Reversed depth is positive: the nearer has the larger bits.
bool before(uvec2 a, uvec2 b) { return a.x > b.x || (a.x == b.x && a.y < b.y); }

#endif
