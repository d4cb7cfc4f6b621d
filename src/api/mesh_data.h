#pragma once

#include <kerf/mesh.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "common/cutting/cut.h"
#include "common/repair/proven_mesh.h"
#include "common/repair/repair.h"

namespace kerf {

/// Whether all strides are as long as what they stride over, and none leads out of memory.
bool has_right_strides(const MeshInput& input) noexcept;

/// What copies of a Mesh share: the mesh, proven or as a back end gave it, and its arrays once they have been asked
/// for.
class Mesh::Data
{
public:
    explicit Data(core::ProvenMesh&& mesh) : proven_(std::move(mesh)), is_proven_(true) {}
    /// Of a back end. It is proven if it is prepared again, and joined anew if it has surfaces that lie on one another.
    explicit Data(core::IndexedMesh&& mesh) : plain_(std::move(mesh)) {}

    const core::IndexedMesh& mesh() const noexcept
    {
        return is_proven_ ? static_cast<const core::IndexedMesh&>(proven_) : plain_;
    }
    /// The same mesh for one owner. May throw std::bad_alloc.
    Data* clone() const
    {
        return is_proven_ ? new Data(core::ProvenMesh(proven_)) : new Data(core::IndexedMesh(plain_));
    }
    /// Prepares the mesh, which its only owner gives away. May throw std::bad_alloc.
    core::PrepareResult prepare(const core::Backend& back_end, const core::PrepareOptions& options, bool is_last_owner);
    bool is_closed() const;
    core::Box bounds() const { return is_proven_ ? proven_.bounds() : plain_.bounds(); }
    bool has_coarse_coordinates() const;

    void add_owner() noexcept { owners_.fetch_add(1, std::memory_order_relaxed); }
    /// Whether that was the last one.
    bool remove_owner() noexcept { return owners_.fetch_sub(1, std::memory_order_acq_rel) == 1; }
    bool has_one_owner() const noexcept { return owners_.load(std::memory_order_acquire) == 1; }

    /// Fills the arrays at the first call. They are empty if there was no memory, and the next call tries again.
    const MeshArrays& arrays_made() const noexcept;

private:
    void make_arrays() const;

    core::ProvenMesh proven_;
    core::IndexedMesh plain_;
    bool is_proven_ = false;
    std::atomic<std::uint64_t> owners_{1};

    mutable std::mutex mutex_;
    mutable std::atomic<bool> is_made_{false};
    mutable std::vector<Vec3f> positions_, normals_;
    mutable std::vector<Vec2f> uvs_;
    mutable std::vector<TriangleKind> kinds_;
    mutable std::vector<std::uint32_t> materials_, solids_;
    mutable MeshArrays arrays_;
};

/// Of a mesh as it was given.
MeshReport report_of(const core::MeshFacts& facts, const core::Repairs& repairs);

}  // namespace kerf
