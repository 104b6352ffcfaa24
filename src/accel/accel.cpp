#include "accel/accel.h"
