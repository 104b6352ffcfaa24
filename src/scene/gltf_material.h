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

// Metallic-roughness (section B.2 and following of the specification) becomes both models of Scene, with a = roughness^2 and
// f0 = mix(((ior - 1)/(ior + 1))^2, base, metallic):
//   diffuse        base (1 - metallic) (1 - transmission)
//   Cook-Torrance  f0 and the rms slope m = a (GGX is Beckmann's shape with longer tails: Walter et al. 2007)
//   Phong          exponent 2/a^2 - 2 (B. Karis 2013, "Specular BRDF Reference"), and the weight f0 (n + 2)/8 that gives its lobe, per
//                  unit of cosine, the height of the microfacet lobe, D G F / 4 at N = L = V; at most 1
//   reflection f0, transmission base (1 - metallic) transmission, both scattered by the slope a; opacity alpha where alphaMode is BLEND
// A primitive without a material gets Scene's default one, not the white metal that the specification's defaults describe.
// `index`: into the file's materials; none: without.
GltfMaterial material_for(ImportJob& job, const GltfDocument& document, std::optional<std::size_t> index, GltfMaterials& known);

} // namespace lightbench::importer
