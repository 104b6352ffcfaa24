// What the header of the same name says.
#include "radiosity/patches.h"
