// Where the hemi-cubes of a batch stand, and what their pixels look at. In: a table of HemicubeView. Out: views, directions.
#ifndef LIGHTBENCH_RADIOSITY_HEMICUBE_VIEW_GLSL
#define LIGHTBENCH_RADIOSITY_HEMICUBE_VIEW_GLSL

#include "fetch.glsl"
#include "shared/radiosity.h"

layout(constant_id = CONSTANT_RESOLUTION) const uint kResolution = 64u;
const uint kItems = 3u * kResolution * kResolution;

FETCH_TABLE(views, FETCH_HEMICUBE_VIEWS, 44)

HemicubeView read_view(uint cube) {
    uint at = kHemicubeViewTexels * cube;
    uvec4 a = fetch_views(at), b = fetch_views(at + 1u), c = fetch_views(at + 2u), d = fetch_views(at + 3u), e = fetch_views(at + 4u);
    return HemicubeView(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), c.w, uintBitsToFloat(d.xyz),
                        uintBitsToFloat(d.w), uintBitsToFloat(e.x), 0u, 0u, 0u);
}

// Axes of a face: its columns, what its rows count along, and the way it looks. Faces 1 to 4 see the half of theirs above the horizon.
void face_axes(HemicubeView v, uint face, out vec3 across, out vec3 along, out vec3 forward) {
    bool tangent = face == 1u || face == 2u;
    across = tangent ? v.bitangent : v.tangent, along = face == 0u ? v.bitangent : v.normal;
    vec3 out_of = tangent ? v.tangent : v.bitangent;
    forward = face == 0u ? v.normal : (face & 1u) == 1u ? out_of : -out_of;
}

// From the centre through the middle of a pixel; all faces one under the other, as the items are.
vec3 pixel_direction(HemicubeView v, uvec2 pixel) {
    const uint half_rows = kResolution / 2u;
    uint below = pixel.y - kResolution;
    bool top = pixel.y < kResolution;
    uint face = top ? 0u : 1u + uint(below >= half_rows) + uint(below >= 2u * half_rows) + uint(below >= 3u * half_rows);
    vec3 across, along, forward;
    face_axes(v, face, across, along, forward);
    const float size = 2.0 / float(kResolution);
    float row = float(top ? pixel.y : below - (face - 1u) * half_rows) + 0.5;
    return forward + ((float(pixel.x) + 0.5) * size - 1.0) * across + (row * size - (top ? 1.0 : 0.0)) * along;
}

#endif
