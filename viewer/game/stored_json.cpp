#include "viewer/game/stored_json.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "common/io/mesh_file.h"
#include "common/io/output_file.h"

namespace kerf::game {
namespace {

namespace fs = std::filesystem;

fs::path with_ending(const fs::path& path, const std::string& ending)
{
    return path.parent_path() / (path.filename().string() + ending);
}

/// A file that closes itself.
class Descriptor
{
public:
    Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return number_ >= 0; }
    bool write(std::string_view bytes) const
    {
        while (!bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        return true;
    }
    bool synchronise() const { return ::fsync(number_) == 0; }

private:
    int number_;
};

/// Text that is no UTF-8 must not be a reason to lose the rest.
std::string text_of(const nlohmann::json& value)
{
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string cannot(const fs::path& path, const std::string& what, const std::string& why)
{
    return path.string() + " cannot be " + what + ": " + why;
}

StoredJson unreadable(const fs::path& path, const std::string& why)
{
    return {nullptr, cannot(path, "read", why), false};
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

/// Renames a file to the first free name.
StoredJson keep_aside(const fs::path& path, const std::string& reason)
{
    fs::path aside;
    std::error_code error;
    for (int i = 1; aside.empty() || fs::exists(fs::symlink_status(aside, error)); ++i)
        aside = with_ending(path, ".damaged-" + std::to_string(i));
    fs::rename(path, aside, error);
    const std::string what = path.string() + " is damaged (" + reason + ")";
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
    if (fs::file_size(path, error) > kMostStoredBytes) return keep_aside(path, "it is too large");

    std::ifstream in(path, std::ios::binary);
    if (!in) return unreadable(path, std::strerror(errno));
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) return unreadable(path, "reading failed");
    in.close();

    nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) return keep_aside(path, "it is no JSON");
    if (is_later(value, newest))
        return {nullptr, path.string() + " is of a later version of Kerf; it stays as it is and nothing is added",
                false};
    const std::string reason = objection(value);
    if (!reason.empty()) return keep_aside(path, reason);
    return {std::move(value), {}, true};
}

std::string save_json(const fs::path& name, const nlohmann::json& value)
{
    std::error_code error;
    fs::create_directories(name.parent_path(), error);
    fs::path path;
    try {
        path = io::behind_links(name);  // somebody keeps settings elsewhere
    } catch (const io::FileError& reason) {
        return reason.what();
    }
    const fs::path temporary = with_ending(path, ".new");
    {
        const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
        if (!file.is_open() || !file.write(text_of(value)) || !file.synchronise()) {
            const std::string why = std::strerror(errno);
            fs::remove(temporary, error);
            return cannot(path, "written", why);
        }
    }
    fs::rename(temporary, path, error);
    if (error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        return cannot(path, "written", error.message());
    }
    // The new name, too, must be on the disk. Some file systems have no synchronising of folders: nothing is lost then
    // but the last game.
    const Descriptor folder(path.parent_path(), O_RDONLY | O_DIRECTORY);
    if (folder.is_open()) static_cast<void>(folder.synchronise());
    return {};
}

FileLock::FileLock(const fs::path& path, const GivesUp& gives_up)
{
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    descriptor_ = ::open(with_ending(path, ".lock").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) return;
    constexpr std::chrono::milliseconds kBetweenTries{10};
    while (::flock(descriptor_, gives_up ? LOCK_EX | LOCK_NB : LOCK_EX) != 0) {
        if (errno == EINTR) continue;
        if (errno != EWOULDBLOCK) return;
        if (gives_up()) {
            is_held_elsewhere_ = true;
            return;
        }
        std::this_thread::sleep_for(kBetweenTries);
    }
}

FileLock::~FileLock()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace kerf::game
