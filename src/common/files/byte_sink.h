#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf::core::io {

/// Where a writer puts its bytes.
class ByteSink
{
public:
    virtual ~ByteSink() = default;

    /// Appends bytes. @throws FileError  they cannot be kept
    virtual void write(std::string_view bytes) = 0;
    /// What messages call it, and what names of files beside it are made of.
    virtual const std::filesystem::path& path() const = 0;

protected:
    ByteSink() = default;
    ByteSink(const ByteSink&) = default;
    ByteSink(ByteSink&&) = default;
    ByteSink& operator=(const ByteSink&) = default;
    ByteSink& operator=(ByteSink&&) = default;
};

/// A sink in memory.
class MemorySink final : public ByteSink
{
public:
    /// @param name  see path()
    explicit MemorySink(std::filesystem::path name) : name_(std::move(name)) {}

    void write(std::string_view bytes) override { bytes_ += bytes; }
    const std::filesystem::path& path() const override { return name_; }
    std::string take() { return std::move(bytes_); }

private:
    std::filesystem::path name_;
    std::string bytes_;
};

}  // namespace kerf::core::io
