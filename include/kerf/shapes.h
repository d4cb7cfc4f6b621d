#pragma once

#include <kerf/export.h>
#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <cstddef>
#include <cstdint>

namespace kerf {

/// @addtogroup shapes
/// Generated meshes to try things with. Component `shapes`.
/// @{

/// The most triangles that a shape is asked for.
inline constexpr std::uint64_t kMostShapeTriangles = 16'000'000;

/// Options of make_shape().
struct ShapeOptions
{
    std::uint64_t seed = 1;              ///< only the asteroid uses it
    const Material* material = nullptr;  ///< of all triangles; null: the shape's own
    /// Called from the thread that makes the shape, with the share that is done: 0 at the start, about 0.4 if the
    /// triangles are there and are to be joined to a mesh, 1 at the end. Returns false to stop; the status is
    /// `cancelled` then. Must not throw: that ends the program. May be null.
    bool (*progress)(void* user, double share) = nullptr;
    void* user = nullptr;  ///< for `progress`
};

/// A closed shape by its name with about so many triangles (at least what it needs; of more than kMostShapeTriangles it
/// has about that many).
/// O(n log n). Status: `invalid_argument` for a name that is none of shape_name(), `cancelled`, `out_of_memory`.
///
///     const kerf::Result<kerf::Mesh> rock = kerf::make_shape("asteroid", 100'000);
///     if (!rock) return complain(rock.reason());
KERF_API Result<Mesh> make_shape(const char* name, std::uint64_t triangles, const ShapeOptions& options = {}) noexcept;

/// "asteroid", "bowl", "box", ...; null beyond the last.
KERF_API const char* shape_name(std::size_t i) noexcept;

/// Triangles, and a plane whose section is hard for a cutter: where a step is quadratic, the cut takes minutes. For
/// programs that measure the worst that a cut can cost.
class KERF_API HardSection
{
public:
    /// An empty one; what is moved from is empty, too.
    /// @{
    HardSection() noexcept = default;
    HardSection(HardSection&& other) noexcept;
    HardSection& operator=(HardSection&& other) noexcept;
    /// @}
    ~HardSection();

    /// The triangles as Mesh::make() takes them, closed. Valid as long as the section is.
    MeshInput input() const noexcept;
    /// Of an empty section z = 0.
    Plane plane() const noexcept;

    /// @cond For the library itself.
    struct Data;
    explicit HardSection(Data* data) noexcept : data_(data) {}
    /// @endcond

private:
    Data* data_ = nullptr;
};

/// A hard section by its name. `size` is about how many loops it has, or points of one loop, or triangles in the plane:
/// what makes it hard. O(size). Status: `invalid_argument` for a name that is none of hard_section_name(),
/// `out_of_memory`.
KERF_API Result<HardSection> make_hard_section(const char* name, std::uint32_t size) noexcept;

/// "bricks", "checkerboard", "comb", ...; null beyond the last.
KERF_API const char* hard_section_name(std::size_t i) noexcept;

/// @}

}  // namespace kerf
