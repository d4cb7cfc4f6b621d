#include "common/io/mesh_file.h"
