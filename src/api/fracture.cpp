#include <kerf/fracture.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "api/convert.h"
#include "api/no_memory.h"
#include "back_ends/back_ends.h"
#include "common/cutting/back_end_helpers.h"
#include "common/cutting/breakable.h"
#include "common/fracture/piece_meshes.h"
#include "common/fracture/take_apart_by_subtrees.h"

namespace kerf {

namespace {

struct FracturedPiece
{
    Object object;
    std::vector<std::uint32_t> cells;
};

constexpr std::uint32_t kNoPiece = 0xFFFFFFFFu;

}  // namespace

/// What a Fracture hides.
struct Fracture::Data
{
    std::vector<FracturedPiece> pieces;
    std::vector<FractureBond> bonds;
    std::vector<Vec3d> sites;
};

struct FractureMaker
{
    static Fracture refused(Status status, const char* refusal)
    {
        Fracture fracture;
        fracture.status_ = status;
        fracture.refusal_ = refusal;
        return fracture;
    }

    /// One that has no pieces yet. May throw std::bad_alloc.
    static Fracture begun()
    {
        Fracture fracture;
        fracture.data_ = new Fracture::Data;
        return fracture;
    }

    static Fracture::Data& data(Fracture& fracture) { return *fracture.data_; }
};

namespace {

/// May throw std::bad_alloc.
class Breaker
{
public:
    Breaker(const core::Cuttable& object, const FractureOptions& options)
        : object_(object), options_(options), progress_({options.progress, options.user}, 0.0, 1.0)
    {
    }

    Fracture run()
    {
        try {
            return take_apart_and_make_pieces();
        } catch (const core::Cancelled&) {
            return FractureMaker::refused(Status::cancelled, "the caller asked to stop; there are no pieces");
        }
    }

private:
    /// What is done when sites are there, and when cells and contacts are; the rest is the pieces' meshes and preparing.
    static constexpr double kShareOfSites = 0.1, kShareOfSplitting = 0.5;

    Fracture take_apart_and_make_pieces()
    {
        progress_.at(0.0);
        breakable_ = object_.breakable();
        if (breakable_ == nullptr) take_mesh();
        const std::vector<glm::dvec3> sites = sites_wanted();
        if (sites.empty())
            return FractureMaker::refused(Status::invalid_mesh,
                                          "the object has no inside, or fills too little of its box to find it");
        if (!take_apart(sites))
            return FractureMaker::refused(Status::invalid_mesh,
                                          "the surface passes through itself where pieces would meet");
        progress_.at(kShareOfSplitting);
        Fracture fracture = FractureMaker::begun();
        Fracture::Data& data = FractureMaker::data(fracture);
        for (const glm::dvec3& site : taken_.apart.sites) data.sites.push_back(to_public(site));
        make_pieces(data);
        add_bonds(data);
        progress_.at(1.0);
        return fracture;
    }

    void take_mesh()
    {
        mesh_ = object_.to_indexed_mesh();
        solid_.emplace(mesh_);
    }

    std::vector<glm::dvec3> sites_wanted() const
    {
        if (!options_.sites.empty()) {
            std::vector<glm::dvec3> sites;
            for (const Vec3d& site : options_.sites) sites.push_back(to_core(site));
            return sites;
        }
        core::SitesWanted wanted;
        const bool is_known = options_.pattern <= FracturePattern::splinters;
        wanted.pattern = static_cast<core::FracturePattern>(is_known ? options_.pattern : FracturePattern::uniform);
        wanted.count = options_.cells;
        wanted.seed = options_.seed;
        wanted.at = options_.at ? to_core(*options_.at) : object_.bounds().centre();
        wanted.direction = glm::normalize(to_core(options_.direction));
        return breakable_ != nullptr ? core::make_sites(*breakable_, wanted)
                                     : core::make_sites(core::AllTriangles(*solid_), wanted);
    }

    core::InsideLook look_wanted(core::IndexedMesh& mesh) const
    {
        const bool is_there = options_.material < mesh.materials.size();
        return {is_there ? options_.material : core::add_cap_material(mesh.materials), options_.uv_scale};
    }

    /// By subtrees if the object has a tree and that pays.
    bool take_apart(std::span<const glm::dvec3> sites)
    {
        core::ProgressOfStep progress = progress_.part(kShareOfSites, kShareOfSplitting);
        if (breakable_ != nullptr) {
            look_ = look_wanted(breakable_->border());
            constexpr double kShareOfTrial = 0.9;  // if it is refused, there is a rest for the other way
            if (auto taken = core::take_apart_by_subtrees(*breakable_, sites, options_.least_volume, look_,
                                                          progress.part(0.0, kShareOfTrial))) {
                taken_ = *std::move(taken);
                mesh_ = std::move(breakable_->border());
                breakable_.reset();
                return true;
            }
            breakable_.reset();
            take_mesh();
            progress = progress.part(kShareOfTrial, 1.0);
        }
        look_ = look_wanted(mesh_);
        auto apart = core::take_apart(*solid_, sites, options_.least_volume, progress);
        if (!apart) return false;
        taken_.apart = *std::move(apart);
        taken_.points = std::move(solid_->points);
        taken_.objects.resize(taken_.apart.fragments.fragments.size());
        return true;
    }

