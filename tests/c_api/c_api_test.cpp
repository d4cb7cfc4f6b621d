// kerf/c.h: what C sees is what C++ sees, and no null, no size and no number that makes no sense does harm.

#include <gtest/gtest.h>
#include <kerf/c.h>
#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kerf {
namespace {

struct Free
{
    void operator()(void* handle) const { kerf_free(handle); }
};
template <class T>
using Held = std::unique_ptr<T, Free>;

template <class T>
T sized()
{
    T t{};
    t.size = sizeof(T);
    return t;
}

kerf_plane plane_at(const std::array<double, 3>& point, const std::array<double, 3>& normal)
{
    auto plane = sized<kerf_plane>();
    std::copy(point.begin(), point.end(), plane.point);
    std::copy(normal.begin(), normal.end(), plane.normal);
    return plane;
}

template <class T>
bool equal(std::span<const T> expected, const T* found)
{
    return expected.empty() || std::memcmp(expected.data(), found, expected.size_bytes()) == 0;
}

bool is_at(const double* found, const Vec3d& expected)
{
    return found[0] == expected.x && found[1] == expected.y && found[2] == expected.z;
}

/// A mesh, an object and a plane, for C and for C++.
class CApi : public testing::Test
{
protected:
    CApi()
    {
        const MeshArrays arrays = shape_.arrays();
        input_.positions = &arrays.positions.data()->x;
        input_.vertex_count = arrays.positions.size();
        input_.indices = arrays.indices.data();
        input_.triangle_count = arrays.indices.size() / 3;
        input_.normals = &arrays.normals.data()->x;
        input_.uvs = &arrays.uvs.data()->x;
        mesh_ = make(input_);
        object_ = prepare();

        MeshInput same;
        same.positions = input_.positions;
        same.vertex_count = input_.vertex_count;
        same.indices = input_.indices;
        same.triangle_count = input_.triangle_count;
        same.normals = input_.normals;
        same.uvs = input_.uvs;
        cpp_mesh_ = *Mesh::make(same);
        cpp_object_ = *kerf::prepare(cpp_mesh_);
    }

    Held<kerf_mesh> make(const kerf_mesh_input& input)
    {
        kerf_mesh* mesh = nullptr;
        EXPECT_EQ(kerf_mesh_make(&input, &mesh, reason_, sizeof reason_), KERF_DONE) << reason_;
        return Held<kerf_mesh>(mesh);
    }
    Held<kerf_object> prepare()
    {
        kerf_object* object = nullptr;
        EXPECT_EQ(kerf_prepare(mesh_.get(), nullptr, &object, reason_, sizeof reason_), KERF_DONE) << reason_;
        return Held<kerf_object>(object);
    }

