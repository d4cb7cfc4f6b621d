#include "viewer/game/stored_json.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "common/files/output_file.h"

namespace kerf::game {
namespace {

namespace fs = std::filesystem;

/// Text that is no UTF-8 must not be a reason to lose the rest.
std::string text_of(const nlohmann::json& value)
{
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

StoredJson unreadable(const fs::path& path, const std::string& why)
{
    return {nullptr, path.string() + " cannot be read: " + why, false};
}

/// One of Kerf's files, by a later version of the program.
bool is_later(const nlohmann::json& value, int newest)
{
    if (!value.is_object()) return false;
    const nlohmann::json format = value.value("format", nlohmann::json()),
                         version = value.value("version", nlohmann::json());
    return format.is_string() && format.get<std::string>().starts_with("kerf-") && version.is_number_integer() &&
           version.get<std::int64_t>() > newest;
}

StoredJson set_aside(const fs::path& path, const std::string& reason)
{
    const std::string what = path.string() + " is damaged (" + reason + ")";
    fs::path aside = path;
    aside += ".damaged";
    std::error_code error;
    if (fs::exists(fs::symlink_status(aside, error)))
        return {nullptr, what + " and stays as it is, because " + aside.filename().string() + " is there already",
                false};
    fs::rename(path, aside, error);
    if (error) return {nullptr, what + " and cannot be renamed: " + error.message(), false};
    return {nullptr, what + "; it is kept as " + aside.filename().string(), true};
}

}  // namespace

StoredJson load_json(const fs::path& path, const Objection& objection, int newest)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return {};
    if (error) return unreadable(path, error.message());
    if (!fs::is_regular_file(status)) return unreadable(path, "it is no regular file");
    if (fs::file_size(path, error) > kMostStoredBytes) return set_aside(path, "it is too large");

    std::ifstream in(path, std::ios::binary);
    if (!in) return unreadable(path, std::strerror(errno));
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) return unreadable(path, "reading failed");
    in.close();

    nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) return set_aside(path, "it is no JSON");
    if (is_later(value, newest))
        return {nullptr, path.string() + " is of a later version of Kerf; it stays as it is and nothing is added",
                false};
    const std::string reason = objection(value);
    if (!reason.empty()) return set_aside(path, reason);
    return {std::move(value), {}, true};
}

std::string save_json(const fs::path& path, const nlohmann::json& value)
{
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);  // where that fails, the file says so
    try {
        core::io::OutputFile file(path);
        file.write(text_of(value));
        file.synchronise();
        file.finish();
        file.commit();
    } catch (const core::io::FileError& error) {
        return error.what();
    }
    return {};
}

}  // namespace kerf::game
