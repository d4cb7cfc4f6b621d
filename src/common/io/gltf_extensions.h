#pragma once

#include <set>
#include <string>

#include "common/io/gltf_document.h"

namespace kerf::core::io {

/// The extensions that a file requires of its readers, and whether its surface can be read without them.
///
/// KHR_mesh_quantization, EXT_mesh_gpu_instancing and KHR_texture_transform are read. Most others are about materials,
/// textures, animations or behaviour: they are noted and passed over, known or not. An extension that changes the
/// surface belongs to an object that the surface is read from: a mesh, primitive, accessor, buffer view or buffer. If
/// it is required there and not known to be decoration, the file is refused. Compression is no reason if the file has
/// an uncompressed copy, or if the scene shows nothing that is compressed.
class GltfExtensions
{
public:
    /// Notes what is passed over. @throws FileError
    explicit GltfExtensions(const GltfDocument& document);

    /// Looks at an object that the surface is read from.
    /// @throws FileError  it carries a required extension that may change the surface
    void check(const GltfJson& object, const std::string& where) const;

private:
    const GltfDocument& document_;
    std::set<std::string, std::less<>> required_;
};

}  // namespace kerf::core::io
