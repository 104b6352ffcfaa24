// What all ray functions share.
#ifndef LIGHTBENCH_LIB_RAY
#define LIGHTBENCH_LIB_RAY

const float kNoHit = 3.4028235e38; // the t of a ray that meets nothing

#endif
