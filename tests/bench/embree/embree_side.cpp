#include "embree_side.h"

#include "accel/parallel.h"
#include "gpu/check.h"

#include <chrono>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <pmmintrin.h>

namespace lightbench {

struct EmbreeState {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double milliseconds = 0;
};

namespace {

constexpr std::size_t kPiece = 2048; // rays that a thread takes at a time
constexpr unsigned kNone = ~0u;      // RTC_INVALID_GEOMETRY_ID, which is an old-style cast

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void attach(const EmbreeState& s, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s.scene, geometry);
    rtcReleaseGeometry(geometry);
}

void add_triangles(const EmbreeState& s, const RayPrimitives& primitives) {
    const std::size_t n = primitives.triangles.size();
    RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners =
        static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * n));
    auto* indices =
        static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), n));
    for (const auto& t : primitives.triangles)
        for (const glm::vec3& v : {t.v0, t.v1, t.v2}) *corners++ = v;
    for (unsigned i = 0; i < 3 * n; ++i) indices[i] = i;
    attach(s, geometry);
}

void add_spheres(const EmbreeState& s, const RayPrimitives& primitives) {
    RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* spheres = static_cast<glm::vec4*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), primitives.spheres.size()));
    for (const auto& sphere : primitives.spheres) *spheres++ = {sphere.center, sphere.radius};
    attach(s, geometry);
}

struct Traced {
    std::span<const BenchRay> rays;
    Distances& distances;
    std::vector<glm::vec3>* normals;
};

void set_ray(RTCRay8& r, int lane, const BenchRay& from) {
    r.org_x[lane] = from.origin.x, r.org_y[lane] = from.origin.y, r.org_z[lane] = from.origin.z;
    r.dir_x[lane] = from.direction.x, r.dir_y[lane] = from.direction.y, r.dir_z[lane] = from.direction.z;
    r.tnear[lane] = 0, r.tfar[lane] = from.limit, r.time[lane] = 0, r.mask[lane] = ~0u, r.flags[lane] = 0;
}

void nearest_of_eight(RTCScene scene, RTCIntersectContext& context, const Traced& t, std::size_t first) {
    RTCRayHit8 eight;
    alignas(32) int valid[8];
    const std::size_t count = std::min<std::size_t>(8, t.rays.size() - first);
    for (int lane = 0; lane < 8; ++lane) {
        const auto i = static_cast<std::size_t>(lane);
        valid[lane] = i < count ? -1 : 0;
        set_ray(eight.ray, lane, t.rays[first + std::min(i, count - 1)]);
        eight.hit.geomID[lane] = kNone, eight.hit.instID[0][lane] = kNone;
    }
    rtcIntersect8(valid, scene, &context, &eight);
    for (std::size_t i = 0; i < count; ++i) {
        t.distances[first + i] = eight.hit.geomID[i] == kNone ? kMiss : eight.ray.tfar[i];
        if (t.normals) (*t.normals)[first + i] = {eight.hit.Ng_x[i], eight.hit.Ng_y[i], eight.hit.Ng_z[i]};
    }
}

void shadow_of_eight(RTCScene scene, RTCIntersectContext& context, const Traced& t, std::size_t first) {
    RTCRay8 eight;
    alignas(32) int valid[8];
    const std::size_t count = std::min<std::size_t>(8, t.rays.size() - first);
    for (int lane = 0; lane < 8; ++lane) {
        const auto i = static_cast<std::size_t>(lane);
        valid[lane] = i < count ? -1 : 0;
        set_ray(eight, lane, t.rays[first + std::min(i, count - 1)]);
    }
    rtcOccluded8(valid, scene, &context, &eight);
    for (std::size_t i = 0; i < count; ++i) t.distances[first + i] = eight.tfar[i] < 0 ? 0 : kMiss;
}

void nearest_of_one(RTCScene scene, RTCIntersectContext& context, const Traced& t, std::size_t i) {
    const BenchRay& from = t.rays[i];
    RTCRayHit one;
    one.ray = {
        from.origin.x, from.origin.y, from.origin.z, 0, from.direction.x, from.direction.y, from.direction.z, 0, from.limit, ~0u, 0, 0};
    one.hit.geomID = kNone, one.hit.instID[0] = kNone;
    rtcIntersect1(scene, &context, &one);
    t.distances[i] = one.hit.geomID == kNone ? kMiss : one.ray.tfar;
}

} // namespace

EmbreeScene::EmbreeScene(const RayPrimitives& primitives) : state_(std::make_unique<EmbreeState>()) {
    EmbreeState& s = *state_;
    s.device = rtcNewDevice(fmt::format("threads={},set_affinity=0", kThreads).c_str());
    s.scene = rtcNewScene(s.device);
    rtcSetSceneBuildQuality(s.scene, RTC_BUILD_QUALITY_HIGH);
    if (!primitives.triangles.empty()) add_triangles(s, primitives);
    if (!primitives.spheres.empty()) add_spheres(s, primitives);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(s.scene);
    s.milliseconds = since(start);
    CHECK(rtcGetDeviceError(s.device) == RTC_ERROR_NONE);
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(state_->scene);
    rtcReleaseDevice(state_->device);
}

double EmbreeScene::build_milliseconds() const {
    return state_->milliseconds;
}

double EmbreeScene::trace(std::span<const BenchRay> rays, Travel travel, Distances& distances, std::vector<glm::vec3>* normals) const {
    distances.resize(rays.size());
    if (normals) normals->resize(rays.size());
    const Traced traced{rays, distances, normals};
    const auto start = std::chrono::steady_clock::now();
    run_parallel((rays.size() + kPiece - 1) / kPiece, kThreads, [&](std::size_t piece) {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON); // as Embree's manual asks of every thread
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = travel == Travel::alone ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        const std::size_t end = std::min(rays.size(), (piece + 1) * kPiece);
        for (std::size_t i = piece * kPiece; i < end; i += travel == Travel::alone ? 1 : 8) {
            if (travel == Travel::together) nearest_of_eight(state_->scene, context, traced, i);
            if (travel == Travel::shadow) shadow_of_eight(state_->scene, context, traced, i);
            if (travel == Travel::alone) nearest_of_one(state_->scene, context, traced, i);
        }
    });
    return since(start);
}

} // namespace lightbench
