#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/bytes.h"

namespace kerf::core::io {

/// Two triangles with texture coordinates and a material: the smallest GLB that has everything.
inline nlohmann::json sample_document()
{
    return nlohmann::json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"name": "peel", "pbrMetallicRoughness":
            {"baseColorFactor": [1, 0.5, 0.25, 1], "baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "peel.png"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "buffers": [{"byteLength": 92}]})");
}

inline std::string sample_buffer()
{
    std::string bytes;
    for (const float x : {0.0f, 0.0f, 0.0f, 0.1f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f, 1.0f, 0.0f})
        store_little(bytes, x);
    for (const float x : {0.0f, 0.0f, 0.1f, 0.0f, 1.0f, 1.0f, 0.0f, 1.0f}) store_little(bytes, x);
    for (const int i : {0, 1, 2, 0, 2, 3}) store_little(bytes, static_cast<std::uint16_t>(i));
    return bytes;
}

inline std::string glb_of_text(std::string json, std::string buffer)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    for (const std::size_t n : {std::size_t{2}, 28 + json.size() + buffer.size(), json.size()})
        store_little(bytes, static_cast<std::uint32_t>(n));
    bytes += "JSON" + json;
    store_little(bytes, static_cast<std::uint32_t>(buffer.size()));
    return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::string glb(const nlohmann::json& document, const std::string& buffer)
{
    return glb_of_text(document.dump(), buffer);
}

inline std::string base64(const std::string& bytes)
{
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

inline nlohmann::json& primitive_of(nlohmann::json& document)
{
    return document["meshes"][0]["primitives"][0];
}

/// Appends numbers to the buffer and an accessor for them, and returns its index.
template <class T>
std::size_t add_accessor(nlohmann::json& document, std::string& buffer, int component, const std::string& type,
                         std::size_t count, const std::vector<T>& values)
{
    while (buffer.size() % 4 != 0) buffer += '\0';
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", values.size() * sizeof(T)}});
    for (const T value : values) store_little(buffer, value);
    document["buffers"][0]["byteLength"] = buffer.size();
    document["accessors"].push_back({{"bufferView", document["bufferViews"].size() - 1},
                                     {"componentType", component},
                                     {"count", count},
                                     {"type", type}});
    return document["accessors"].size() - 1;
}

}  // namespace kerf::core::io
