#include "common/mesh_facts.h"
