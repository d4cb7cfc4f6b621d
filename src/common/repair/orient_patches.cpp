#include "common/repair/orient_patches.h"

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace kerf::core {

namespace {

class PatchFlood
{
public:
    explicit PatchFlood(const LinkedSurface& surface) : surface_(surface), turned_(surface.corners.size(), 0)
    {
        result_.patch.assign(surface.corners.size(), kNoPatch);
    }

    Patches run()
    {
        for (std::uint32_t t = 0; t < surface_.corners.size(); ++t) {
            if (result_.patch[t] != kNoPatch) continue;
            flood(t);
            ++patch_count_;
        }
        choose_smaller_part();
        return std::move(result_);
    }

private:
    static constexpr std::uint32_t kNoPatch = std::numeric_limits<std::uint32_t>::max();

    struct Step
    {
        std::uint32_t triangle;
        std::uint8_t turned;  ///< relative to the patch's first triangle
    };

    void enter(Step step)
    {
        if (result_.patch[step.triangle] != kNoPatch) return;
        result_.patch[step.triangle] = patch_count_;
        turned_[step.triangle] = step.turned;
        agreeing_.push_back(step.triangle);
    }

    void flood(std::uint32_t first)
    {
        agreeing_.clear();
        disagreeing_.clear();
        enter({first, 0});
        std::size_t next_agreeing = 0, next_disagreeing = 0;
        while (true) {
            if (next_agreeing < agreeing_.size())
                visit(agreeing_[next_agreeing++]);
            else if (next_disagreeing < disagreeing_.size())
                enter(disagreeing_[next_disagreeing++]);
            else
                break;
        }
    }

    void visit(std::uint32_t t)
    {
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t across = surface_.opposite[h];
            if (across == kNone) continue;
            if (surface_.start(h) != surface_.start(across))
                enter({across / 3, turned_[t]});
            else if (result_.patch[across / 3] == kNoPatch)
                disagreeing_.push_back({across / 3, static_cast<std::uint8_t>(1 - turned_[t])});
        }
    }

    void choose_smaller_part()
    {
        std::vector<std::array<std::uint32_t, 2>> sizes(patch_count_, {0, 0});
        for (std::size_t t = 0; t < turned_.size(); ++t) ++sizes[result_.patch[t]][turned_[t]];
        for (std::size_t t = 0; t < turned_.size(); ++t) {
            // In a draw the first triangle stays as it is.
            const auto& [kept, turned] = sizes[result_.patch[t]];
            turned_[t] = static_cast<std::uint8_t>(turned_[t] != (turned > kept ? 1 : 0));
        }
        result_.flip = std::move(turned_);
    }

    const LinkedSurface& surface_;
    Patches result_;
    Buffer<std::uint8_t> turned_;
    std::uint32_t patch_count_ = 0;
    std::vector<std::uint32_t> agreeing_;
    std::vector<Step> disagreeing_;
};

}  // namespace

Patches orient_patches(const LinkedSurface& surface)
{
    return PatchFlood(surface).run();
}

}  // namespace kerf::core
