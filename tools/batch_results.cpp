#include "tools/batch_results.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "tools/content_key.h"
#include "tools/mesh_files.h"

namespace kerf::tools {

namespace {

std::string content_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// How the line of a job begins.
std::string beginning_of(std::size_t job)
{
    return "{\"job\":" + std::to_string(job + 1) + ",";
}

/// Whether all files that a line names are as they were.
bool has_its_files(const Json& line)
{
    for (const char* side : {"positive", "negative"}) {
        if (!line.contains(side)) continue;
        for (const Json& piece : line[side]["pieces"]) {
            const std::string path = piece["file"].get<std::string>();
            if (!std::filesystem::is_regular_file(path) || key_of_file(path) != piece.value("key", "")) return false;
        }
    }
    return true;
}

/// Whether a process does anything still. One that was killed is there until its parent has asked for its end.
bool is_running(pid_t process)
{
    if (kill(process, 0) != 0 && errno == ESRCH) return false;
    const std::string facts = content_of("/proc/" + std::to_string(process) + "/stat");
    const std::size_t name_end = facts.rfind(") ");
    return name_end == std::string::npos || (facts[name_end + 2] != 'Z' && facts[name_end + 2] != 'X');
}

std::string host()
{
    char name[256] = {};
    return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

std::string key_of_file(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path + ": it can't be read");
    ContentKey key;
    std::vector<char> bytes(1 << 20);
    while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0)
        key.add(std::as_bytes(std::span(bytes.data(), static_cast<std::size_t>(file.gcount()))));
    return key.text();
}

BatchResults::BatchResults(std::string path, std::string prefix) : path_(std::move(path)), prefix_(std::move(prefix))
{
    if (path_.empty()) return;
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) throw FileError(path_ + ": it can't be written");
    if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    const bool is_taken = errno == EWOULDBLOCK;
    close(file_);
    file_ = -1;
    throw FileError(path_ + (is_taken ? ": another batch is writing it" : ": it can't be locked"));
}

BatchResults::~BatchResults()
{
    if (file_ >= 0) close(file_);
}

void BatchResults::go_on(std::size_t count, const std::function<std::string(std::size_t)>& key_of)
{
    if (path_.empty()) return;
    const std::string content = content_of(path_);
    std::size_t at = 0;
    bool has_all_files = true;
    for (std::size_t job = 0; at < content.size(); ++job) {
        const std::size_t end = content.find('\n', at);
        const std::string line = content.substr(at, end == std::string::npos ? end : end - at);
        const Json json = Json::parse(line, nullptr, false);
        // A batch that was killed may leave a part of a line, the last one.
        const std::string beginning = job < count ? beginning_of(job) : "";
        const bool is_part = end == std::string::npos && !beginning.empty() && json.is_discarded() &&
                             line.compare(0, beginning.size(), beginning, 0, line.size()) == 0;
        if (!is_part &&
            (job >= count || end == std::string::npos || !json.is_object() || json.value("key", "") != key_of(job)))
            throw FileError(path_ + ": line " + std::to_string(job + 1) +
                            " is no result of this job; name another file of results, or remove it");
        has_all_files = has_all_files && !is_part && has_its_files(json);
        if (has_all_files) earlier_.push_back(json);
        at = end == std::string::npos ? content.size() : end + 1;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < earlier_.size(); ++i) kept = content.find('\n', kept) + 1;
    if (ftruncate(file_, static_cast<off_t>(kept)) != 0 || lseek(file_, 0, SEEK_END) < 0)
        throw FileError(path_ + ": it can't be written");
    remove_leftovers();
    note_process();
}

void BatchResults::add(const std::string& line)
{
    if (path_.empty()) {
        print(line);
        return;
    }
    for (std::size_t written = 0; written < line.size();) {
        const ssize_t count = write(file_, line.data() + written, line.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw FileError(path_ + ": it can't be written");
        written += static_cast<std::size_t>(count);
    }
}

void BatchResults::finish()
{
    if (!path_.empty()) std::filesystem::remove(note_path());
}

/// Who writes: "HOST PID".
void BatchResults::note_process() const
{
    std::ofstream note(note_path());
    note << host() << " " << getpid() << "\n";
}

/// Temporary names of the process that the note names, if it was one of this machine and is no more.
void BatchResults::remove_leftovers() const
{
    std::ifstream note(note_path());
    std::string name;
    pid_t process = 0;
    if (!(note >> name >> process) || name != host() || process <= 0 || is_running(process)) return;
    const std::filesystem::path folder = std::filesystem::path(prefix_).parent_path();
    const std::string beginning = ".kerf-" + std::to_string(process) + "-";
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
        const std::string file = entry.path().filename().string();
        if (file.starts_with(beginning) && file.ends_with(".tmp")) std::filesystem::remove(entry.path(), error);
    }
}

}  // namespace kerf::tools
