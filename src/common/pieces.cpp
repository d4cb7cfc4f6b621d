#include "common/pieces.h"
