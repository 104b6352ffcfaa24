// What the header of the same name says.
#include "radiosity/form_factors.h"
