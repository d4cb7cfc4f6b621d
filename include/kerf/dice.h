#pragma once

#include <kerf/cut.h>

namespace kerf {

/// @addtogroup cutting
/// @{

/// Parallel planes that an object is diced by.
struct DicePlanes
{
    Normal normal;                    ///< across all of them
    std::span<const double> heights;  ///< signed distances from the origin along the normal; in any order
};

/// Options of dice().
struct DiceOptions
{
    CutOptions cut;  ///< of each cut: caps, gap, components; `only` is refused
    /// Called now and then from the thread that asks, with the share that is done: 0 first, 1 last. Returns false to
    /// stop; dice() then says `cancelled`. Must not throw: that ends the program. May be null.
    bool (*progress)(void* user, double share) = nullptr;
    void* user = nullptr;  ///< for `progress`
};

/// The pieces of an object that many planes divide.
///
///     const double at[] = {-0.2, 0.2};
///     const kerf::DicePlanes planes[] = {{kerf::Normal(1, 0, 0), at}, {kerf::Normal(0, 1, 0), at}};
///     kerf::Dice dice = kerf::dice(std::move(object), planes);
///     for (std::size_t i = 0; kerf::Object* piece = dice.piece(i); ++i)
///         keep(std::move(*piece), dice.cell(i)[0], dice.cell(i)[1]);
class [[nodiscard]] KERF_API Dice
{
public:
    Status status() const noexcept { return status_; }  ///< dice() lists them
    /// Why there are no pieces, in one sentence; "" if there are. Never null; valid for ever.
    const char* reason() const noexcept;

    std::size_t count() const noexcept;  ///< of pieces
    /// Piece i, in the order of their cells; null beyond the last. Without CutOptions::components there is one for each
    /// cell that is not empty.
    Object* piece(std::size_t i) noexcept;
    /// Where a piece lies: for each of the planes that were given the number of the layer, 0 below the lowest. Empty
    /// beyond the last piece.
    std::span<const std::uint32_t> cell(std::size_t i) const noexcept;

    std::uint64_t empty_cells() const noexcept { return empty_cells_; }  ///< in which nothing of the object lies
    /// A warning, as of a cut: Cut::caps_exceed_section of any.
    bool caps_exceed_section() const noexcept { return caps_exceed_section_; }
    /// What all cuts have cost.
    const CutStatistics& statistics() const noexcept;

    /// One without pieces; what is moved from is such a one.
    /// @{
    Dice() noexcept;
    Dice(Dice&& other) noexcept;
    Dice& operator=(Dice&& other) noexcept;
    /// @}
    ~Dice();

    /// @cond For the library itself.
    struct Data;
    /// @endcond

private:
    friend struct DiceMaker;
    Data* data_ = nullptr;
    Status status_ = Status::done;
    bool caps_exceed_section_ = false;
    std::uint64_t empty_cells_ = 0;
    const char* refusal_ = "";  ///< what reason() says of an invalid argument
};

/// Cuts an object by many planes, and consumes it. Planes of one direction divide it in halves and halves of these, so
/// that l layers of it cost a linear back end log l looks at its triangles and not l. Pieces and volumes are those of
/// cuts one after the other.
///
/// Status: `done`; `open_section` if the mesh has holes at a cut; `invalid_argument` (as cut(), a normal without a
/// direction, a height that is not finite); `cancelled`; `out_of_memory`. All but the first two have no pieces, and but
/// for `invalid_argument`, which leaves it as it was, the object is gone: dice a clone if it is to be tried again.
KERF_API Dice dice(Object&& object, std::span<const DicePlanes> planes, const DiceOptions& options = {}) noexcept;

/// How many times a linear back end looks at all triangles if it dices by these planes: what PrepareOptions::cuts_expected
/// goes by. O(planes).
KERF_API std::uint32_t cuts_expected(std::span<const DicePlanes> planes) noexcept;

/// @}

}  // namespace kerf
