#pragma once

#include <cstddef>
#include <string>

namespace kerf::bench {

/// What a library made of the planes of one mesh.
struct PeerRow
{
    std::string peer, mesh;
    std::size_t triangles = 0, planes = 0, right = 0;
    double ms = 0.0;                       ///< for a plane: both sides of a cut, or a section; processor time; mean
    double least_ms = 0.0, most_ms = 0.0;  ///< of the planes, each of which is asked for once
    std::string verdict;                   ///< "right", or what is the matter and how often
};

}  // namespace kerf::bench
