#include "tools/cut_output.h"

#include <filesystem>

#include "tools/flat_mesh.h"

namespace kerf::tools {

std::string CutOutput::file_name(Side side, std::optional<std::size_t> component) const
{
    std::string name = prefix + (side == Side::positive ? ".positive" : ".negative");
    if (component) name.append(".").append(std::to_string(*component));
    return name.append(".").append(format);
}

namespace {

void refuse_to_replace(const CutOutput& output, const std::string& name)
{
    for (const std::string& kept : output.kept_files) {
        std::error_code error;
        if (kept != "-" && std::filesystem::equivalent(kept, name, error) && !error)
            throw FileError(name + ": a piece would replace what the batch reads, or its results; choose another name");
    }
}

}  // namespace

void add_pieces(MeshFileSet& files, const CutOutput& output, bool components, Cut& cut, CutReport& report)
{
    for (const Side side : {Side::positive, Side::negative}) {
        if (output.keep.value_or(side) != side) continue;
        SideReport& said = side == Side::positive ? report.positive : report.negative;
        for (std::size_t i = 0; const Object* piece = cut.piece(side, i); ++i) {
            const Mesh mesh = mesh_of(*piece);
            const std::string name = output.file_name(side, components ? std::optional(i) : std::nullopt);
            refuse_to_replace(output, name);
            check(files.add(name.c_str(), mesh));
            said.pieces.push_back({name, measure_fragment(flat(mesh), piece->mass_properties())});
        }
    }
}

}  // namespace kerf::tools
