#include "common/io/gltf_accessors.h"

#include <algorithm>
#include <array>
#include <limits>

#include "common/io/bytes.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

/// A buffer may claim this many bytes more than there are: lengths are rounded up by so much.
constexpr std::uint64_t kPadding = 3;

constexpr std::uint64_t kWidest = 16;

/// Sparse accessors may share bytes, but not without limit: all together may have as many values as the file has bytes,
/// or this many.
constexpr std::uint64_t kSparseAllowed = 1 << 20;

/// 0 for a type that glTF does not know.
std::uint64_t size_of(GltfComponent type)
{
    switch (type) {
        case GltfComponent::int8:
        case GltfComponent::uint8:
            return 1;
        case GltfComponent::int16:
        case GltfComponent::uint16:
            return 2;
        case GltfComponent::uint32:
        case GltfComponent::float32:
            return 4;
    }
    return 0;
}

double number_at(const char* place, GltfComponent type)
{
    switch (type) {
        case GltfComponent::int8:
            return load<std::int8_t>(place, Endian::little);
        case GltfComponent::uint8:
            return load<std::uint8_t>(place, Endian::little);
        case GltfComponent::int16:
            return load<std::int16_t>(place, Endian::little);
        case GltfComponent::uint16:
            return load<std::uint16_t>(place, Endian::little);
        case GltfComponent::uint32:
            return load<std::uint32_t>(place, Endian::little);
        case GltfComponent::float32:
            return static_cast<double>(load<float>(place, Endian::little));
    }
    return 0.0;
}

double largest(GltfComponent type)
{
    switch (type) {
        case GltfComponent::int8:
            return std::numeric_limits<std::int8_t>::max();
        case GltfComponent::uint8:
            return std::numeric_limits<std::uint8_t>::max();
        case GltfComponent::int16:
            return std::numeric_limits<std::int16_t>::max();
        case GltfComponent::uint16:
            return std::numeric_limits<std::uint16_t>::max();
        case GltfComponent::uint32:
            return std::numeric_limits<std::uint32_t>::max();
        case GltfComponent::float32:
            return 1.0;
    }
    return 1.0;
}

/// Of a buffer view: whether its data exist compressed, too. Of a buffer: whether it holds such uncompressed copies.
bool is_compressed(const GltfDocument& document, const GltfJson& source)
{
    return document.extension(source, "EXT_meshopt_compression") != nullptr ||
           document.extension(source, "KHR_meshopt_compression") != nullptr;
}

}  // namespace

const char* GltfAccessor::place_of(std::uint64_t element) const
{
    static constexpr std::array<char, kWidest * sizeof(float)> kZeros{};
    const auto other = std::lower_bound(sparse_.begin(), sparse_.end(), element,
                                        [](const auto& value, std::uint64_t wanted) { return value.first < wanted; });
    if (other != sparse_.end() && other->first == element) return other->second;
    return first_ != nullptr ? first_ + element * stride_ : kZeros.data();
}

double GltfAccessor::stored(std::uint64_t element, std::uint64_t k) const
{
    return number_at(place_of(element) + k * size_of(component), component);
}

double GltfAccessor::fraction(std::uint64_t element, std::uint64_t k) const
{
    const double number = stored(element, k);
    return is_integer() ? std::max(number / largest(component), -1.0) : number;
}

const GltfAccessor& GltfAccessors::at(std::uint64_t index, const std::string& where)
{
    return accessors_.at(index, [&] {
        const GltfJson& source = document_.element("accessors", index, "accessor", where);
        return make(source, "accessor " + std::to_string(index));
    });
}

