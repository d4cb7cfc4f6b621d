#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/cutting/cut.h"

namespace kerf::core::test {

/// A back end under test.
struct NamedBackend
{
    std::string name;  ///< as GoogleTest wants it: letters, digits and underscores
    std::function<std::unique_ptr<Backend>()> make;
};

/// How GoogleTest prints one in failure messages.
inline void PrintTo(const NamedBackend& backend, std::ostream* out)
{
    *out << backend.name;
}

/// Every back end but halfedge/cgal, and every vertex lookup, the half-edge back end last: the contract tests run over all of them. In a
/// brief build without the two lookups that give the bytes of `hash`
/// (VertexLookup.ScanAndTwoBucketsGiveTheBytesOfHash).
const std::vector<NamedBackend>& backends();

/// One vertex lookup of the baseline, and the half-edge back end if it is built: enough where only surfaces matter,
/// which are equal bit for bit.
std::vector<NamedBackend> one_of_each_kind();

}  // namespace kerf::core::test
