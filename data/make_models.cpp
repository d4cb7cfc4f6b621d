// make_models FOLDER: writes the report's fifteen models as OBJ files into FOLDER.

#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "maker/models.h"
#include "maker/obj.h"

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: make_models FOLDER\n";
        return 2;
    }
    int failures = 0;
    for (const auto& model : kerf::maker::kModels) {
        try {
            const kerf::maker::PolyMesh mesh = model.make();
            const int triangles = kerf::maker::triangle_count(mesh);
            if (triangles != model.triangles)
                throw std::logic_error(std::to_string(triangles) + " triangles instead of " +
                                       std::to_string(model.triangles));
            const std::string text = kerf::maker::obj_text(mesh, std::string(model.name));
            const std::string path = std::string(argv[1]) + '/' + std::string(model.name) + ".obj";
            std::ofstream file(path, std::ios::binary);
            file << text;
            file.close();
            if (!file) throw std::runtime_error("cannot write " + path);
            std::cout << path << ": " << triangles << " triangles\n";
        } catch (const std::exception& error) {
            std::cerr << model.name << ": " << error.what() << '\n';
            ++failures;
        }
    }
    return failures == 0 ? 0 : 1;
}
