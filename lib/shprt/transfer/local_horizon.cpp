#include "shprt/transfer/local_horizon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace shprt {
namespace {

// How far above the own triangle its infinitesimal step rises, as an angle in radians: dihedral angles
// smaller than this count as closed.
constexpr double kStepElevation = 1e-3;
// Steps this near to a wedge of another surface, as an angle, stand on neither side of it.
constexpr double kBeside = 2 * kStepElevation;
// Edges up to this elevation (sine) above a plane count as lying in it. The lowest of n cosine-distributed
// rays stands about 1/sqrt(2n) high, 100 times more than this for n = 65536.
constexpr double kFlat = 1e-6;
// Wedges whose sine of the opening angle is less are degenerate: their plane is rounding.
constexpr double kDegenerate = 1e-9;
// Steps at least this near to each other, as a cosine, count as one. It bounds how many there are.
constexpr double kSameStep = 0.98;

Vec3d edgeDirection(const SurfaceTopology& topology, std::uint32_t from, std::uint32_t to) {
  return normalize(toDouble(topology.positions()[to]) - toDouble(topology.positions()[from]));
}

// Whether the arc between two directions stays below a plane up to kFlat. Nearly opposite ones may rise in
// between.
bool staysBelow(Vec3d plane, Vec3d edge1, Vec3d edge2) {
  return dot(plane, edge1) <= kFlat && dot(plane, edge2) <= kFlat && length(edge1 + edge2) > 0.1;
}

SurfacePoint cornerPlace(std::uint32_t triangle, std::size_t corner) {
  return {triangle, corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f};
}

// The origin's place on a triangle that holds it, by the areas that it makes with the sides.
SurfacePoint innerPlace(std::uint32_t triangle, const Vec3d (&corners)[3]) {
  const double a = length(cross(corners[1], corners[2])), b = length(cross(corners[2], corners[0])),
               c = length(cross(corners[0], corners[1]));
  return {triangle, static_cast<float>(b / (a + b + c)), static_cast<float>(c / (a + b + c))};
}

}  // namespace

double LocalHorizon::Sector::cosine() const {
  return dot(edge1, edge2);
}

bool LocalHorizon::Sector::isStep() const {
  return own && length(cross(edge1, edge2)) >= kDegenerate;
}

void LocalHorizon::addWedge(const Sector& sector) {
  const auto& [edge1, edge2, own, place] = sector;
  const bool belowNormal = staysBelow(normal_, edge1, edge2);
  if (own ? belowNormal : belowNormal && staysBelow(step_.plane, edge1, edge2)) return;
  const Vec3d crossed = cross(edge1, edge2);
  if (length(crossed) < kDegenerate) return;
  const Vec3d plane = normalize(crossed);
  // A direction s edge1 + t edge2 has s >= 0 where inside1 is positive and t >= 0 where inside2 is.
  const Vec3d inside1 = cross(edge2, plane), inside2 = cross(plane, edge1);
  Wedge wedge{toFloat(plane), toFloat(inside1), toFloat(inside2), {}, {}, {}};
  for (const int below : {0, 1}) {
    const Vec3d origin = own || below ? normal_ : step_.direction;
    wedge.originPlane[below] = static_cast<float>(dot(origin, plane));
    wedge.originInside1[below] = static_cast<float>(dot(origin, inside1));
    wedge.originInside2[below] = static_cast<float>(dot(origin, inside2));
  }
  wedges_.push_back(wedge);
  places_.push_back(place);
  if (!own) {
    othersRise_ = true;
    const auto height = [&](Vec3d form) { return dot(step_.direction, form); };
    alongWedge_ |=
        std::abs(height(plane)) < kBeside && height(inside1) > -kBeside && height(inside2) > -kBeside;
  }
  // The arc between the edges is highest in between where the normal's foot on the plane lies there.
  const bool peaks = dot(normal_, inside1) > 0 && dot(normal_, inside2) > 0;
  const double top =
      peaks ? length(cross(normal_, plane)) : std::max(dot(normal_, edge1), dot(normal_, edge2));
  highest_ = std::max(highest_, own ? static_cast<float>(top + kFlat) : 1.0f);
}

