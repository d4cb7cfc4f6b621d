#pragma once

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace kerf::core {

/// `order` becomes the numbers below `count` by key(number), those of equal keys as they follow one another. What
/// std::stable_sort gives, but that takes memory even for one number. O(count log count).
template <class Number, class Key>
void order_by(std::vector<Number>& order, std::size_t count, Key key)
{
    order.resize(count);
    std::iota(order.begin(), order.end(), Number{0});
    std::sort(order.begin(), order.end(),
              [&](Number a, Number b) { return std::make_tuple(key(a), a) < std::make_tuple(key(b), b); });
}

}  // namespace kerf::core
