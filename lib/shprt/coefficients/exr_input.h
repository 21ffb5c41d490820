// Opening an OpenEXR file that nobody vouches for.
#pragma once

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <filesystem>
#include <memory>
#include <string>

namespace shprt {

// Throws Error when the file is missing, no OpenEXR file, or damaged in its headers or chunk tables.
std::unique_ptr<Imf::MultiPartInputFile> openExr(const std::filesystem::path& path);

// Of the data window, in pixels; OpenEXR has checked that it is not empty.
int width(const Imf::Header& header);
int height(const Imf::Header& header);

// "B,G,R": the channels in the order of the file, which is alphabetical.
std::string channelNames(const Imf::Header& header);

}  // namespace shprt
