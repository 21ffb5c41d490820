// Channels by their names.

#include "shprt/image/image_channels.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include "shprt/base/error.h"

namespace shprt {
namespace {

// The end of a channel name like "left.R", in capitals.
std::string baseName(const std::string& channel) {
  std::string name = channel.substr(channel.rfind('.') + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

// The first channel of either name; -1 when there is none.
int find(const std::vector<std::string>& names, std::string_view shortName, std::string_view longName) {
  for (std::size_t channel = 0; channel < names.size(); ++channel) {
    const std::string name = baseName(names[channel]);
    if (name == shortName || name == longName) return static_cast<int>(channel);
  }
  return -1;
}

std::array<int, 3> chooseByName(const std::vector<std::string>& names) {
  const std::array<int, 3> colours = {find(names, "R", "RED"), find(names, "G", "GREEN"),
                                      find(names, "B", "BLUE")};
  if (colours[0] >= 0 && colours[1] >= 0 && colours[2] >= 0) return colours;
  const int luminance = find(names, "Y", "LUMINANCE");
  return {luminance, luminance, luminance};
}

std::string listNames(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 8); ++i)
    list += (i > 0 ? ", " : "") + names[i];
  return names.size() > 8 ? list + ", ..." : list;
}

}  // namespace

ColourChannels chooseColourChannels(const std::vector<std::string>& names, bool trusted,
                                    const std::string& file) {
  ColourChannels chosen{chooseByName(names), {}};
  if (chosen.index[0] < 0) {
    if (trusted && names.size() > 1)
      throw Error(file, "has no channels R, G, B or Y among " + listNames(names),
                  "give a picture with colours");
    chosen.index = names.size() >= 3 ? std::array<int, 3>{0, 1, 2} : std::array<int, 3>{0, 0, 0};
  }
  const bool grey = chosen.index[0] == chosen.index[1];
  if (grey) chosen.notes.push_back("one channel, used for all three colours");
  const std::size_t others = names.size() - (grey ? 1 : 3);
  if (others > 0) {
    chosen.notes.push_back(std::to_string(others) +
                           (others == 1 ? " further channel ignored" : " further channels ignored"));
  }
  return chosen;
}

}  // namespace shprt
