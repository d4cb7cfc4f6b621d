#include "common/repair/vertex_builder.h"

#include <glm/geometric.hpp>

#include "common/geometry/pair_table.h"
#include "common/mesh/index.h"
#include "common/repair/smooth_normals.h"

namespace kerf::core {

namespace {

/// Gives numbers an index, in the order of first use.
class SingleNumbering
{
public:
    explicit SingleNumbering(std::size_t size) : index_(size, kNone) {}

    /// Without a branch on whether the number is new, which can't be predicted: every sixth is.
    std::uint32_t number(std::uint32_t of)
    {
        const bool is_new = index_[of] == kNone;
        index_[of] = is_new ? count_ : index_[of];
        count_ += is_new ? 1 : 0;
        return index_[of];
    }

    std::uint32_t count() const { return count_; }

private:
    Buffer<std::uint32_t> index_;
    std::uint32_t count_ = 0;
};

/// Gives each pair of numbers an index, in the order of first use. Most first numbers come with one second number only,
/// so the table is rarely needed.
class PairNumbering
{
public:
    explicit PairNumbering(std::size_t first_count) : entry_(first_count, Entry{kNone, kNone}) {}

    /// Without a branch on whether the pair is new, as above.
    std::uint32_t number(std::uint32_t first, std::uint32_t second)
    {
        Entry& entry = entry_[first];
        const bool is_new = entry.index == kNone;
        entry = is_new ? Entry{second, count_} : entry;
        count_ += is_new ? 1 : 0;
        if (entry.second == second) return entry.index;
        std::uint32_t& index = others_(first, second);
        if (index == kNone) index = count_++;
        return index;
    }

    std::uint32_t count() const { return count_; }

private:
    struct Entry
    {
        std::uint32_t second, index;
    };
    Buffer<Entry> entry_;
    PairTable others_;
    std::uint32_t count_ = 0;
};

class VertexBuilder
{
public:
    VertexBuilder(const VertexSources& sources, IndexedMesh& mesh) : in_(sources), mesh_(mesh) {}

    void run(std::span<const std::uint32_t> order)
    {
        if (in_.soup.has_normals)
            find_turned_normals();
        else
            smooth_ = smooth_normals(in_.surface, in_.positions, in_.soup.crease_degrees);
        number_vertices(order);
        make_vertices();
        fill_streams();
    }

private:
    /// The soup vertex at a corner of the surface.
    std::uint32_t soup_vertex(std::uint32_t corner) const
    {
        const std::uint32_t t = corner / 3, i = corner % 3;
        const std::uint32_t soup_corner = in_.surface.flipped[t] ? (3 - i) % 3 : i;
        return in_.first_equal[in_.soup.triangles[in_.soup_triangles[t]][soup_corner]];
    }

    glm::dvec3 area_normal(std::uint32_t t) const
    {
        const auto& [a, b, c] = in_.surface.corners[t];
        const glm::dvec3 p = in_.positions[a], q = in_.positions[b], r = in_.positions[c];
        return glm::cross(q - p, r - p);
    }

    /// Finds the vertices whose normals point behind their triangles now that some have been turned over.
    void find_turned_normals()
    {
        const auto& flipped = in_.surface.flipped;
        if (std::find(flipped.begin(), flipped.end(), 1) == flipped.end()) return;
        Buffer<glm::dvec3> sums(in_.soup.vertices.size(), glm::dvec3(0.0));
        for (std::uint32_t t = 0; t < flipped.size(); ++t) {
            if (!flipped[t]) continue;
            const glm::dvec3 normal = area_normal(t);
            for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) sums[soup_vertex(corner)] += normal;
        }
        turned_.assign(sums.size(), 0);
        for (std::size_t v = 0; v < sums.size(); ++v)
            turned_[v] = glm::dot(sums[v], glm::dvec3(in_.soup.vertices[v].normal)) < 0.0;
    }

    bool is_turned(std::uint32_t corner, std::uint32_t v) const
    {
        return !turned_.empty() && in_.surface.flipped[corner / 3] != 0 && turned_[v] != 0;
    }

