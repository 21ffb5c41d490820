// Text files as plain bytes, whichever encoding an exporter chose.
#pragma once

#include <string>
#include <vector>

namespace shprt {

// A UTF-8 byte-order mark is dropped; UTF-16, with or without its mark, becomes UTF-8 with a note. All else
// comes back as it is.
std::string decodeText(std::string bytes, std::vector<std::string>& notes);

}  // namespace shprt
