#include "common/assemble.h"
