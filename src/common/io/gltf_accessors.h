#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/io/gltf_buffers.h"
#include "common/io/gltf_document.h"
#include "common/io/gltf_extensions.h"
#include "common/io/mesh_file.h"

// Accessors of glTF: typed arrays in buffers, sparse and normalised ones included.

namespace kerf::core::io {

/// Component types, by the format's numbers.
enum class GltfComponent : std::uint64_t
{
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126
};

/// `count` elements of `width` numbers, all of them inside their buffer.
class GltfAccessor
{
public:
    std::uint64_t count = 0, width = 1;
    GltfComponent component = GltfComponent::float32;
    bool is_normalized = false;

    bool is_integer() const { return component != GltfComponent::float32; }

    /// Whether the file holds data for it; otherwise it is zeros.
    bool has_data() const { return first_ != nullptr || !sparse_.empty(); }

    /// A number of an element as it is stored. O(1); for a sparse accessor O(log) of its values.
    double stored(std::uint64_t element, std::uint64_t k) const;

    /// The meaning of that number: normalized integers are fractions of the largest one, not below -1.
    double value(std::uint64_t element, std::uint64_t k) const
    {
        return is_normalized ? fraction(element, k) : stored(element, k);
    }

    /// The number as a fraction, whether or not it is normalized.
    double fraction(std::uint64_t element, std::uint64_t k) const;

private:
    friend class GltfAccessors;

    const char* place_of(std::uint64_t element) const;

    const char* first_ = nullptr;  ///< nullptr: zeros
    std::uint64_t stride_ = 0;
    std::vector<std::pair<std::uint64_t, const char*>> sparse_;  ///< by element, each once: stored elsewhere
};

/// The accessors of a document, made and checked on first use: every length is checked against the bytes that are
/// there. Sparse ones are read; those without a buffer view are zeros.
class GltfAccessors
{
public:
    GltfAccessors(const GltfDocument& document, const GltfExtensions& extensions)
        : document_(document), extensions_(extensions), files_(document.path(), document.notes())
    {
    }

    /// @param where  names the asker in messages
    /// @throws FileError
    const GltfAccessor& at(std::uint64_t index, const std::string& where);

    /// Bytes in files of their own, each counted once.
    std::uint64_t bytes_beside() const { return files_.bytes_beside(); }

private:
    /// Objects that are made on first use. One that failed is not tried again, because decoration may ask for it
    /// thousands of times; it fails with the same words.
    template <class T>
    class Once
    {
    public:
        template <class Make>
        const T& at(std::uint64_t index, Make make)
        {
            if (const auto known = made_.find(index); known != made_.end()) return known->second;
            if (const auto known = failed_.find(index); known != failed_.end()) throw FileError(known->second);
            try {
                return made_.emplace(index, make()).first->second;
            } catch (const FileError& error) {
                failed_.emplace(index, error.what());
                throw;
            }
        }

    private:
        std::map<std::uint64_t, T> made_;
        std::map<std::uint64_t, std::string> failed_;
    };

    struct View
    {
        std::string_view bytes;
        std::uint64_t stride = 0;
    };

    GltfAccessor make(const GltfJson& source, const std::string& where);
    void place(GltfAccessor& accessor, const GltfJson& source, const std::string& where);
    void place_sparse(GltfAccessor& accessor, const GltfJson& source, const std::string& where);
    View make_view(std::uint64_t index, const std::string& asker);
    std::string_view make_buffer(std::uint64_t index, const std::string& asker);
    const GltfJson* uri_of(const GltfJson& buffer) const;
    bool has_data(const GltfJson& source, std::uint64_t index) const;
    std::string_view bytes_of_buffer(const GltfJson& source, std::uint64_t index, const std::string& where);

    const GltfDocument& document_;
    const GltfExtensions& extensions_;
    GltfBuffers files_;
    std::uint64_t sparse_values_ = 0;
    Once<std::string_view> buffers_;
    Once<View> views_;
    Once<GltfAccessor> accessors_;
};

}  // namespace kerf::core::io
