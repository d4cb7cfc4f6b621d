// make_fruit FOLDER: writes the game's fruit as GLB files into FOLDER.

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "common/io/mesh_file.h"
#include "common/repair/repair.h"
#include "maker/fruit/fruit.h"
#include "maker/fruit/soup.h"

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: make_fruit FOLDER\n";
        return 2;
    }
    int failures = 0;
    for (const auto& fruit : kerf::maker::kFruit) {
        try {
            const kerf::core::Repaired made = kerf::core::repair(kerf::maker::soup_of(fruit.make()));
            if (!made.error.empty()) throw std::logic_error(made.error);
            if (!made.repairs.none()) throw std::logic_error(made.repairs.describe());
            const std::string path = std::string(argv[1]) + '/' + std::string(fruit.name) + ".glb";
            kerf::core::io::write_mesh(path, made.mesh);
            std::cout << path << ": " << made.mesh->triangles.size() << " triangles\n";
        } catch (const std::exception& error) {
            std::cerr << fruit.name << ": " << error.what() << '\n';
            ++failures;
        }
    }
    return failures == 0 ? 0 : 1;
}
