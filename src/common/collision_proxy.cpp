#include "common/collision_proxy.h"
