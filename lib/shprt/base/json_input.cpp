#include "shprt/base/json_input.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <set>
#include <stdexcept>

#include "shprt/base/error.h"
#include "shprt/base/file.h"

namespace shprt {
namespace {

// Of two values for one field the parser would silently keep the last.
class DuplicateField : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace

nlohmann::json parseJson(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  // Far deeper than any file means; what is deeper would overflow the stack where it is written again.
  constexpr int kDeepest = 100;
  std::vector<std::set<std::string>> open;  // the fields so far of every object that is not closed yet
  return nlohmann::json::parse(text, [&](int depth, Event event, nlohmann::json& parsed) {
    if (depth > kDeepest) throw std::length_error("nested too deeply");
    if (event == Event::object_start) open.emplace_back();
    if (event == Event::object_end) open.pop_back();
    if (event == Event::key && !open.back().insert(parsed.get<std::string>()).second)
      throw DuplicateField(parsed.get<std::string>());
    return true;
  });
}

JsonOutline outlineJson(const std::filesystem::path& path) {
  using Event = nlohmann::json::parse_event_t;
  JsonOutline outline;
  std::string head = readFirstBytes(path, std::size_t{1} << 16);
  if (head.starts_with("\xef\xbb\xbf")) head.erase(0, 3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || head[first] != '{') return outline;
  outline.object = true;
  std::string key;
  struct Enough {};
  try {
    std::ifstream file(path, std::ios::binary);  // read as far as the parser goes
    [[maybe_unused]] const nlohmann::json topLevel =
        nlohmann::json::parse(file, [&](int depth, Event event, nlohmann::json& parsed) {
          if (depth != 1) return depth < 1;
          if (event == Event::key) key = parsed.get<std::string>();
          if (event == Event::key && key == "objects") {
            outline.hasObjects = true;
            throw Enough{};
          }
          if (event == Event::value && key == "format" && parsed.is_string()) {
            outline.format = parsed.get<std::string>();
            throw Enough{};
          }
          if (event == Event::array_start && key == "lights") {
            outline.hasLights = true;
            throw Enough{};
          }
          return true;
        });
  } catch (const Enough&) {
  } catch (const std::exception&) {
    // Whoever reads the file in earnest says what is wrong with it.
  }
  return outline;
}

nlohmann::json readJsonObject(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaximumBytes = std::uint64_t{1} << 30;
  const std::string bytes = readFile(path, kMaximumBytes);
  nlohmann::json value;
  try {
    value = parseJson(bytes);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t at = std::min<std::size_t>(error.byte > 0 ? error.byte - 1 : 0, bytes.size());
    const auto line = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
    const std::size_t lineStart = at == 0 ? 0 : bytes.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    throw Error(path.string(),
                "is not valid JSON at line " + std::to_string(line) + ", column " +
                    std::to_string(at - lineStart + 1),
                "mend the syntax there");
  } catch (const DuplicateField& field) {
    throw Error(
        path.string(),
        std::string("gives the field '") + std::string(field.what()).substr(0, 40) + "' twice in one object",
        "keep one of them");
  } catch (const std::length_error&) {
    throw Error(path.string(), "is JSON nested more deeply than any that is read here");
  } catch (const nlohmann::json::exception&) {
    throw Error(path.string(), "is JSON with a number beyond the range of double", "mend that number");
  }
  if (!value.is_object())
    throw Error(path.string(), "holds no JSON object", "give a file that begins with '{'");
  return value;
}

JsonObject::JsonObject(std::string file, std::string place, const nlohmann::json& value)
    : file_(std::move(file)), place_(std::move(place)), value_(value) {
  if (!value_.is_object()) throw Error(file_, place_ + " is no object", "write it as {...}");
}

void JsonObject::fail(std::string_view field, const std::string& problem, const std::string& remedy) const {
  throw Error(file_, placeOf(field) + " " + problem, remedy);
}

std::string JsonObject::placeOf(std::string_view field) const {
  if (field.empty()) return place_;
  return place_.empty() ? std::string(field) : place_ + "." + std::string(field);
}

const nlohmann::json& JsonObject::field(std::string_view name) const {
  if (!has(name)) fail(name, "is missing", "add it");
  return value_.at(std::string(name));
}

std::string JsonObject::text(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_string()) fail(name, "is no text", "write it in quotes");
  return value.get<std::string>();
}

double JsonObject::number(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_number() || !std::isfinite(value.get<double>())) fail(name, "is no finite number");
  return value.get<double>();
}

bool JsonObject::boolean(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_boolean()) fail(name, "is neither true nor false");
  return value.get<bool>();
}

std::int64_t JsonObject::integer(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_number_integer()) fail(name, "is no whole number");
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX) fail(name, "is too large");
  return value.get<std::int64_t>();
}

std::uint64_t JsonObject::natural(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_number_unsigned()) fail(name, "is no whole number from 0 up");
  return value.get<std::uint64_t>();
}

const nlohmann::json& JsonObject::list(std::string_view name) const {
  const nlohmann::json& value = field(name);
  if (!value.is_array()) fail(name, "is no list", "write it as [...]");
  return value;
}

std::array<double, 3> JsonObject::tripleOf(const std::string& name, const nlohmann::json& value) const {
  if (!value.is_array() || value.size() != 3) fail(name, "does not have three numbers", "write [a, b, c]");
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!value[i].is_number() || !std::isfinite(value[i].get<double>()))
      fail(name, "has an entry that is no finite number");
    numbers[i] = value[i].get<double>();
  }
  return numbers;
}

std::array<double, 3> JsonObject::triple(std::string_view name) const {
  return tripleOf(std::string(name), field(name));
}

std::vector<std::array<double, 3>> JsonObject::triples(std::string_view name) const {
  const nlohmann::json& values = list(name);
  std::vector<std::array<double, 3>> triples;
  triples.reserve(values.size());
  for (const nlohmann::json& value : values)
    triples.push_back(tripleOf(std::string(name) + "[" + std::to_string(triples.size()) + "]", value));
  return triples;
}

JsonObject JsonObject::object(std::string_view name) const {
  return {file_, placeOf(name), field(name)};
}

std::vector<std::string> JsonObject::names() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : value_.items()) names.push_back(name);
  return names;
}

void JsonObject::allowOnly(std::initializer_list<std::string_view> fields) const {
  for (const auto& [name, value] : value_.items()) {
    if (std::find(fields.begin(), fields.end(), name) != fields.end()) continue;
    std::string known;
    for (const std::string_view field : fields) known += (known.empty() ? "" : ", ") + std::string(field);
    fail(name.substr(0, 40), "is not known here", "known fields: " + known);
  }
}

}  // namespace shprt
