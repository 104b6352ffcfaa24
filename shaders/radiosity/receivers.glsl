// Elements as they receive, and their corners. In: tables. Out: Receiver, corners.
#ifndef LIGHTBENCH_RADIOSITY_RECEIVERS_GLSL
#define LIGHTBENCH_RADIOSITY_RECEIVERS_GLSL

#include "fetch.glsl"
#include "shared/radiosity.h"

FETCH_TABLE(receivers, FETCH_RECEIVERS, 58)

Receiver read_receiver(uint element) {
    uint at = kReceiverTexels * element;
    uvec4 a = fetch_receivers(at), b = fetch_receivers(at + 1u), c = fetch_receivers(at + 2u);
    return Receiver(uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), c.w);
}

#endif
