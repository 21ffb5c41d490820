// The elements of a PLY file, value by value, in any of its three encodings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shprt {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  bool list = false;
  PlyType countType = PlyType::kUint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // Index of the property of that name, or -1.
  int find(std::string_view property) const;
};

class PlyReader {
 public:
  // Reads the header; bytes must outlive the reader. path is for messages. Throws Error when the header makes
  // no sense or claims more records than the bytes can hold.
  PlyReader(std::string_view bytes, std::string path);

  const std::vector<PlyElement>& elements() const { return elements_; }
  bool ascii() const { return encoding_ == Encoding::kAscii; }
  std::uint64_t overlongLines() const { return overlongLines_; }
  // Bytes not read yet.
  std::uint64_t bytesLeft() const { return bytes_.size(); }

  // The next record of the element that is due: values[property] has one value, or a list's values. Throws
  // Error, naming element and record, at the end of the bytes or at a token that is no number. In ASCII a
  // record ends with its line: what the header does not announce is passed over, and counted.
  void readRecord(const PlyElement& element, std::uint64_t record, std::vector<std::vector<double>>& values);

 private:
  enum class Encoding { kAscii, kLittle, kBig };

  void readHeader();
  double readValue(PlyType type);
  [[noreturn]] void fail(const std::string& problem) const;

  std::string_view bytes_;
  std::string path_;
  Encoding encoding_ = Encoding::kAscii;
  std::vector<PlyElement> elements_;
  std::uint64_t overlongLines_ = 0;
};

}  // namespace shprt
