#include "common/io/output_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "common/io/read_formats.h"
#include "common/io/unfinished_files.h"

namespace kerf::io {

namespace fs = std::filesystem;

namespace {

/// A name in the same folder that nobody else uses: hidden, with process and serial number.
fs::path temporary_beside(const fs::path& path)
{
    static std::atomic<unsigned> serial{0};
    std::string name(1, '.');
    name.append(path.filename().string());
    name.append(1, '.').append(std::to_string(::getpid()));
    name.append(1, '-').append(std::to_string(serial++)).append(".tmp");
    return path.parent_path() / name;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path))
{
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(path_, "it exists and is not a regular file; choose another name");
    const fs::path temporary = temporary_beside(path_);
    file_.reset(std::fopen(temporary.c_str(), "wbx"));
    if (!file_ && errno == ENOENT) fail(path_, "it cannot be written: its folder does not exist; make that first");
    if (!file_) fail_to_write();
    temporary_ = temporary;
    unfinished_ = remember_unfinished(temporary_);
    constexpr std::size_t kBufferBytes = 1 << 20;
    std::setvbuf(file_.get(), nullptr, _IOFBF, kBufferBytes);
}

OutputFile::~OutputFile()
{
    file_.reset();
    std::error_code ignored;
    if (temporary_.empty()) return;
    fs::remove(temporary_, ignored);
    forget_unfinished(unfinished_);
}

void OutputFile::write(std::string_view bytes)
{
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail_to_write();
}

void OutputFile::finish()
{
    if (std::fclose(file_.release()) != 0) fail_to_write();
}

void OutputFile::commit()
{
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) fail(path_, "it cannot be written (" + error.message() + "); choose another place");
    forget_unfinished(unfinished_);
    temporary_.clear();
}

void OutputFile::withdraw() noexcept
{
    std::error_code ignored;
    fs::remove(path_, ignored);
}

void OutputFile::fail_to_write() const
{
    fail(path_, std::string("it cannot be written (") + std::strerror(errno) + "); choose another place");
}

}  // namespace kerf::io
