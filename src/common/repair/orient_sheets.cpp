#include "common/repair/orient_sheets.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <vector>

#include "common/mesh/index.h"
#include "common/repair/halfedges_by_edge.h"

namespace kerf::core {

namespace {

class SheetTurner
{
public:
    SheetTurner(std::uint32_t point_count, std::span<const Triangle> corners) : triangle_count_(corners.size())
    {
        make_sheets(corners);
        find_neighbours(point_count);
    }

    Buffer<std::uint8_t> run()
    {
        const std::int64_t open = count_open([&](std::uint32_t s) { return sheets_[s].strength; });
        make_patches();
        list_uses_of_patches();
        settle();
        const auto chosen = [&](std::uint32_t s) { return sheets_[s].sign * patches_[sheets_[s].patch].strength; };
        if (count_open(chosen) >= open) return {};
        Buffer<std::uint8_t> turned(triangle_count_, 0);
        for (std::uint32_t s = 0; s < sheets_.size(); ++s)
            turn_copies(sheets_[s], chosen(s) - sheets_[s].strength, turned);
        return turned;
    }

private:
    /// Looks at sides of patches, per side, before the search ends. A few are enough, unless thousands of triangles
    /// meet at one edge or no choice closes the open edges.
    static constexpr std::size_t kMostLooks = 256;

    struct Copy
    {
        Triangle points;  ///< in ascending order
        std::uint32_t triangle;
        int direction;  ///< 1 if it goes through its points in that order, otherwise -1

        bool operator<(const Copy& other) const
        {
            return std::tie(points, triangle) < std::tie(other.points, other.triangle);
        }
    };

    struct Sheet
    {
        std::uint32_t first, count;  ///< in copies_
        int strength;
        std::uint32_t patch = kNone;
        int sign = 1;  ///< -1 if its strength is the opposite of its patch's
    };

    /// A place where a sheet, or a patch, meets an edge.
    struct EdgeUse
    {
        std::uint32_t owner, edge;
        int direction;  ///< of a patch: the sum of its sheets'
    };

    struct Patch
    {
        int count;  ///< copies in each sheet
        int strength;
        std::uint32_t size = 0;  ///< sheets
        std::uint32_t first_use = 0, last_use = 0;
    };

    struct Move
    {
        std::uint32_t patch;
        int change;  ///< of its strength
    };

    void make_sheets(std::span<const Triangle> corners)
    {
        for (std::uint32_t t = 0; t < corners.size(); ++t) {
            const auto& [a, b, c] = corners[t];
            if (a == b || b == c || c == a) continue;
            Copy copy{corners[t], t, (a < b) + (b < c) + (c < a) == 2 ? 1 : -1};
            std::sort(copy.points.begin(), copy.points.end());
            copies_.push_back(copy);
        }
        std::sort(copies_.begin(), copies_.end());
        for (std::uint32_t i = 0; i < copies_.size(); ++i) {
            if (i == 0 || copies_[i].points != copies_[i - 1].points) sheets_.push_back({i, 0, 0});
            ++sheets_.back().count;
            sheets_.back().strength += copies_[i].direction;
        }
    }

    /// Two sheets that meet at an edge, without a third, and have the same number of copies are neighbours; other edges
    /// where several meet are hinges.
    void find_neighbours(std::uint32_t point_count)
    {
        Buffer<Triangle> corners;
        for (const Sheet& sheet : sheets_) corners.push_back(copies_[sheet.first].points);
        neighbours_.assign(3 * corners.size(), kNone);
        HalfedgesByEdge(point_count, corners).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
            if (edge.size() == 1 && sheets_[edge[0].halfedge / 3].strength != 0) return;
            if (edge.size() == 2) link(edge[0].halfedge, edge[1].halfedge);
            for (const HalfedgesByEdge::Entry& entry : edge)
                uses_.push_back({entry.halfedge / 3, edge_count_, direction(entry.halfedge)});
            ++edge_count_;
        });
    }

    void link(std::uint32_t a, std::uint32_t b)
    {
        if (sheets_[a / 3].count != sheets_[b / 3].count) return;
        neighbours_[a] = b;
        neighbours_[b] = a;
    }

    /// Along the last side the points of a sheet descend.
    static int direction(std::uint32_t halfedge) { return halfedge % 3 == 2 ? -1 : 1; }

    /// The number of open sides at the edges that count, if sheet s has strength_of(s).
    template <class StrengthOf>
    std::int64_t count_open(StrengthOf&& strength_of) const
    {
        std::vector<std::int64_t> balance(edge_count_, 0);
        for (const EdgeUse& use : uses_) balance[use.edge] += use.direction * strength_of(use.owner);
        return std::accumulate(balance.begin(), balance.end(), std::int64_t{0},
                               [](std::int64_t sum, std::int64_t b) { return sum + std::abs(b); });
    }

