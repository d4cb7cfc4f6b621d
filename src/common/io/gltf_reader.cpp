#include <assimp/DefaultIOSystem.h>
#include <assimp/GltfMaterial.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/io/gltf_document.h"
#include "common/io/mesh_file.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"

// Reads glTF with Assimp, without any of its post-processing: steps that join, split or move vertices would not leave
// the coordinates as they are. Nodes are walked here, in double.

namespace kerf::io {

namespace {

/// Gives Assimp the checked document under the file's own name, and buffers beside it from the disk.
class CheckedFile : public Assimp::DefaultIOSystem
{
public:
    CheckedFile(std::string name, std::string document) : name_(std::move(name)), document_(std::move(document)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        if (name_ != file) return DefaultIOSystem::Open(file, mode);
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(document_.data()), document_.size());
    }

private:
    std::string name_, document_;
};

glm::dmat4 to_matrix(const aiMatrix4x4& m)
{
    // Assimp's rows are glm's columns.
    return glm::transpose(
        glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

glm::dvec3 to_vector(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

Material to_material(const aiMaterial& source)
{
    Material material;
    material.name = source.GetName().C_Str();
    aiColor4D colour;
    if (source.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS)
        material.colour = {colour.r, colour.g, colour.b, colour.a};
    aiString texture;
    // "*0" is an image inside the file, which has no name that would mean anything outside.
    if (source.GetTexture(aiTextureType_BASE_COLOR, 0, &texture) == AI_SUCCESS && texture.C_Str()[0] != '*')
        material.texture = texture.C_Str();
    return material;
}

std::uint64_t count_triangles(const aiScene& scene)
{
    std::uint64_t count = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        for (unsigned k = 0; k < scene.mMeshes[i]->mNumFaces; ++k)
            count += scene.mMeshes[i]->mFaces[k].mNumIndices == 3;
    return count;
}

class SceneReader
{
public:
    SceneReader(const std::filesystem::path& path, const aiScene& scene) : path_(path), scene_(scene), builder_(path) {}

    TriangleSoup read()
    {
        for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
            builder_.soup.materials.push_back(to_material(*scene_.mMaterials[i]));
        plan_streams();
        if (scene_.mRootNode != nullptr) add_node(*scene_.mRootNode, glm::dmat4(1.0));
        return builder_.finish();
    }

private:
    /// One stream for everything that some mesh has; others get white and 0.
    void plan_streams()
    {
        for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
            const aiMesh& mesh = *scene_.mMeshes[i];
            has_colour_ = has_colour_ || mesh.HasVertexColors(0);
            for (unsigned k = 1; k < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++k)
                if (mesh.HasTextureCoords(k)) uv_sets_ = std::max(uv_sets_, k + 1);
        }
        if (has_colour_) builder_.soup.streams.push_back({"color", 4, {}});
        for (unsigned k = 1; k < uv_sets_; ++k) builder_.soup.streams.push_back({"uv" + std::to_string(k), 2, {}});
    }

    void add_node(const aiNode& node, const glm::dmat4& parent)
    {
        const glm::dmat4 transform = parent * to_matrix(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(*scene_.mMeshes[node.mMeshes[i]], transform);
        for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], transform);
    }

    void add_mesh(const aiMesh& mesh, const glm::dmat4& transform)
    {
        constexpr unsigned kSurface = aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON;
        if ((mesh.mPrimitiveTypes & kSurface) == 0) return;
        const std::vector<std::uint32_t> index = add_vertices(mesh, transform);

        builder_.use_material(mesh.mMaterialIndex);
        // A transform that mirrors turns triangles inside out.
        const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0.0;
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            face_.clear();
            for (unsigned k = 0; k < face.mNumIndices; ++k) face_.push_back(index[face.mIndices[k]]);
            if (mirrored) std::reverse(face_.begin(), face_.end());
            builder_.add_face(face_);
        }
    }

    /// Adds the vertices that faces use (primitives may share one long list) and returns their indices.
    std::vector<std::uint32_t> add_vertices(const aiMesh& mesh, const glm::dmat4& transform)
    {
        constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
        std::vector<std::uint32_t> index(mesh.mNumVertices, kUnused);
        for (unsigned i = 0; i < mesh.mNumFaces; ++i)
            for (unsigned k = 0; k < mesh.mFaces[i].mNumIndices; ++k) {
                const unsigned corner = mesh.mFaces[i].mIndices[k];
                if (corner >= mesh.mNumVertices)
                    fail(path_, "a triangle names vertex " + std::to_string(corner) + ", but its mesh has only " +
                                    std::to_string(mesh.mNumVertices));
                index[corner] = 0;
            }
        const bool moved = transform != glm::dmat4(1.0);
        // Normals follow the inverse transpose; up to its length, which is restored later, that is the cofactor matrix.
        const glm::dmat3 linear(transform);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            if (index[i] == kUnused) continue;
            Vertex v{{}, kNoNormal, {}};
            const glm::dvec3 p = to_vector(mesh.mVertices[i]);
            v.position = moved ? glm::vec3(glm::dvec3(transform * glm::dvec4(p, 1.0))) : glm::vec3(p);
            if (mesh.HasNormals()) {
                const glm::dvec3 n = to_vector(mesh.mNormals[i]);
                v.normal = moved ? unit(side * (cofactors * n)) : glm::vec3(n);
            }
            // Assimp has turned v upside down already.
            if (mesh.HasTextureCoords(0)) v.uv = {mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y};
            index[i] = builder_.add_vertex(v);
            add_streams(mesh, i);
        }
        return index;
    }

