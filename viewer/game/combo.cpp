#include "viewer/game/combo.h"

#include "viewer/game/game_mode.h"

namespace kerf::game {

std::optional<Combo::Closed> Combo::add(std::uint32_t swipe, sim::Tick now, const glm::dvec2& place)
{
    std::optional<Closed> earlier;
    if (swipe != swipe_ || now - last_ > kComboGap) earlier = close();
    swipe_ = swipe;
    last_ = now;
    ++fruit_;
    sum_of_places_ += place;
    return earlier;
}

std::optional<Combo::Closed> Combo::tick(std::uint32_t swipe, bool pressed, sim::Tick now)
{
    if (fruit_ == 0 || (pressed && swipe == swipe_ && now - last_ <= kComboGap)) return std::nullopt;
    return close();
}

std::optional<Combo::Closed> Combo::close()
{
    std::optional<Closed> closed;
    if (fruit_ >= kSmallestCombo) closed = Closed{fruit_, sum_of_places_ / double(fruit_)};
    fruit_ = 0;
    sum_of_places_ = glm::dvec2(0.0);
    return closed;
}

void Combo::hash(sim::StateHash& hash) const
{
    hash.add(swipe_);
    hash.add(std::int64_t(fruit_));
    hash.add(last_);
    hash.add(sum_of_places_.x);
    hash.add(sum_of_places_.y);
}

}  // namespace kerf::game
