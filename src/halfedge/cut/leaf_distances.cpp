#include "halfedge/cut/leaf_distances.h"

#include <cassert>

#include "common/support/processor.h"

#ifdef KERF_AVX2
#include <immintrin.h>
#endif

namespace kerf::core::halfedge {

void LeafDistances::find(const Plane& plane, std::span<const Vertex> vertices, std::span<const Triangle> triangles)
{
    assert(triangles.size() <= kMaxLeafTriangles);
#ifdef KERF_AVX2
    if (has_avx2()) {
        find_three_at_once(plane, vertices, triangles);
        return;
    }
#endif
    find_one_by_one(plane, vertices, triangles);
}

void LeafDistances::find_one_by_one(const Plane& given_plane, std::span<const Vertex> vertices,
                                    std::span<const Triangle> triangles)
{
    const Plane plane = given_plane;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        unsigned above = 0, below = 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double d = plane.signed_distance(vertices[t[corner]].position);
            distances_[i][corner] = d;
            above |= unsigned{d > 0.0} << corner;
            below |= unsigned{d < 0.0} << corner;
        }
        above_[i] = static_cast<std::uint8_t>(above);
        below_[i] = static_cast<std::uint8_t>(below);
    }
}

LeafDistances::Masks LeafDistances::masks(std::size_t count) const
{
    // Eight triangles at a time, a byte each; no byte is larger than seven, so nothing is carried into the next.
    constexpr std::uint64_t kOnes = 0x0101010101010101, kHighBits = 0x80 * kOnes;
    const auto is_set = [](std::uint64_t bytes) { return (bytes + 0x7F * kOnes) & kHighBits; };
    // The high bits of eight bytes, side by side.
    const auto gathered = [](std::uint64_t bytes) { return (bytes >> 7) * 0x0102040810204080 >> 56; };
    Masks masks;
    for (std::size_t i = 0; i < count; i += 8) {
        std::uint64_t above = 0, below = 0;
        for (std::size_t byte = 0; byte < 8; ++byte) {
            above |= std::uint64_t{above_[i + byte]} << 8 * byte;
            below |= std::uint64_t{below_[i + byte]} << 8 * byte;
        }
        masks.crossing |= gathered(is_set(above) & is_set(below)) << i;
        masks.above |= gathered(is_set(above)) << i;
        masks.on |= gathered(is_set((above | below) ^ kAllCorners * kOnes)) << i;
    }
    const std::uint64_t asked_for = (std::uint64_t(1) << count) - 1;
    return {masks.crossing & asked_for, masks.on & asked_for, masks.above & asked_for};
}

#ifdef KERF_AVX2
KERF_AVX2 void LeafDistances::find_three_at_once(const Plane& plane, std::span<const Vertex> vertices,
                                                 std::span<const Triangle> triangles)
{
    const __m256d nx = _mm256_set1_pd(plane.normal.x), ny = _mm256_set1_pd(plane.normal.y);
    const __m256d nz = _mm256_set1_pd(plane.normal.z), offset = _mm256_set1_pd(plane.offset);
    const __m256d zero = _mm256_setzero_pd();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        // A position and the first float of the normal in one load.
        const __m128 a = _mm_loadu_ps(&vertices[t[0]].position.x), b = _mm_loadu_ps(&vertices[t[1]].position.x);
        const __m128 c = _mm_loadu_ps(&vertices[t[2]].position.x);
        const __m128 ab = _mm_unpacklo_ps(a, b);  // xx yy
        const __m256d x = _mm256_cvtps_pd(_mm_movelh_ps(ab, c));
        const __m256d y = _mm256_cvtps_pd(_mm_shuffle_ps(ab, c, _MM_SHUFFLE(1, 1, 3, 2)));
        const __m256d z = _mm256_cvtps_pd(_mm_shuffle_ps(_mm_unpackhi_ps(a, b), c, _MM_SHUFFLE(2, 2, 1, 0)));
        // The order of operations is that of Plane::signed_distance().
        const __m256d d = ((nx * x + ny * y) + nz * z) - offset;
        _mm256_storeu_pd(distances_[i].data(), d);
        const int above = _mm256_movemask_pd(_mm256_cmp_pd(d, zero, _CMP_GT_OQ));
        const int below = _mm256_movemask_pd(_mm256_cmp_pd(d, zero, _CMP_LT_OQ));
        above_[i] = static_cast<std::uint8_t>(above & kAllCorners);
        below_[i] = static_cast<std::uint8_t>(below & kAllCorners);
    }
}
#endif

}  // namespace kerf::core::halfedge
