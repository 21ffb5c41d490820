#include "shprt/scene/ray_caster.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <string>

#include "shprt/base/error.h"
#include "shprt/scene/point_triangle_distance.h"

namespace shprt {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

#if RTC_VERSION_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
void initContext(QueryContext* context) {
  rtcInitRayQueryContext(context);
}
#else
using QueryContext = RTCIntersectContext;
void initContext(QueryContext* context) {
  rtcInitIntersectContext(context);
}
#endif

// What the filter needs to know about the rays under way. Embree hands the context back by pointer, so ours
// begins with its.
struct FilterContext {
  QueryContext base;
  const IgnoredTriangles* ignored;
};

// Lists of a few numbers, which most are, are searched without branches.
bool contains(std::span<const std::uint32_t> sorted, std::uint32_t number) {
  constexpr std::size_t kFew = 32;
  if (sorted.size() > kFew) return std::binary_search(sorted.begin(), sorted.end(), number);
  bool found = false;
  for (const std::uint32_t entry : sorted) found |= entry == number;
  return found;
}

// Rejects hits on triangles that the origin lies on.
void filterIgnored(const RTCFilterFunctionNArguments* arguments) {
  const IgnoredTriangles& ignored = *reinterpret_cast<const FilterContext*>(arguments->context)->ignored;
  for (unsigned lane = 0; lane < arguments->N; ++lane) {
    if (arguments->valid[lane] != -1) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, lane);
    if (contains(ignored.meeting, triangle) || contains(ignored.touching, triangle))
      arguments->valid[lane] = 0;
  }
}

template <int N, typename Packet>
void fillPacket(const FilterContext& context, Vec3f origin, const RayPacket& rays, int first,
                std::uint32_t active, int* valid, Packet& packet) {
  for (int lane = 0; lane < N; ++lane) {
    valid[lane] = (active >> (first + lane)) & 1u ? -1 : 0;
    packet.org_x[lane] = origin.x;
    packet.org_y[lane] = origin.y;
    packet.org_z[lane] = origin.z;
    packet.dir_x[lane] = rays.x[first + lane];
    packet.dir_y[lane] = rays.y[first + lane];
    packet.dir_z[lane] = rays.z[first + lane];
    packet.tnear[lane] = context.ignored->distance;
    packet.tfar[lane] = kInfinity;
    packet.time[lane] = 0;
    packet.mask[lane] = ~0u;
    packet.id[lane] = 0;
    packet.flags[lane] = 0;
  }
}

template <int N, typename Packet>
std::uint32_t occludedPacket(RTCScene scene, FilterContext& context, Vec3f origin, const RayPacket& rays,
                             int first, std::uint32_t active,
                             void (*trace)(const int*, RTCScene, FilterContext&, Packet*)) {
  alignas(64) int valid[N];
  alignas(64) Packet packet;
  fillPacket<N>(context, origin, rays, first, active, valid, packet);
  trace(valid, scene, context, &packet);
  std::uint32_t hit = 0;
  for (int lane = 0; lane < N; ++lane) {
    if (valid[lane] && packet.tfar[lane] < 0) hit |= 1u << (first + lane);
  }
  return hit;
}

