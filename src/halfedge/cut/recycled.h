#pragma once

#include <cstddef>
#include <vector>

namespace kerf::core::halfedge {

/// A vector whose elements are used again and again without being made anew: add() returns one as it was left.
template <class T>
class Recycled
{
public:
    T& add()
    {
        if (size_ == items_.size()) items_.emplace_back();
        return items_[size_++];
    }
    void clear() { size_ = 0; }
    /// To a number that is not larger than its size.
    void shorten_to(std::size_t size) { size_ = size; }
    void reserve(std::size_t count)
    {
        if (items_.size() < count) items_.resize(count);
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return items_[i]; }
    const T& operator[](std::size_t i) const { return items_[i]; }
    auto begin() { return items_.begin(); }
    auto end() { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }
    auto begin() const { return items_.begin(); }
    auto end() const { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }

private:
    std::vector<T> items_;
    std::size_t size_ = 0;
};

/// Makes room for so many elements, and touches it. The vector is empty.
template <class T>
void reserve_touched(std::vector<T>& vector, std::size_t count)
{
    if (vector.capacity() >= count) return;
    vector.resize(count);
    vector.clear();
}

}  // namespace kerf::core::halfedge
