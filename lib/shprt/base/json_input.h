// Reading JSON with complaints a user can act on: file, place, and what to do. Internal to the library: the
// one header that names a type of nlohmann-json, for the rooms that read JSON files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shprt {

// JSON nested at most 100 deep, no field of an object given twice. Throws what nlohmann-json throws,
// std::length_error and another std::runtime_error.
nlohmann::json parseJson(std::string_view text);

// What a file is, as far as its top level tells.
struct JsonOutline {
  bool object = false;      // begins like a JSON object
  std::string format;       // its "format", where that is a text
  bool hasLights = false;   // has a list "lights"
  bool hasObjects = false;  // has a field "objects"
};
// Reads no further than it must. A file that is missing, no JSON, or damaged before anything was found has
// the outline of nothing but `object`.
JsonOutline outlineJson(const std::filesystem::path& path);

// The object a file holds. Throws Error with line and column when it is no JSON, and when it is no object.
nlohmann::json readJsonObject(const std::filesystem::path& path);

// One JSON object of a file and where in the file it is, for messages: "lights[2]".
class JsonObject {
 public:
  JsonObject(std::string file, std::string place, const nlohmann::json& value);

  bool has(std::string_view field) const { return value_.contains(field); }
  // The field, or Error when it is missing or of another kind. Numbers are finite.
  const nlohmann::json& field(std::string_view name) const;
  std::string text(std::string_view name) const;
  double number(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  std::uint64_t natural(std::string_view name) const;       // the whole range of 64 bits
  const nlohmann::json& list(std::string_view name) const;  // an array, of any content
  std::array<double, 3> triple(std::string_view name) const;
  std::vector<std::array<double, 3>> triples(std::string_view name) const;
  JsonObject object(std::string_view name) const;

  bool boolean(std::string_view name) const;

  std::vector<std::string> names() const;
  // What the field is in the file, for messages of others: "objects[2].transform".
  std::string placeOf(std::string_view field) const;

  // Throws Error when the object has any other field.
  void allowOnly(std::initializer_list<std::string_view> fields) const;
  [[noreturn]] void fail(std::string_view field, const std::string& problem,
                         const std::string& remedy = "") const;

 private:
  std::array<double, 3> tripleOf(const std::string& name, const nlohmann::json& value) const;

  std::string file_, place_;
  const nlohmann::json& value_;
};

}  // namespace shprt