template <int N, typename Packet>
std::uint32_t nearestPacket(RTCScene scene, FilterContext& context, Vec3f origin, const RayPacket& rays,
                            int first, std::uint32_t active, RayPacketHits& hits,
                            void (*trace)(const int*, RTCScene, FilterContext&, Packet*)) {
  alignas(64) int valid[N];
  alignas(64) Packet packet;
  fillPacket<N>(context, origin, rays, first, active, valid, packet.ray);
  for (int lane = 0; lane < N; ++lane) {
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
  trace(valid, scene, context, &packet);
  std::uint32_t hit = 0;
  for (int lane = 0; lane < N; ++lane) {
    if (!valid[lane] || packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
    hit |= 1u << (first + lane);
    hits.triangle[first + lane] = packet.hit.primID[lane];
    hits.u[first + lane] = packet.hit.u[lane];
    hits.v[first + lane] = packet.hit.v[lane];
  }
  return hit;
}

// The calls that Embree 3 and 4 spell differently.
#if RTC_VERSION_MAJOR >= 4
RTCOccludedArguments occludedArguments(FilterContext& context) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context.base;
  return arguments;
}
RTCIntersectArguments intersectArguments(FilterContext& context) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.base;
  return arguments;
}
void occludedSixteen(const int* valid, RTCScene scene, FilterContext& context, RTCRay16* packet) {
  RTCOccludedArguments arguments = occludedArguments(context);
  rtcOccluded16(valid, scene, packet, &arguments);
}
void occludedEight(const int* valid, RTCScene scene, FilterContext& context, RTCRay8* packet) {
  RTCOccludedArguments arguments = occludedArguments(context);
  rtcOccluded8(valid, scene, packet, &arguments);
}
void occludedFour(const int* valid, RTCScene scene, FilterContext& context, RTCRay4* packet) {
  RTCOccludedArguments arguments = occludedArguments(context);
  rtcOccluded4(valid, scene, packet, &arguments);
}
void nearestSixteen(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit16* packet) {
  RTCIntersectArguments arguments = intersectArguments(context);
  rtcIntersect16(valid, scene, packet, &arguments);
}
void nearestEight(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit8* packet) {
  RTCIntersectArguments arguments = intersectArguments(context);
  rtcIntersect8(valid, scene, packet, &arguments);
}
void nearestFour(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit4* packet) {
  RTCIntersectArguments arguments = intersectArguments(context);
  rtcIntersect4(valid, scene, packet, &arguments);
}
void nearestOne(RTCScene scene, FilterContext& context, RTCRayHit* rayHit) {
  RTCIntersectArguments arguments = intersectArguments(context);
  rtcIntersect1(scene, rayHit, &arguments);
}
#else
void occludedSixteen(const int* valid, RTCScene scene, FilterContext& context, RTCRay16* packet) {
  rtcOccluded16(valid, scene, &context.base, packet);
}
void occludedEight(const int* valid, RTCScene scene, FilterContext& context, RTCRay8* packet) {
  rtcOccluded8(valid, scene, &context.base, packet);
}
void occludedFour(const int* valid, RTCScene scene, FilterContext& context, RTCRay4* packet) {
  rtcOccluded4(valid, scene, &context.base, packet);
}
void nearestSixteen(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit16* packet) {
  rtcIntersect16(valid, scene, &context.base, packet);
}
void nearestEight(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit8* packet) {
  rtcIntersect8(valid, scene, &context.base, packet);
}
void nearestFour(const int* valid, RTCScene scene, FilterContext& context, RTCRayHit4* packet) {
  rtcIntersect4(valid, scene, &context.base, packet);
}
void nearestOne(RTCScene scene, FilterContext& context, RTCRayHit* rayHit) {
  rtcIntersect1(scene, &context.base, rayHit);
}
#endif

FilterContext makeContext(const IgnoredTriangles& ignored) {
  FilterContext context;
  initContext(&context.base);
  context.ignored = &ignored;
  return context;
}

struct NearQuery {
  Vec3d point;
  double radius;
  std::span<const std::uint32_t> except;
  const Vec3f* positions;
  const std::array<std::uint32_t, 3>* triangles;
  std::vector<std::uint32_t> found;
};

bool collectNear(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<NearQuery*>(arguments->userPtr);
  if (contains(query.except, arguments->primID)) return false;
  const auto& corners = query.triangles[arguments->primID];
  const Vec3d a = toDouble(query.positions[corners[0]]) - query.point,
              b = toDouble(query.positions[corners[1]]) - query.point,
              c = toDouble(query.positions[corners[2]]) - query.point;
  // Embree offers whole leaves; most of their triangles lie to one side of the ball.
  const auto isApart = [&](double u, double v, double w) {
    return std::min({u, v, w}) > query.radius || std::max({u, v, w}) < -query.radius;
  };
  if (isApart(a.x, b.x, c.x) || isApart(a.y, b.y, c.y) || isApart(a.z, b.z, c.z)) return false;
  if (pointTriangleDistance({}, a, b, c) <= query.radius) query.found.push_back(arguments->primID);
  return false;
}

}  // namespace

// Embree tells of every change of its memory, from any of its threads.
struct MemoryMonitor {
  std::atomic<std::int64_t> now = 0, peak = 0;

  static bool changed(void* self, ssize_t bytes, bool) {
    auto& monitor = *static_cast<MemoryMonitor*>(self);
    const std::int64_t held = monitor.now += bytes;
    for (std::int64_t seen = monitor.peak; held > seen && !monitor.peak.compare_exchange_weak(seen, held);) {
    }
    return true;
  }
};

struct RayCaster::Impl {
  MemoryMonitor memory;  // outlives the device
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const Vec3f* positions = nullptr;
  const std::array<std::uint32_t, 3>* triangles = nullptr;
  int nativeWidth = 4;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void check(const char* step) const {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw Error("Embree", std::string(step) + " failed with error " + std::to_string(static_cast<int>(error)),
                error == RTC_ERROR_OUT_OF_MEMORY ? "there is not enough memory for this mesh" : "");
  }
};

