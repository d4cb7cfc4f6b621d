#include <kerf/mass.h>

#include <cmath>
#include <utility>

namespace kerf {

namespace {

double determinant(const Mat4d& a)
{
    const auto& m = a.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[2][1] * m[1][2]) - m[1][0] * (m[0][1] * m[2][2] - m[2][1] * m[0][2]) +
           m[2][0] * (m[0][1] * m[1][2] - m[1][1] * m[0][2]);
}

/// trace(s) - s: from second moments to inertia; trace(s) / 2 - s is the way back.
Mat3d trace_less(const Mat3d& s, double share)
{
    const double trace = share * (s.m[0][0] + s.m[1][1] + s.m[2][2]);
    Mat3d result;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result.m[column][row] = (row == column ? trace : 0.0) - s.m[column][row];
    return result;
}

}  // namespace

Mat3d MassProperties::inertia_of(double density) const noexcept
{
    Mat3d result = inertia;
    for (auto& column : result.m)
        for (double& number : column) number *= density;
    return result;
}

MassProperties MassProperties::placed(const Mat4d& object_to_world) const noexcept
{
    const auto& m = object_to_world.m;
    const double c[3] = {centre.x, centre.y, centre.z};
    double moved[3];
    for (int row = 0; row < 3; ++row)
        moved[row] = ((m[0][row] * c[0] + m[1][row] * c[1]) + m[2][row] * c[2]) + m[3][row];
    const double scale = std::abs(determinant(object_to_world));

    // Second moments about the centre transform as a quadratic form: A S A^T, times the change of volume.
    const Mat3d second = trace_less(inertia, 0.5);
    Mat3d turned;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            double sum = 0.0;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) sum += m[i][row] * second.m[j][i] * m[j][column];
            turned.m[column][row] = scale * sum;
        }
    MassProperties result = *this;
    result.volume = scale * volume;
    result.centre = {moved[0], moved[1], moved[2]};
    result.inertia = trace_less(turned, 1.0);
    return result;
}

PrincipalAxes principal_axes(const Mat3d& inertia) noexcept
{
    double a[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // rows; columns of v are the axes
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            a[row][column] = 0.5 * (inertia.m[column][row] + inertia.m[row][column]);
    // Each sweep squares what is left off the diagonal; a matrix of doubles needs six at most.
    constexpr int kSweeps = 12;
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (a[p][q] == 0.0 || !std::isfinite(a[p][q])) continue;
            const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
            const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
            for (int i = 0; i < 3; ++i) {
                const double x = a[i][p], y = a[i][q];
                a[i][p] = c * x - s * y;
                a[i][q] = s * x + c * y;
            }
            for (int i = 0; i < 3; ++i) {
                const double x = a[p][i], y = a[q][i];
                a[p][i] = c * x - s * y;
                a[q][i] = s * x + c * y;
            }
            for (int i = 0; i < 3; ++i) {
                const double x = v[i][p], y = v[i][q];
                v[i][p] = c * x - s * y;
                v[i][q] = s * x + c * y;
            }
            a[p][q] = a[q][p] = 0.0;
        }
    int order[3] = {0, 1, 2};
    const auto put_in_order = [&](int i, int j) {
        if (a[order[j]][order[j]] < a[order[i]][order[i]]) std::swap(order[i], order[j]);
    };
    put_in_order(0, 1);
    put_in_order(1, 2);
    put_in_order(0, 1);
    PrincipalAxes result;
    for (int i = 0; i < 3; ++i)
        for (int row = 0; row < 3; ++row) result.axes.m[i][row] = v[row][order[i]];
    result.moments = {a[order[0]][order[0]], a[order[1]][order[1]], a[order[2]][order[2]]};
    // The third axis is the cross product of the others, so that they are right-handed.
    const auto& x = result.axes.m[0];
    const auto& y = result.axes.m[1];
    auto& z = result.axes.m[2];
    z[0] = x[1] * y[2] - x[2] * y[1];
    z[1] = x[2] * y[0] - x[0] * y[2];
    z[2] = x[0] * y[1] - x[1] * y[0];
    return result;
}

}  // namespace kerf
