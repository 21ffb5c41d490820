// Light at many places as a matrix: a row per place, with the coefficients of all channels side by side, so
// that following a ray reads consecutive memory.
#pragma once

#include <cstddef>
#include <vector>

namespace shprt {

// What a row holds: the coefficients of each channel, then three more numbers where the scene emits, the
// irradiance/pi of its own lights in red, green and blue. A band is what bounces with one albedo channel: one
// channel's coefficients, or one of those numbers.
struct LightLayout {
  int channels = 1;  // 1 or 3
  int coefficients = 1;
  bool emission = false;

  struct Band {
    std::size_t first, end;  // columns
    int albedoChannel;
  };
  int bandCount() const { return channels + (emission ? 3 : 0); }
  Band band(int index) const {
    const auto width = static_cast<std::size_t>(coefficients), before = static_cast<std::size_t>(index);
    if (index < channels) return {before * width, (before + 1) * width, index};
    const std::size_t column = emissionColumn() + before - static_cast<std::size_t>(channels);
    return {column, column + 1, index - channels};
  }
  std::size_t emissionColumn() const {
    return static_cast<std::size_t>(channels) * static_cast<std::size_t>(coefficients);
  }
  std::size_t columns() const { return emissionColumn() + (emission ? 3u : 0u); }
};

// Rows begin at cache lines and are padded with zeros to whole ones. Zero at first.
class LightRows {
 public:
  LightRows(std::size_t rows, std::size_t columns)
      : lines_((columns + kLine - 1) / kLine), storage_(rows * lines_) {}

  std::size_t rows() const { return storage_.size() / lines_; }
  std::size_t stride() const { return lines_ * kLine; }  // floats from one row to the next
  float* row(std::size_t index) { return storage_[index * lines_].values; }
  const float* row(std::size_t index) const { return storage_[index * lines_].values; }

 private:
  static constexpr std::size_t kLine = 16;
  struct alignas(64) Line {
    float values[kLine] = {};
  };
  std::size_t lines_;
  std::vector<Line> storage_;
};

}  // namespace shprt