RayCaster::RayCaster(std::span<const Vec3f> positions,
                     std::span<const std::array<std::uint32_t, 3>> triangles)
    : impl_(std::make_unique<Impl>()) {
  impl_->device = rtcNewDevice(nullptr);
  if (!impl_->device) throw Error("Embree", "no device could be made");
  rtcSetDeviceMemoryMonitorFunction(impl_->device, MemoryMonitor::changed, &impl_->memory);
  if (rtcGetDeviceProperty(impl_->device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) {
    impl_->nativeWidth = 16;
  } else if (rtcGetDeviceProperty(impl_->device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) {
    impl_->nativeWidth = 8;
  }
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_MEDIUM);
  // Robust: rays do not slip between neighbouring triangles.
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);

  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vec3f), positions.size());
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          sizeof(triangles[0]), triangles.size());
  if (vertices && indices) {
    std::memcpy(vertices, positions.data(), positions.size_bytes());
    std::memcpy(indices, triangles.data(), triangles.size_bytes());
    impl_->positions = static_cast<const Vec3f*>(vertices);
    impl_->triangles = static_cast<const std::array<std::uint32_t, 3>*>(indices);
    rtcSetGeometryOccludedFilterFunction(geometry, filterIgnored);
    rtcSetGeometryIntersectFilterFunction(geometry, filterIgnored);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(impl_->scene, geometry);
  }
  rtcReleaseGeometry(geometry);
  impl_->check("the copy of the mesh");
  rtcCommitScene(impl_->scene);
  impl_->check("the build of the acceleration structure");
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::uint32_t RayCaster::occluded(Vec3f origin, const RayPacket& rays, std::uint32_t active,
                                  const IgnoredTriangles& ignored) const {
  FilterContext context = makeContext(ignored);
  std::uint32_t hit = 0;
  switch (impl_->nativeWidth) {
    case 16:
      hit = occludedPacket<16, RTCRay16>(impl_->scene, context, origin, rays, 0, active, occludedSixteen);
      break;
    case 8:
      for (int first = 0; first < kRayPacketSize; first += 8) {
        hit |= occludedPacket<8, RTCRay8>(impl_->scene, context, origin, rays, first, active, occludedEight);
      }
      break;
    default:
      for (int first = 0; first < kRayPacketSize; first += 4) {
        hit |= occludedPacket<4, RTCRay4>(impl_->scene, context, origin, rays, first, active, occludedFour);
      }
  }
  return hit;
}

std::uint32_t RayCaster::nearest(Vec3f origin, const RayPacket& rays, std::uint32_t active,
                                 const IgnoredTriangles& ignored, RayPacketHits& hits) const {
  FilterContext context = makeContext(ignored);
  RTCScene scene = impl_->scene;
  std::uint32_t hit = 0;
  switch (impl_->nativeWidth) {
    case 16:
      hit = nearestPacket<16, RTCRayHit16>(scene, context, origin, rays, 0, active, hits, nearestSixteen);
      break;
    case 8:
      for (int first = 0; first < kRayPacketSize; first += 8) {
        hit |= nearestPacket<8, RTCRayHit8>(scene, context, origin, rays, first, active, hits, nearestEight);
      }
      break;
    default:
      for (int first = 0; first < kRayPacketSize; first += 4) {
        hit |= nearestPacket<4, RTCRayHit4>(scene, context, origin, rays, first, active, hits, nearestFour);
      }
  }
  return hit;
}

RayHit RayCaster::intersect(Vec3f origin, Vec3f direction) const {
  RTCRayHit rayHit;
  rayHit.ray = {.org_x = origin.x,
                .org_y = origin.y,
                .org_z = origin.z,
                .tnear = 0,
                .dir_x = direction.x,
                .dir_y = direction.y,
                .dir_z = direction.z,
                .time = 0,
                .tfar = kInfinity,
                .mask = ~0u,
                .id = 0,
                .flags = 0};
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  const IgnoredTriangles none{};
  FilterContext context = makeContext(none);
  nearestOne(impl_->scene, context, &rayHit);
  if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {rayHit.ray.tfar, rayHit.hit.primID, rayHit.hit.u, rayHit.hit.v};
}

std::uint64_t RayCaster::peakMemory() const {
  return static_cast<std::uint64_t>(impl_->memory.peak.load());
}

std::vector<std::uint32_t> RayCaster::trianglesNear(Vec3f point, double radius,
                                                    std::span<const std::uint32_t> except) const {
  NearQuery near{toDouble(point), radius, except, impl_->positions, impl_->triangles, {}};
  // Slightly wider than asked, so that rounding inside Embree loses none; collectNear decides.
  RTCPointQuery query{
      .x = point.x, .y = point.y, .z = point.z, .time = 0, .radius = static_cast<float>(radius * 1.5)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(impl_->scene, &query, &context, collectNear, &near);
  std::sort(near.found.begin(), near.found.end());
  return std::move(near.found);
}

}  // namespace shprt
