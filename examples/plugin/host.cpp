// Loads the plug-in, and unloads it.

#include <dlfcn.h>

#include <cstdio>

int main()
{
    void* const plugin = dlopen(PLUGIN, RTLD_NOW | RTLD_LOCAL);
    if (plugin == nullptr) return std::fprintf(stderr, "%s\n", dlerror()), 1;
    using CutInTwo = double (*)(const char*, double, unsigned long*);
    const auto cut_in_two = reinterpret_cast<CutInTwo>(dlsym(plugin, "cut_in_two"));
    if (cut_in_two == nullptr) return std::fprintf(stderr, "%s\n", dlerror()), 1;
    unsigned long triangles[2] = {};
    const double area = cut_in_two("torus", 0.1, triangles);
    std::printf("area %g, %lu and %lu triangles\n", area, triangles[0], triangles[1]);
    const bool is_right = area > 0.0 && triangles[0] > 0 && triangles[1] > 0 && cut_in_two("nothing", 0, triangles) < 0;
    // Nothing of it stays: a new version could be loaded.
    const bool is_gone = dlclose(plugin) == 0 && dlopen(PLUGIN, RTLD_NOW | RTLD_NOLOAD) == nullptr;
    if (!is_gone) std::fprintf(stderr, "the plug-in stays loaded\n");
    return is_right && is_gone ? 0 : 1;
}
