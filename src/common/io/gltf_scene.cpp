#include "common/io/gltf_scene.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

std::string name_of(std::size_t node)
{
    return "node " + std::to_string(node);
}

/// The transform that scales, then turns, then moves.
glm::dmat4 compose(const glm::dvec3& translation, const std::array<double, 4>& rotation, const glm::dvec3& scale)
{
    glm::dmat4 matrix(1.0);
    const glm::dquat q(rotation[3], rotation[0], rotation[1], rotation[2]);
    if (const double length = glm::length(q); length > 0.0) matrix = glm::mat4_cast(q / length);
    for (int i = 0; i < 3; ++i) {
        matrix[i] *= scale[i];
        matrix[3][i] = translation[i];
    }
    return matrix;
}

/// Walks the nodes of a document and finds where its meshes stand.
class Walk
{
public:
    Walk(const GltfDocument& document, GltfAccessors& accessors)
        : document_(document), accessors_(accessors), nodes_(document.list("nodes"))
    {
    }

    std::vector<GltfPlacement> from_scene()
    {
        if (document_.list("scenes").empty()) return {};
        const auto chosen = document_.index_if(document_.root(), "scene", "the document");
        const GltfJson& scene = document_.element("scenes", chosen.value_or(0), "scene", "'scene' of the document");
        const std::vector<std::size_t> starts = named(document_.indices(scene, "nodes", "the scene"), "the scene");
        document_.notes().add("nodes that the scene names although they are below others", count_children(starts));
        return from(starts);
    }

    std::vector<GltfPlacement> from_all()
    {
        std::vector<std::size_t> all(nodes_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        return from(all);
    }

private:
    /// The nodes that exist, each once, in the order in which they are named. O(n log n).
    std::vector<std::size_t> named(const std::vector<std::uint64_t>& indices, const std::string& where) const
    {
        std::vector<std::pair<std::size_t, std::size_t>> order;  // node, and where it is named
        order.reserve(indices.size());
        for (const std::uint64_t index : indices) {
            document_.element("nodes", index, "node", where);
            order.emplace_back(static_cast<std::size_t>(index), order.size());
        }
        std::sort(order.begin(), order.end());
        const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
        order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
        std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        document_.notes().add("nodes that are named again passed over", indices.size() - order.size());
        std::vector<std::size_t> nodes;
        nodes.reserve(order.size());
        for (const auto& [node, place] : order) nodes.push_back(node);
        return nodes;
    }

    std::vector<GltfPlacement> from(const std::vector<std::size_t>& starts)
    {
        find_families(starts);
        std::vector<GltfPlacement> placements;
        transforms_.assign(nodes_.size(), std::nullopt);
        std::vector<std::size_t> stack;
        for (auto start = starts.rbegin(); start != starts.rend(); ++start)
            if (parents_[*start] == kNoNode) stack.push_back(*start);
        std::size_t visited = 0;
        while (!stack.empty()) {
            const std::size_t node = stack.back();
            stack.pop_back();
            ++visited;
            if (const auto mesh = document_.index_if(nodes_[node], "mesh", name_of(node))) {
                document_.element("meshes", *mesh, "mesh", name_of(node));
                placements.push_back({*mesh, transform_of(node), instances_of(node)});
            }
            stack.insert(stack.end(), children_[node].rbegin(), children_[node].rend());
        }
        if (visited < reached_) document_.refuse("its nodes are not trees: some of them are below themselves");
        return placements;
    }

    /// Fills `parents_` and `children_` for all nodes at and below the ones where the walk starts.
    void find_families(const std::vector<std::size_t>& starts)
    {
        parents_.assign(nodes_.size(), kNoNode);
        children_.assign(nodes_.size(), {});
        reached_ = 0;
        std::vector<bool> is_reached(nodes_.size(), false);
        std::vector<std::size_t> stack = starts;
        while (!stack.empty()) {
            const std::size_t node = stack.back();
            stack.pop_back();
            if (is_reached[node]) continue;
            is_reached[node] = true;
            ++reached_;
            if (!nodes_[node].is_object()) document_.refuse(name_of(node) + " is not an object");
            children_[node] = named(document_.indices(nodes_[node], "children", name_of(node)), name_of(node));
            for (const std::size_t child : children_[node]) {
                if (parents_[child] != kNoNode)
                    document_.refuse(name_of(child) + " has two parents, " + name_of(parents_[child]) + " and " +
                                     name_of(node));
                parents_[child] = node;
                stack.push_back(child);
            }
        }
    }

    /// The number of these nodes that are below others, in the scene or not. Invalid references are ignored here.
    std::uint64_t count_children(const std::vector<std::size_t>& starts) const
    {
        std::vector<bool> is_child(nodes_.size(), false);
        for (const GltfJson& node : nodes_) {
            const auto children = node.find("children");
            if (children == node.end() || !children->is_array()) continue;
            for (const GltfJson& child : *children)
                if (child.is_number_unsigned() && child.get<std::uint64_t>() < is_child.size())
                    is_child[child.get<std::size_t>()] = true;
        }
        return static_cast<std::uint64_t>(
            std::count_if(starts.begin(), starts.end(), [&](std::size_t node) { return is_child[node]; }));
    }

    /// The transform of a node in the scene; those of the nodes above it are kept.
    const glm::dmat4& transform_of(std::size_t node)
    {
        std::vector<std::size_t> path{node};
        while (!transforms_[path.back()] && parents_[path.back()] != kNoNode) path.push_back(parents_[path.back()]);
        for (auto place = path.rbegin(); place != path.rend(); ++place) {
            if (transforms_[*place]) continue;
            const std::size_t parent = parents_[*place];
            const glm::dmat4 own = own_transform(*place);
            transforms_[*place] = parent == kNoNode ? own : *transforms_[parent] * own;
        }
        return *transforms_[node];
    }

    /// Numbers of a node. False if it has none of this name.
    template <std::size_t N>
    bool numbers(std::size_t node, const char* name, std::array<double, N>& values) const
    {
        const GltfJson* found = document_.member(nodes_[node], name);
        if (found == nullptr) return false;
        if (!found->is_array() || found->size() != N ||
            !std::all_of(found->begin(), found->end(), [](const GltfJson& n) { return n.is_number(); }))
            document_.refuse(in_quotes(name) + " of " + name_of(node) + " is not " + std::to_string(N) + " numbers");
        for (std::size_t i = 0; i < N; ++i) values[i] = (*found)[i].template get<double>();
        return true;
    }

    glm::dmat4 own_transform(std::size_t node) const
    {
        std::array<double, 16> m{};
        if (numbers(node, "matrix", m)) {
            glm::dmat4 matrix(1.0);
            for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];  // by columns
            return matrix;
        }
        std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
        std::array<double, 4> rotation{0, 0, 0, 1};
        numbers(node, "translation", translation);
        numbers(node, "rotation", rotation);
        numbers(node, "scale", scale);
        return compose({translation[0], translation[1], translation[2]}, rotation, {scale[0], scale[1], scale[2]});
    }

