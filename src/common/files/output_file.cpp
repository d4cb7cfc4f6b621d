#include "common/files/output_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace kerf::core::io {

namespace fs = std::filesystem;

namespace {

/// A name in the same folder that nobody else uses: hidden, with process and serial number, and short, because a name
/// made longer might be longer than the file system allows.
fs::path temporary_beside(const fs::path& path)
{
    static std::atomic<unsigned> serial{0};
    return path.parent_path() / (".kerf-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp");
}

}  // namespace

fs::path behind_links(const fs::path& path)
{
    constexpr int kMostLinks = 40;  // as many as Linux follows in one name
    fs::path place = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
        const fs::path target = fs::read_symlink(place, error);
        if (error) fail(path, "the link of this name cannot be read (" + error.message() + ")");
        if (links == kMostLinks) fail(path, "the link of this name leads nowhere; choose another name");
        place = place.parent_path() / target;  // an absolute target takes the place of all
    }
    return place;
}

fs::path place_of(const fs::path& path)
{
    const fs::path name = behind_links(path);
    std::error_code error;
    fs::path folder = fs::absolute(name.parent_path() / ".", error);
    if (!error) folder = fs::weakly_canonical(folder, error);
    if (error) fail(path, "its folder cannot be looked at (" + error.message() + "); choose another place");
    return folder / name.filename();
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path))
{
    if (path_.native().find('\0') != fs::path::string_type::npos)
        fail(path_, "no file can have a name with a byte of 0 in it; choose another name");
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(path_, "it exists and is not a regular file; choose another name");
    if (error && status.type() != fs::file_type::not_found) fail_to_write(error.value());
    place_ = behind_links(path_);
    int reason = 0;
    do {  // one that another process left behind may have the name
        temporary_ = temporary_beside(place_);
        unfinished_ = remember_unfinished(temporary_);
        file_.reset(std::fopen(temporary_.c_str(), "wbx"));
        reason = file_ ? 0 : errno;
        if (!file_) unfinished_.reset();
    } while (reason == EEXIST);
    if (!file_) {
        if (reason == ENOENT && place_ != path_)
            fail(path_,
                 "it cannot be written: the link of this name leads into a folder that does not exist; make that "
                 "first, or remove the link");
        if (reason == ENOENT) fail(path_, "it cannot be written: its folder does not exist; make that first");
        fail_to_write(reason);
    }
    constexpr std::size_t kBufferBytes = 1 << 20;
    std::setvbuf(file_.get(), nullptr, _IOFBF, kBufferBytes);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      place_(std::move(other.place_)),
      temporary_(std::move(other.temporary_)),
      previous_(std::move(other.previous_)),
      unfinished_(std::move(other.unfinished_)),
      previous_unfinished_(std::move(other.previous_unfinished_)),
      file_(std::move(other.file_)),
      state_(std::exchange(other.state_, State::gone))
{
    // A path that was moved from is in an unspecified state.
    for (fs::path* path : {&other.path_, &other.place_, &other.temporary_, &other.previous_}) path->clear();
}

OutputFile::~OutputFile()
{
    file_.reset();
    std::error_code ignored;
    if (has_temporary()) fs::remove(temporary_, ignored);
    if (!previous_.empty()) fs::remove(previous_, ignored);
}

void OutputFile::write(std::string_view bytes)
{
    expect(State::open);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size()) return;
    const int reason = errno;
    state_ = State::failed;
    fail_to_write(reason);
}

void OutputFile::synchronise()
{
    expect(State::open);
    if (std::fflush(file_.get()) == 0 && ::fsync(::fileno(file_.get())) == 0) return;
    const int reason = errno;
    state_ = State::failed;
    fail_to_write(reason);
}

void OutputFile::finish()
{
    expect(State::open);
    state_ = State::failed;
    if (std::fclose(file_.release()) != 0) fail_to_write(errno);
    state_ = State::finished;
}

void OutputFile::commit()
{
    expect(State::finished);
    if (previous_.empty()) keep_previous();
    std::error_code error;
    fs::rename(temporary_, place_, error);
    if (error) fail_to_write(error.value());
    unfinished_.reset();
    state_ = State::named;
}

void OutputFile::withdraw() noexcept
{
    if (state_ != State::named) return;
    std::error_code error;
    if (!previous_.empty()) fs::rename(previous_, place_, error);
    if (previous_.empty() || error) fs::remove(place_, error);
    previous_.clear();
    previous_unfinished_.reset();
    state_ = State::gone;
}

void OutputFile::keep_previous()
{
    fs::path name = temporary_beside(place_);
    previous_unfinished_ = remember_unfinished(name);
    previous_ = std::move(name);  // before the link is there: afterwards memory could run out
    std::error_code error;
    fs::create_hard_link(place_, previous_, error);
    if (!error) return;
    previous_.clear();
    previous_unfinished_.reset();
}

bool OutputFile::has_temporary() const noexcept
{
    return state_ == State::open || state_ == State::finished || state_ == State::failed;
}

void OutputFile::expect(State state) const
{
    if (state_ == state) return;
    if (state_ == State::open) fail(path_, "it cannot get its name before it is finished; finish it first");
    const fs::path name = path_.empty() ? fs::path("a file that was moved away") : path_;
    fail(name, std::string("nothing can be written to it any more, ") +
                   (state_ == State::failed ? "as writing it failed" : "as it is finished") + "; open it again");
}

void OutputFile::fail_to_write(int reason) const
{
    fail(path_, std::string("it cannot be written (") + std::strerror(reason) + "); choose another place");
}

}  // namespace kerf::core::io
