#include "window_option.h"

namespace shprt {

CLI::Option* addWindow(CLI::App& app, Window& window) {
  return addParsed(
             app, "--window", "NAME", [&window](const std::string& text) { window = parseWindow(text); },
             "Against ringing: none | hann | lanczos | gaussian | auto (the least that keeps the irradiance "
             "non-negative) | auto-radiance (the same for the radiance)")
      ->default_str("none");
}

}  // namespace shprt
