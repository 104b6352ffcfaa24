// Curved primitives and the box as faces: points on the true surface with the true outward normals, watertight by index.
// In: a shape, how finely it is cut, how it stands. Out: Faces in world axes about the shape's own centre; the caller sets the anchor.
#pragma once

#include "scene/scene.h"
#include "scene/tessellate_faces.h"
#include "scene/tessellate_placement.h"

namespace lightbench {

// Pieces along and across: a chord error of `error` (object units) for the shape's radii, each piece halved `halvings` times.
struct Cuts {
    std::uint32_t along = 1; // around the axis; of a sphere: pieces of an edge of the solid that is blown up
    std::uint32_t across =
        1; // around a torus's tube; rows of a cylinder's or cone's side, rings of its caps; of a sphere: the solid's faces, 8 or 20
    auto operator<=>(const Cuts&) const = default;
};

Cuts cuts_of(const Sphere& sphere, double error, unsigned halvings);
Cuts cuts_of(const Cylinder& cylinder, double error, unsigned halvings);
Cuts cuts_of(const Cone& cone, double error, unsigned halvings);
Cuts cuts_of(const Torus& torus, double error, unsigned halvings);

// Triangles that the faces below come to.
std::size_t triangle_count(const Sphere& sphere, Cuts cuts);
std::size_t triangle_count(const Cylinder& cylinder, Cuts cuts);
std::size_t triangle_count(const Cone& cone, Cuts cuts);
std::size_t triangle_count(const Torus& torus, Cuts cuts);

// Radius 1 about 0, an octahedron or icosahedron whose triangles are cut into along^2 each; normals are the points.
Faces unit_sphere_faces(Cuts cuts);

Faces box_faces(const Box& box);
Faces cone_faces(const Cone& cone, Cuts cuts); // cylinders are cones of equal radii
Faces torus_faces(const Torus& torus, Cuts cuts);

glm::dvec3 center_of(const Box& box);
glm::dvec3 center_of(const Cone& cone);
Cone cone_of(const Cylinder& cylinder);

// Object axes to world axes; turns windings where the transform mirrors.
void place(Faces& faces, const Placement& placement);

} // namespace lightbench
