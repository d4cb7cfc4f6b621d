#include "viewer/app/inspect/throw_choices.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"

namespace kerf::app {

namespace {

bool is_baseline(const std::string& backend)
{
    return backend.starts_with("baseline");
}

/// The element after `current`, round and round.
template <typename Range, typename Value>
auto next_of(const Range& range, const Value& current)
{
    auto found = std::find(std::begin(range), std::end(range), current);
    if (found != std::end(range)) ++found;
    return found == std::end(range) ? *std::begin(range) : *found;
}

}  // namespace

std::string ThrowChoices::next_backend()
{
    const std::string current = simulation_.backend_to_come();
    if (is_baseline(current)) last_baseline_ = current;
    const auto& names = sim::backend_names();
    const auto other = std::find_if(names.begin(), names.end(), [](const auto& name) { return !is_baseline(name); });
    const std::string wanted = !is_baseline(current) || other == names.end() ? last_baseline_ : *other;
    simulation_.command("backend " + wanted);
    return "the next throw is cut by " + sim::known_back_end(wanted);
}

std::string ThrowChoices::next_lookup()
{
    std::vector<std::string> lookups;
    for (const std::string& name : sim::backend_names())
        if (is_baseline(name)) lookups.push_back(name);
    const std::string wanted = next_of(lookups, simulation_.backend_to_come());
    simulation_.command("backend " + wanted);
    return "the next throw is cut by " + wanted;
}

std::string ThrowChoices::next_proxy()
{
    const std::string wanted(sim::proxy_name(next_of(sim::kProxyKinds, simulation_.proxy_to_come())));
    simulation_.command("proxy " + wanted);
    return "the next throw collides as " + wanted;
}

std::string ThrowChoices::next_gesture()
{
    const bool to_segment = simulation_.gesture_to_come() == sim::Gesture::blade;
    const sim::Gesture wanted = to_segment ? sim::Gesture::segment : sim::Gesture::blade;
    simulation_.command("gesture " + std::string(name_of(wanted)));
    return to_segment ? "cuts on release, along the straight line" : "cuts while moving";
}

}  // namespace kerf::app
