#pragma once

#include <array>
#include <string_view>

#include "maker/poly_mesh.h"

namespace kerf::maker {

PolyMesh make_cube();
PolyMesh make_icosphere();
PolyMesh make_sphere();
PolyMesh make_cylinder();
PolyMesh make_cone();
PolyMesh make_pedestal();
PolyMesh make_barrel();
PolyMesh make_pawn();
PolyMesh make_rook();
PolyMesh make_bishop();
PolyMesh make_queen();
PolyMesh make_king();
PolyMesh make_horse();
PolyMesh make_monkey();
PolyMesh make_car();

struct Model
{
    std::string_view name;  ///< of the file, and in lower case the report's
    PolyMesh (*make)();
    int triangles;  ///< what Table 1 of the report asks for; the next even number for King and Queen
};

/// The report's fifteen, in the order of its Table 1.
inline constexpr std::array<Model, 15> kModels{{
    {"car", make_car, 2836},
    {"cube", make_cube, 12},
    {"rook", make_rook, 926},
    {"pedestal", make_pedestal, 44},
    {"horse", make_horse, 446},
    {"icosphere", make_icosphere, 80},
    {"bishop", make_bishop, 1216},
    {"cylinder", make_cylinder, 124},
    {"pawn", make_pawn, 898},
    {"cone", make_cone, 62},
    {"barrel", make_barrel, 706},
    {"king", make_king, 966},
    {"sphere", make_sphere, 760},
    {"queen", make_queen, 1060},
    {"monkey", make_monkey, 968},
}};

}  // namespace kerf::maker
