// Texts as one word of a command line that can be pasted into a shell.
#pragma once

#include <string>

namespace shprt {

// In quotes where a shell would read it otherwise.
std::string quoteForShell(const std::string& text);

}  // namespace shprt
