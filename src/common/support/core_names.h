#pragma once

// The library's own code is in namespace kerf::core; kerf itself has what programs use (include/kerf). The project's
// programs and tests that look inside find core's names in kerf, too. Files that include both have to say which they
// mean, and define KERF_NO_CORE_NAMES.

namespace kerf::core {
}

#ifndef KERF_NO_CORE_NAMES
namespace kerf {
using namespace core;
}
#endif
