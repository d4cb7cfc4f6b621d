#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace kerf::core::test {

/// The fifteen models, and the meshes of a folder that is not part of the project, as far as it is there. In the order
/// of their paths.
inline std::vector<std::filesystem::path> real_files()
{
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (const fs::path& folder : {fs::path(KERF_DATA_DIR) / "models", fs::path(KERF_SHARED_MESHES_DIR)}) {
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder)) {
            std::string extension = entry.path().extension().string();
            std::transform(extension.begin(), extension.end(), extension.begin(),
                           [](char c) { return char(std::tolower(c)); });
            if (extension == ".obj" || extension == ".off" || extension == ".ply" || extension == ".stl" ||
                extension == ".glb")
                files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// A file's name as GoogleTest wants it: letters, digits and underscores.
inline std::string test_name_of(const std::filesystem::path& file)
{
    std::string name = file.filename().string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

}  // namespace kerf::core::test
