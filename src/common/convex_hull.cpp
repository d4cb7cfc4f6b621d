#include "common/convex_hull.h"
