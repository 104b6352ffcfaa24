// Contrast of a cell of samples against a threshold (S26). Extremes in, a decision out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_CONTRAST
#define LIGHTBENCH_LIB_CONTRAST

// C = (Imax - Imin) / (Imax + Imin) above a threshold; without the division, whose 0/0 of a black cell is no number (AA-1). What is no
// number compares false: not split; the census of the picture reports it.
// Mitchell 1987, "Generating antialiased images at low sampling densities", sec. 3.
//   high, low   largest and smallest intensity of the cell
// Error: as in real arithmetic unless C is within relative 3 u of the threshold (kernel test ContrastExceeds).
bool contrast_exceeds(float high, float low, float threshold) {
    precise float sum = high + low, difference = high - low, most = threshold * sum;
    return sum > 0.0 && difference > most;
}

#endif
