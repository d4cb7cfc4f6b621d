#include <kerf/io.h>

#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/file_answers.h"
#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "common/files/unfinished_files.h"
#include "common/io/mesh_file.h"
#include "common/io/scene_file.h"

namespace kerf {

namespace io = core::io;

namespace {

constexpr const char* kEmpty = "the mesh is empty: there is nothing to write";

}  // namespace

struct FileReport::Data
{
    MeshReport mesh;
    std::vector<io::ReadingNote> notes;
    std::vector<std::string> files;
};

struct FileReportMaker
{
    static void fill(FileReport& report, const io::LoadedMesh& loaded)
    {
        auto data = std::make_unique<FileReport::Data>();
        data->mesh = report_of(loaded.facts, loaded.repairs);
        data->notes = loaded.notes.list();
        for (const std::filesystem::path& file : loaded.files) data->files.push_back(file.string());
        delete report.data_;
        report.data_ = data.release();
    }
};

FileReport::FileReport(FileReport&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

FileReport& FileReport::operator=(FileReport&& other) noexcept
{
    FileReport taken(std::move(other));
    std::swap(data_, taken.data_);
    return *this;
}

FileReport::~FileReport()
{
    delete data_;
}

const MeshReport& FileReport::mesh() const noexcept
{
    static const MeshReport none;
    return data_ != nullptr ? data_->mesh : none;
}

std::size_t FileReport::note_count() const noexcept
{
    return data_ != nullptr ? data_->notes.size() : 0;
}

FileReport::Note FileReport::note(std::size_t i) const noexcept
{
    if (i >= note_count()) return {};
    return {data_->notes[i].what.c_str(), data_->notes[i].count};
}

std::size_t FileReport::file_count() const noexcept
{
    return data_ != nullptr ? data_->files.size() : 0;
}

const char* FileReport::file(std::size_t i) const noexcept
{
    return i < file_count() ? data_->files[i].c_str() : "";
}

namespace {

/// `read` gives what is loaded. The report changes last: the name of the file may be the report's own.
template <class Read>
Result<Mesh> read_with_report(FileReport* report, Read read)
{
    Result<Mesh> answer = answer_of_file<Result<Mesh>>([&]() -> Result<Mesh> {
        io::LoadedMesh loaded = read();
        if (report != nullptr) FileReportMaker::fill(*report, loaded);
        return Mesh(new Mesh::Data(std::move(loaded.mesh)));
    });
    if (!answer && report != nullptr) *report = FileReport();
    return answer;
}

Result<Mesh> no_name(FileReport* report, const char* reason)
{
    if (report != nullptr) *report = FileReport();
    return {Status::invalid_argument, Sentence(reason)};
}

std::string_view text_of(std::span<const std::byte> file)
{
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

}  // namespace

Result<Mesh> read_mesh(const char* path, FileReport* report) noexcept
{
    if (path == nullptr || *path == '\0') return no_name(report, "there is no name of a file");
    return read_with_report(report, [&] { return io::read_mesh(path); });
}

Result<Mesh> read_mesh(std::span<const std::byte> file, const char* format, FileReport* report) noexcept
{
    if (format == nullptr) return no_name(report, "there is no name of a format");
    return read_with_report(report, [&] { return io::read_mesh(text_of(file), format); });
}

Outcome write_mesh(const Mesh& mesh, const char* path) noexcept
{
    if (path == nullptr || *path == '\0') return {Status::invalid_argument, Sentence("there is no name of a file")};
    if (mesh.is_empty()) return {Status::invalid_mesh, Sentence(kEmpty)};
    return answer_of_file<Outcome>([&] {
        io::write_mesh(path, mesh.data()->mesh());
        return Outcome();
    });
}

void remove_unfinished_files_on_signals() noexcept
{
    io::remove_unfinished_files_on_signals();
}

FileBytes::FileBytes(FileBytes&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept
{
    FileBytes taken(std::move(other));
    std::swap(data_, taken.data_);
    return *this;
}

FileBytes::~FileBytes()
{
    delete data_;
}

std::span<const std::byte> FileBytes::bytes() const noexcept
{
    if (data_ == nullptr) return {};
    return std::as_bytes(std::span(data_->text.data(), data_->text.size()));
}

Result<FileBytes> mesh_file_bytes(const Mesh& mesh, const char* format) noexcept
{
    if (format == nullptr) return {Status::invalid_argument, Sentence("there is no name of a format")};
    if (mesh.is_empty()) return {Status::invalid_mesh, Sentence(kEmpty)};
    return answer_of_file<Result<FileBytes>>([&]() -> Result<FileBytes> {
        auto data = std::make_unique<FileBytes::Data>();
        data->text = io::mesh_bytes(mesh.data()->mesh(), format);
        return FileBytes(data.release());
    });
}

Result<FileBytes> scene_file_bytes(std::span<const SceneNode> nodes) noexcept
{
    for (const SceneNode& node : nodes) {
        if (node.mesh == nullptr || node.name == nullptr || node.extras == nullptr)
            return {Status::invalid_argument, Sentence("a node of the scene has a null pointer")};
        if (node.mesh->is_empty()) return {Status::invalid_mesh, Sentence(kEmpty)};
    }
    return answer_of_file<Result<FileBytes>>([&]() -> Result<FileBytes> {
        std::vector<io::SceneNode> inside;
        for (const SceneNode& node : nodes)
            inside.push_back({node.name,
                              &node.mesh->data()->mesh(),
                              {node.translation.x, node.translation.y, node.translation.z},
                              node.extras});
        auto data = std::make_unique<FileBytes::Data>();
        data->text = io::scene_bytes(inside);
        return FileBytes(data.release());
    });
}

const char* readable_format(std::size_t i) noexcept
{
    static constexpr const char* kFormats[]{"obj", "ply", "stl", "off", "gltf", "glb"};
    return i < std::size(kFormats) ? kFormats[i] : nullptr;
}

const char* writable_format(std::size_t i) noexcept
{
    return answer_or(static_cast<const char*>(nullptr), [&] {
        const std::vector<std::string>& formats = io::writable_formats();
        return i < formats.size() ? formats[i].c_str() : nullptr;
    });
}

struct MeshFileSet::Data
{
    io::MeshFileSet files;

    /// The files of a set that may have none yet.
    static io::MeshFileSet& files_of(Data*& set)
    {
        if (set == nullptr) set = new Data;
        return set->files;
    }
};

MeshFileSet::MeshFileSet(const FileReport& inputs) noexcept : is_unprotected_(!protect(inputs)) {}

MeshFileSet::MeshFileSet(MeshFileSet&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), is_unprotected_(other.is_unprotected_)
{
}

MeshFileSet& MeshFileSet::operator=(MeshFileSet&& other) noexcept
{
    MeshFileSet taken(std::move(other));
    std::swap(data_, taken.data_);
    std::swap(is_unprotected_, taken.is_unprotected_);
    return *this;
}

MeshFileSet::~MeshFileSet()
{
    delete data_;
}

Outcome MeshFileSet::protect(const FileReport& inputs) noexcept
{
    return answer_of_file<Outcome>([&] {
        std::vector<std::filesystem::path> paths;
        for (std::size_t i = 0; i < inputs.file_count(); ++i) paths.emplace_back(inputs.file(i));
        Data::files_of(data_).protect(paths);
        return Outcome();
    });
}

Outcome MeshFileSet::add(const char* path, const Mesh& mesh) noexcept
{
    if (path == nullptr || *path == '\0') return {Status::invalid_argument, Sentence("there is no name of a file")};
    if (mesh.is_empty()) return {Status::invalid_mesh, Sentence(kEmpty)};
    if (is_unprotected_) return {Status::out_of_memory, Sentence(kNoMemoryForFile)};
    return answer_of_file<Outcome>([&] {
        Data::files_of(data_).add(path, mesh.data()->mesh());
        return Outcome();
    });
}

Outcome MeshFileSet::add(const char* path, std::span<const std::byte> bytes) noexcept
{
    if (path == nullptr || *path == '\0') return {Status::invalid_argument, Sentence("there is no name of a file")};
    if (is_unprotected_) return {Status::out_of_memory, Sentence(kNoMemoryForFile)};
    return answer_of_file<Outcome>([&] {
        Data::files_of(data_).add(path, text_of(bytes));
        return Outcome();
    });
}

Outcome MeshFileSet::commit() noexcept
{
    if (data_ == nullptr) return {};
    return answer_of_file<Outcome>([&] {
        data_->files.commit();
        return Outcome();
    });
}

}  // namespace kerf
