#include "progress_bar.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "interrupt.h"

namespace shprt {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kBetweenBars{0.1};
constexpr Seconds kBetweenLines{5};
constexpr int kBarWidth = 30;

std::string formatDuration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string describe(const ProgressReport& report, double seconds) {
  const double share = static_cast<double>(report.done) / static_cast<double>(report.total);
  std::string text = fmt::format("{:3.0f}%", 100 * share);
  if (report.rays > 0)
    text += fmt::format("  {:.1f} Mrays/s", static_cast<double>(report.rays) / seconds * 1e-6);
  text += "  " + formatDuration(seconds * (1 - share) / share) + " left";
  return text;
}

}  // namespace

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      shown_(start_) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::setLabel(std::string label) {
  label_ = std::move(label);
  if (terminal_) shown_ = {};
}

ProgressCallback ProgressBar::callback() {
  return [this](const ProgressReport& report) {
    throwIfInterrupted();
    if (!quiet_ && report.done > 0 && report.total > 0) show(report);
  };
}

void ProgressBar::show(const ProgressReport& report) {
  const Clock::time_point now = Clock::now();
  if (now - shown_ < (terminal_ ? kBetweenBars : kBetweenLines)) return;
  shown_ = now;
  const std::string text = describe(report, Seconds(now - start_).count());
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(kBarWidth * static_cast<double>(report.done) /
                                                 static_cast<double>(report.total));
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    fmt::print(stderr, "\r\x1b[K{} [{}] {}", label_, bar, text);
    drawn_ = true;
  } else {
    fmt::print(stderr, "{}: {}\n", label_, text);
  }
  std::fflush(stderr);
}

}  // namespace shprt
