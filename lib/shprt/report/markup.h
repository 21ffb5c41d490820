// Text on its way into HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace shprt {

// The text as UTF-8 on one line: control characters become spaces; bytes that are no UTF-8, and code points
// that XML does not allow, become U+FFFD.
std::string plainLine(std::string_view text);

// plainLine with & < > " ' escaped: right as the content of an element and as the value of an attribute.
std::string escapeMarkup(std::string_view text);

}  // namespace shprt