    void make_pieces(Fracture::Data& data)
    {
        const core::RegisteredBackend& entry = *core::find_back_end(object_.memory.back_end);
        std::optional<core::PieceMeshes> meshes;  // if one is wanted
        std::vector<core::Fragment>& fragments = taken_.apart.fragments.fragments;
        const core::ProgressOfStep progress = progress_.part(kShareOfSplitting, 1.0);
        for (std::size_t f = 0; f < fragments.size(); ++f) {
            number_of_.push_back(kNoPiece);
            std::unique_ptr<core::Cuttable> object = std::move(taken_.objects[f]);
            if (object == nullptr) {
                if (!meshes) meshes.emplace(mesh_, taken_.points, taken_.apart.split, look_, taken_.stream_means);
                if (auto mesh = meshes->make(fragments[f])) {
                    core::PrepareResult prepared = entry.back_end->prepare(std::move(*mesh), {});
                    if (prepared.status == core::Status::out_of_memory) throw std::bad_alloc();
                    object = std::move(prepared.object);
                }
            }
            if (object != nullptr) {
                object->memory = object_.memory;
                object->set_noise(object_.noise());
                number_of_.back() = static_cast<std::uint32_t>(data.pieces.size());
                data.pieces.push_back({Object(object.release()), std::move(fragments[f].cells)});
            }
            fragments[f] = {};
            progress.at(double(f + 1) / double(fragments.size() + 1));
        }
    }

    void add_bonds(Fracture::Data& data) const
    {
        for (const core::Bond& bond : taken_.apart.fragments.bonds) {
            const std::uint32_t first = number_of_[bond.first], second = number_of_[bond.second];
            if (first != kNoPiece && second != kNoPiece)
                data.bonds.push_back({first, second, bond.area, to_public(bond.centre), to_public(bond.normal)});
        }
    }

    const core::Cuttable& object_;
    const FractureOptions& options_;
    const core::ProgressOfStep progress_;
    std::unique_ptr<core::Breakable> breakable_;  ///< null: the object is broken as a mesh
    core::IndexedMesh mesh_;                      ///< of the object, or of its border
    std::optional<core::SolidOfPoints> solid_;
    core::InsideLook look_;
    core::TakenApartBySubtrees taken_;
    std::vector<std::uint32_t> number_of_;  ///< the piece that a fragment has become
};

bool is_finite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What is wrong with the arguments, or null.
const char* fault_of(const Object& object, const FractureOptions& options)
{
    if (object.is_empty()) return "the object is empty: it was cut, moved from, or never made";
    if (options.sites.empty() && options.cells == 0) return "there must be a cell";
    if (options.at && !is_finite(*options.at)) return "`at` must be finite";
    if (!Plane::at(Point(0, 0, 0), options.direction)) return "`direction` must have a direction";
    if (!std::ranges::all_of(options.sites, is_finite)) return "sites must be finite";
    // Beyond, doubles don't tell where in the object such a site's borders lie.
    constexpr double kMostAway = 1e6;
    const core::Box box = object.inside()->bounds();
    const double reach = kMostAway * glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
    if (!std::ranges::all_of(options.sites, [&](const Vec3d& site) {
            return glm::length(to_core(site) - glm::dvec3(box.centre())) <= reach;
        }))
        return "sites must lie within a million times the object's size";
    if (!std::isfinite(options.least_volume) || options.least_volume < 0.0)
        return "the least volume must be finite and not below 0";
    if (!std::isfinite(options.uv_scale)) return "the scale of uv must be finite";
    return nullptr;
}

}  // namespace

Fracture fracture(const Object& object, const FractureOptions& options) noexcept
{
    if (const char* fault = fault_of(object, options)) return FractureMaker::refused(Status::invalid_argument, fault);
    const core::Cuttable& inside = *object.inside();
    if (!inside.memory.is_of_solid)
        return FractureMaker::refused(Status::invalid_mesh, "the object is open: only a solid can be broken");
    return answer_or(
        FractureMaker::refused(Status::out_of_memory, "there is not enough memory for the pieces; ask for fewer cells"),
        [&] { return Breaker(inside, options).run(); });
}

Fracture::Fracture() noexcept = default;

Fracture::Fracture(Fracture&& other) noexcept
{
    *this = std::move(other);
}

Fracture& Fracture::operator=(Fracture&& other) noexcept
{
    if (this == &other) return *this;
    delete std::exchange(data_, std::exchange(other.data_, nullptr));
    status_ = std::exchange(other.status_, Status::done);
    refusal_ = std::exchange(other.refusal_, "");
    return *this;
}

Fracture::~Fracture()
{
    delete data_;
}

std::size_t Fracture::count() const noexcept
{
    return data_ == nullptr ? 0 : data_->pieces.size();
}

Object* Fracture::piece(std::size_t i) noexcept
{
    return i < count() ? &data_->pieces[i].object : nullptr;
}

std::span<const std::uint32_t> Fracture::cells(std::size_t i) const noexcept
{
    if (i >= count()) return {};
    return data_->pieces[i].cells;
}

std::span<const FractureBond> Fracture::bonds() const noexcept
{
    if (data_ == nullptr) return {};
    return data_->bonds;
}

std::span<const Vec3d> Fracture::sites() const noexcept
{
    if (data_ == nullptr) return {};
    return data_->sites;
}

}  // namespace kerf
