#include "shprt/transfer/local_horizon.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace shprt {
namespace {

// How far above the own triangle its infinitesimal step rises, as an angle in radians: dihedral angles
// smaller than this count as closed.
constexpr double kStepElevation = 1e-3;
// Edges up to this elevation (sine) above a plane count as lying in it. The lowest of n cosine-distributed
// rays stands about 1/sqrt(2n) high, 100 times more than this for n = 65536.
constexpr double kFlat = 1e-6;
// Wedges whose sine of the opening angle is less are degenerate: their plane is rounding.
constexpr double kDegenerate = 1e-9;

Vec3d edgeDirection(const SurfaceTopology& topology, std::uint32_t from, std::uint32_t to) {
  return normalize(toDouble(topology.positions()[to]) - toDouble(topology.positions()[from]));
}

// Whether the arc between two directions stays below a plane up to kFlat. Nearly opposite ones may rise in
// between.
bool staysBelow(Vec3d plane, Vec3d edge1, Vec3d edge2) {
  return dot(plane, edge1) <= kFlat && dot(plane, edge2) <= kFlat && length(edge1 + edge2) > 0.1;
}

}  // namespace

void LocalHorizon::addWedge(Vec3d edge1, Vec3d edge2, bool own) {
  const bool belowNormal = staysBelow(normal_, edge1, edge2);
  if (own ? belowNormal : belowNormal && staysBelow(facePlane_, edge1, edge2)) return;
  const Vec3d crossed = cross(edge1, edge2);
  if (length(crossed) < kDegenerate) return;
  const Vec3d plane = normalize(crossed);
  // A direction s edge1 + t edge2 has s >= 0 where inside1 is positive and t >= 0 where inside2 is.
  const Vec3d inside1 = cross(edge2, plane), inside2 = cross(plane, edge1);
  Wedge wedge{toFloat(plane), toFloat(inside1), toFloat(inside2), {}, {}, {}};
  for (const int below : {0, 1}) {
    const Vec3d step = own || below ? normal_ : faceStep_;
    wedge.originPlane[below] = static_cast<float>(dot(step, plane));
    wedge.originInside1[below] = static_cast<float>(dot(step, inside1));
    wedge.originInside2[below] = static_cast<float>(dot(step, inside2));
  }
  wedges_.push_back(wedge);
  // The arc between the edges is highest in between where the normal's foot on the plane lies there.
  const bool peaks = dot(normal_, inside1) > 0 && dot(normal_, inside2) > 0;
  const double top =
      peaks ? length(cross(normal_, plane)) : std::max(dot(normal_, edge1), dot(normal_, edge2));
  highest_ = std::max(highest_, own ? static_cast<float>(top + kFlat) : 1.0f);
}

void LocalHorizon::prepare(const SurfaceTopology& topology, std::uint32_t vertex,
                           std::span<const std::uint32_t> touching) {
  wedges_.clear();
  highest_ = 0;
  normal_ = topology.normal(vertex);
  normalFloat_ = toFloat(normal_);
  const std::uint32_t position = topology.positionIds()[vertex];
  const std::uint32_t point = topology.pointIds()[vertex];

  struct Corner {
    Vec3d edge1, edge2;
    bool own;
  };
  std::vector<Corner> corners;
  double widestCosine = 2;
  for (const std::uint32_t triangle : topology.trianglesAt(position)) {
    const Triangle& t = topology.triangles()[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      if (topology.positionIds()[t[k]] != position) continue;
      const Corner corner{edgeDirection(topology, t[k], t[(k + 1) % 3]),
                          edgeDirection(topology, t[k], t[(k + 2) % 3]), topology.pointIds()[t[k]] == point};
      corners.push_back(corner);
      const Vec3d crossed = cross(corner.edge1, corner.edge2);
      const double cosine = dot(corner.edge1, corner.edge2);
      if (!corner.own || cosine >= widestCosine || length(crossed) < kDegenerate) continue;
      widestCosine = cosine;
      facePlane_ = normalize(crossed);
      // The bisector; rotating an edge into the wedge serves opposite edges too.
      faceStep_ = cosine > -0.99 ? normalize(corner.edge1 + corner.edge2) : cross(facePlane_, corner.edge1);
      if (dot(facePlane_, normal_) < 0) facePlane_ = -facePlane_;
      faceStep_ = normalize(faceStep_ + facePlane_ * kStepElevation);
    }
  }
  if (widestCosine > 1.5) facePlane_ = faceStep_ = normal_;
  facePlaneFloat_ = toFloat(facePlane_);
  for (const Corner& corner : corners) addWedge(corner.edge1, corner.edge2, corner.own);

  const Vec3d here = toDouble(topology.positions()[vertex]);
  for (const std::uint32_t triangle : touching) {
    Vec3d edges[3];
    int atCorner = -1;
    for (int k = 0; k < 3; ++k) {
      const Vec3d offset =
          toDouble(topology.positions()[topology.triangles()[triangle][static_cast<std::size_t>(k)]]) - here;
      if (length(offset) <= 2 * topology.contactDistance()) atCorner = k;
      edges[k] = normalize(offset);
    }
    if (atCorner >= 0) {
      addWedge(edges[(atCorner + 1) % 3], edges[(atCorner + 2) % 3], false);
      continue;
    }
    // From inside the triangle its three edges span the whole plane. On an edge, that edge's own wedge is
    // flat to rounding and the other two span the half plane.
    for (int k = 0; k < 3; ++k) {
      constexpr double kOnEdge = 1e-3;
      if (length(cross(edges[k], edges[(k + 1) % 3])) > kOnEdge)
        addWedge(edges[k], edges[(k + 1) % 3], false);
    }
  }
}

std::uint32_t LocalHorizon::hidden(const RayPacket& rays) const {
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
    for (const Wedge& wedge : wedges_) {
      const Lanes plane = form(wedge.plane), originPlane = choose(wedge.originPlane);
      // The ray o + t d meets the plane at t = -originPlane / plane, at a point whose two coordinates in the
      // wedge have the signs of these products (the division by plane^2 is left out).
      const Lanes side1 = (choose(wedge.originInside1) * plane - originPlane * form(wedge.inside1)) * plane;
      const Lanes side2 = (choose(wedge.originInside2) * plane - originPlane * form(wedge.inside2)) * plane;
      hiddenLanes |= (originPlane * plane < 0) & (side1 >= 0) & (side2 >= 0);
    }
    for (int lane = 0; lane < kWidth; ++lane) mask |= (hiddenLanes[lane] != 0 ? 1u : 0u) << (first + lane);
  }
  return mask;
}

}  // namespace shprt
