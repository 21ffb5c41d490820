// What a scene's materials alone tell about the effects it calls for.
#pragma once

#include "shprt/scene/scene.h"

namespace shprt {

struct MaterialEvidence {
  bool grey = true;         // whether every surface that can reflect, receiver or blocker, is grey
  double colourSpread = 0;  // RMS over receivers and channels of albedo's difference from the mean of its
                            // channels, over its RMS; without textures between vertices
  double brightest = 0;     // the most that any surface reflects, in any channel; 1 where a texture may tell
  bool emits = false;       // whether any material in use sends out light
  bool receiversEmit = false;
  // Shares of the receivers' area whose materials have it, and the part it has of all that the receivers
  // reflect diffusely or with it, weighted by area, mean over channels.
  double glossyArea = 0, glossyShare = 0;
  double translucentArea = 0, translucentShare = 0;
};

MaterialEvidence examineMaterials(const Scene& scene);

}  // namespace shprt
