#include "common/mesh/mass_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "common/mesh/tolerances.h"
#include "common/support/processor.h"

namespace kerf::core {
namespace {

// Four doubles, one for each of four triangles. What has no room for four computes two and two: the same sums.
using Quad = double __attribute__((vector_size(32)));

struct QuadOfPoints
{
    Quad x, y, z;
};

// The positions of four vertices, side by side and in double.
KERF_IN_CALLER void side_by_side(const std::array<const Vertex*, 4>& v, QuadOfPoints& points)
{
#ifdef __SSE2__
    // The position and the first float of the normal in one load, then shuffles, and conversions of two at a time. Left
    // to itself the compiler converts four through memory, or one at a time: either costs a third of the whole sum.
    const auto put = [](const __m128 front, const __m128 back, Quad& numbers) {
        const __m128d two = _mm_cvtps_pd(front), more = _mm_cvtps_pd(back);
        numbers = Quad{two[0], two[1], more[0], more[1]};
    };
    const __m128 a = _mm_loadu_ps(&v[0]->position.x), b = _mm_loadu_ps(&v[1]->position.x);
    const __m128 c = _mm_loadu_ps(&v[2]->position.x), d = _mm_loadu_ps(&v[3]->position.x);
    const __m128 ab = _mm_unpacklo_ps(a, b), cd = _mm_unpacklo_ps(c, d);
    put(ab, cd, points.x);
    put(_mm_movehl_ps(ab, ab), _mm_movehl_ps(cd, cd), points.y);
    put(_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d), points.z);
#else
    for (std::size_t i = 0; i < v.size(); ++i) {
        points.x[i] = v[i]->position.x;
        points.y[i] = v[i]->position.y;
        points.z[i] = v[i]->position.z;
    }
#endif
}

// Four triangles take 36 multiplications, 39 additions and 9 conversions. On the machines measured, additions and
// conversions share two units and take most of the time: only fewer additions would make this faster.
struct QuadOfMoments
{
    Quad volume{}, x{}, y{}, z{}, xx{}, yy{}, zz{}, yz{}, zx{}, xy{};

    KERF_IN_CALLER void add(const QuadOfPoints& p, const QuadOfPoints& q, const QuadOfPoints& r)
    {
        const Quad det = p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
        const QuadOfPoints a{p.x + q.x, p.y + q.y, p.z + q.z};
        const QuadOfPoints b{q.x + r.x, q.y + r.y, q.z + r.z};
        const QuadOfPoints c{r.x + p.x, r.y + p.y, r.z + p.z};
        volume += det;
        x += det * (a.x + r.x);
        y += det * (a.y + r.y);
        z += det * (a.z + r.z);
        xx += det * (a.x * a.x + b.x * b.x + c.x * c.x);
        yy += det * (a.y * a.y + b.y * b.y + c.y * c.y);
        zz += det * (a.z * a.z + b.z * b.z + c.z * c.z);
        yz += det * (a.y * a.z + b.y * b.z + c.y * c.z);
        zx += det * (a.z * a.x + b.z * b.x + c.z * c.x);
        xy += det * (a.x * a.y + b.x * b.y + c.x * c.y);
    }
};

struct MomentsInput
{
    std::span<const Vertex> vertices;
    std::span<const std::span<const Triangle>> runs;
    glm::dvec3 reference;
};

template <bool kAboutOrigin>
class Sum
{
public:
    KERF_IN_CALLER explicit Sum(const MomentsInput& in) : vertex_(in.vertices.data())
    {
        const glm::dvec3& o = in.reference;
        origin_.x = Quad{o.x, o.x, o.x, o.x};
        origin_.y = Quad{o.y, o.y, o.y, o.y};
        origin_.z = Quad{o.z, o.z, o.z, o.z};
        // Four triangles may be of several runs.
        std::array<const Triangle*, 4> four{};
        std::size_t count = 0;
        for (const std::span<const Triangle>& run : in.runs) {
            const Triangle *t = run.data(), *const end = t + run.size();
            while (count > 0 && t != end) {
                four[count++] = t++;
                if (count < 4) continue;
                add(four);
                count = 0;
            }
            for (; end - t >= 4; t += 4) add({t, t + 1, t + 2, t + 3});
            while (t != end) four[count++] = t++;
        }
        if (count == 0) return;
        // Places that no triangle takes: one corner three times, which adds 0.
        const std::uint32_t corner = (*four[0])[0];
        const Triangle none{corner, corner, corner};
        while (count < 4) four[count++] = &none;
        add(four);
    }

