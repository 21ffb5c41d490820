// Pictures out, through memory.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/image/image.h"

namespace shprt {

void saveImage(const std::filesystem::path& path, const Image& image) {
  const std::string name = path.string();
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool linear = suffix == ".exr" || suffix == ".hdr";
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) {
    OIIO::geterror();  // OpenImageIO prints what nobody fetched
    throw Error(name, "has a suffix that is no image format", "use .png, .exr, .hdr or .jpg");
  }
  OIIO::ImageSpec spec(image.width, image.height, 3, linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  if (suffix == ".exr") spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  // Formats hide what goes wrong while a file is closed; written to memory first, nothing can, and the file
  // is ours to write.
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->supports("ioproxy") || !output->set_ioproxy(&memory))
    throw Error(name, "is of a format that cannot be written here", "use .png, .exr, .hdr or .jpg");
  bool good = output->open(name, spec);
  good = good && output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data());
  good = output->close() && good;
  if (!good) throw Error(name, "cannot be encoded: " + output->geterror().substr(0, 200));
  writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace shprt
