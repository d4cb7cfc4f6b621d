#include "viewer/sim/input_queue.h"

#include <algorithm>
#include <utility>

namespace kerf::sim {

namespace {

template <typename Events>
auto place_of(Events& events, Microseconds time)
{
    return std::upper_bound(events.begin(), events.end(), time,
                            [](Microseconds t, const InputEvent& other) { return t < other.time; });
}

}  // namespace

void InputQueue::push(InputEvent event)
{
    if (records_) recorded_.insert(place_of(recorded_, event.time), event);
    const auto place = place_of(waiting_, event.time);
    waiting_.insert(place, std::move(event));
}

std::optional<InputEvent> InputQueue::take(Tick now)
{
    if (waiting_.empty() || tick_of(waiting_.front().time) > now) return std::nullopt;
    std::optional<InputEvent> event = std::move(waiting_.front());
    waiting_.pop_front();
    return event;
}

std::string_view InputQueue::argument_of(std::string_view verb, Tick last) const
{
    std::string_view argument;
    for (const InputEvent& event : waiting_) {
        if (tick_of(event.time) > last) break;
        if (event.kind != InputKind::command) continue;
        const std::string_view text(event.text);
        if (text.starts_with(verb) && text.size() > verb.size() && text[verb.size()] == ' ')
            argument = text.substr(verb.size() + 1);
    }
    return argument;
}

void InputQueue::hash(StateHash& hash) const
{
    for (const InputEvent& event : waiting_) {
        hash.add(event.time);
        hash.add(std::uint64_t(event.kind));
        hash.add(event.position.x);
        hash.add(event.position.y);
        hash.add(std::string_view(event.text));
    }
}

}  // namespace kerf::sim
