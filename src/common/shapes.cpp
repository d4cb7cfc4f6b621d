#include "common/shapes.h"