GltfAccessor GltfAccessors::make(const GltfJson& source, const std::string& where)
{
    constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kWidths{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", kWidest}}};
    extensions_.check(source, where);
    GltfAccessor accessor;
    accessor.count = document_.number(source, "count", where);
    accessor.component = static_cast<GltfComponent>(document_.number(source, "componentType", where));
    const GltfJson* type = document_.member(source, "type");
    const auto width = std::find_if(kWidths.begin(), kWidths.end(), [&](const auto& known) {
        return type != nullptr && type->is_string() && type->get_ref<const std::string&>() == known.first;
    });
    if (width == kWidths.end() || size_of(accessor.component) == 0)
        document_.refuse(where + " has no type that glTF knows");
    accessor.width = width->second;
    const GltfJson* normalized = document_.member(source, "normalized");
    accessor.is_normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
    place(accessor, source, where);
    if (const GltfJson* sparse = document_.object_if(source, "sparse")) place_sparse(accessor, *sparse, where);
    return accessor;
}

/// Finds the elements of an accessor in its buffer view; without one, it stays zeros.
void GltfAccessors::place(GltfAccessor& accessor, const GltfJson& source, const std::string& where)
{
    const auto index = document_.index_if(source, "bufferView", where);
    if (!index || accessor.count == 0) return;
    const View& from = views_.at(*index, [&] { return make_view(*index, where); });
    const std::uint64_t size = accessor.width * size_of(accessor.component);
    const std::uint64_t offset = document_.number_if(source, "byteOffset", where).value_or(0);
    accessor.stride_ = from.stride != 0 ? from.stride : size;
    if (accessor.stride_ < size) document_.refuse(where + " has elements that are longer than their stride");
    if (offset + size > from.bytes.size() ||
        accessor.count - 1 > (from.bytes.size() - offset - size) / accessor.stride_)
        document_.refuse(where + " is not inside its buffer view");
    accessor.first_ = from.bytes.data() + offset;
}

void GltfAccessors::place_sparse(GltfAccessor& accessor, const GltfJson& source, const std::string& where)
{
    GltfAccessor elements, values = accessor;
    elements.count = values.count = document_.number(source, "count", where);
    values.first_ = nullptr;
    if (values.count == 0) return;
    const auto part = [&](const char* name) -> const GltfJson& {
        const GltfJson* object = document_.object_if(source, name);
        if (object == nullptr || !document_.index_if(*object, "bufferView", where))
            document_.refuse(in_quotes(name) + " of the sparse " + where + " are missing");
        return *object;
    };
    const GltfJson& indices = part("indices");
    elements.component = static_cast<GltfComponent>(document_.number(indices, "componentType", where));
    if (!elements.is_integer() || size_of(elements.component) == 0)
        document_.refuse("the sparse indices of " + where + " are not integers");
    place(elements, indices, where);
    place(values, part("values"), where);
    sparse_values_ += values.count;
    const std::uint64_t size = document_.parts().json.size() + document_.parts().binary.size() + bytes_beside();
    if (sparse_values_ > std::max(kSparseAllowed, size))
        document_.refuse("its sparse accessors have more values in all than it has bytes; export it without them");
    accessor.sparse_.reserve(values.count);
    for (std::uint64_t i = 0; i < values.count; ++i) {
        const double element = elements.stored(i, 0);
        if (!(element >= 0.0 && element < static_cast<double>(accessor.count)))
            document_.refuse("a sparse index of " + where + " is out of range");
        accessor.sparse_.emplace_back(static_cast<std::uint64_t>(element), values.place_of(i));
    }
    // A value that is given twice is the last one, as if they were written one after the other.
    const auto is_before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(accessor.sparse_.begin(), accessor.sparse_.end(), is_before);
    const auto last = std::unique(accessor.sparse_.rbegin(), accessor.sparse_.rend(),
                                  [](const auto& a, const auto& b) { return a.first == b.first; });
    accessor.sparse_.erase(accessor.sparse_.begin(), last.base());
}

GltfAccessors::View GltfAccessors::make_view(std::uint64_t index, const std::string& asker)
{
    const GltfJson& source = document_.element("bufferViews", index, "buffer view", asker);
    const std::string where = "buffer view " + std::to_string(index);
    extensions_.check(source, where);
    const std::uint64_t size = document_.number(source, "byteLength", where);
    const std::uint64_t offset = document_.number_if(source, "byteOffset", where).value_or(0);
    const std::uint64_t buffer_index = document_.index(source, "buffer", where);
    if (is_compressed(document_, source)) {
        if (!has_data(document_.element("buffers", buffer_index, "buffer", where), buffer_index))
            document_.refuse(where +
                             " is compressed by EXT_meshopt_compression, which is not supported, and there is no "
                             "uncompressed copy of it; export it without compression");
        document_.notes().add("buffer views with compressed data read from their uncompressed copies");
    }
    const std::string_view bytes = buffers_.at(buffer_index, [&] { return make_buffer(buffer_index, where); });
    if (offset + size > bytes.size() + kPadding || offset > bytes.size())
        document_.refuse(where + " is not inside its buffer");
    if (offset + size > bytes.size()) document_.notes().add("lengths that pass the end of their data by padding");
    return {bytes.substr(offset, size), document_.number_if(source, "byteStride", where).value_or(0)};
}

std::string_view GltfAccessors::make_buffer(std::uint64_t index, const std::string& asker)
{
    const GltfJson& source = document_.element("buffers", index, "buffer", asker);
    const std::string where = "buffer " + std::to_string(index);
    extensions_.check(source, where);
    const std::string_view bytes = bytes_of_buffer(source, index, where);
    std::uint64_t size = document_.number_if(source, "byteLength", where).value_or(bytes.size());
    // No buffer is empty: the length was never filled in.
    if (size == 0 && !bytes.empty()) {
        document_.notes().add("buffers said to have no bytes read as they are");
        size = bytes.size();
    }
    if (size > bytes.size() + kPadding)
        document_.refuse("it is truncated: " + where + " should have " + std::to_string(size) + " bytes, but has " +
                         std::to_string(bytes.size()));
    if (size > bytes.size()) document_.notes().add("lengths that pass the end of their data by padding");
    return bytes.substr(0, size);
}

/// Null for a buffer that names no file; an empty name is none.
const GltfJson* GltfAccessors::uri_of(const GltfJson& buffer) const
{
    const GltfJson* uri = document_.member(buffer, "uri");
    return uri != nullptr && uri->is_string() && uri->get_ref<const std::string&>().empty() ? nullptr : uri;
}

/// The first buffer of a GLB file is its binary chunk, unless it stands for data that are only there compressed.
bool GltfAccessors::has_data(const GltfJson& source, std::uint64_t index) const
{
    return uri_of(source) != nullptr ||
           (index == 0 && document_.parts().is_container && !is_compressed(document_, source));
}

/// Bytes that a buffer really has.
std::string_view GltfAccessors::bytes_of_buffer(const GltfJson& source, std::uint64_t index, const std::string& where)
{
    if (!has_data(source, index)) document_.refuse(where + " has no data");
    const GltfJson* uri = uri_of(source);
    if (uri == nullptr) return document_.parts().binary;
    if (!uri->is_string()) document_.refuse("'uri' of " + where + " is not a text");
    return files_.bytes_of(uri->get_ref<const std::string&>(), where);
}

}  // namespace kerf::core::io
