// Mip chains. In: a picture. Out: the picture and its halvings down to 1x1, level l of max(1, width >> l) by max(1, height >> l) pixels.
#pragma once

#include "image/image.h"

#include <vector>

namespace lightbench {

// Every pixel of a level is the mean of the level above over the pixel's area, also where a side is odd and areas cut through pixels: the
// mean of the picture is the same on every level, within 1e-6 of its largest magnitude (unit test Mips.MeanIsPreserved; TX-7).
std::vector<ImageF> mip_chain(const ImageF& image);

} // namespace lightbench
