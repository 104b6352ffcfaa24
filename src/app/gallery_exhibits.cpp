#include "app/gallery_exhibits.h"

namespace lightbench {
namespace {

constexpr ExhibitSource made(const char* kind) {
    return {kind, nullptr};
}
constexpr ExhibitSource stored(const char* scene) {
    return {nullptr, scene};
}

} // namespace

const std::vector<ExhibitRow>& exhibit_rows() {
    using enum Shading;
    static const std::vector<ExhibitRow> rows = {
        {"Three places to evaluate one model, and rays",
         "The same illumination model, evaluated once a polygon (flat), once a vertex (Gouraud) and once a pixel (Phong). Rays evaluate it "
         "where they hit, and ask two questions more: whether a light sees the point, and what the point mirrors. What the last two differ "
         "in from Phong is not their error but what it leaves out.",
         stored("default.toml"),
         2,
         {{"flat", "default-flat", flat},
          {"Gouraud", "default-gouraud", gouraud},
          {"Phong", "default-phong", phong},
          {"rays from the eye and to the lights: shadows", "default-shadows", phong, {}, {1}},
          {"and mirrored ones: the ray tree, 5 levels", "default-rays", phong, {}, {5, 0, 1, true}},
          {"radiosity: what the surfaces send each other", "default-radiosity", phong, {}, {}, {300}}}},
        {"Radiosity",
         "The Cornell box. Its lamp has an area, its walls light each other: the red one colors the block beside it, shadows are soft, and "
         "what the rasteriser and the ray tracer call ambient light is found out. Each patch shoots what light it has, the brightest "
         "first; "
         "the first pictures are already right on average, since what is not shot yet is spread over the room.",
         made("cornell-box"),
         -1,
         {{"Phong, with a light in place of the lamp", "cornell-phong", phong},
          {"rays, with the same light", "cornell-rays", phong, {}, {2}},
          {"the patches", "cornell-patches", phong, {}, {}, {0, Show::patches}},
          {"radiosity, after 1 shot", "cornell-1", phong, {}, {}, {1}},
          {"after 32 shots", "cornell-32", phong, {}, {}, {32}},
          {"after 500 shots", "cornell-500", phong, {}, {}, {500}}}},
        {"Glass",
         "The ball shows the floor upside down, the box mirrors where it is seen at a grazing angle, the prism's edges have colors, the "
         "pane "
         "at the back is frosted, and the stained glass throws its colors on the floor. The rasteriser has one answer to all of it: "
         "straight "
         "through.",
         stored("lens.toml"),
         -1,
         {{"Phong: straight through", "lens-phong", phong}, {"rays, 8 levels, 4 samples a pixel", "lens-rays", phong, {}, {8, 0.04f, 4}}}},
        {"A kaleidoscope",
         "Three mirrors around a handful of things. The depth of the ray tree says how often a ray may be mirrored; beyond that there is "
         "nothing.",
         stored("mirrors.toml"),
         2,
         {{"2 levels: mirrored once", "mirrors-2", phong, {}, {2}},
          {"5 levels", "mirrors-5", phong, {}, {5}},
          {"20 levels: more than anything here needs", "mirrors-20", phong, {}, {20}}}},
        {"Haines' sphereflake",
         "Each ball carries nine of a third of its radius, and they mirror each other: the scene of his Standard Procedural Databases "
         "(1987), "
         "as the rasteriser draws it and as rays do.",
         made("sphereflake"),
         -1,
         {{"Phong", "flake-phong", phong, {{"depth", "3"}}}, {"rays", "flake-rays", phong, {{"depth", "3"}}, {5}}}},
        {"Frosted glass",
         "Four panes before one checkered wall and four balls, rougher from left to right: refracted rays are scattered about the "
         "direction "
         "that smooth glass would send them to.",
         stored("frosted.toml"),
         -1,
         {{"one sample a pixel: what scatters is noise", "frosted-1", phong, {}, {5}},
          {"9 samples a pixel: what scatters is blur", "frosted-9", phong, {}, {5, 0, 9}}}},
        {"The lost highlight",
         "A highlight in the middle of one large triangle. Gouraud knows the vertices only, where there is none; Phong, or a finer mesh, "
         "finds it.",
         made("highlight"),
         2,
         {{"flat", "highlight-flat", flat},
          {"Gouraud: lost", "highlight-gouraud", gouraud},
          {"Phong: the cure", "highlight-phong", phong},
          {"Gouraud, each triangle in 256: the other cure", "highlight-fine", gouraud, {{"subdivide", "4"}}}}},
        {"The corrugated sheet",
         "On a regular zigzag the averages of neighbouring normals are all parallel: interpolated shading sees a plane. Strips within each "
         "side keep "
         "the side's own normal.",
         made("corrugated"),
         3,
         {{"flat", "corrugated-flat", flat},
          {"Gouraud: looks flat", "corrugated-gouraud", gouraud},
          {"Phong: looks flat too", "corrugated-phong", phong},
          {"Phong, 16 strips a side: the cure", "corrugated-fine", phong, {{"subdivide", "16"}}}}},
        {"The crease",
         "Left: normals averaged over every edge, which smears shading across corners. Right: edges sharper than 30 degrees stay edges.",
         made("crease"),
         3,
         {{"flat", "crease-flat", flat},
          {"Gouraud", "crease-gouraud", gouraud},
          {"Phong", "crease-phong", phong},
          {"Phong, edges kept on both sides: the cure", "crease-kept", phong, {{"left", "30"}}}}},
        {"The quad",
         "Four corner intensities do not say what lies between them. Split along its bright diagonal (left), along its dark one (middle), "
         "interpolated along scan lines (right), as Gouraud did in 1971: that one changes when the quad is turned, the triangles do not.",
         made("quads"),
         -1,
         {{"Gouraud", "quads-gouraud", gouraud}, {"Gouraud, turned by 30 degrees", "quads-turned", gouraud, {{"turn", "30"}}}}},
        {"Mach bands",
         "Intensity that is linear between vertices has kinks at them, and the eye draws a line at each. Phong bends instead of kinking; "
         "more facets "
         "make the kinks smaller.",
         made("mach-band"),
         3,
         {{"flat", "mach-band-flat", flat},
          {"Gouraud: bands", "mach-band-gouraud", gouraud},
          {"Phong", "mach-band-phong", phong},
          {"Phong, 256 facets: the cure", "mach-band-fine", phong, {{"facets", "256"}}}}},
        {"Cook-Torrance beside Phong",
         "Left halves: Phong. Right halves: Cook-Torrance, whose highlight has the same height and width where light and eye are in front: "
         "on "
         "the wall no seam is seen. Along the floor the light grazes, facets mirror far more of it, and Phong does not know. Gouraud asks "
         "at "
         "the corners only and lights the whole floor.",
         stored("grazing.toml"),
         1,
         {{"Gouraud: from the corners", "grazing-gouraud", gouraud}, {"Phong", "grazing-phong", phong}}},
        {"Metals and their paint",
         "Copper, gold, silver, aluminium; in each pair the left ball is of metal (Cook-Torrance with the measured reflectances), the "
         "right one "
         "painted (Phong). A metal's highlight has the metal's color; rougher ones below.",
         made("metals"),
         1,
         {{"Gouraud", "metals-gouraud", gouraud}, {"Phong", "metals-phong", phong}}},
        {"Texture mapping",
         "One picture around two globes and flat on the wall. The right globe has its back to us: the seam of the picture, where u wraps "
         "from 1 "
         "to 0, runs down its middle, and a pole is in view. Pictures are looked up in each pixel, whatever the shading.",
         stored("globe.toml"),
         2,
         {{"flat", "globe-flat", flat}, {"Gouraud", "globe-gouraud", gouraud}, {"Phong", "globe-phong", phong}}},
        {"Bump mapping",
         "The normal is tilted, by noise on the orange, by waves on the melon; the geometry and its outline stay smooth. A bump lives "
         "where "
         "the model is evaluated: once a polygon or once a vertex is not often enough.",
         stored("orange.toml"),
         2,
         {{"flat", "orange-flat", flat}, {"Gouraud", "orange-gouraud", gouraud}, {"Phong", "orange-phong", phong}}},
        {"Environment mapping",
         "Chrome mirrors a picture of its surroundings by the direction of reflection alone: not itself, and nothing near it.",
         stored("teapot.toml"),
         2,
         {{"flat", "teapot-flat", flat}, {"Gouraud", "teapot-gouraud", gouraud}, {"Phong", "teapot-phong", phong}}},
        {"Exact transparency",
         "Three panes cut through one another: no order of the panes is right, so the layers are put into order in each pixel. Each lets "
         "through what its color says.",
         stored("glass.toml"),
         -1,
         {{"Phong", "glass-phong", phong}}},
        {"A thousand layers",
         "Petals of glass, listed out of order, that all overlap in the middle: as many layers as there are petals, all of them blended, "
         "none "
         "lost.",
         made("panes"),
         -1,
         {{"72 panes of opacity 0.4", "panes-few", phong, {{"n", "72"}, {"opacity", "0.4"}}},
          {"1000 panes of opacity 0.04", "panes-many", phong}}},
    };
    return rows;
}

} // namespace lightbench