    const Mesh shape_ = *make_shape("asteroid", 2'000);
    char reason_[200] = "";
    kerf_mesh_input input_ = sized<kerf_mesh_input>();
    Held<kerf_mesh> mesh_;
    Held<kerf_object> object_;
    kerf_plane plane_ = plane_at({0.01, 0.02, 0.03}, {1.0, 2.0, 3.0});
    Mesh cpp_mesh_;
    Object cpp_object_;
    const Plane cpp_plane_ = *Plane::at(Point(0.01, 0.02, 0.03), Normal(1.0, 2.0, 3.0));
};

TEST_F(CApi, MeshesHaveTheirArrays)
{
    auto found = sized<kerf_mesh_arrays>();
    ASSERT_EQ(kerf_mesh_get_arrays(mesh_.get(), &found), KERF_DONE);
    const MeshArrays expected = cpp_mesh_.arrays();
    ASSERT_EQ(found.vertex_count, expected.positions.size());
    ASSERT_EQ(found.triangle_count, expected.indices.size() / 3);
    EXPECT_EQ(found.point_count, expected.point_count);
    EXPECT_TRUE(equal(expected.indices, found.indices));
    EXPECT_TRUE(equal(expected.sources, found.sources));
    EXPECT_EQ(std::memcmp(expected.positions.data(), found.positions, expected.positions.size_bytes()), 0);
    EXPECT_EQ(std::memcmp(expected.normals.data(), found.normals, expected.normals.size_bytes()), 0);
    EXPECT_TRUE(std::all_of(found.is_cap, found.is_cap + found.triangle_count, [](uint8_t cap) { return cap == 0; }));
}

TEST_F(CApi, MeshesHaveTheirStreamsAndMaterials)
{
    std::vector<float> values(2 * input_.vertex_count);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i);
    auto stream = sized<kerf_stream>();
    stream.name = "heat";
    stream.width = 2;
    stream.values = values.data();
    auto material = sized<kerf_material>();
    material.name = "rock";
    input_.streams = &stream;
    input_.materials = &material;
    input_.stream_count = input_.material_count = 1;
    const Held<kerf_mesh> mesh = make(input_);
    auto found = sized<kerf_stream>();
    ASSERT_EQ(kerf_mesh_get_stream(mesh.get(), 0, &found), KERF_DONE);
    EXPECT_STREQ(found.name, "heat");
    EXPECT_EQ(found.width, 2u);
    EXPECT_EQ(kerf_mesh_get_stream(mesh.get(), 1, &found), KERF_INVALID_ARGUMENT);
}

TEST_F(CApi, CutsAreThoseOfCpp)
{
    kerf_object* object = object_.release();
    kerf_pieces* made = nullptr;
    auto options = sized<kerf_cut_options>();
    ASSERT_EQ(kerf_cut(&object, &plane_, &options, &made, reason_, sizeof reason_), KERF_DONE) << reason_;
    EXPECT_EQ(object, nullptr);
    EXPECT_STREQ(reason_, "");
    const Held<kerf_pieces> pieces(made);
    Cut cut = kerf::cut(std::move(cpp_object_), cpp_plane_);
    auto facts = sized<kerf_cut_facts>();
    ASSERT_EQ(kerf_pieces_get_facts(pieces.get(), &facts), KERF_DONE);
    EXPECT_EQ(facts.section_area, cut.section_area);
    EXPECT_EQ(facts.crossing_triangles, cut.statistics().crossing_triangles);
    for (const Side side : {Side::negative, Side::positive}) {
        const auto number = static_cast<int32_t>(side);
        ASSERT_EQ(facts.count[number], 1u);
        const Held<kerf_object> piece(kerf_pieces_take(pieces.get(), number, 0));
        ASSERT_NE(piece, nullptr);
        EXPECT_EQ(kerf_pieces_take(pieces.get(), number, 0), nullptr);
        EXPECT_EQ(kerf_pieces_take(pieces.get(), number, 1), nullptr);
        auto of_piece = sized<kerf_object_facts>();
        ASSERT_EQ(kerf_object_get_facts(piece.get(), &of_piece), KERF_DONE);
        const MassProperties mass = cut.one(side)->mass_properties();
        EXPECT_EQ(of_piece.volume, mass.volume);
        EXPECT_EQ(of_piece.is_solid, 1);
        EXPECT_EQ(of_piece.triangle_count, cut.one(side)->triangle_count());
        EXPECT_STREQ(of_piece.back_end, cut.one(side)->back_end_name());
        EXPECT_TRUE(std::equal(of_piece.inertia, of_piece.inertia + 9, &mass.inertia.m[0][0]));
        kerf_mesh* mesh = nullptr;
        ASSERT_EQ(kerf_object_get_mesh(piece.get(), &mesh), KERF_DONE);
        const Held<kerf_mesh> held(mesh);
        auto arrays = sized<kerf_mesh_arrays>();
        ASSERT_EQ(kerf_mesh_get_arrays(mesh, &arrays), KERF_DONE);
        const Mesh expected = *cut.one(side)->mesh();
        ASSERT_EQ(arrays.triangle_count, expected.triangle_count());
        EXPECT_TRUE(equal(expected.arrays().indices, arrays.indices));
    }
}

TEST_F(CApi, AMissLeavesTheObject)
{
    kerf_object* object = object_.get();
    const kerf_plane beside = plane_at({0.0, 0.0, 100.0}, {0.0, 0.0, 1.0});
    kerf_pieces* made = nullptr;
    ASSERT_EQ(kerf_cut(&object, &beside, nullptr, &made, reason_, sizeof reason_), KERF_MISSED);
    EXPECT_EQ(object, object_.get());
    const Held<kerf_pieces> pieces(made);
    auto facts = sized<kerf_cut_facts>();
    ASSERT_EQ(kerf_pieces_get_facts(pieces.get(), &facts), KERF_DONE);
    EXPECT_EQ(facts.status, KERF_MISSED);
    EXPECT_EQ(facts.side_of_object, KERF_NEGATIVE);
    EXPECT_EQ(kerf_pieces_take(pieces.get(), KERF_NEGATIVE, 0), nullptr);
    kerf_object* copy = nullptr;
    ASSERT_EQ(kerf_object_clone(object, &copy), KERF_DONE);
    const Held<kerf_object> held(copy);
}

TEST_F(CApi, SectionsAreThoseOfCpp)
{
    kerf_section* made = nullptr;
    auto options = sized<kerf_section_options>();
    options.fill = 1;
    ASSERT_EQ(kerf_section_find(object_.get(), &plane_, &options, &made, reason_, sizeof reason_), KERF_DONE);
    const Held<kerf_section> section(made);
    auto found = sized<kerf_section_arrays>();
    ASSERT_EQ(kerf_section_get_arrays(section.get(), &found), KERF_DONE);
    SectionOptions filled;
    filled.fill = true;
    const Section expected = kerf::section(cpp_object_, cpp_plane_, filled);
    EXPECT_EQ(found.area, expected.area);
    ASSERT_EQ(found.path_count, expected.path_count());
    ASSERT_EQ(found.point_count, expected.points().size());
    EXPECT_EQ(std::memcmp(found.points, expected.points().data(), expected.points().size_bytes()), 0);
    ASSERT_EQ(found.triangle_count, expected.triangles().size() / 3);
    EXPECT_TRUE(equal(expected.triangles(), found.triangles));
    for (std::size_t p = 0; p < found.path_count; ++p) {
        const SectionPath path = expected.path(p);
        ASSERT_EQ(found.path_starts[p + 1] - found.path_starts[p], path.points.size());
        EXPECT_EQ(found.areas[p], path.area);
        EXPECT_EQ(found.parents[p], path.parent);
        EXPECT_EQ(found.is_closed[p], 1);
        for (std::size_t i = 0; i < path.edges.size(); ++i)
            EXPECT_EQ(found.sources[found.path_starts[p] + i], path.edges[i].source);
    }
    // Used again.
    const kerf_plane beside = plane_at({0.0, 0.0, 100.0}, {0.0, 0.0, 1.0});
    EXPECT_EQ(kerf_section_find(object_.get(), &beside, nullptr, &made, nullptr, 0), KERF_MISSED);
    ASSERT_EQ(kerf_section_get_arrays(section.get(), &found), KERF_DONE);
    EXPECT_EQ(found.status, KERF_MISSED);
    EXPECT_EQ(found.path_count, 0u);
}

TEST_F(CApi, BreaksAsCppDoes)
{
    auto options = sized<kerf_fracture_options>();
    options.pattern = KERF_IMPACT;
    options.cells = 12;
    options.has_at = 1;
    options.at[1] = 0.3;
    options.seed = 7;
    options.uv_scale = 2.0;
    options.material = 1;
    kerf_fracture* made = nullptr;
    ASSERT_EQ(kerf_fracture_make(object_.get(), &options, &made, reason_, sizeof reason_), KERF_DONE) << reason_;
    const Held<kerf_fracture> fracture(made);
    FractureOptions same;
    same.pattern = FracturePattern::impact;
    same.cells = 12;
    same.at = Point(0.0, 0.3, 0.0);
    same.seed = 7;
    same.uv_scale = 2.0;
    same.material = 0;
    Fracture expected = kerf::fracture(cpp_object_, same);

    auto found = sized<kerf_fracture_arrays>();
    ASSERT_EQ(kerf_fracture_get_arrays(fracture.get(), &found), KERF_DONE);
    ASSERT_EQ(found.piece_count, expected.count());
    ASSERT_EQ(found.site_count, expected.sites().size());
    EXPECT_EQ(std::memcmp(found.sites, expected.sites().data(), expected.sites().size_bytes()), 0);
    ASSERT_EQ(found.bond_count, expected.bonds().size());
    EXPECT_GT(found.bond_count, 10u);
    for (std::size_t b = 0; b < found.bond_count; ++b) {
        const FractureBond& bond = expected.bonds()[b];
        EXPECT_EQ(found.bonds[2 * b], bond.first);
        EXPECT_EQ(found.bonds[2 * b + 1], bond.second);
        EXPECT_EQ(found.areas[b], bond.area);
        EXPECT_TRUE(is_at(found.centres + 3 * b, bond.centre));
        EXPECT_TRUE(is_at(found.normals + 3 * b, bond.normal));
    }
    for (std::size_t i = 0; i < found.piece_count; ++i) {
        const std::span<const std::uint32_t> cells = expected.cells(i);
        ASSERT_EQ(found.cell_starts[i + 1] - found.cell_starts[i], cells.size());
        EXPECT_TRUE(equal(cells, found.cells + found.cell_starts[i]));
        const Held<kerf_object> piece(kerf_fracture_take(fracture.get(), i));
        ASSERT_NE(piece, nullptr);
        EXPECT_EQ(kerf_fracture_take(fracture.get(), i), nullptr) << "it was taken";
        auto facts = sized<kerf_object_facts>();
        ASSERT_EQ(kerf_object_get_facts(piece.get(), &facts), KERF_DONE);
        EXPECT_EQ(facts.volume, expected.piece(i)->mass_properties().volume);
        EXPECT_EQ(facts.triangle_count, expected.piece(i)->triangle_count());
    }
    EXPECT_EQ(kerf_fracture_take(fracture.get(), found.piece_count), nullptr);
}

TEST_F(CApi, BreaksByDefaultsAndByGivenSites)
{
    kerf_fracture* made = nullptr;
    ASSERT_EQ(kerf_fracture_make(object_.get(), nullptr, &made, nullptr, 0), KERF_DONE);
    const Held<kerf_fracture> by_default(made);
    auto found = sized<kerf_fracture_arrays>();
    ASSERT_EQ(kerf_fracture_get_arrays(made, &found), KERF_DONE);
    EXPECT_EQ(found.site_count, FractureOptions().cells);

    const double sites[]{-0.3, 0.0, 0.0, 0.3, 0.0, 0.0};
    auto options = sized<kerf_fracture_options>();
    options.sites = sites;
    options.site_count = 2;
    ASSERT_EQ(kerf_fracture_make(object_.get(), &options, &made, nullptr, 0), KERF_DONE);
    const Held<kerf_fracture> by_sites(made);
    ASSERT_EQ(kerf_fracture_get_arrays(made, &found), KERF_DONE);
    EXPECT_EQ(found.site_count, 2u);
    EXPECT_TRUE(std::ranges::equal(std::span(found.sites, 6), sites));
}

TEST_F(CApi, RefusesToBreakWhatMakesNoSense)
{
    kerf_fracture* made = nullptr;
    const auto answer = [&](const std::function<void(kerf_fracture_options&)>& change) {
        auto options = sized<kerf_fracture_options>();
        change(options);
        const kerf_status status = kerf_fracture_make(object_.get(), &options, &made, reason_, sizeof reason_);
        EXPECT_EQ(made, nullptr);
        EXPECT_STRNE(reason_, "");
        return status;
    };
    const double site[]{0.0, 0.0, 0.0};
    for (const int32_t wrong : {-1, 5, 256, std::numeric_limits<int32_t>::max()})
        EXPECT_EQ(answer([&](auto& o) { o.pattern = wrong; }), KERF_INVALID_ARGUMENT);
    EXPECT_EQ(answer([](auto& o) { o.site_count = 1; }), KERF_INVALID_ARGUMENT);
    EXPECT_EQ(answer([&](auto& o) {
                  o.sites = site;
                  o.site_count = std::numeric_limits<std::size_t>::max();
              }),
              KERF_INVALID_ARGUMENT);
    EXPECT_EQ(answer([](auto& o) { o.least_volume = -1.0; }), KERF_INVALID_ARGUMENT);
    EXPECT_EQ(answer([](auto& o) { o.direction[0] = std::numeric_limits<double>::quiet_NaN(); }),
              KERF_INVALID_ARGUMENT);
    EXPECT_EQ(answer([](auto& o) { o.progress = [](void*, double share) { return share < 0.3 ? 1 : 0; }; }),
              KERF_CANCELLED);
}

TEST_F(CApi, DrawsWhatCppDraws)
{
    kerf_draw* made = nullptr;
    ASSERT_EQ(kerf_object_draw(object_.get(), &made), KERF_DONE);
    const Held<kerf_draw> draw(made);
    auto found = sized<kerf_draw_arrays>();
    ASSERT_EQ(kerf_draw_get_arrays(draw.get(), &found), KERF_DONE);
    DrawView expected;
    ASSERT_EQ(cpp_object_.draw(expected), Status::done);
    ASSERT_EQ(found.vertex_count, expected.vertices.size());
    EXPECT_EQ(std::memcmp(found.vertices, expected.vertices.data(), expected.vertices.size_bytes()), 0);
    ASSERT_EQ(found.range_count, expected.ranges.size());
    EXPECT_EQ(found.ranges[1], expected.ranges[0].index_count);
    EXPECT_EQ(found.new_vertices_from, 0u);
    ASSERT_EQ(kerf_object_mark_uploaded(object_.get(), draw.get()), KERF_DONE);
    ASSERT_EQ(kerf_object_draw(object_.get(), &made), KERF_DONE);
    ASSERT_EQ(kerf_draw_get_arrays(draw.get(), &found), KERF_DONE);
    EXPECT_EQ(found.new_vertices_from, found.vertex_count);
}

TEST_F(CApi, PlanesOfTheWorldBecomeLocal)
{
    const double moved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    const kerf_plane world = plane_at({5.0, 6.0, 7.5}, {0.0, 0.0, 2.0});
    auto local = sized<kerf_plane>();
    ASSERT_EQ(kerf_plane_to_local(&world, moved, &local), KERF_DONE);
    EXPECT_EQ(local.normal[2], 1.0);
    EXPECT_EQ(local.point[2], 0.5);
    const double flat[16] = {};
    EXPECT_EQ(kerf_plane_to_local(&world, flat, &local), KERF_INVALID_ARGUMENT);
}

TEST_F(CApi, PreparingCanBeStopped)
{
    auto options = sized<kerf_prepare_options>();
    options.progress = [](void*, double) { return 0; };
    kerf_object* object = nullptr;
    EXPECT_EQ(kerf_prepare(mesh_.get(), &options, &object, reason_, sizeof reason_), KERF_CANCELLED);
    EXPECT_EQ(object, nullptr);
    EXPECT_STRNE(reason_, "");
    options = sized<kerf_prepare_options>();
    options.back_end = "none such";
    EXPECT_EQ(kerf_prepare(mesh_.get(), &options, &object, reason_, sizeof reason_), KERF_INVALID_ARGUMENT);
}

TEST_F(CApi, ReasonsFitTheirRoom)
{
    kerf_mesh* mesh = nullptr;
    EXPECT_EQ(kerf_mesh_read("no/such.obj", &mesh, reason_, sizeof reason_), KERF_UNUSABLE_FILE);
    EXPECT_NE(std::string(reason_).find("no/such.obj"), std::string::npos);
    char little[8] = "1234567";
    EXPECT_EQ(kerf_mesh_read("no/such.obj", &mesh, little, 4), KERF_UNUSABLE_FILE);
    EXPECT_EQ(std::strlen(little), 3u);
    EXPECT_EQ(little[4], '5');
    EXPECT_EQ(kerf_mesh_read("no/such.obj", &mesh, little, 0), KERF_UNUSABLE_FILE);
    EXPECT_EQ(std::strlen(little), 3u);
    EXPECT_EQ(kerf_mesh_read("no/such.obj", &mesh, nullptr, 5), KERF_UNUSABLE_FILE);
}

TEST_F(CApi, StatusesHaveTexts)
{
    EXPECT_STREQ(kerf_status_text(KERF_DONE), "done");
    EXPECT_STREQ(kerf_status_text(KERF_NOT_SEPARATED), text(Status::not_separated));
    for (const kerf_status wrong : {-1, 9, 256, std::numeric_limits<kerf_status>::max()})
        EXPECT_STREQ(kerf_status_text(wrong), "unknown");
    EXPECT_STREQ(kerf_version(), version());
    EXPECT_EQ(kerf_bits_version(), bits_version());
}

/// A struct is tried null and with all sizes that are not its own, in memory of just that size.
template <class T>
void expect_refused(T good, const std::function<kerf_status(T*)>& call)
{
    EXPECT_EQ(call(nullptr), KERF_INVALID_ARGUMENT);
    for (const uint32_t size : {0u, 1u, 4u, 8u, uint32_t(sizeof(T)) - 1, uint32_t(sizeof(T)) + 1, 1000u, 0xFFFFFFFFu}) {
        T wrong = good;
        wrong.size = size;
        EXPECT_EQ(call(&wrong), KERF_INVALID_ARGUMENT) << size;
    }
}

TEST_F(CApi, RefusesStructsThatAreNullOrOfAnotherSize)
{
    kerf_mesh* mesh = nullptr;
    kerf_object* object = object_.get();
    kerf_object* other = nullptr;
    kerf_pieces* pieces = nullptr;
    kerf_section* section = nullptr;
    kerf_draw* draw = nullptr;
    kerf_fracture* fracture = nullptr;
    ASSERT_EQ(kerf_fracture_make(object, nullptr, &fracture, nullptr, 0), KERF_DONE);
    const Held<kerf_fracture> held_fracture(fracture);
    expect_refused<kerf_fracture_arrays>(sized<kerf_fracture_arrays>(),
                                         [&](auto* out) { return kerf_fracture_get_arrays(held_fracture.get(), out); });
    ASSERT_EQ(kerf_section_find(object, &plane_, nullptr, &section, nullptr, 0), KERF_DONE);
    ASSERT_EQ(kerf_object_draw(object, &draw), KERF_DONE);
    const Held<kerf_section> held_section(section);
    const Held<kerf_draw> held_draw(draw);
    const double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    auto plane = plane_;

    expect_refused<kerf_mesh_input>(input_, [&](auto* in) { return kerf_mesh_make(in, &mesh, nullptr, 0); });
    expect_refused<kerf_mesh_arrays>(sized<kerf_mesh_arrays>(),
                                     [&](auto* out) { return kerf_mesh_get_arrays(mesh_.get(), out); });
    expect_refused<kerf_plane>(plane_, [&](auto* in) { return kerf_plane_to_local(in, matrix, &plane); });
    expect_refused<kerf_plane>(plane_, [&](auto* out) { return kerf_plane_to_local(&plane_, matrix, out); });
    expect_refused<kerf_object_facts>(sized<kerf_object_facts>(),
                                      [&](auto* out) { return kerf_object_get_facts(object, out); });
    expect_refused<kerf_plane>(plane_, [&](auto* in) { return kerf_cut(&object, in, nullptr, &pieces, nullptr, 0); });
    expect_refused<kerf_plane>(plane_,
                               [&](auto* in) { return kerf_section_find(object, in, nullptr, &section, nullptr, 0); });
    expect_refused<kerf_section_arrays>(sized<kerf_section_arrays>(),
                                        [&](auto* out) { return kerf_section_get_arrays(section, out); });
    expect_refused<kerf_draw_arrays>(sized<kerf_draw_arrays>(),
                                     [&](auto* out) { return kerf_draw_get_arrays(draw, out); });
    // Null options say nothing; those of a wrong size are refused.
    const auto unless_null = [](auto* options, auto call) {
        return options == nullptr ? KERF_INVALID_ARGUMENT : call();
    };
    expect_refused<kerf_cut_options>(sized<kerf_cut_options>(), [&](auto* in) {
        return unless_null(in, [&] { return kerf_cut(&object, &plane_, in, &pieces, nullptr, 0); });
    });
    expect_refused<kerf_section_options>(sized<kerf_section_options>(), [&](auto* in) {
        return unless_null(in, [&] { return kerf_section_find(object, &plane_, in, &section, nullptr, 0); });
    });
    expect_refused<kerf_fracture_options>(sized<kerf_fracture_options>(), [&](auto* in) {
        return unless_null(in, [&] { return kerf_fracture_make(object, in, &fracture, nullptr, 0); });
    });
    expect_refused<kerf_prepare_options>(sized<kerf_prepare_options>(), [&](auto* in) {
        return unless_null(in, [&] { return kerf_prepare(mesh_.get(), in, &other, nullptr, 0); });
    });
    // In lists.
    expect_refused<kerf_stream>(sized<kerf_stream>(), [&](auto* in) {
        input_.streams = in;
        input_.stream_count = 1;
        return kerf_mesh_make(&input_, &mesh, nullptr, 0);
    });
    input_.stream_count = 0;
    expect_refused<kerf_material>(sized<kerf_material>(), [&](auto* in) {
        input_.materials = in;
        input_.material_count = 1;
        return kerf_mesh_make(&input_, &mesh, nullptr, 0);
    });
    EXPECT_EQ(object, object_.get());
    EXPECT_EQ(mesh, nullptr);
    EXPECT_EQ(other, nullptr);
    EXPECT_EQ(pieces, nullptr);

    ASSERT_EQ(kerf_cut(&object, &plane_, nullptr, &pieces, nullptr, 0), KERF_DONE);
    static_cast<void>(object_.release());
    const Held<kerf_pieces> held_pieces(pieces);
    expect_refused<kerf_cut_facts>(sized<kerf_cut_facts>(),
                                   [&](auto* out) { return kerf_pieces_get_facts(pieces, out); });
}

TEST_F(CApi, RefusesHandlesThatAreNull)
{
    auto arrays = sized<kerf_mesh_arrays>();
    auto stream = sized<kerf_stream>();
    auto facts = sized<kerf_object_facts>();
    auto of_cut = sized<kerf_cut_facts>();
    auto of_section = sized<kerf_section_arrays>();
    auto of_draw = sized<kerf_draw_arrays>();
    auto of_fracture = sized<kerf_fracture_arrays>();
    auto local = plane_;
    kerf_mesh* mesh = mesh_.get();
    kerf_object *object = object_.get(), *nothing = nullptr;
    kerf_pieces* pieces = nullptr;
    kerf_section* section = nullptr;
    kerf_draw* draw = nullptr;
    kerf_fracture* fracture = nullptr;
    for (const kerf_status status : {kerf_mesh_make(&input_, nullptr, nullptr, 0),
                                     kerf_mesh_read("x.obj", nullptr, nullptr, 0),
                                     kerf_mesh_read(nullptr, &mesh, nullptr, 0),
                                     kerf_mesh_write(nullptr, "x.obj", nullptr, 0),
                                     kerf_mesh_write(mesh_.get(), nullptr, nullptr, 0),
                                     kerf_mesh_get_arrays(nullptr, &arrays),
                                     kerf_mesh_get_stream(nullptr, 0, &stream),
                                     kerf_plane_to_local(&plane_, nullptr, &local),
                                     kerf_prepare(nullptr, nullptr, &nothing, nullptr, 0),
                                     kerf_prepare(mesh_.get(), nullptr, nullptr, nullptr, 0),
                                     kerf_object_clone(nullptr, &nothing),
                                     kerf_object_clone(object, nullptr),
                                     kerf_object_get_facts(nullptr, &facts),
                                     kerf_object_get_mesh(nullptr, &mesh),
                                     kerf_object_get_mesh(object, nullptr),
                                     kerf_cut(nullptr, &plane_, nullptr, &pieces, nullptr, 0),
                                     kerf_cut(&nothing, &plane_, nullptr, &pieces, nullptr, 0),
                                     kerf_cut(&object, &plane_, nullptr, nullptr, nullptr, 0),
                                     kerf_pieces_get_facts(nullptr, &of_cut),
                                     kerf_section_find(nullptr, &plane_, nullptr, &section, nullptr, 0),
                                     kerf_section_find(object, &plane_, nullptr, nullptr, nullptr, 0),
                                     kerf_section_get_arrays(nullptr, &of_section),
                                     kerf_fracture_make(nullptr, nullptr, &fracture, nullptr, 0),
                                     kerf_fracture_make(object, nullptr, nullptr, nullptr, 0),
                                     kerf_fracture_get_arrays(nullptr, &of_fracture),
                                     kerf_object_draw(nullptr, &draw),
                                     kerf_object_draw(object, nullptr),
                                     kerf_draw_get_arrays(nullptr, &of_draw),
                                     kerf_object_mark_uploaded(nullptr, draw),
                                     kerf_object_mark_uploaded(object, nullptr)})
        EXPECT_EQ(status, KERF_INVALID_ARGUMENT);
    EXPECT_EQ(kerf_pieces_take(nullptr, KERF_POSITIVE, 0), nullptr);
    EXPECT_EQ(kerf_fracture_take(nullptr, 0), nullptr);
    kerf_free(nullptr);
    EXPECT_EQ(object, object_.get());
    for (const kerf_plane& wrong :
         {plane_at({0, 0, 0}, {0, 0, 0}), plane_at({0, 0, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}),
          plane_at({std::numeric_limits<double>::infinity(), 0, 0}, {0, 0, 1})})
        EXPECT_EQ(kerf_cut(&object, &wrong, nullptr, &pieces, reason_, sizeof reason_), KERF_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace kerf
