#include "common/mass_properties.h"
