// Journals: nothing is measured twice, nothing that was measured is lost, and no damage to the file gets into
// the numbers.
#include "shprt/study/study_journal.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

using Numbers = std::vector<double>;

std::vector<std::uint64_t> bits(const Numbers& numbers) {
  std::vector<std::uint64_t> all;
  for (const double number : numbers) all.push_back(std::bit_cast<std::uint64_t>(number));
  return all;
}

Numbers mustNotRun() {
  ADD_FAILURE() << "measured again";
  return {};
}

std::string newJournal() {
  const std::string path = test::scratch("journal.json");
  std::filesystem::remove(path);
  return path;
}

TEST(StudyJournal, MeasuresOnce) {
  StudyJournal journal("", "f");
  EXPECT_EQ(journal.measure("a", [] { return Numbers{1, 2}; }), (Numbers{1, 2}));
  EXPECT_EQ(journal.measure("a", mustNotRun), (Numbers{1, 2}));
  EXPECT_EQ(journal.measure("b", [] { return Numbers{3}; }), (Numbers{3}));
  EXPECT_EQ(journal.reused(), 1u);
}

TEST(StudyJournal, GoesOnWhereItWas) {
  const std::string path = newJournal();
  {
    StudyJournal journal(path, "f");
    EXPECT_FALSE(std::filesystem::exists(path));
    journal.measure("a", [] { return Numbers{1.5}; });
    journal.measure("nothing", [] { return Numbers{}; });
  }
  StudyJournal again(path, "f");
  EXPECT_EQ(again.measure("a", mustNotRun), (Numbers{1.5}));
  EXPECT_EQ(again.measure("nothing", mustNotRun), Numbers{});
  EXPECT_EQ(again.measure("b", [] { return Numbers{2.5}; }), (Numbers{2.5}));
  EXPECT_EQ(again.reused(), 2u);
  StudyJournal third(path, "f");
  EXPECT_EQ(third.measure("a", mustNotRun), (Numbers{1.5}));
  EXPECT_EQ(third.measure("b", mustNotRun), (Numbers{2.5}));
}

TEST(StudyJournal, BitsSurvive) {
  using Limits = std::numeric_limits<double>;
  const Numbers numbers = {0.0,
                           -0.0,
                           0.1,
                           -1.0 / 3,
                           Limits::infinity(),
                           -Limits::infinity(),
                           Limits::quiet_NaN(),
                           std::bit_cast<double>(std::uint64_t{0xfff8000000abcdef}),  // a NaN with a payload
                           Limits::denorm_min(),
                           Limits::max(),
                           std::nextafter(1.0, 2.0)};
  const std::string path = newJournal();
  const auto give = [&] { return numbers; };
  EXPECT_EQ(bits(StudyJournal(path, "f").measure("a", give)), bits(numbers));
  EXPECT_EQ(bits(StudyJournal(path, "f").measure("a", mustNotRun)), bits(numbers));
}

TEST(StudyJournal, KeysAndFingerprintsMayBeAnyText) {
  const std::string path = newJournal(), key = "\"\\\n\t{}\xcf\x80 \x01", fingerprint = "f\"\\ \xe2\x82\xac";
  StudyJournal(path, fingerprint).measure(key, [] { return Numbers{1}; });
  EXPECT_EQ(StudyJournal(path, fingerprint).measure(key, mustNotRun), Numbers{1});
  // What is no UTF-8 is not found again, but does no harm.
  StudyJournal(path, fingerprint).measure("\xff", [] { return Numbers{2}; });
  EXPECT_EQ(StudyJournal(path, fingerprint).measure(key, mustNotRun), Numbers{1});
}

TEST(StudyJournal, OfAnotherFingerprintBeginsAnew) {
  const std::string path = newJournal();
  StudyJournal(path, "f").measure("a", [] { return Numbers{1}; });
  {
    // What is there stays until there is something to replace it with.
    StudyJournal other(path, "g");
  }
  EXPECT_EQ(StudyJournal(path, "f").measure("a", mustNotRun), Numbers{1});
  EXPECT_EQ(StudyJournal(path, "g").measure("a", [] { return Numbers{2}; }), Numbers{2});
  EXPECT_EQ(StudyJournal(path, "g").measure("a", mustNotRun), Numbers{2});
  EXPECT_EQ(StudyJournal(path, "f").measure("a", [] { return Numbers{3}; }), Numbers{3});
}

