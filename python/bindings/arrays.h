#pragma once

#include <kerf/math.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

// Numbers of the library as NumPy arrays that nobody can write to, without a copy. Whoever holds the array holds what the
// numbers belong to.

namespace kerf::python {

/// What a view holds. Let go of without Python's lock: a mesh of a million triangles takes its time.
template <class Owner>
pybind11::capsule hold(Owner owner)
{
    return pybind11::capsule(new Owner(std::move(owner)), [](void* held) {
        const pybind11::gil_scoped_release unlocked;
        delete static_cast<Owner*>(held);
    });
}

/// `count` rows of `width` elements, `stride` bytes from row to row. Of width 0: `count` elements.
inline pybind11::array view(const pybind11::dtype& type, const void* data, std::size_t count, std::size_t width,
                            std::size_t stride, const pybind11::capsule& owner)
{
    std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(count)};
    std::vector<pybind11::ssize_t> strides{static_cast<pybind11::ssize_t>(stride)};
    if (width > 0) {
        shape.push_back(static_cast<pybind11::ssize_t>(width));
        strides.push_back(type.itemsize());
    }
    pybind11::array array(type, std::move(shape), std::move(strides), data, owner);
    pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

inline pybind11::array view(std::span<const Vec3f> rows, const pybind11::capsule& owner)
{
    return view(pybind11::dtype::of<float>(), rows.data(), rows.size(), 3, sizeof(Vec3f), owner);
}

inline pybind11::array view(std::span<const Vec2f> rows, const pybind11::capsule& owner)
{
    return view(pybind11::dtype::of<float>(), rows.data(), rows.size(), 2, sizeof(Vec2f), owner);
}

template <class T>
pybind11::array view(std::span<const T> numbers, std::size_t width, const pybind11::capsule& owner)
{
    const std::size_t elements = width > 0 ? width : 1;
    return view(pybind11::dtype::of<T>(), numbers.data(), numbers.size() / elements, width, elements * sizeof(T),
                owner);
}

/// Numbers that are all ones where there is none, such as kNone, as signed ones: -1. (Below 2^31 both are the same.)
inline pybind11::array signed_view(std::span<const std::uint32_t> numbers, const pybind11::capsule& owner)
{
    return view(pybind11::dtype::of<std::int32_t>(), numbers.data(), numbers.size(), 0, sizeof(std::uint32_t), owner);
}

/// A copy: few numbers.
inline pybind11::array_t<double> small_array(Vec3d v)
{
    const double numbers[] = {v.x, v.y, v.z};
    return pybind11::array_t<double>(3, numbers);
}

inline pybind11::array_t<double> small_array(const Box& box)
{
    pybind11::array_t<double> result({2, 3});
    double* to = result.mutable_data();
    for (const Vec3f& corner : {box.lo, box.hi}) {
        *to++ = static_cast<double>(corner.x);
        *to++ = static_cast<double>(corner.y);
        *to++ = static_cast<double>(corner.z);
    }
    return result;
}

}  // namespace kerf::python
