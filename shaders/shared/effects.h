// The effect mask and the other specialisation constants: bit and constant numbers, shared by the plan (C++) and the shaders (GLSL).
// The plan sets a bit only if the scene calls for it; a shader asks with wants(EFFECT_...), and what is 0 is gone from the SPIR-V.
#ifndef LIGHTBENCH_SHARED_EFFECTS_H
#define LIGHTBENCH_SHARED_EFFECTS_H

#define EFFECT_AMBIENT 0x1u                     // S1
#define EFFECT_DIFFUSE 0x2u                     // S2
#define EFFECT_SPECULAR 0x4u                    // S3: Phong's
#define EFFECT_EMISSION 0x8u                    // surfaces that glow of themselves
#define EFFECT_POINT_LIGHT 0x10u                // S5: which kinds of light there are
#define EFFECT_DIRECTIONAL_LIGHT 0x20u
#define EFFECT_SPOT_LIGHT 0x40u
#define EFFECT_ATTENUATION_NONE 0x80u           // S4: which laws positional lights have
#define EFFECT_ATTENUATION_LINEAR 0x100u
#define EFFECT_ATTENUATION_INVERSE_SQUARE 0x200u
#define EFFECT_TWO_SIDED 0x400u                 // some surface is seen from behind: its normal is turned
#define EFFECT_COMPENSATED_SUM 0x800u           // more lights than a plain float sum adds up within 8 u (LI-6)
#define EFFECT_MANY_MATERIALS 0x1000u           // otherwise every surface has material 0
#define EFFECT_VANISHING_NORMALS 0x2000u        // a file's normals may interpolate to zero: the face's normal stands in (NI-1)
#define EFFECT_GAUSSIAN 0x4000u                 // S6: Cook-Torrance, by distribution
#define EFFECT_BECKMANN 0x8000u
#define EFFECT_TEXTURE 0x10000u                 // S10: pictures
#define EFFECT_CHECKER 0x20000u                 // the texture without a file
#define EFFECT_MAP_UV 0x40000u                  // which mappings textures and bump pictures have
#define EFFECT_MAP_SPHERICAL 0x80000u
#define EFFECT_MAP_CYLINDRICAL 0x100000u
#define EFFECT_MAP_PLANAR 0x200000u
#define EFFECT_BUMP_WAVES 0x400000u             // S11
#define EFFECT_BUMP_NOISE 0x800000u
#define EFFECT_BUMP_HEIGHT 0x1000000u           // a height image
#define EFFECT_NORMAL_MAP 0x2000000u
#define EFFECT_MIRROR_ENVIRONMENT 0x4000000u    // S12: some material mirrors the environment
#define EFFECT_SIX_FACES 0x8000000u             // the environment is six faces, not one equirectangular picture
#define EFFECT_RENDERED_CUBE 0x80000000u         // it is what objects see around them: six faces a surface, in place of a map
#define EFFECT_BACKGROUND_MAP 0x20000000u       // it stands behind the scene
#define EFFECT_TRANSPARENCY 0x10000000u         // S13: some opacity is below 1
#define EFFECT_TEXTURE_ALPHA 0x40000000u        // the alpha of some picture multiplies the opacity

#define EFFECT_ANY_MAPPING (EFFECT_MAP_UV | EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR)
#define EFFECT_ANY_TEXTURE (EFFECT_TEXTURE | EFFECT_CHECKER)
#define EFFECT_ANY_BUMP (EFFECT_BUMP_WAVES | EFFECT_BUMP_NOISE | EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)
#define EFFECT_COOK_TORRANCE (EFFECT_GAUSSIAN | EFFECT_BECKMANN)

// Specialisation constants: constant_id of each.
#define CONSTANT_EFFECTS 0                      // the mask above
#define CONSTANT_SHADING 1                      // SHADING_...
#define CONSTANT_OUTPUT 2                       // OUTPUT_...
#define CONSTANT_LIGHT_COUNT 3                  // lights, if few (then loops have a constant end); 0: from the push constants
#define CONSTANT_FETCH_STORAGE 4                // FETCH_... bits of the tables that are storage buffers; the others are texel buffers
#define CONSTANT_LAYERS 5                       // of the passes over layers: see there

#define FETCH_MATERIALS 0x1u
#define FETCH_LIGHTS 0x2u
#define FETCH_POINTS 0x4u
#define FETCH_COLORS 0x8u
#define FETCH_OBJECTS 0x10u
#define FETCH_TEXELS 0x20u
#define FETCH_DETAIL 0x40u
#define FETCH_LAYERS 0x80u
#define FETCH_NODES 0x100u                      // from here on: of the ray tracer
#define FETCH_NARROW 0x200u
#define FETCH_TRIANGLES 0x400u
#define FETCH_SPHERES 0x800u
#define FETCH_SHAPES 0x1000u
#define FETCH_CORNERS 0x2000u
#define FETCH_RAYS 0x4000u                      // rays, hits, points, nodes of the ray tree
#define FETCH_EYE_POINTS 0x8000u
#define FETCH_BUILD 0x10000u                   // of the passes that build a structure

#define SHADING_FLAT 0u
#define SHADING_GOURAUD 1u
#define SHADING_PHONG 2u

#define OUTPUT_RADIANCE 0u                      // linear radiance of the terms in the mask
#define OUTPUT_NORMAL 1u                        // the shading normal, world axes
#define OUTPUT_DEPTH 2u                         // metres along the viewing direction times the frame's scale
#define OUTPUT_OBJECT 3u                        // object number + 1; 0 is the background
#define OUTPUT_ATTENUATION 4u                   // sum over lights of the attenuated, spot-shaped Ip that arrives, without cosines
#define OUTPUT_SHADOW 5u                        // of rays: radiance that is missing because something stands before the lights

#endif
