#pragma once

namespace kerf {

/// @addtogroup math
/// Points, vectors and matrices: plain numbers. Anything with members x, y and z (glm, Eigen's accessors apart, most
/// engines) converts to a Vec3f or a Vec3d by itself, and these to it where the type is named: `glm::vec3(point)`.
///
///     const kerf::Vec3d centre = glm::dvec3(1, 2, 3);
///     const glm::dvec3 back(centre);
/// @{

/// A type with coordinates x, y and z.
template <class T>
concept HasXyz = requires(const T& t)
{
    static_cast<double>(t.x);
    static_cast<double>(t.y);
    static_cast<double>(t.z);
};

/// A type of three coordinates that can be made of them.
template <class T>
concept IsMadeOfXyz = HasXyz<T> && requires(const T& t)
{
    T{t.x, t.y, t.z};
};

/// A place in a texture, in single precision.
struct Vec2f
{
    /// A coordinate.
    /// @{
    float x = 0.0f, y = 0.0f;
    /// @}

    friend bool operator==(const Vec2f&, const Vec2f&) = default;
};

/// A place in the drawing of a plane, in double precision.
struct Vec2d
{
    /// A coordinate.
    /// @{
    double x = 0.0, y = 0.0;
    /// @}

    friend bool operator==(const Vec2d&, const Vec2d&) = default;
};

/// A position, or a direction, in single precision: as meshes hold them.
struct Vec3f
{
    /// A coordinate.
    /// @{
    float x = 0.0f, y = 0.0f, z = 0.0f;
    /// @}

    /// The origin.
    constexpr Vec3f() = default;
    /// Of three coordinates.
    constexpr Vec3f(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
    /// Of a vector of the caller's own type.
    template <HasXyz T>
    constexpr Vec3f(const T& t) : x(static_cast<float>(t.x)), y(static_cast<float>(t.y)), z(static_cast<float>(t.z))
    {
    }

    /// As the caller's own type.
    template <IsMadeOfXyz T>
    explicit constexpr operator T() const
    {
        return T{static_cast<decltype(T::x)>(x), static_cast<decltype(T::y)>(y), static_cast<decltype(T::z)>(z)};
    }

    friend bool operator==(const Vec3f&, const Vec3f&) = default;
};

/// The same in double precision: as planes hold them.
struct Vec3d
{
    /// A coordinate.
    /// @{
    double x = 0.0, y = 0.0, z = 0.0;
    /// @}

    /// The origin.
    constexpr Vec3d() = default;
    /// Of three coordinates.
    constexpr Vec3d(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
    /// Of a vector of the caller's own type.
    template <HasXyz T>
    constexpr Vec3d(const T& t) : x(static_cast<double>(t.x)), y(static_cast<double>(t.y)), z(static_cast<double>(t.z))
    {
    }

    /// As the caller's own type.
    template <IsMadeOfXyz T>
    explicit constexpr operator T() const
    {
        return T{static_cast<decltype(T::x)>(x), static_cast<decltype(T::y)>(y), static_cast<decltype(T::z)>(z)};
    }

    friend bool operator==(const Vec3d&, const Vec3d&) = default;
};

/// A 3x3 matrix by columns: m[column][row].
struct Mat3d
{
    /// m[column][row]; the identity at first.
    double m[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
};

/// A 4x4 matrix by columns, m[column][row], which is applied to a column (x, y, z, 1): as OpenGL, glm and glTF have it.
/// The last row is 0, 0, 0, 1.
struct Mat4d
{
    /// m[column][row]; the identity at first.
    double m[4][4] = {{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};

    /// From sixteen numbers, column by column: what `glm::value_ptr()` points to.
    template <class T>
    static constexpr Mat4d from_columns(const T* numbers)
    {
        Mat4d result;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) result.m[column][row] = static_cast<double>(numbers[4 * column + row]);
        return result;
    }
};

/// A box along the axes. An empty one has lo > hi; a default one is empty.
struct Box
{
    Vec3f lo{1.0f, 1.0f, 1.0f};     ///< the least coordinates
    Vec3f hi{-1.0f, -1.0f, -1.0f};  ///< the largest ones

    /// Whether nothing lies in it, not even a point.
    constexpr bool is_empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
};

/// @}

}  // namespace kerf
