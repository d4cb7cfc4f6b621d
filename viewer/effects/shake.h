#pragma once

#include <glm/vec2.hpp>

namespace kerf::effects {

/// A camera that is hit: the picture trembles, less and less, and comes to rest where it was.
class Shake
{
public:
    /// Farthest that the picture is moved, metres on the stage: a fortieth of its height.
    static constexpr float kFarthest = 0.2f;

    /// @param force  0 to 1; several hits add up to at most 1
    void hit(float force);
    void advance(float seconds);
    void rest() { force_ = 0.0f; }

    /// Where the picture is now, metres on the stage.
    glm::vec2 offset() const;
    bool at_rest() const { return force_ <= 0.0f; }

private:
    float force_ = 0.0f;
    float time_ = 0.0f;
};

}  // namespace kerf::effects