    void make_patches()
    {
        std::vector<int> strengths;
        for (std::uint32_t s = 0; s < sheets_.size(); ++s) {
            if (sheets_[s].patch != kNone) continue;
            strengths.clear();
            flood(s, strengths);
            Patch patch{static_cast<int>(sheets_[s].count), best_strength(strengths)};
            patch.size = static_cast<std::uint32_t>(strengths.size());
            patches_.push_back(patch);
        }
    }

    /// Gives the sheets of a patch their signs. Neighbours that cancel already come before others, so that a twisted
    /// patch opens where it is open already.
    void flood(std::uint32_t first, std::vector<int>& strengths)
    {
        struct Step
        {
            std::uint32_t sheet;
            int sign;
        };
        std::vector<std::uint32_t> fitting;
        std::vector<Step> others;
        const auto enter = [&](Step step) {
            Sheet& sheet = sheets_[step.sheet];
            if (sheet.patch != kNone) return;
            sheet.patch = static_cast<std::uint32_t>(patches_.size());
            sheet.sign = step.sign;
            strengths.push_back(step.sign * sheet.strength);
            fitting.push_back(step.sheet);
        };
        enter({first, 1});
        for (std::size_t next = 0, next_other = 0;;) {
            if (next == fitting.size()) {
                if (next_other == others.size()) break;
                enter(others[next_other++]);
                continue;
            }
            const std::uint32_t s = fitting[next++];
            for (std::uint32_t h = 3 * s; h < 3 * s + 3; ++h) {
                const std::uint32_t across = neighbours_[h];
                if (across == kNone || sheets_[across / 3].patch != kNone) continue;
                const int relative = -direction(h) * direction(across);
                const Step step{across / 3, relative * sheets_[s].sign};
                if (sheets_[across / 3].strength == relative * sheets_[s].strength)
                    enter(step);
                else
                    others.push_back(step);
            }
        }
    }

    /// The median turns the fewest over. Of two the larger in size is taken; in a draw the first sheet decides the
    /// sign.
    static int best_strength(std::vector<int>& strengths)
    {
        const int first = strengths.front();
        std::sort(strengths.begin(), strengths.end());
        const int low = strengths[(strengths.size() - 1) / 2], high = strengths[strengths.size() / 2];
        if (std::abs(low) != std::abs(high)) return std::abs(low) > std::abs(high) ? low : high;
        return first < 0 ? low : high;
    }

    /// Lists uses by patch, those of a patch at one edge added up, and computes the balance of each edge.
    void list_uses_of_patches()
    {
        for (const EdgeUse& use : uses_) {
            const Sheet& sheet = sheets_[use.owner];
            uses_of_patches_.push_back({sheet.patch, use.edge, use.direction * sheet.sign});
        }
        std::sort(uses_of_patches_.begin(), uses_of_patches_.end(), [](const EdgeUse& a, const EdgeUse& b) {
            return std::tie(a.owner, a.edge) < std::tie(b.owner, b.edge);
        });
        std::size_t count = 0;
        for (const EdgeUse& use : uses_of_patches_) {
            if (count > 0 && uses_of_patches_[count - 1].owner == use.owner &&
                uses_of_patches_[count - 1].edge == use.edge)
                uses_of_patches_[count - 1].direction += use.direction;
            else
                uses_of_patches_[count++] = use;
        }
        uses_of_patches_.resize(count);
        std::erase_if(uses_of_patches_, [](const EdgeUse& use) { return use.direction == 0; });

        balance_.assign(edge_count_, 0);
        patches_at_.assign(edge_count_ + 1, 0);
        for (std::uint32_t i = 0; i < uses_of_patches_.size(); ++i) {
            const EdgeUse& use = uses_of_patches_[i];
            Patch& patch = patches_[use.owner];
            if (patch.last_use == 0) patch.first_use = i;
            patch.last_use = i + 1;
            balance_[use.edge] += std::int64_t{use.direction} * patch.strength;
            ++patches_at_[use.edge + 1];
        }
        std::partial_sum(patches_at_.begin(), patches_at_.end(), patches_at_.begin());
        patch_at_.resize(uses_of_patches_.size());
        std::vector<std::uint32_t> next(patches_at_.begin(), patches_at_.end() - 1);
        for (const EdgeUse& use : uses_of_patches_) patch_at_[next[use.edge]++] = use.owner;
    }

    std::span<const EdgeUse> uses_of(const Patch& patch) const
    {
        return std::span(uses_of_patches_).subspan(patch.first_use, patch.last_use - patch.first_use);
    }

