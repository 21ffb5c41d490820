// The journal is one small JSON file, written anew with each measurement. Numbers are kept as their 64 bits
// in hexadecimal, which brings back infinities, NaNs and signed zeros, too.
#include "shprt/study/study_journal.h"

#include <bit>
#include <charconv>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "shprt/base/file.h"
#include "shprt/base/json_input.h"

namespace shprt {
namespace {

constexpr const char* kFormat = "shprt-study-journal";
constexpr int kVersion = 1;
constexpr std::uint64_t kMaximumBytes = std::uint64_t{1} << 28;

std::string bitsOf(double number) {
  return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(number));
}

double fromBits(const std::string& text) {
  std::uint64_t bits = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, bits, 16);
  if (text.size() != 16 || result.ec != std::errc() || result.ptr != end)
    throw std::runtime_error("no bits of a number");
  return std::bit_cast<double>(bits);
}

// Of what write() writes (FNV-1a): measurements that were edited or damaged are none.
template <class Json>
std::string checksumOf(const Json& measurements) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : measurements.dump(-1, ' ', false, Json::error_handler_t::replace))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

// Throws a std::exception at anything that is not what write() writes.
std::map<std::string, std::vector<double>> readMeasurements(const std::filesystem::path& path,
                                                            const std::string& fingerprint) {
  const nlohmann::json journal = parseJson(readFile(path, kMaximumBytes));
  if (journal.at("format") != kFormat || journal.at("version") != kVersion ||
      journal.at("fingerprint") != fingerprint ||
      journal.at("checksum") != checksumOf(journal.at("measurements")))
    return {};
  std::map<std::string, std::vector<double>> kept;
  for (const auto& [key, numbers] : journal.at("measurements").get<nlohmann::json::object_t>()) {
    std::vector<double>& measured = kept[key];
    for (const std::string& bits : numbers.get<std::vector<std::string>>())
      measured.push_back(fromBits(bits));
  }
  return kept;
}

}  // namespace

StudyJournal::StudyJournal(std::filesystem::path path, std::string fingerprint)
    : path_(std::move(path)), fingerprint_(std::move(fingerprint)) {
  if (path_.empty()) return;
  try {
    kept_ = readMeasurements(path_, fingerprint_);
    for (const auto& [key, numbers] : kept_) before_.insert(key);
  } catch (const std::exception&) {
    // Missing, or damaged: what it held is measured again. A place that cannot be written shows then.
  }
}

std::vector<double> StudyJournal::measure(const std::string& key,
                                          const std::function<std::vector<double>()>& run) {
  if (const auto found = kept_.find(key); found != kept_.end()) {
    ++reused_;
    if (before_.contains(key)) fromBefore_.insert(key);
    return found->second;
  }
  std::vector<double> measured = run();
  kept_[key] = measured;
  if (!path_.empty()) write();
  return measured;
}

void StudyJournal::write() const {
  nlohmann::ordered_json journal = {{"format", kFormat},
                                    {"version", kVersion},
                                    {"fingerprint", fingerprint_},
                                    {"measurements", nlohmann::ordered_json::object()}};
  for (const auto& [key, numbers] : kept_) {
    nlohmann::ordered_json& list = journal["measurements"][key] = nlohmann::ordered_json::array();
    for (const double number : numbers) list.push_back(bitsOf(number));
  }
  journal["checksum"] = checksumOf(journal["measurements"]);
  writeFile(path_, journal.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace shprt
