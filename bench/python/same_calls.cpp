// What bench/python/calls.py times in Python, called from C++: arrays become a mesh, it is cut, and the halves become
// arrays. It reads the arrays, and then times one round for each line of standard input.
#include <kerf/kerf.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

template <class T>
std::vector<T> read_numbers(const char* path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::vector<T> numbers(static_cast<std::size_t>(file.tellg()) / sizeof(T));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(T)));
    return numbers;
}

[[noreturn]] void fail(const char* why)
{
    std::cerr << "kerf_same_calls: " << why << "\n";
    std::exit(1);
}

/// The triangles of both halves, so that nothing can be left out. Both are there at the end, as in Python.
std::size_t round_trip(const kerf::MeshInput& input, const kerf::Plane& plane)
{
    const kerf::Result<kerf::Mesh> mesh = kerf::Mesh::make(input);
    if (!mesh) fail(mesh.reason());
    // Python's mesh stays, so this one does.
    kerf::PrepareOptions options;
    options.back_end = kerf::BackEnd::linear;
    options.cuts_expected = 1;
    kerf::Result<kerf::Object> object = kerf::prepare(kerf::Mesh(*mesh), options);
    if (!object) fail(object.reason());
    kerf::Cut cut = kerf::cut(*std::move(object), plane);
    std::vector<kerf::Mesh> halves;
    std::size_t triangles = 0;
    for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative}) {
        const kerf::Object* const half = cut.one(side);
        if (half == nullptr) fail("the plane misses");
        kerf::Result<kerf::Mesh> piece = half->mesh();
        if (!piece) fail(piece.reason());
        halves.push_back(*std::move(piece));
        triangles += halves.back().arrays().indices.size() / 3;
    }
    return triangles;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3) fail("two files expected: positions, and indices");
    const std::vector<float> positions = read_numbers<float>(argv[1]);
    const std::vector<std::uint32_t> indices = read_numbers<std::uint32_t>(argv[2]);
    kerf::MeshInput input;
    input.positions = positions.data();
    input.vertex_count = positions.size() / 3;
    input.indices = indices.data();
    input.triangle_count = indices.size() / 3;
    const auto plane = kerf::Plane::at(kerf::Point(0, 0, 0), kerf::Normal(1, 2, 3));
    for (std::string line; std::getline(std::cin, line);) {
        const auto began = std::chrono::steady_clock::now();
        const std::size_t triangles = round_trip(input, *plane);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
        std::cout << took.count() << " " << triangles << std::endl;
    }
}
