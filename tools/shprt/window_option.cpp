#include "window_option.h"

namespace shprt {

CLI::Option* addWindow(CLI::App& app, Window& window) {
  return addParsed(
             app, "--window", "NAME", [&window](const std::string& text) { window = parseWindow(text); },
             "Against ringing: none | hann | lanczos | auto (the least that keeps the irradiance "
             "non-negative)")
      ->default_str("none");
}

}  // namespace shprt
