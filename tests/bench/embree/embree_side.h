// Embree's side: a scene of the same triangles and spheres. In: RayPrimitives, rays. Out: distances, and the time of two threads.
#pragma once

#include "accel/primitives.h"
#include "rays.h"

#include <memory>
#include <span>

namespace lightbench {

constexpr unsigned kThreads = 2; // of either side

struct EmbreeState;

class EmbreeScene {
  public:
    explicit EmbreeScene(const RayPrimitives& primitives);
    ~EmbreeScene();
    // Milliseconds. `normals`, if not null: the geometric normal at each hit, on the side that the ray comes from.
    double trace(std::span<const BenchRay> rays, Travel travel, Distances& distances, std::vector<glm::vec3>* normals = nullptr) const;
    double build_milliseconds() const;

  private:
    std::unique_ptr<EmbreeState> state_;
};

} // namespace lightbench
