#pragma once

#include <kerf/object.h>

#include <optional>

namespace kerf {

/// @addtogroup cutting
/// @{

/// How the cells of a fracture lie.
enum class FracturePattern : unsigned char
{
    uniform = 0,    ///< anywhere in the object
    impact = 1,     ///< the nearer to a point, the smaller: what a blow does to glass or stone
    crack = 2,      ///< the nearer to a plane, the smaller: the object parts there, in crumbs
    grid = 3,       ///< in rows and layers, each moved a little
    splinters = 4,  ///< long, along a direction: wood
};

/// Options of fracture().
struct FractureOptions
{
    FracturePattern pattern = FracturePattern::uniform;  ///< a number that is none of them is `uniform`
    /// How many. A cell that reaches into several parts of an object, the legs of a table, makes several pieces. A grid
    /// has as many rows and layers as give about this number.
    std::uint32_t cells = 50;
    std::uint64_t seed = 0;  ///< another one, other cells; the same one, the same bytes, on every machine
    /// Of an impact; on the plane of a crack; in the middle of splinters. Mesh coordinates; not set: the middle of the box.
    std::optional<Point> at;
    Normal direction{0, 1, 0};  ///< across the plane of a crack; along splinters
    /// Sites of the cells instead of a pattern: each place belongs to the nearest one. Mesh coordinates, within a million
    /// times the object's size.
    std::span<const Vec3d> sites;
    /// A piece that is smaller is joined to the largest of its neighbours, until it is not. The mesh's unit, cubed.
    double least_volume = 0.0;
    std::uint32_t material = kNone;  ///< of the inside; a number that the object lacks: one is added, "cap"
    double uv_scale = 1.0;           ///< uv of the inside for each unit of length
    /// Called now and then from the thread that asks, with the share that is done: 0 first, 1 last. Returns false to
    /// stop; fracture() then says `cancelled`. Must not throw: that ends the program. May be null.
    bool (*progress)(void* user, double share) = nullptr;
    void* user = nullptr;  ///< for `progress`
};

/// Where two pieces touch: what holds them together until something breaks it. Both are closed there by the same
/// triangles, those of the second turned over.
struct FractureBond
{
    std::uint32_t first = 0;   ///< the number of a piece
    std::uint32_t second = 0;  ///< of another one, which is larger
    double area = 0.0;         ///< the mesh's unit, squared
    Vec3d centre;              ///< of that area; mesh coordinates
    Vec3d normal;              ///< from the first to the second, of length 1; 0 if the area bends all around
};

/// The pieces of an object that was broken, and how they hang together.
///
///     kerf::FractureOptions options;
///     options.pattern = kerf::FracturePattern::impact;
///     options.at = kerf::Point(0.2, 1.1, 0);
///     kerf::Fracture broken = kerf::fracture(object, options);
///     for (std::size_t i = 0; kerf::Object* piece = broken.piece(i); ++i) throw_away(std::move(*piece));
///     for (const kerf::FractureBond& bond : broken.bonds()) glue(bond.first, bond.second, bond.area);
class [[nodiscard]] KERF_API Fracture
{
public:
    Status status() const noexcept { return status_; }  ///< fracture() lists them
    /// Why there are no pieces, in one sentence; "" if there are. Never null; valid for ever.
    const char* reason() const noexcept { return refusal_; }

    std::size_t count() const noexcept;  ///< of pieces
    /// Piece i, in the order of their first cells; null beyond the last. Several of one cell come in an order that depends on
    /// the back end.
    Object* piece(std::size_t i) noexcept;
    /// The cells that a piece consists of, ascending: one, unless small ones were joined. Empty beyond the last piece.
    std::span<const std::uint32_t> cells(std::size_t i) const noexcept;

    /// Ascending by pieces. Valid until this is moved from or ends.
    std::span<const FractureBond> bonds() const noexcept;
    /// Of all cells, also those in which nothing of the object lies. Sites that lay badly, on a lattice or a sphere, were
    /// moved: by ten millionths of the object's size, or more if that is not enough. Valid as bonds() is.
    std::span<const Vec3d> sites() const noexcept;

    /// One without pieces; what is moved from is such a one.
    /// @{
    Fracture() noexcept;
    Fracture(Fracture&& other) noexcept;
    Fracture& operator=(Fracture&& other) noexcept;
    /// @}
    ~Fracture();

    /// @cond For the library itself.
    struct Data;
    /// @endcond

private:
    friend struct FractureMaker;
    Data* data_ = nullptr;
    Status status_ = Status::done;
    const char* refusal_ = "";
};

/// Breaks a closed object into the cells of points (a Voronoi diagram), whatever its shape: docs/fracture.md says how. Where
/// the diagram meets the surface is one rounded point for all pieces, and each contact is closed once, so that the pieces
/// fill the object without a gap. They are objects of the same back end, with all attributes. The object stays as it is, and
/// shares buffers with none of them.
///
/// Pieces of the half-edge back end share buffers with one another if the object has 20 000 triangles or more, as those of
/// a cut do (Object::shares_buffers_with()): they are uploaded once, and who keeps few of many says compact() to those when
/// they are `is_scattered()`, which lets go of the rest; detach() parts a piece from the others in any case. Some are made
/// alone all the same: those in which contacts do not hang together, and those in which rounding has made points coincide.
///
/// Costs a copy of memory and O(k log(n / k) + k log k) with the half-edge back end, for n triangles, k of them in leaves of
/// its tree at the borders of cells or at contacts; pieces that are made alone, small objects and the linear back end O(n + k
/// log k), and the preparing of those pieces.
///
/// Status: `done`; `invalid_argument` (an empty object, no cell, a number that is not finite, a direction without one, a site
/// too far away);
/// `invalid_mesh` (the object is open, has no inside, or its surface passes through itself where cells meet);
/// `cancelled`; `out_of_memory`. All but the first have no pieces.
KERF_API Fracture fracture(const Object& object, const FractureOptions& options = {}) noexcept;

/// @}

}  // namespace kerf
