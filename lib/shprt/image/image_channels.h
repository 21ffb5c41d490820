// Which channels of a picture serve as red, green and blue.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace shprt {

struct ColourChannels {
  std::array<int, 3> index{};      // of red, green and blue; all the same for a grey picture
  std::vector<std::string> notes;  // what was made of the others
};

// From the names of a picture's channels (at least one): R, G, B or Red, Green, Blue in any order and behind
// any layer's name, or Y; else by position. Where names are to be trusted, as in OpenEXR files, several
// channels without a colour among them are refused. file is for messages. Throws Error.
ColourChannels chooseColourChannels(const std::vector<std::string>& names, bool trusted,
                                    const std::string& file);

}  // namespace shprt
