// kerf_peers: other libraries on the meshes and planes of kerf_bench. Prints JSON.
//   kerf_peers cgal SECONDS TRIANGLES...      asteroids of these sizes and the fifteen models, each within a budget
//   kerf_peers export FOLDER TRIANGLES...     the same inputs as files, for peers that are no C++ (vtk_peer.py)
//   kerf_peers sections SECONDS TRIANGLES...  sections of asteroids and of meshes that are not round, which stay
//                                             whole, each within a budget
//   kerf_peers cells SECONDS TRIANGLES...     asteroids broken into cells of points, each within a budget
//   kerf_peers export-sections FOLDER TRIANGLES...  the same inputs as files (vtk_sections.py)

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/peers/cgal_cells.h"
#include "bench/peers/cgal_peer.h"
#include "bench/peers/cgal_slicer.h"
#include "bench/peers/peer_inputs.h"

namespace kerf::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Calls `take` with every input, one at a time: large ones should not all stay in memory.
template <class Take>
void for_each_input(const std::vector<std::string>& sizes, Take take)
{
    for (const PeerInput& input : model_inputs()) take(input);
    for (const std::string& size : sizes) take(asteroid_input(std::stoull(size)));
}

Json to_json(const PeerRow& row)
{
    return {{"peer", row.peer},     {"mesh", row.mesh},         {"triangles", row.triangles},
            {"ms", row.ms},         {"least_ms", row.least_ms}, {"most_ms", row.most_ms},
            {"planes", row.planes}, {"right", row.right},       {"verdict", row.verdict}};
}

Json cgal(double budget, const std::vector<std::string>& sizes)
{
    Json rows = Json::array();
    for_each_input(sizes, [&](const PeerInput& input) {
        for (const PeerRow& row : {time_cgal_clip(input, budget), time_cgal_split(input, budget)})
            rows.push_back(to_json(row));
    });
    return {{"peers", std::move(rows)}};
}

/// As for_each_input(): asteroids, and the meshes that are not round.
template <class Take>
void for_each_section_input(const std::vector<std::string>& sizes, Take take)
{
    for (const std::string& size : sizes) take(asteroid_section_input(std::stoull(size)));
    for (std::size_t i = 0; i < real_section_input_count(); ++i) take(real_section_input(i));
}

Json sections(double budget, const std::vector<std::string>& sizes)
{
    Json rows = Json::array();
    for_each_section_input(sizes, [&](const SectionInput& input) {
        for (const SlicerRow& sliced : time_cgal_slicer(input, budget)) {
            Json row = to_json(sliced.row);
            row["heights"] = sliced.heights;
            row["prepare_ms"] = sliced.prepare_ms;
            rows.push_back(std::move(row));
        }
    });
    return {{"sections", std::move(rows)}};
}

Json cells(double budget, const std::vector<std::string>& sizes)
{
    Json rows = Json::array();
    for (const std::string& size : sizes)
        for (const std::uint32_t count : {10u, 100u}) {
            Json row = to_json(time_cgal_cells(asteroid_cell_input(std::stoull(size), count), budget));
            row["cells"] = count;
            rows.push_back(std::move(row));
        }
    return {{"cells", std::move(rows)}};
}

template <class Element>
void write_bytes(const std::filesystem::path& path, const std::vector<Element>& elements)
{
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(elements.data()),
              static_cast<std::streamsize>(elements.size() * sizeof(Element)));
    if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// NAME.points: three floats each; NAME.triangles: three 32-bit indices each. Returns NAME.
std::string write_mesh(const std::filesystem::path& folder, const BareMesh& mesh)
{
    std::filesystem::create_directories(folder);
    std::string file = mesh.name + "-" + std::to_string(mesh.triangles.size());
    write_bytes(folder / (file + ".points"), mesh.points);
    write_bytes(folder / (file + ".triangles"), mesh.triangles);
    return file;
}

Json export_sections(const std::filesystem::path& folder, const std::vector<std::string>& sizes)
{
    Json inputs = Json::array();
    for_each_section_input(sizes, [&](const SectionInput& input) {
        Json planes = Json::array(), stacks = Json::array();
        for (std::size_t i = 0; i < input.planes.size(); ++i) {
            const Normal normal = input.planes[i].normal();
            planes.push_back({{"normal", {normal.x, normal.y, normal.z}},
                              {"offset", input.planes[i].offset()},
                              {"length", input.expected[i].length},
                              {"loops", input.expected[i].loops}});
        }
        for (const SectionInput::Stack& stack : input.stacks)
            stacks.push_back(
                {{"heights", stack.heights}, {"length", stack.expected.length}, {"loops", stack.expected.loops}});
        inputs.push_back({{"mesh", input.name},
                          {"file", write_mesh(folder, input)},
                          {"planes", std::move(planes)},
                          {"stacks", std::move(stacks)}});
    });
    return {{"length_share", kLengthShare}, {"inputs", std::move(inputs)}};
}

/// The JSON names the meshes' files.
Json export_inputs(const std::filesystem::path& folder, const std::vector<std::string>& sizes)
{
    Json inputs = Json::array();
    for_each_input(sizes, [&](const PeerInput& input) {
        const std::string file = write_mesh(folder, input);
        Json planes = Json::array();
        for (std::size_t i = 0; i < input.planes.size(); ++i) {
            const Plane& plane = input.planes[i];
            const Normal normal = plane.normal();
            planes.push_back({{"normal", {normal.x, normal.y, normal.z}},
                              {"offset", plane.offset()},
                              {"negative_volume", input.volumes[i]}});
        }
        inputs.push_back(
            {{"mesh", input.name}, {"file", file}, {"volume", input.volume}, {"planes", std::move(planes)}});
    });
    return {{"volume_share", kVolumeShare}, {"inputs", std::move(inputs)}};
}

int run(const std::vector<std::string>& arguments)
{
    const std::string what = arguments.empty() ? "" : arguments[0];
    const bool is_known =
        what == "cgal" || what == "export" || what == "sections" || what == "cells" || what == "export-sections";
    if (arguments.size() < 2 || !is_known) {
        std::cerr << "Usage: kerf_peers cgal|sections|cells SECONDS TRIANGLES...\n"
                     "       kerf_peers export|export-sections FOLDER TRIANGLES...\n";
        return 2;
    }
    const std::vector<std::string> sizes(arguments.begin() + 2, arguments.end());
    Json answer;
    if (what == "cgal") answer = cgal(std::stod(arguments[1]), sizes);
    if (what == "sections") answer = sections(std::stod(arguments[1]), sizes);
    if (what == "cells") answer = cells(std::stod(arguments[1]), sizes);
    if (what == "export") answer = export_inputs(arguments[1], sizes);
    if (what == "export-sections") answer = export_sections(arguments[1], sizes);
    std::cout << answer << '\n';
    return std::cout.flush() ? 0 : 1;
}

}  // namespace
}  // namespace kerf::bench

int main(int argc, char** argv)
{
    try {
        return kerf::bench::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "kerf_peers: " << error.what() << '\n';
        return 1;
    }
}
