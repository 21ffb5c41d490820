// Names and attributes of the asset file, shared by its writer and reader. docs/file-formats.md is the
// specification.
#pragma once

#include <cstddef>

namespace shprt::asset_layout {

inline constexpr int kFormatVersion = 1;

// Parts, in file order; emission only when the scene has lights of its own, the errors only when they were
// measured, textureCoordinates only when the mesh has any.
inline constexpr const char* kTransfer = "transfer";
inline constexpr const char* kPositions = "positions";
inline constexpr const char* kNormals = "normals";
inline constexpr const char* kAlbedo = "albedo";
inline constexpr const char* kEmission = "emission";
inline constexpr const char* kError = "error";
inline constexpr const char* kEmissionError = "emissionError";
inline constexpr const char* kTextureCoordinates = "textureCoordinates";
inline constexpr const char* kTriangles = "triangles";

// Attributes of the part `transfer`.
inline constexpr const char* kVersionAttribute = "shprtFormatVersion";
inline constexpr const char* kDegreeAttribute = "shprtDegree";
inline constexpr const char* kConventionAttribute = "shprtConvention";
inline constexpr const char* kModelAttribute = "shprtModel";
inline constexpr const char* kRaysAttribute = "shprtRays";
inline constexpr const char* kSeedAttribute = "shprtSeed";  // a string: EXR has no 64-bit integers
inline constexpr const char* kToolAttribute = "shprtTool";
inline constexpr const char* kMetadataAttribute = "shprtMetadata";

inline constexpr std::size_t kMaximumPlanBytes = std::size_t{1}
                                                 << 20;  // of the object "plan" in the metadata

// The name of one of `channels` channels, 1 or 3, of the parts `transfer` and `error`; they have the same.
inline const char* channelName(int channels, int channel) {
  constexpr const char* kNames[] = {"R", "G", "B"};
  return channels == 1 ? "Y" : kNames[channel];
}

// Tiles of the part `transfer` are as high as the image and at most this wide.
inline constexpr unsigned kMaximumTileWidth = 16384;

inline constexpr const char* kConvention =
    "real orthonormal SH, index l(l+1)+m, no Condon-Shortley phase; right-handed, +Y up; linear Rec.709; "
    "albedo/pi folded in";

}  // namespace shprt::asset_layout