LocalHorizon::Step LocalHorizon::stepInto(const Sector& sector) const {
  const Vec3d plane = normalize(cross(sector.edge1, sector.edge2));
  // The bisector; rotating an edge into the wedge serves opposite edges too.
  const Vec3d along = dot(sector.edge1, sector.edge2) > -0.99 ? normalize(sector.edge1 + sector.edge2)
                                                              : cross(plane, sector.edge1);
  const Vec3d front = dot(plane, normal_) < 0 ? -plane : plane;
  return {front, normalize(along + front * kStepElevation)};
}

void LocalHorizon::makeWedges(const Step& step) {
  wedges_.clear();
  places_.clear();
  highest_ = 0;
  othersRise_ = alongWedge_ = false;
  step_ = step;
  facePlaneFloat_ = toFloat(step.plane);
  for (const Sector& sector : sectors_) addWedge(sector);
}

void LocalHorizon::addSectorsOfTouching(const SurfaceTopology& topology, Vec3d here, std::uint32_t triangle) {
  Vec3d offsets[3], edges[3];
  std::size_t atCorner = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    offsets[k] = toDouble(topology.positions()[topology.triangles()[triangle][k]]) - here;
    if (length(offsets[k]) <= 2 * topology.contactDistance()) atCorner = k;
    edges[k] = normalize(offsets[k]);
  }
  if (atCorner < 3) {
    sectors_.push_back(
        {edges[(atCorner + 1) % 3], edges[(atCorner + 2) % 3], false, cornerPlace(triangle, atCorner)});
    return;
  }
  // From inside the triangle its three edges span the whole plane. On an edge, that edge's own wedge is
  // flat to rounding and the other two span the half plane.
  const SurfacePoint place = innerPlace(triangle, offsets);
  for (std::size_t k = 0; k < 3; ++k) {
    constexpr double kOnEdge = 1e-3;
    if (length(cross(edges[k], edges[(k + 1) % 3])) > kOnEdge)
      sectors_.push_back({edges[k], edges[(k + 1) % 3], false, place});
  }
}

void LocalHorizon::prepare(const SurfaceTopology& topology, std::uint32_t vertex,
                           std::span<const std::uint32_t> touching) {
  sectors_.clear();
  steps_.clear();
  normal_ = topology.normal(vertex);
  normalFloat_ = toFloat(normal_);
  const std::uint32_t position = topology.positionIds()[vertex];
  const std::uint32_t point = topology.pointIds()[vertex];
  for (const std::uint32_t triangle : topology.trianglesAt(position)) {
    const Triangle& t = topology.triangles()[triangle];
    for (std::size_t k = 0; k < 3; ++k)
      if (topology.positionIds()[t[k]] == position)
        sectors_.push_back({edgeDirection(topology, t[k], t[(k + 1) % 3]),
                            edgeDirection(topology, t[k], t[(k + 2) % 3]), topology.pointIds()[t[k]] == point,
                            cornerPlace(triangle, k)});
  }
  const Vec3d here = toDouble(topology.positions()[vertex]);
  for (const std::uint32_t triangle : touching) addSectorsOfTouching(topology, here, triangle);

  const Sector* widest = nullptr;
  for (const Sector& sector : sectors_)
    if (sector.isStep() && (!widest || sector.cosine() < widest->cosine())) widest = &sector;
  makeWedges(widest ? stepInto(*widest) : Step{normal_, normal_});
  if (alongWedge_) listSteps();
}

