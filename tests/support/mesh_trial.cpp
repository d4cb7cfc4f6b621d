#include "support/mesh_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>
#include <vector>

#include "common/mesh/plane_noise.h"
#include "common/proxy/collision_proxy.h"
#include "support/referee.h"
#include "support/surface_referee.h"

namespace kerf::core::test {

namespace {

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

constexpr int kMostCuts = 2;

void require(bool condition, const std::string& promise)
{
    if (!condition) throw std::logic_error("broken promise: " + promise);
}

/// What prove() has to find out, by other means.
bool keeps_all_promises(const IndexedMesh& mesh)
{
    if (!referee::is_well_formed(mesh) || !surface_referee::judge(mesh).fault.empty()) return false;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> solid_at;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto ends =
                    std::minmax(mesh.points[mesh.triangles[t][i]], mesh.points[mesh.triangles[t][(i + 1) % 3]]);
                if (solid_at.try_emplace(ends, group.solid).first->second != group.solid) return false;
            }
    return true;
}

bool has_only_numbers(const IndexedMesh& mesh)
{
    for (const VertexStream& stream : mesh.streams)
        for (const float value : stream.values)
            if (!std::isfinite(value)) return false;
    return true;
}

/// A plane that meets a mesh in an interesting way. Valid.
Plane trial_plane(const IndexedMesh& mesh, Random& random)
{
    const auto vertex = [&] {
        return glm::dvec3(mesh.vertices[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))].position);
    };
    std::optional<Plane> plane;
    switch (random.below(4)) {
        case 0: {
            const glm::dvec3 a = vertex(), b = vertex(), c = vertex();
            plane = Plane::through(a, glm::cross(b - a, c - a));
            break;
        }
        case 1: {
            glm::dvec3 axis(0.0);
            axis[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -1.0;
            plane = Plane::through(vertex(), axis);
            break;
        }
        case 2:
            plane = Plane::through((vertex() + vertex()) * 0.5, random.direction());
            break;
        default:
            plane = Plane::through(mesh.bounds().centre(), random.direction());
    }
    if (!plane) plane = Plane::through(mesh.bounds().centre(), {1.0, 0.0, 0.0});
    return plane.value_or(Plane{});
}

/// All that can be asked of an object agrees with its copy.
void query(const Cuttable& object, const IndexedMesh& mesh, Random& random, const std::string& who)
{
    require(referee::is_well_formed(mesh), who + ": a fragment is a mesh");
    require(check(mesh).empty(), who + ": check() takes a fragment (" + check(mesh) + ")");
    require(object.triangle_count() == mesh.triangles.size(), who + ": triangles are counted");
    const Box bounds = object.bounds(), box = mesh.bounds();
    require(bounds.lo == box.lo && bounds.hi == box.hi, who + ": bounds are those of the vertices");
    const DrawView view = object.draw_view();
    std::uint64_t drawn = 0;
    for (const DrawRange& range : view.ranges) {
        require(std::uint64_t{range.first_index} + range.index_count <= view.indices.size(),
                who + ": ranges lie in the index buffer");
        require(range.material < view.materials.size(), who + ": ranges have a material");
        for (std::uint32_t i = 0; i < range.index_count; ++i)
            require(view.indices[range.first_index + i] < view.vertices.size(), who + ": indices are of vertices");
        drawn += range.index_count;
    }
    require(drawn == 3 * object.triangle_count(), who + ": what is drawn is what there is");
    const MassProperties mass = object.mass_properties();
    require(std::isfinite(mass.volume) && std::isfinite(mass.centre.x + mass.centre.y + mass.centre.z),
            who + ": mass properties are numbers");
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) require(std::isfinite(mass.inertia[i][j]), who + ": inertia is made of numbers");
    // A kind that does not exist among them.
    const CollisionProxy proxy = collision_proxy(object, static_cast<ProxyKind>(random.below(6)));
    for (const Triangle& face : proxy.faces)
        for (const std::uint32_t point : face)
            require(point < proxy.points.size(), who + ": faces of a proxy are over its points");
    require(std::isfinite(proxy.radius) && std::isfinite(proxy.centre.x + 0.0 + proxy.centre.y + proxy.centre.z),
            who + ": a sphere is made of numbers");
    for (const glm::vec3& point : proxy.points)
        require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z),
                who + ": points of a proxy are numbers");
    for (const SectionLoop& loop : object.section_loops()) require(!loop.points.empty(), who + ": a loop has points");
}

/// What its pieces keep of a mesh.
struct Whole
{
    bool is_closed;  ///< and caps are asked for
    double noise;
};

