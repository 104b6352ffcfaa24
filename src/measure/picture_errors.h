// How far a picture lies from its reference, by every metric that a report knows.
#pragma once

#include "image/image.h"
#include "measure/report.h"

namespace lightbench {

// "rmse", "relative rmse" and "maximum" of linear radiance, "flip" of what a screen shows at that exposure. A relative error of something
// other than a black reference is infinite. Pixels that are not finite make all of them infinite: no figure of the rest would be honest.
Errors picture_errors(const ImageF& reference, const ImageF& picture, float exposure = 0);

} // namespace lightbench