    /// Numbers the vertices in the order in which triangles use them. A vertex is a fan, or a smooth sector of it, with the
    /// attributes of a soup vertex.
    void number_vertices(std::span<const std::uint32_t> order)
    {
        if (!in_.soup.has_normals) {
            PairNumbering numbering(smooth_.normals.size());
            number_corners(order, numbering, [&](std::uint32_t corner, std::uint32_t v) {
                return numbering.number(smooth_.sector[corner], v);
            });
        } else if (in_.fans.is_one_at_each_point && turned_.empty()) {
            // A soup vertex, which has one point, is then in one fan.
            SingleNumbering numbering(in_.soup.vertices.size());
            number_corners(order, numbering, [&](std::uint32_t, std::uint32_t v) { return numbering.number(v); });
        } else {
            PairNumbering numbering(in_.soup.vertices.size());
            number_corners(order, numbering, [&](std::uint32_t corner, std::uint32_t v) {
                const std::uint32_t fan = in_.fans.fan[corner];
                return numbering.number(v, is_turned(corner, v) ? kNone - 1 - fan : fan);
            });
        }
    }

    /// Gives each corner the vertex that number_of(corner of the surface, soup vertex) says.
    template <class NumberOf>
    void number_corners(std::span<const std::uint32_t> order, const auto& numbering, NumberOf&& number_of)
    {
        mesh_.triangles.resize(order.size());
        first_corner_.resize(3 * order.size() + 1);
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            const std::uint32_t t = order[i];
            const bool flipped = in_.surface.flipped[t] != 0;
            const Triangle& from = in_.soup.triangles[in_.soup_triangles[t]];
            for (std::uint32_t c = 0; c < 3; ++c) {
                const std::uint32_t corner = 3 * t + c;
                first_corner_[numbering.count()] = corner;  // of the next vertex, if this is a new one
                mesh_.triangles[i][c] = number_of(corner, in_.first_equal[from[flipped ? (3 - c) % 3 : c]]);
            }
        }
        first_corner_.resize(numbering.count());
    }

    void make_vertices()
    {
        const std::size_t count = first_corner_.size();
        mesh_.vertices.resize(count);
        mesh_.points.resize(count);
        origin_.resize(count);
        Buffer<std::uint32_t> point_of_fan(in_.fans.count, kNone);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t corner = first_corner_[i], v = soup_vertex(corner);
            // In its place: a copy that is changed piece by piece is read again before its pieces are written.
            Vertex& vertex = mesh_.vertices[i];
            vertex = in_.soup.vertices[v];
            vertex.position = in_.positions[in_.surface.start(corner)];
            if (!in_.soup.has_normals)
                vertex.normal = smooth_.normals[smooth_.sector[corner]];
            else if (is_turned(corner, v))
                vertex.normal = -vertex.normal;
            origin_[i] = v;
            std::uint32_t& point = point_of_fan[in_.fans.fan[corner]];
            if (point == kNone) point = mesh_.point_count++;
            mesh_.points[i] = point;
        }
    }

    void fill_streams()
    {
        for (const VertexStream& from : in_.soup.streams) {
            VertexStream& to = mesh_.streams.emplace_back();
            to.name = from.name;
            to.width = from.width;
            to.values.resize(std::size_t{from.width} * origin_.size());
            for (std::size_t v = 0; v < origin_.size(); ++v)
                std::copy_n(from.values.data() + std::size_t{origin_[v]} * from.width, from.width,
                            to.values.data() + v * from.width);
        }
    }

    const VertexSources& in_;
    IndexedMesh& mesh_;
    SmoothNormals smooth_;
    Buffer<std::uint8_t> turned_;         ///< for each soup vertex; empty if nothing was turned over
    Buffer<std::uint32_t> first_corner_;  ///< for each new vertex, of the surface
    Buffer<std::uint32_t> origin_;        ///< for each new vertex the soup vertex
};

}  // namespace

void build_vertices(const VertexSources& sources, std::span<const std::uint32_t> order, IndexedMesh& mesh)
{
    VertexBuilder(sources, mesh).run(order);
}

}  // namespace kerf::core
