#include "common/outgoing_edges.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kerf {
namespace {

std::uint32_t number(std::uint32_t below)
{
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint32_t>(0, below));
}

struct Edge
{
    std::uint32_t from, tag;
    bool is_used = false;
};

RC_GTEST_PROP(OutgoingEdges, GiveWhatALoopOverAllEdgesGives, ())
{
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    const std::uint32_t points = 1 + number(5), tags = 1 + number(4), count = number(60);
    std::vector<Edge> edges;
    for (std::uint32_t i = 0; i < count; ++i) edges.push_back({number(points), number(tags)});
    OutgoingEdges outgoing(
        points, edges.size(), [&](std::uint32_t i) { return edges[i].from; },
        [&](std::uint32_t i) { return edges[i].tag; });
    for (std::uint32_t point = 0; point < points; ++point) {
        std::vector<std::uint32_t> leaving;
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            if (edges[i].from == point) leaving.push_back(i);
        RC_ASSERT(outgoing.leaving(point) == leaving);
    }
    for (std::uint32_t step = 0; step < 2 * count; ++step) {
        const std::uint32_t point = number(points), tag = number(tags);
        std::uint32_t expected = kNone;
        for (std::uint32_t i = 0; i < edges.size() && expected == kNone; ++i)
            if (edges[i].from == point && edges[i].tag == tag && !edges[i].is_used) expected = i;
        RC_ASSERT(outgoing.next(point, tag) == expected);
        // The one that was given is used, or any other.
        const std::uint32_t used = expected != kNone && number(2) == 0 ? expected : number(count);
        edges[used].is_used = true;
        outgoing.use(used);
        RC_ASSERT(outgoing.is_used(used));
    }
}

}  // namespace
}  // namespace kerf