    GltfInstances instances_of(std::size_t node)
    {
        GltfInstances instances;
        const GltfJson* extension = document_.extension(nodes_[node], "EXT_mesh_gpu_instancing");
        const GltfJson* attributes = extension != nullptr ? document_.object_if(*extension, "attributes") : nullptr;
        if (attributes == nullptr) return instances;
        const std::string where = "the instances of " + name_of(node);
        bool is_first = true;
        const auto find = [&](const char* name, std::uint64_t width) -> const GltfAccessor* {
            const auto index = document_.index_if(*attributes, name, where);
            if (!index) return nullptr;
            const GltfAccessor& accessor = accessors_.at(*index, where);
            if (accessor.width != width)
                document_.refuse(in_quotes(name) + " of " + where + " does not have " + std::to_string(width) +
                                 " numbers for each");
            if (!is_first && accessor.count != instances.count)
                document_.refuse(where + " have " + std::to_string(accessor.count) + " values in " + in_quotes(name) +
                                 ", but " + std::to_string(instances.count) + " in another list");
            instances.count = accessor.count;
            is_first = false;
            return &accessor;
        };
        instances.translation = find("TRANSLATION", 3);
        instances.rotation = find("ROTATION", 4);
        instances.scale = find("SCALE", 3);
        return instances;
    }

    const GltfDocument& document_;
    GltfAccessors& accessors_;
    const GltfJson& nodes_;
    std::vector<std::size_t> parents_;
    std::vector<std::vector<std::size_t>> children_;
    std::vector<std::optional<glm::dmat4>> transforms_;
    std::size_t reached_ = 0;
};

}  // namespace

glm::dmat4 GltfInstances::transform(std::uint64_t i) const
{
    glm::dvec3 move(0.0), size(1.0);
    std::array<double, 4> turn{0, 0, 0, 1};
    for (int k = 0; k < 3; ++k) {
        if (translation != nullptr) move[k] = translation->value(i, static_cast<std::uint64_t>(k));
        if (scale != nullptr) size[k] = scale->value(i, static_cast<std::uint64_t>(k));
    }
    for (std::size_t k = 0; k < 4; ++k)
        if (rotation != nullptr) turn[k] = rotation->value(i, k);
    return compose(move, turn, size);
}

std::vector<GltfPlacement> placements_of(const GltfDocument& document, GltfAccessors& accessors)
{
    Walk walk(document, accessors);
    std::vector<GltfPlacement> placements = walk.from_scene();
    if (!placements.empty()) return placements;
    placements = walk.from_all();
    if (placements.empty())
        for (std::size_t mesh = 0; mesh < document.list("meshes").size(); ++mesh)
            placements.push_back({mesh, glm::dmat4(1.0), {}});
    if (!placements.empty() && !document.list("scenes").empty())
        document.notes().add("scenes that show no mesh passed over");
    return placements;
}

}  // namespace kerf::core::io
