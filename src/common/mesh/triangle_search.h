#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "common/mesh/box.h"

namespace kerf::core {

/// Triangles as an object has them, for who needs those in some places only.
class TriangleSearch
{
public:
    using Corners = std::array<glm::vec3, 3>;

    virtual ~TriangleSearch() = default;
    /// The smallest box around all of them.
    virtual Box bounds() const = 0;
    /// Calls `visit` with some triangles at a time, until it has seen each whose own box is wanted; others may come, too.
    /// A box that is wanted is wanted as a part of a larger one.
    virtual void find(const std::function<bool(const Box&)>& is_wanted,
                      const std::function<void(std::span<const Corners>)>& visit) const = 0;

protected:
    TriangleSearch() = default;
    TriangleSearch(const TriangleSearch&) = default;
    TriangleSearch& operator=(const TriangleSearch&) = default;
};

}  // namespace kerf::core