    /// By how much the number of open sides would grow.
    std::int64_t cost(const Patch& patch, int change) const
    {
        std::int64_t cost = 0;
        for (const EdgeUse& use : uses_of(patch)) {
            const std::int64_t before = balance_[use.edge], after = before + std::int64_t{use.direction} * change;
            cost += std::abs(after) - std::abs(before);
        }
        return cost;
    }

    void move(const Move& m)
    {
        Patch& patch = patches_[m.patch];
        open_ += cost(patch, m.change);
        patch.strength += m.change;
        for (const EdgeUse& use : uses_of(patch)) balance_[use.edge] += std::int64_t{use.direction} * m.change;
    }

    void move_and_queue(const Move& m)
    {
        move(m);
        moves_.push_back(m);
        for (const EdgeUse& use : uses_of(patches_[m.patch])) {
            const std::uint32_t first = patches_at_[use.edge], last = patches_at_[use.edge + 1];
            look(last - first);
            for (std::uint32_t i = first; i < last; ++i) queue(patch_at_[i]);
        }
    }

    void queue(std::uint32_t patch)
    {
        if (is_queued_[patch]) return;
        is_queued_[patch] = 1;
        queue_.push_back(patch);
    }

    void look(std::size_t count) { looks_left_ -= std::min(looks_left_, count); }

    /// Moves the queued patches, all but `fixed`, as long as that leaves fewer sides open.
    void descend(std::uint32_t fixed)
    {
        for (std::size_t next = 0; next < queue_.size(); ++next) {
            const std::uint32_t p = queue_[next];
            const Patch& patch = patches_[p];
            is_queued_[p] = 0;
            look(3 * uses_of(patch).size());
            if (p == fixed || looks_left_ == 0) continue;
            int best = 0;
            std::int64_t least = 0;
            for (const int change : {2, -2, -2 * patch.strength}) {
                if (std::abs(patch.strength + change) > patch.count) continue;
                if (const std::int64_t c = cost(patch, change); c < least) best = change, least = c;
            }
            if (best != 0) move_and_queue({p, best});
        }
        queue_.clear();
    }

    /// Makes a move that may open sides, then all that pay. Undoes them and returns false unless fewer sides are open.
    bool try_move(const Move& m)
    {
        const std::int64_t open = open_;
        moves_.clear();
        move_and_queue(m);
        descend(m.patch);
        if (open_ < open) return true;
        while (!moves_.empty()) {
            move({moves_.back().patch, -moves_.back().change});
            moves_.pop_back();
        }
        return false;
    }

    /// Lets patches change their strength, small ones first, until no change pays, nor any two changes of which one
    /// costs something.
    void settle()
    {
        std::vector<std::uint32_t> order(patches_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return patches_[a].size < patches_[b].size; });
        is_queued_.assign(patches_.size(), 0);
        looks_left_ = kMostLooks * uses_of_patches_.size();
        for (const std::uint32_t p : order) queue(p);
        descend(kNone);
        for (std::uint32_t e = 0; e < edge_count_; ++e)
            for (std::uint32_t i = patches_at_[e]; i < patches_at_[e + 1] && std::abs(balance_[e]) > 1; ++i) {
                const Patch& patch = patches_[patch_at_[i]];
                for (const int change : {2, -2})
                    if (looks_left_ > 0 && std::abs(patch.strength + change) <= patch.count)
                        if (try_move({patch_at_[i], change})) break;
            }
    }

    void turn_copies(const Sheet& sheet, int change, Buffer<std::uint8_t>& turned) const
    {
        for (std::uint32_t i = sheet.first + sheet.count; change != 0 && i-- > sheet.first;) {
            const Copy& copy = copies_[i];
            if (copy.direction * change > 0) continue;
            turned[copy.triangle] = 1;
            change += 2 * copy.direction;
        }
    }

    std::size_t triangle_count_;
    std::vector<Copy> copies_;
    std::vector<Sheet> sheets_;
    std::vector<std::uint32_t> neighbours_;  ///< of each side of each sheet, or kNone
    std::vector<EdgeUse> uses_;              ///< of sheets
    std::uint32_t edge_count_ = 0;           ///< those that count
    std::vector<Patch> patches_;
    std::vector<EdgeUse> uses_of_patches_;
    std::vector<std::int64_t> balance_;      ///< of each edge
    std::vector<std::uint32_t> patches_at_;  ///< for each edge the first in patch_at_
    std::vector<std::uint32_t> patch_at_;
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint8_t> is_queued_;
    std::vector<Move> moves_;  ///< since the last one that may open something
    std::int64_t open_ = 0;    ///< compared only
    std::size_t looks_left_ = 0;
};

}  // namespace

Buffer<std::uint8_t> find_turned_sheets(std::uint32_t point_count, std::span<const Triangle> corners)
{
    return SheetTurner(point_count, corners).run();
}

}  // namespace kerf::core
