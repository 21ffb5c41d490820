// --window, wherever light can ring.
#pragma once

#include "options.h"
#include "shprt/light/window.h"

namespace shprt {

CLI::Option* addWindow(CLI::App& app, Window& window);

}  // namespace shprt
