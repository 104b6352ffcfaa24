// Materials of glTF 2.0 as Scene has them. In: the checked document. Out: materials and their pictures in the scene, as faces ask for them.
#pragma once

#include "scene/gltf_document.h"

#include <cstdint>
#include <map>
#include <optional>

namespace lightbench::importer {

struct GltfMaterial {
    std::uint32_t material = 0; // index into Scene::materials
    std::uint64_t uv_set = 0;   // TEXCOORD_n that its texture wants
};

struct GltfMaterials {
    std::map<std::size_t, GltfMaterial> added;                    // by index in the file
    std::optional<GltfMaterial> plain;                            // of primitives without one
    std::map<std::size_t, std::optional<std::uint32_t>> pictures; // by index of the image
};

// Metallic-roughness (glTF 2.0, appendix B.2 and following) becomes Cook-Torrance (S6), with a = roughness^2 and
// f0 = mix(((ior - 1)/(ior + 1))^2, base, metallic):
//   diffuse        base (1 - metallic) (1 - transmission)
//   highlight      specular 1, f0, and the rms slope m = a of Beckmann's distribution
//   shininess      2/a^2 - 2 (B. Karis 2013, "Specular BRDF Reference"), for whoever turns the model to Phong
//   reflection f0, transmission base (1 - metallic) transmission, both scattered by the slope a; opacity alpha where alphaMode is BLEND
// What is lost: GGX has longer tails than Beckmann's distribution of the same slope (Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces"), and masks by Smith's G where S6 has V-grooves; F is that of a dielectric with this f0 instead of Schlick's, 1 %
// of it apart; the diffuse term is not weighted by 1 - F, so grazing views are brighter. Pictures of the base color modulate the diffuse
// term alone (S10): the highlights of a textured metal have the color of its factor.
// A primitive without a material gets Scene's default one, not the white metal that the specification's defaults describe.
// `index`: into the file's materials; none: without.
GltfMaterial material_for(ImportJob& job, const GltfDocument& document, std::optional<std::size_t> index, GltfMaterials& known);

} // namespace lightbench::importer
