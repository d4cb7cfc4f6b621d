#include "common/io/gltf_document.h"

#include <cmath>

#include "common/io/lenient_json.h"
#include "common/io/read_formats.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::uint64_t kTooLarge = std::uint64_t{1} << 48;

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
    : path_(path), notes_(notes), parts_(split_gltf(path, bytes, notes))
{
    try {
        root_ = parse_lenient_json(parts_.json, notes);
    } catch (const JsonError& error) {
        if (!parts_.is_container && path_.extension() == ".glb")
            refuse("it does not begin with 'glTF', as binary glTF does, and what it holds is no JSON either");
        refuse("its JSON is malformed or cut off at byte " + std::to_string(error.byte));
    }
    if (!root_.is_object()) refuse("its JSON is not an object");
    check_version();
}

void GltfDocument::refuse(const std::string& reason) const
{
    fail(path_, reason.find("; ") != std::string::npos ? reason : reason + "; export it again as glTF 2.0");
}

const GltfJson* GltfDocument::member(const GltfJson& object, const char* name) const
{
    const auto found = object.find(name);
    if (found == object.end()) return nullptr;
    if (!found->is_null()) return &*found;
    notes_.add("members that are null taken as absent");
    return nullptr;
}

const GltfJson* GltfDocument::object_if(const GltfJson& object, const char* name) const
{
    const auto found = object.find(name);
    return found != object.end() && found->is_object() ? &*found : nullptr;
}

const GltfJson* GltfDocument::extension(const GltfJson& object, const char* name) const
{
    const GltfJson* extensions = object_if(object, "extensions");
    return extensions != nullptr ? object_if(*extensions, name) : nullptr;
}

const GltfJson& GltfDocument::list(const GltfJson& object, const char* name, const std::string& where) const
{
    static const GltfJson kEmpty = GltfJson::array();
    const GltfJson* found = member(object, name);
    if (found == nullptr) return kEmpty;
    if (!found->is_array()) refuse(in_quotes(name) + " of " + where + " is not an array");
    return *found;
}

const GltfJson& GltfDocument::element(const char* list_name, std::uint64_t index, const std::string& kind,
                                      const std::string& where) const
{
    const GltfJson& all = list(list_name);
    if (index >= all.size())
        refuse(where + " names " + kind + " " + std::to_string(index) + ", but there are only " +
               std::to_string(all.size()) + ", counted from 0");
    if (!all[index].is_object()) refuse(kind + " " + std::to_string(index) + " is not an object");
    return all[index];
}

std::optional<std::uint64_t> GltfDocument::whole(const GltfJson& value) const
{
    if (value.is_number_integer()) {  // unsigned as well
        if (!value.is_number_unsigned() && value.get<std::int64_t>() < 0) return std::nullopt;
        const auto number = value.get<std::uint64_t>();
        return number < kTooLarge ? std::optional(number) : std::nullopt;
    }
    if (!value.is_number_float()) return std::nullopt;
    const auto number = value.get<double>();
    if (!(number >= 0.0 && number < static_cast<double>(kTooLarge) && std::floor(number) == number))
        return std::nullopt;
    notes_.add("whole numbers written as decimals");
    return static_cast<std::uint64_t>(number);
}

bool GltfDocument::is_nothing(const GltfJson& value) const
{
    if (value.is_null())
        notes_.add("members that are null taken as absent");
    else if (value.is_number() && value.get<double>() == -1.0)
        notes_.add("references of -1 taken as none");
    else
        return false;
    return true;
}

std::optional<std::uint64_t> GltfDocument::number_if(const GltfJson& object, const char* name,
                                                     const std::string& where) const
{
    const GltfJson* found = member(object, name);
    if (found == nullptr) return std::nullopt;
    const auto value = whole(*found);
    if (!value) refuse(in_quotes(name) + " of " + where + " is not a number that makes sense");
    return value;
}

std::uint64_t GltfDocument::number(const GltfJson& object, const char* name, const std::string& where) const
{
    const auto value = number_if(object, name, where);
    if (!value) refuse(in_quotes(name) + " of " + where + " is missing");
    return *value;
}

std::optional<std::uint64_t> GltfDocument::index_if(const GltfJson& object, const char* name,
                                                    const std::string& where) const
{
    const auto found = object.find(name);
    if (found == object.end() || is_nothing(*found)) return std::nullopt;
    return number_if(object, name, where);
}

std::uint64_t GltfDocument::index(const GltfJson& object, const char* name, const std::string& where) const
{
    const auto value = index_if(object, name, where);
    if (!value) refuse(in_quotes(name) + " of " + where + " is missing");
    return *value;
}

std::vector<std::uint64_t> GltfDocument::indices(const GltfJson& object, const char* name,
                                                 const std::string& where) const
{
    std::vector<std::uint64_t> places;
    for (const GltfJson& value : list(object, name, where)) {
        if (is_nothing(value)) continue;
        const auto place = whole(value);
        if (!place) refuse(in_quotes(name) + " of " + where + " has a number that makes no sense");
        places.push_back(*place);
    }
    return places;
}

/// Only version 1 is another format: its lists are objects.
void GltfDocument::check_version() const
{
    const GltfJson* asset = object_if(root_, "asset");
    const GltfJson* version = asset != nullptr ? member(*asset, "version") : nullptr;
    const auto meshes = root_.find("meshes");
    if (version == nullptr && meshes != root_.end() && meshes->is_array())
        return notes_.add("version that is missing taken as 2.0");
    if (version == nullptr) refuse("it does not say which version of glTF it is");
    const std::string text = version->is_string()   ? version->get<std::string>()
                             : version->is_number() ? version->dump()
                                                    : "";
    if (!text.starts_with('2'))
        refuse("it is not version 2 of glTF, but " + in_quotes(text) + "; convert it to glTF 2.0");
}

}  // namespace kerf::core::io
