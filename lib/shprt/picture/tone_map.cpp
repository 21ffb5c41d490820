#include "shprt/picture/tone_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shprt {
namespace {

// Bright enough to use the display's range, robust against a few highlights.
constexpr double kPercentile = 0.98;
constexpr float kTarget = 0.9f;

float encodeChannel(float linear) {
  if (!(linear > 0)) return 0;  // negative lobes, and NaN
  if (linear >= 1) return 1;
  if (linear <= 0.0031308f) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

}  // namespace

float luminance(Vec3f rgb) {
  return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z;
}

float autoExposure(std::span<const Vec3f> radiance) {
  std::vector<float> luminances;
  luminances.reserve(radiance.size());
  for (const Vec3f& value : radiance) {
    const float y = luminance(value);
    if (y > 0 && std::isfinite(y)) luminances.push_back(y);
  }
  if (luminances.empty()) return 1;
  const auto rank = luminances.begin() +
                    static_cast<std::ptrdiff_t>(kPercentile * static_cast<double>(luminances.size() - 1));
  std::nth_element(luminances.begin(), rank, luminances.end());
  // Subnormal luminance would ask for an infinite factor.
  return std::min(kTarget / *rank, 1e30f);
}

Vec3f encodeSrgb(Vec3f linear, float exposure) {
  return {encodeChannel(linear.x * exposure), encodeChannel(linear.y * exposure),
          encodeChannel(linear.z * exposure)};
}

std::array<std::uint8_t, 3> encodeSrgb8(Vec3f linear, float exposure) {
  const Vec3f encoded = encodeSrgb(linear, exposure);
  const auto byte = [](float value) { return static_cast<std::uint8_t>(value * 255 + 0.5f); };
  return {byte(encoded.x), byte(encoded.y), byte(encoded.z)};
}

Image encodeSrgb(const Image& linear, float exposure) {
  Image encoded = linear;
  for (Vec3f& pixel : encoded.pixels) pixel = encodeSrgb(pixel, exposure);
  return encoded;
}

}  // namespace shprt
