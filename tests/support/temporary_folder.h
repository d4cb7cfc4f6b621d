#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::test {

/// An empty folder of one's own, removed at the end with all that it holds. No two are the same, whatever runs beside.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "kerf_XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
        folder_ = pattern;
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return folder_; }

    /// The path of a file or folder in this one, there or not.
    std::filesystem::path file(const std::filesystem::path& name) const { return folder_ / name; }

    /// Writes a file with these bytes. Returns its path.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view bytes) const
    {
        std::ofstream out(file(name), std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file(name);
    }

    bool exists(const std::filesystem::path& name) const { return std::filesystem::exists(file(name)); }

    static std::string read_text(const std::filesystem::path& path)
    {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// The bytes of a file.
    std::string text_of(const std::filesystem::path& name) const { return read_text(file(name)); }

    /// In alphabetical order.
    std::vector<std::string> names_in_folder() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

protected:
    std::filesystem::path folder_;
};

/// A test with a folder.
class FolderTest : public ::testing::Test, protected TemporaryFolder
{
};

}  // namespace kerf::test

namespace kerf::core::test {
using namespace kerf::test;
}
