// kerf_peers: other libraries on the meshes and planes of kerf_bench. Prints JSON.
//   kerf_peers cgal SECONDS TRIANGLES...      asteroids of these sizes and the fifteen models, each within a budget
//   kerf_peers export FOLDER TRIANGLES...     the same inputs as files, for peers that are no C++ (vtk_peer.py)

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/peers/cgal_peer.h"
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

Json cgal(double budget, const std::vector<std::string>& sizes)
{
    Json rows = Json::array();
    for_each_input(sizes, [&](const PeerInput& input) {
        for (const PeerRow& row : {time_cgal_clip(input, budget), time_cgal_split(input, budget)})
            rows.push_back({{"peer", row.peer},
                            {"mesh", row.mesh},
                            {"triangles", row.triangles},
                            {"ms", row.ms},
                            {"least_ms", row.least_ms},
                            {"most_ms", row.most_ms},
                            {"planes", row.planes},
                            {"right", row.right},
                            {"verdict", row.verdict}});
    });
    return {{"peers", std::move(rows)}};
}

template <class Element>
void write_bytes(const std::filesystem::path& path, const std::vector<Element>& elements)
{
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(elements.data()),
              static_cast<std::streamsize>(elements.size() * sizeof(Element)));
    if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// NAME.points: three floats each; NAME.triangles: three 32-bit indices each; the JSON names them.
Json export_inputs(const std::filesystem::path& folder, const std::vector<std::string>& sizes)
{
    std::filesystem::create_directories(folder);
    Json inputs = Json::array();
    for_each_input(sizes, [&](const PeerInput& input) {
        const std::string file = input.name + "-" + std::to_string(input.triangles.size());
        write_bytes(folder / (file + ".points"), input.points);
        write_bytes(folder / (file + ".triangles"), input.triangles);
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
    if (arguments.size() < 2 || (arguments[0] != "cgal" && arguments[0] != "export")) {
        std::cerr << "Usage: kerf_peers cgal SECONDS TRIANGLES... | kerf_peers export FOLDER TRIANGLES...\n";
        return 2;
    }
    const std::vector<std::string> sizes(arguments.begin() + 2, arguments.end());
    std::cout << (arguments[0] == "cgal" ? cgal(std::stod(arguments[1]), sizes) : export_inputs(arguments[1], sizes))
              << '\n';
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
