#include "shprt/mesh/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/mesh/text.h"

namespace shprt {
namespace {

std::optional<PlyType> parseType(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> kNames = {{{"char", PlyType::kInt8},
                                                                            {"int8", PlyType::kInt8},
                                                                            {"uchar", PlyType::kUint8},
                                                                            {"uint8", PlyType::kUint8},
                                                                            {"short", PlyType::kInt16},
                                                                            {"int16", PlyType::kInt16},
                                                                            {"ushort", PlyType::kUint16},
                                                                            {"uint16", PlyType::kUint16},
                                                                            {"int", PlyType::kInt32},
                                                                            {"int32", PlyType::kInt32},
                                                                            {"uint", PlyType::kUint32},
                                                                            {"uint32", PlyType::kUint32},
                                                                            {"float", PlyType::kFloat32},
                                                                            {"float32", PlyType::kFloat32},
                                                                            {"double", PlyType::kFloat64},
                                                                            {"float64", PlyType::kFloat64}}};
  for (const auto& [spelling, type] : kNames) {
    if (spelling == name) return type;
  }
  return {};
}

std::size_t byteSize(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kFloat64:
      return 8;
    default:
      return 4;
  }
}

bool isInteger(PlyType type) {
  return type != PlyType::kFloat32 && type != PlyType::kFloat64;
}

double decode(std::uint64_t bits, PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return static_cast<std::int8_t>(bits);
    case PlyType::kUint8:
      return static_cast<std::uint8_t>(bits);
    case PlyType::kInt16:
      return static_cast<std::int16_t>(bits);
    case PlyType::kUint16:
      return static_cast<std::uint16_t>(bits);
    case PlyType::kInt32:
      return static_cast<std::int32_t>(bits);
    case PlyType::kUint32:
      return static_cast<std::uint32_t>(bits);
    case PlyType::kFloat32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case PlyType::kFloat64:
      return std::bit_cast<double>(bits);
  }
  return 0;
}

}  // namespace

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return static_cast<int>(i);
  }
  return -1;
}

void PlyReader::fail(const std::string& problem) const {
  throw Error(path_, problem, "export the mesh again");
}

PlyReader::PlyReader(std::string_view bytes, std::string path) : bytes_(bytes), path_(std::move(path)) {
  readHeader();
  for (const PlyElement& element : elements_) {
    std::uint64_t smallest = 0;
    for (const PlyProperty& property : element.properties) {
      smallest += ascii() ? 2 : byteSize(property.list ? property.countType : property.type);
    }
    if (element.count > bytes_.size() / std::max<std::uint64_t>(smallest, 1) + 1) {
      fail("claims " + std::to_string(element.count) + " records of '" + element.name + "', more than its " +
           std::to_string(bytes_.size()) + " bytes can hold");
    }
  }
}

void PlyReader::readHeader() {
  if (trimBlanks(takeLine(bytes_)) != "ply")
    throw Error(path_, "does not begin with 'ply'", "give a PLY file");
  bool hasFormat = false;
  for (;;) {
    if (bytes_.empty()) fail("the header has no end_header");
    std::string_view line = takeLine(bytes_);
    const std::string_view shown = line, keyword = takeToken(line);
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
    if (keyword == "format") {
      const std::string_view name = takeToken(line);
      hasFormat = true;
      if (name == "ascii")
        encoding_ = Encoding::kAscii;
      else if (name == "binary_little_endian")
        encoding_ = Encoding::kLittle;
      else if (name == "binary_big_endian")
        encoding_ = Encoding::kBig;
      else
        fail("has the unknown format '" + shownToken(name) + "'");
    } else if (keyword == "element") {
      PlyElement element;
      element.name = shownToken(takeToken(line));
      const auto count = parseInteger<std::uint64_t>(takeToken(line));
      if (!count) fail("the count of element '" + element.name + "' cannot be read");
      element.count = *count;
      elements_.push_back(element);
    } else if (keyword == "property" && !elements_.empty()) {
      PlyProperty property;
      std::string_view type = takeToken(line);
      if (type == "list") {
        property.list = true;
        const auto countType = parseType(takeToken(line));
        if (!countType || !isInteger(*countType))
          fail("header line '" + shownToken(shown) + "' has no integer type for its count");
        property.countType = *countType;
        type = takeToken(line);
      }
      const auto valueType = parseType(type);
      if (!valueType) fail("header line '" + shownToken(shown) + "' has an unknown type");
      property.type = *valueType;
      property.name = takeToken(line);
      elements_.back().properties.push_back(property);
    } else {
      fail("header line '" + shownToken(shown) + "' makes no sense");
    }
  }
  if (!hasFormat) fail("the header names no format");
}

double PlyReader::readValue(PlyType type) {
  if (ascii()) {
    while (!bytes_.empty() && (isBlank(bytes_.front()) || bytes_.front() == '\n' || bytes_.front() == '\r'))
      bytes_.remove_prefix(1);
    const std::size_t length = std::min(bytes_.size(), bytes_.find_first_of(" \t\v\f\r\n"));
    if (length == 0) throw std::out_of_range("the file ends");
    // Straight to float where that is the type: by way of double it could end on the neighbour.
    const std::string_view token = bytes_.substr(0, length);
    const std::optional<double> value =
        type == PlyType::kFloat32 ? std::optional<double>(parseReal<float>(token)) : parseReal<double>(token);
    if (!value) throw std::out_of_range("'" + shownToken(token) + "' is no number");
    bytes_.remove_prefix(length);
    return *value;
  }
  const std::size_t size = byteSize(type);
  if (bytes_.size() < size) throw std::out_of_range("the file ends");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[i]));
    bits |= byte << (8 * (encoding_ == Encoding::kLittle ? i : size - 1 - i));
  }
  bytes_.remove_prefix(size);
  return decode(bits, type);
}

void PlyReader::readRecord(const PlyElement& element, std::uint64_t record,
                           std::vector<std::vector<double>>& values) {
  values.resize(element.properties.size());
  try {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      std::uint64_t count = 1;
      if (property.list) {
        const double claimed = readValue(property.countType);
        const std::uint64_t smallest = ascii() ? 1 : byteSize(property.type);
        if (!(claimed >= 0) || claimed > static_cast<double>(bytes_.size() / smallest))
          throw std::out_of_range("a list claims more values than the file holds");
        count = static_cast<std::uint64_t>(claimed);
      }
      values[p].clear();
      for (std::uint64_t i = 0; i < count; ++i) values[p].push_back(readValue(property.type));
    }
    if (ascii() && !trimBlanks(takeLine(bytes_)).empty()) ++overlongLines_;
  } catch (const std::out_of_range& problem) {
    fail("claims " + std::to_string(element.count) + " records of '" + element.name + "'; in record " +
         std::to_string(record) + " " + problem.what());
  }
}

}  // namespace shprt
