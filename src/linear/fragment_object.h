#pragma once

#include <functional>
#include <memory>

#include "common/cutting/cut.h"
#include "linear/slices.h"

namespace kerf::core::linear {

/// An object that is one Fragment: all of Cuttable but how it is cut and copied.
class FragmentObject : public Cuttable
{
public:
    /// All of a mesh.
    FragmentObject(ProvenMesh&& mesh, const BufferListener& listener);
    FragmentObject(Fragment&& fragment, const BufferListener& listener);

    std::uint64_t triangle_count() const override { return fragment_.mesh.triangles.size(); }
    Box bounds() const override { return fragment_.bounds; }
    DrawView draw_view() const override;
    void mark_uploaded(const DrawView& view) override { is_uploaded_ |= view.buffers == identity_.serial(); }
    MassProperties mass_properties() const override;
    std::array<glm::vec3, kSupportDirections> support_points() const override;
    std::span<const Vertex> used_vertices(std::vector<Vertex>&) const override { return fragment_.mesh.vertices; }
    std::span<const SectionLoop> section_loops() const override { return fragment_.section; }
    double noise() const override { return fragment_.noise; }
    void set_noise(double noise) override { fragment_.noise = noise; }
    std::span<const Material> materials() const override { return fragment_.mesh.materials; }
    std::uint32_t add_material(const Material& material) override;
    IndexedMesh to_indexed_mesh() const override { return fragment_.mesh; }
    std::unique_ptr<StackSearch> search_stack(const glm::dvec3& normal, std::span<const double> offsets,
                                              const ProgressOfStep& progress) const override;

protected:
    const Fragment& fragment() const { return fragment_; }
    const BufferListener& listener() const { return identity_.listener(); }

private:
    void find_section(const Plane& plane, PlaneSection& section) const override;
    std::uint64_t buffers() const noexcept override { return identity_.serial(); }

    Fragment fragment_;
    const BufferIdentity identity_;
    bool is_uploaded_ = false;
};

/// A fragment that is all of a mesh.
Fragment fragment_of(ProvenMesh&& mesh);

/// The result of a cut; make(Fragment) makes an object of each fragment, positive ones first.
template <class Make>
CutResult to_result(Slices slices, Make make)
{
    CutResult result;
    result.status = slices.status;
    result.side_of_object = slices.side_of_object;
    result.section_area = slices.section_area;
    result.caps_exceed_section = slices.caps_exceed_section;
    result.statistics = slices.statistics;
    if (slices.status == Status::missed || slices.status == Status::not_separated) return result;
    for (Fragment& fragment : slices.positive) result.positive.push_back(make(std::move(fragment)));
    for (Fragment& fragment : slices.negative) result.negative.push_back(make(std::move(fragment)));
    return result;
}

}  // namespace kerf::core::linear