    static glm::vec3 unit(const glm::dvec3& n)
    {
        const double length = std::hypot(n.x, n.y, n.z);
        return length > 0.0 ? glm::vec3(n / length) : kNoNormal;
    }

    void add_streams(const aiMesh& mesh, unsigned i)
    {
        std::vector<VertexStream>& streams = builder_.soup.streams;
        std::size_t next = 0;
        if (has_colour_) {
            const aiColor4D c = mesh.HasVertexColors(0) ? mesh.mColors[0][i] : aiColor4D(1.0f);
            for (const float channel : {c.r, c.g, c.b, c.a}) streams[next].values.push_back(channel);
            ++next;
        }
        for (unsigned k = 1; k < uv_sets_; ++k, ++next) {
            const bool has = mesh.HasTextureCoords(k);
            streams[next].values.push_back(has ? mesh.mTextureCoords[k][i].x : 0.0f);
            streams[next].values.push_back(has ? mesh.mTextureCoords[k][i].y : 0.0f);
        }
    }

    const std::filesystem::path& path_;
    const aiScene& scene_;
    SoupBuilder builder_;
    bool has_colour_ = false;
    unsigned uv_sets_ = 1;
    std::vector<std::uint32_t> face_;
};

}  // namespace

TriangleSoup read_gltf(const std::filesystem::path& path, std::string_view bytes)
{
    try {
        CheckedGltf checked = checked_gltf(path, bytes);
        Assimp::Importer importer;
        // The importer owns it.
        importer.SetIOHandler(new CheckedFile(path.string(), std::move(checked.document)));
        const aiScene* scene = importer.ReadFile(path.string(), 0);
        if (scene == nullptr) {
            const std::string reason = importer.GetErrorString();
            fail(path, "it is not a usable glTF file (" + reason.substr(0, reason.find('\n')) + ")");
        }
        if (count_triangles(*scene) != checked.triangles)
            fail(path, "a triangle names a vertex that its mesh does not have");
        return SceneReader(path, *scene).read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const FileError&) {
        throw;
    } catch (const std::exception& error) {
        fail(path, std::string("it is not a usable glTF file (") + error.what() + ")");
    }
}

}  // namespace kerf::io
