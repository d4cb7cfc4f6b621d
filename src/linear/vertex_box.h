#pragma once

#include <cstring>
#include <limits>

#include "common/mesh/box.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf::core::linear {

/// The box around vertices that are added one at a time, in a few instructions each: four floats are compared at once,
/// the three of the position and one more that is ignored.
class VertexBox
{
public:
    void add(const Vertex& vertex)
    {
        Lanes p;
        std::memcpy(&p, &vertex, sizeof(p));
        lo_ = p < lo_ ? p : lo_;
        hi_ = hi_ < p ? p : hi_;
    }

    Box box() const { return {{lo_[0], lo_[1], lo_[2]}, {hi_[0], hi_[1], hi_[2]}}; }

private:
    typedef float Lanes __attribute__((vector_size(4 * sizeof(float))));
    static constexpr float kEnd = std::numeric_limits<float>::infinity();
    Lanes lo_{kEnd, kEnd, kEnd, kEnd}, hi_{-kEnd, -kEnd, -kEnd, -kEnd};
};

}  // namespace kerf::core::linear
