#include "baseline/baseline.h"