    KERF_IN_CALLER MassMoments moments() const
    {
        const auto sum = [](const Quad& q) { return (q[0] + q[1]) + (q[2] + q[3]); };
        MassMoments moments;
        moments.volume6 = sum(quad_.volume);
        moments.first24 = {sum(quad_.x), sum(quad_.y), sum(quad_.z)};
        moments.squares120 = {sum(quad_.xx), sum(quad_.yy), sum(quad_.zz)};
        moments.products120 = {sum(quad_.yz), sum(quad_.zx), sum(quad_.xy)};
        return moments;
    }

private:
    KERF_IN_CALLER void add(const std::array<const Triangle*, 4>& t)
    {
        std::array<QuadOfPoints, 3> corner{};
        for (std::size_t c = 0; c < 3; ++c) {
            side_by_side({&vertex_[(*t[0])[c]], &vertex_[(*t[1])[c]], &vertex_[(*t[2])[c]], &vertex_[(*t[3])[c]]},
                         corner[c]);
            if constexpr (!kAboutOrigin) {
                corner[c].x -= origin_.x;
                corner[c].y -= origin_.y;
                corner[c].z -= origin_.z;
            }
        }
        quad_.add(corner[0], corner[1], corner[2]);
    }

    const Vertex* vertex_;
    QuadOfPoints origin_;
    QuadOfMoments quad_;
};

// Subtracting 0 changes no number, so both ways give the same bits.
KERF_IN_CALLER MassMoments sum_about_any(const MomentsInput& in)
{
    return in.reference == glm::dvec3(0.0) ? Sum<true>(in).moments() : Sum<false>(in).moments();
}

MassMoments sum_anywhere(const MomentsInput& in)
{
    return sum_about_any(in);
}

#ifdef KERF_AVX2
KERF_AVX2 MassMoments sum_with_avx2(const MomentsInput& in)
{
    return sum_about_any(in);
}
#endif

}  // namespace

MassProperties MassMoments::properties(const glm::dvec3& reference) const
{
    MassProperties result;
    result.volume = volume6 / 6.0;
    const glm::dvec3 first = first24 / 24.0;
    glm::dvec3 c = first / result.volume;
    // With no volume, or so little that the quotient overflows, there is no meaningful centre.
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) c = glm::dvec3(0.0);
    result.centre = reference + c;

    // Second moments about the centre of mass (parallel axes), then the tensor.
    const glm::dvec3 squares = squares120 / 120.0 - first * c;
    const glm::dvec3 products = products120 / 120.0 - glm::dvec3(first.y * c.z, first.z * c.x, first.x * c.y);
    glm::dmat3& inertia = result.inertia;
    inertia[0][0] = squares.y + squares.z;
    inertia[1][1] = squares.z + squares.x;
    inertia[2][2] = squares.x + squares.y;
    inertia[1][2] = inertia[2][1] = -products.x;
    inertia[2][0] = inertia[0][2] = -products.y;
    inertia[0][1] = inertia[1][0] = -products.z;
    return result;
}

MassMoments mass_moments(std::span<const Vertex> vertices, std::span<const Triangle> triangles,
                         const glm::dvec3& reference)
{
    return mass_moments(vertices, std::span(&triangles, 1), reference);
}

MassMoments mass_moments(std::span<const Vertex> vertices, std::span<const std::span<const Triangle>> runs,
                         const glm::dvec3& reference)
{
    const MomentsInput in{vertices, runs, reference};
#ifdef KERF_AVX2
    if (has_avx2()) return sum_with_avx2(in);
#endif
    return sum_anywhere(in);
}

bool has_no_volume(double volume6, const Box& box, double noise)
{
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    return std::abs(volume6) <= 12.0 * noise * (size.x * size.y + size.y * size.z + size.z * size.x);
}

glm::dvec3 mass_reference(const Box& bounds)
{
    if (bounds.empty()) return glm::dvec3(0.0);
    const glm::dvec3 centre = bounds.centre(), half = (glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo)) * 0.5;
    const double largest_half = std::max({half.x, half.y, half.z});
    const double distance = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
    return distance <= kHalfSizesFromOrigin * largest_half ? glm::dvec3(0.0) : centre;
}

}  // namespace kerf::core
