// Follows light backwards over diffuse surfaces, from where a ray meets the first of them until it reaches
// the sky or is absorbed: one random path of the sum over bounces that a bake computes as a whole.
// Based on: Kajiya 1986 (the rendering equation, solved by paths).
#pragma once

#include <cstdint>
#include <optional>

#include "shprt/base/vec.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

// A point on the front of a triangle, where light is reflected.
struct ReflectingPoint {
  std::uint32_t triangle = 0;
  Vec3f position;          // in the frame that rays are traced in
  Vec3d normal;            // of the triangle, unit, on its front
  Vec3f albedo, emission;  // linear Rec.709
};

struct LightPath {
  bool reachesSky = false;
  int bounces = 0;   // surfaces it met
  Vec3d direction;   // in which it left the last one, unit
  Vec3d throughput;  // product of albedos over probabilities of having got so far; linear Rec.709
  Vec3d emission;    // radiance that the surfaces met send along it
};

class PathFollower {
 public:
  // A path is cut off here, which loses what bounces more often.
  static constexpr int kMostBounces = 80;

  PathFollower(const PreparedScene& prepared, std::uint64_t seed) : prepared_(prepared), seed_(seed) {}

  // What a ray in this direction meets where it hits a triangle; nothing where it comes from behind
  // (front_faces.h).
  std::optional<ReflectingPoint> meet(const SurfacePoint& hit, Vec3d direction) const;

  // The same for a hit right at a corner (LocalHorizon::nearest), where several triangles meet and no path
  // can go on: a hundredth of the way to the triangle's middle.
  std::optional<ReflectingPoint> meetNearby(const SurfacePoint& hit, Vec3d direction) const;

  // The rest of the path, in cosine-distributed directions about the triangles' normals. index names the path
  // among those of the seed. Russian roulette ends dim paths without bias.
  LightPath follow(const ReflectingPoint& first, std::uint64_t index) const;

 private:
  std::optional<ReflectingPoint> trace(const ReflectingPoint& from, Vec3d direction, bool& reachesSky) const;

  const PreparedScene& prepared_;
  std::uint64_t seed_;
};

}  // namespace shprt
