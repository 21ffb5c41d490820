#include "shprt/mesh/text_encoding.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace shprt {
namespace {

void appendUtf8(std::string& text, std::uint32_t codePoint) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | (codePoint >> shift & 0x3f)); };
  if (codePoint < 0x80) {
    text += static_cast<char>(codePoint);
  } else if (codePoint < 0x800) {
    text += static_cast<char>(0xc0 | codePoint >> 6);
    tail(0);
  } else if (codePoint < 0x10000) {
    text += static_cast<char>(0xe0 | codePoint >> 12);
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xf0 | codePoint >> 18);
    tail(12), tail(6), tail(0);
  }
}

// Half a surrogate pair becomes U+FFFD, the sign for what cannot be read.
std::string fromUtf16(std::string_view bytes, bool bigEndian) {
  const auto unitAt = [&](std::size_t i) -> std::uint32_t {
    if (i + 1 >= bytes.size()) return 0;
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    return bigEndian ? first * 256u + second : second * 256u + first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const std::uint32_t unit = unitAt(i), following = unitAt(i + 2);
    if (unit >= 0xd800 && unit < 0xdc00 && following >= 0xdc00 && following < 0xe000) {
      appendUtf8(text, 0x10000 + ((unit - 0xd800) << 10) + (following - 0xdc00));
      i += 2;
    } else {
      appendUtf8(text, unit >= 0xd800 && unit < 0xe000 ? 0xfffd : unit);
    }
  }
  return text;
}

}  // namespace

std::string decodeText(std::string bytes, std::vector<std::string>& notes) {
  if (bytes.starts_with("\xef\xbb\xbf")) return bytes.substr(3);
  const std::string_view view = bytes;
  const bool marked = view.starts_with("\xff\xfe") || view.starts_with("\xfe\xff");
  const bool looksBig = view.size() >= 4 && view[0] == 0 && view[1] != 0 && view[2] == 0 && view[3] != 0;
  const bool looksLittle = view.size() >= 4 && view[0] != 0 && view[1] == 0 && view[2] != 0 && view[3] == 0;
  if (!marked && !looksBig && !looksLittle) return bytes;
  notes.push_back("UTF-16 text converted");
  return fromUtf16(view.substr(marked ? 2 : 0), marked ? view[0] == '\xfe' : looksBig);
}

}  // namespace shprt
