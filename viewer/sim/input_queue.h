#pragma once

#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "viewer/sim/script.h"
#include "viewer/sim/state_hash.h"

namespace kerf::sim {

/// Input that waits for its tick, in the order of its times; and all of it so far, for who records it.
class InputQueue
{
public:
    explicit InputQueue(bool records) : records_(records) {}

    /// Events of equal time keep their order. O(events that wait)
    void push(InputEvent event);
    /// The first event whose time has come at `now`; empty: none has.
    std::optional<InputEvent> take(Tick now);
    /// What follows `verb` in the last command of it that is carried out by `last`; empty: there is none.
    std::string_view argument_of(std::string_view verb, Tick last) const;
    /// All that was pushed so far, by time; empty unless it is recorded.
    const std::vector<InputEvent>& recorded() const { return recorded_; }
    /// Of what waits.
    void hash(StateHash& hash) const;

private:
    bool records_;
    std::deque<InputEvent> waiting_;
    std::vector<InputEvent> recorded_;
};

}  // namespace kerf::sim
