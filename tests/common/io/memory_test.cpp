#include "common/io/test_files.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"

namespace kerf::core::io {
namespace {

using MemoryTest = MeshFileTest;

TEST_F(MemoryTest, HasTheBytesOfTheFile)
{
    const IndexedMesh mesh = *repair(shapes::torus(1.0f, 0.4f, 12, 8)).mesh;
    for (const std::string& format : writable_formats()) {
        SCOPED_TRACE(format);
        write_mesh(folder_ / ("a." + format), mesh);
        EXPECT_EQ(mesh_bytes(mesh, format), text_of("a." + format));
    }
}

TEST_F(MemoryTest, ReadsWhatItHasWritten)
{
    const IndexedMesh mesh = *repair(shapes::torus(1.0f, 0.4f, 12, 8)).mesh;
    for (const std::string& format : writable_formats()) {
        SCOPED_TRACE(format);
        const std::string bytes = mesh_bytes(mesh, format);
        const LoadedMesh loaded = read_mesh(bytes, format);
        EXPECT_EQ(loaded.mesh->triangles.size(), mesh.triangles.size());
        EXPECT_TRUE(loaded.facts.closed());
        EXPECT_TRUE(loaded.files.empty());
    }
}

/// What FileError says; empty if nothing is thrown.
template <class Act>
std::string reason(Act act)
{
    try {
        act();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

TEST_F(MemoryTest, HasNoOtherFilesBesideIt)
{
    // A file of that name in the folder that the program runs in is none of its business.
    const TriangleSoup soup = read_soup("mtllib models.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj");
    EXPECT_EQ(soup.triangles.size(), 1u);
    EXPECT_EQ(soup.materials.at(0).name, "red");
    const std::string gltf = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"a.bin"}],)"
                             R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
                             R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                             R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],)"
                             R"("scenes":[{"nodes":[0]}],"scene":0})";
    EXPECT_NE(reason([&] { read_soup(gltf, "gltf"); }).find("put the buffer into the file"), std::string::npos);
}

TEST_F(MemoryTest, SaysWhatIsWrongInOneSentence)
{
    EXPECT_EQ(reason([] { read_mesh("", "ply"); }), "memory.ply: it is empty; export it again");
    EXPECT_NE(reason([] { read_mesh("solid", "bmp"); }).find("the extension is not one of"), std::string::npos);
    EXPECT_NE(reason([] { read_mesh("v 0 0 0\n", "obj"); }).find("memory.obj: "), std::string::npos);
    EXPECT_NE(reason([] { mesh_bytes(IndexedMesh{}, "ply"); }).find("it cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace kerf::core::io
