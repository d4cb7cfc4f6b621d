#pragma once

#include "maker/lathe.h"

namespace kerf::maker {

/// The foot that all chess pieces stand on, 7 bands, from the rim of its underside up to radius 0.74, height 0.62.
Profile chess_base();

}  // namespace kerf::maker
