// The rotation kernels for any processor.
#include "shprt/sh/rotation_variants.h"

#define SHPRT_LANE_BYTES 16

#include "shprt/sh/rotation_kernel.h"
#include "shprt/sh/rotation_kernel_low.h"
#include "shprt/sh/rotation_kernel_many.h"
#include "shprt/sh/rotation_kernel_turns.h"

namespace shprt {

const RotationVariant kRotationBaseline = {"baseline",      kScalarLowDegree, isRotationToRounding,
                                           rotateLowKernel, rotateBandKernel, rotateManyBandKernel};

}  // namespace shprt