/// Goes through the fragments of one side.
void look_at_side(const Fragments& side, const Plane& plane, bool is_positive, const Whole& whole, Random& random,
                  MeshTrial& trial, const std::string& who)
{
    require(!side.empty(), who + ": a cut has both sides");
    for (const auto& fragment : side) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        require(!mesh.triangles.empty(), who + ": no fragment is empty");
        query(*fragment, mesh, random, who);
        require(referee::triangles_with_equal_corners(mesh) == 0, who + ": no triangle has two equal corners");
        require(referee::overhang(mesh, plane, is_positive) <= whole.noise, who + ": fragments keep to their side");
        require(!whole.is_closed || (referee::open_edges(mesh) == 0 && referee::open_edges_by_position(mesh) == 0),
                who + ": a closed mesh has closed fragments");
        ++trial.pieces;
        trial.proven_pieces += keeps_all_promises(mesh);
    }
}

}  // namespace

MeshTrial try_mesh(const IndexedMesh& mesh, std::span<const std::unique_ptr<Backend>> backends, Random& random)
{
    MeshTrial trial;
    const bool is_good = keeps_all_promises(mesh);
    Fragments objects;
    for (const auto& backend : backends) {
        PrepareResult prepared = backend->prepare(mesh);
        const std::string who = backend->name();
        require((prepared.status == Status::done) == is_good,
                who + ": prepare() says what the referee says, not '" + prepared.reason + "'");
        if (is_good) {
            require(prepared.object != nullptr && prepared.reason.empty(), who + ": what can be cut is there");
            query(*prepared.object, prepared.object->to_indexed_mesh(), random, who);
            objects.push_back(std::move(prepared.object));
            continue;
        }
        require(prepared.status == Status::invalid_mesh && prepared.object == nullptr, who + ": no object is made");
        require(!prepared.reason.empty() && prepared.reason.size() < 300, who + ": a reason is a sentence");
        require(std::none_of(prepared.reason.begin(), prepared.reason.end(),
                             [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }),
                who + ": a reason has no control characters");
        require(trial.refusal.empty() || trial.refusal == prepared.reason, who + ": the reason is that of the others");
        trial.refusal = prepared.reason;
    }
    if (!is_good) return trial;

    // Bits of NaN are not compared: which of two NaN a sum gives is the compiler's choice.
    const bool comparable = has_only_numbers(mesh);
    IndexedMesh whole = mesh;
    for (int cuts = 0; cuts < kMostCuts; ++cuts) {
        const Plane plane = trial_plane(whole, random);
        CutOptions options;
        options.split_components = random.below(2) == 0;
        options.build_caps = random.below(8) != 0;
        if (random.below(4) == 0) options.cap_material = random.below(3) == 0 ? 0xfffffff0u : random.below(4);
        const Whole kept{options.build_caps && referee::open_edges(whole) == 0,
                         plane_noise(whole.bounds().largest_coordinate())};
        std::vector<CutResult> results;
        for (std::size_t b = 0; b < backends.size(); ++b) {
            const std::string who = backends[b]->name();
            CutResult& result = results.emplace_back(cut(std::move(objects[b]), plane, options));
            require(result.status == results[0].status,
                    who + ": the status is that of the others, not " + std::string(name_of(result.status)));
            if (result.status == Status::missed) {
                require(result.object != nullptr, who + ": what is missed comes back");
                objects[b] = std::move(result.object);
                continue;
            }
            require(result.status == Status::done || (result.status == Status::open_section && !kept.is_closed),
                    who + ": a closed mesh has a closed section, not " + std::string(name_of(result.status)));
            look_at_side(result.positive, plane, true, kept, random, trial, who);
            look_at_side(result.negative, plane, false, kept, random, trial, who);
            require(
                !comparable ||
                    (referee::canonical_surface(result.positive) == referee::canonical_surface(results[0].positive) &&
                     referee::canonical_surface(result.negative) == referee::canonical_surface(results[0].negative)),
                who + ": the sides of the surface are those of the others");
        }
        if (results[0].status == Status::missed) {
            ++trial.missed;
            continue;
        }
        ++trial.cuts;
        trial.closed += kept.is_closed;
        if (cuts + 1 == kMostCuts) break;

        // On with a piece of one back end, in all of them. A piece may touch itself along an edge or in a point, where
        // a cap meets the surface: such a piece is for the back end that made it.
        CutResult& chosen = results[random.below(static_cast<std::uint32_t>(results.size()))];
        Fragments& side = random.below(2) == 0 ? chosen.positive : chosen.negative;
        whole = side[random.below(static_cast<std::uint32_t>(side.size()))]->to_indexed_mesh();
        for (CutResult& result : results)
            for (Fragments* fragments : {&result.positive, &result.negative})
                cut(std::move(fragments->front()), trial_plane(whole, random), options);
        objects.clear();
        for (const auto& backend : backends) {
            PrepareResult prepared = backend->prepare(whole);
            require((prepared.status == Status::done) == keeps_all_promises(whole),
                    backend->name() + ": a piece is taken where the referee takes it, not '" + prepared.reason + "'");
            if (!prepared.object) return trial;
            objects.push_back(std::move(prepared.object));
        }
    }
    return trial;
}

}  // namespace kerf::core::test
