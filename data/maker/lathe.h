#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "maker/poly_mesh.h"

namespace kerf::maker {

/// The curve that a lathe turns: radius over height, from the foot upwards, outside on the right.
class Profile
{
public:
    struct Point
    {
        double radius, height;
    };

    Profile(double radius, double height) : points_{{radius, height}} {}

    /// A straight piece, divided into `bands` equal ones.
    Profile& line(double radius, double height, int bands = 1);

    /// A circular arc; `bulge` is the height of the arc over its chord as a share of half the chord, positive to the
    /// right of the way (outwards when going up): 1 is a half circle.
    Profile& arc(double radius, double height, double bulge, int bands);

    /// A smooth curve through `through` (centripetal Catmull-Rom), divided into `bands` pieces of equal length.
    Profile& curve(const std::vector<Point>& through, int bands);

    const std::vector<Point>& points() const { return points_; }

private:
    std::vector<Point> points_;
};

/// One turn of points about the axis, counter-clockwise seen from above, first point on +x.
struct Ring
{
    std::vector<int> points;
    double v = 0;  ///< texture coordinate along the profile
};

/// Turns profiles about the y axis. Band after band is joined by shared points.
class Lathe
{
public:
    Lathe(PolyMesh& mesh, int segments, std::string_view material)
        : mesh_(mesh), segments_(segments), material_(material)
    {
    }

    void use(std::string_view material) { material_ = material; }
    void smooth(int group) { smoothing_ = group; }

    /// Position on the circle of `radius` at `height`; `segment` may lie between two whole numbers.
    glm::dvec3 at(double radius, double height, double segment) const;

    /// A round, level ring; `v` is its texture coordinate along the profile.
    Ring ring(double radius, double height, double v);

    /// A ring of which each point is chosen by its segment number.
    Ring ring(const std::function<glm::dvec3(int)>& point, double v);

    /// Quads between two rings, `upper` to the left of the way round. `wanted` leaves out segments.
    void band(const Ring& lower, const Ring& upper, const std::function<bool(int)>& wanted = {});

    /// Bands along the profile after `first`, which must lie on its first point. Returns the last ring.
    Ring turn(const Ring& first, const Profile& profile);

    /// Closes with triangles to a point on the axis. `up` tells whether the outside is above.
    void fan(const Ring& rim, double height, bool up);
    /// The same to any point.
    void fan(const Ring& rim, const glm::dvec3& apex, bool up);

    /// Closes with one polygon.
    void disc(const Ring& rim, bool up);

    /// The quad between segment `i` and the next of two rings, in the outside order of band().
    void quad(const Ring& lower, const Ring& upper, int i);

private:
    PolyMesh& mesh_;
    int segments_;
    std::string_view material_;
    int smoothing_ = 0;
};

/// Triangles between a polygon and a smaller one inside it, both nearly in one plane and counter-clockwise seen from
/// outside: as many triangles as both have points. O(n^3).
void bridge(PolyMesh& mesh, const std::vector<int>& outer, const std::vector<int>& inner, std::string_view material,
            int smoothing = 0);

/// The points of a ring the other way round.
std::vector<int> reversed(std::vector<int> loop);

}  // namespace kerf::maker