TEST(StudyJournal, TruncatedAnywhereCountsAsNone) {
  const std::string path = newJournal();
  StudyJournal(path, "f").measure("a", [] { return Numbers{1, 2}; });
  const std::string whole = readFile(path);
  for (std::size_t length = 0; length < whole.size() - 2; ++length) {
    writeFile(path, whole.substr(0, length));
    StudyJournal journal(path, "f");
    ASSERT_EQ(journal.measure("a", [] { return Numbers{3}; }), Numbers{3}) << length;
    ASSERT_EQ(StudyJournal(path, "f").measure("a", mustNotRun), Numbers{3}) << length;
  }
}

TEST(StudyJournal, WhatIsNoJournalCountsAsNone) {
  const std::string head = R"({"format":"shprt-study-journal","version":1,"fingerprint":"f","measurements":)";
  const std::string one = R"(["3ff0000000000000"]})";
  const std::string path = newJournal();
  for (const std::string& bytes :
       {std::string(""),
        std::string("\0\0\0", 3),
        std::string("[]"),
        std::string("null"),
        std::string("{}"),
        std::string(R"({"a":[1]})"),
        head + "null}",
        head + "[1]}",
        head + R"({"a":1}})",
        head + R"({"a":[1]}})",
        head + R"({"a":[null]}})",
        head + R"({"a":["3ff000000000000"]}})",
        head + R"({"a":["3ff00000000000000"]}})",
        head + R"({"a":["-ff0000000000000"]}})",
        head + R"({"a":["3ff000000000000g"]}})",
        head + R"({"b":["x"],"a":)" + one + "}",
        R"({"format":"other","version":1,"fingerprint":"f","measurements":{"a":)" + one + "}",
        R"({"format":"shprt-study-journal","version":2,"fingerprint":"f","measurements":{"a":)" + one + "}",
        R"({"format":"shprt-study-journal","version":1,"measurements":{"a":)" + one + "}",
        std::string(100000, '[')}) {
    writeFile(path, bytes);
    EXPECT_EQ(StudyJournal(path, "f").measure("a", [] { return Numbers{7}; }), Numbers{7}) << bytes;
    EXPECT_EQ(StudyJournal(path, "f").measure("a", mustNotRun), Numbers{7}) << bytes;
  }
}

TEST(StudyJournal, EditedCountsAsNone) {
  const std::string path = newJournal();
  StudyJournal(path, "f").measure("a", [] { return Numbers{1, 2}; });
  const std::string whole = readFile(path);
  const auto edited = [&](const std::string& from, const std::string& to) {
    std::string bytes = whole;
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return bytes.replace(at, from.size(), to);
  };
  for (const std::string& bytes :
       {edited("3ff0000000000000", "3ff0000000000001"), edited("\"a\"", "\"b\""),
        edited("journal\"", "other\""), edited("\"version\": 1", "\"version\": 2"),
        edited("\"checksum\": \"", "\"checksum\": \"0"), edited("\"4000000000000000\"", "null")}) {
    writeFile(path, bytes);
    EXPECT_EQ(StudyJournal(path, "f").measure("a", [] { return Numbers{7}; }), Numbers{7}) << bytes;
  }
  // And only that.
  writeFile(path, whole);
  StudyJournal journal(path, "f");
  EXPECT_EQ(journal.measure("a", mustNotRun), (Numbers{1, 2}));
  EXPECT_EQ(journal.measure("a", mustNotRun), (Numbers{1, 2}));
  journal.measure("b", [] { return Numbers{1}; });
  EXPECT_EQ(journal.measure("b", mustNotRun), Numbers{1});
  EXPECT_EQ(journal.reused(), 3u);
  EXPECT_EQ(journal.fromBefore(), 1u);
}

TEST(StudyJournal, ARunThatThrowsKeepsWhatWasBefore) {
  const std::string path = newJournal();
  StudyJournal journal(path, "f");
  journal.measure("a", [] { return Numbers{1}; });
  const std::string before = readFile(path);
  EXPECT_THROW(journal.measure("b", []() -> Numbers { throw std::runtime_error("interrupted"); }),
               std::runtime_error);
  EXPECT_EQ(readFile(path), before);
  EXPECT_EQ(journal.measure("a", mustNotRun), Numbers{1});
  EXPECT_EQ(journal.measure("b", [] { return Numbers{2}; }), Numbers{2});
}

TEST(StudyJournal, SaysWhenItCannotBeWritten) {
  StudyJournal noFolder(test::scratch("missing") + "/journal.json", "f");
  EXPECT_THROW(noFolder.measure("a", [] { return Numbers{1}; }), Error);
  StudyJournal folder(std::filesystem::path(test::scratch("x")).parent_path(), "f");
  EXPECT_THROW(folder.measure("a", [] { return Numbers{1}; }), Error);
}

}  // namespace
}  // namespace shprt