void LocalHorizon::listSteps() {
  const Step widest = step_;
  steps_.clear();
  std::vector<const Sector*> own;
  for (const Sector& sector : sectors_)
    if (sector.isStep()) own.push_back(&sector);
  std::stable_sort(own.begin(), own.end(),
                   [](const Sector* a, const Sector* b) { return a->cosine() < b->cosine(); });
  for (const Sector* sector : own) {
    const Step step = stepInto(*sector);
    const bool isNew = std::none_of(steps_.begin(), steps_.end(), [&](const Step& other) {
      return dot(other.direction, step.direction) > kSameStep;
    });
    if (!isNew) continue;
    makeWedges(step);
    if (!alongWedge_) steps_.push_back(step);
  }
  if (steps_.empty()) steps_.push_back(widest);
  makeWedges(steps_.front());
}

std::size_t LocalHorizon::stepCount() {
  if (!othersRise_) return 1;
  if (steps_.empty()) listSteps();
  return steps_.size();
}

void LocalHorizon::stepAlong(std::size_t step) {
  assert(step < stepCount());
  if (stepCount() > 1) makeWedges(steps_[step]);
}

template <bool kWithHits>
std::uint32_t LocalHorizon::crossWedges(const RayPacket& rays, RayPacketHits* hits) const {
  // Four lanes at a time, in the compiler's vectors: the width that every processor has registers for.
  constexpr int kWidth = 4;
  using Lanes = float __attribute__((vector_size(sizeof(float) * kWidth)));
  using Masks = std::int32_t __attribute__((vector_size(sizeof(std::int32_t) * kWidth)));
  std::uint32_t mask = 0;
  for (int first = 0; first < kRayPacketSize; first += kWidth) {
    Lanes x, y, z;
    std::memcpy(&x, rays.x + first, sizeof x);
    std::memcpy(&y, rays.y + first, sizeof y);
    std::memcpy(&z, rays.z + first, sizeof z);
    const auto form = [&](const Vec3f& f) { return f.x * x + f.y * y + f.z * z; };
    const Masks low = form(normalFloat_) <= highest_;
    if (!(low[0] | low[1] | low[2] | low[3])) continue;
    const Masks below = form(facePlaneFloat_) < 0;
    const auto choose = [&](const float(&origin)[2]) {
      return below ? Lanes{} + origin[1] : Lanes{} + origin[0];
    };
    Masks hiddenLanes{};
    Masks firstWedges = Masks{} - 1;
    Lanes firstDistances{};
    for (std::size_t i = 0; i < wedges_.size(); ++i) {
      const Wedge& wedge = wedges_[i];
      const Lanes plane = form(wedge.plane), originPlane = choose(wedge.originPlane);
      // The ray o + t d meets the plane at t = -originPlane / plane, at a point whose two coordinates in the
      // wedge have the signs of these products (the division by plane^2 is left out).
      const Lanes side1 = (choose(wedge.originInside1) * plane - originPlane * form(wedge.inside1)) * plane;
      const Lanes side2 = (choose(wedge.originInside2) * plane - originPlane * form(wedge.inside2)) * plane;
      const Masks crossed = (originPlane * plane < 0) & (side1 >= 0) & (side2 >= 0);
      hiddenLanes |= crossed;
      if constexpr (kWithHits) {
        const Lanes distance = -originPlane / plane;
        const Masks nearer = crossed & ((firstWedges < 0) | (distance < firstDistances));
        firstWedges = nearer ? Masks{} + static_cast<std::int32_t>(i) : firstWedges;
        firstDistances = nearer ? distance : firstDistances;
      }
    }
    for (int lane = 0; lane < kWidth; ++lane) {
      if (hiddenLanes[lane] == 0) continue;
      mask |= 1u << (first + lane);
      if constexpr (kWithHits) {
        const SurfacePoint& place = places_[static_cast<std::size_t>(firstWedges[lane])];
        hits->triangle[first + lane] = place.triangle;
        hits->u[first + lane] = place.u;
        hits->v[first + lane] = place.v;
      }
    }
  }
  return mask;
}

std::uint32_t LocalHorizon::hidden(const RayPacket& rays) const {
  return crossWedges<false>(rays, nullptr);
}

std::uint32_t LocalHorizon::nearest(const RayPacket& rays, RayPacketHits& hits) const {
  return crossWedges<true>(rays, &hits);
}

}  // namespace shprt
