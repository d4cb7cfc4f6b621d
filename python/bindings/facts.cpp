#include "facts.h"

namespace py = pybind11;

namespace kerf::python {

namespace {

py::dict facts_dict(const MeshFacts& facts)
{
    py::dict result;
    result["triangles"] = facts.triangles;
    result["vertices"] = facts.vertices;
    result["points"] = facts.points;
    result["degenerate_triangles"] = facts.degenerate_triangles;
    result["duplicate_triangles"] = facts.duplicate_triangles;
    result["boundary_edges"] = facts.boundary_edges;
    result["boundary_loops"] = facts.boundary_loops;
    result["open_edges"] = facts.open_edges;
    result["nonmanifold_edges"] = facts.nonmanifold_edges;
    result["nonmanifold_points"] = facts.nonmanifold_points;
    result["misoriented_edges"] = facts.misoriented_edges;
    result["unbalanced_edges"] = facts.unbalanced_edges;
    result["shells"] = facts.shells;
    result["shortest_edge"] = facts.shortest_edge;
    result["area"] = facts.area;
    result["volume"] = facts.volume;
    result["has_coarse_coordinates"] = facts.has_coarse_coordinates;
    return result;
}

py::dict repairs_dict(const Repairs& repairs)
{
    py::dict result;
    result["degenerate_triangles"] = repairs.degenerate_triangles;
    result["duplicate_triangles"] = repairs.duplicate_triangles;
    result["coinciding_triangles"] = repairs.coinciding_triangles;
    result["nonmanifold_edges"] = repairs.nonmanifold_edges;
    result["nonmanifold_points"] = repairs.nonmanifold_points;
    result["flipped_triangles"] = repairs.flipped_triangles;
    result["unorientable_edges"] = repairs.unorientable_edges;
    result["replaced_attributes"] = repairs.replaced_attributes;
    return result;
}

}  // namespace

py::tuple report_tuple(const MeshReport& report)
{
    return py::make_tuple(facts_dict(report.facts), repairs_dict(report.repairs), describe(report.repairs).c_str());
}

py::tuple material_tuple(const Material& material)
{
    const float* const colour = material.base_colour;
    return py::make_tuple(material.name, py::make_tuple(colour[0], colour[1], colour[2], colour[3]),
                          material.base_colour_image);
}

py::dict mass_dict(const MassProperties& mass)
{
    py::array_t<double> inertia({3, 3});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) inertia.mutable_at(row, column) = mass.inertia.m[column][row];
    py::dict result;
    result["volume"] = mass.volume;
    result["centre"] = small_array(mass.centre);
    result["inertia"] = inertia;
    result["is_of_solid"] = mass.is_of_solid;
    return result;
}

py::dict statistics_dict(const CutStatistics& statistics)
{
    py::dict result;
    result["triangles"] = statistics.triangles;
    result["crossing_triangles"] = statistics.crossing_triangles;
    result["crossing_surface"] = statistics.crossing_surface;
    result["section_loops"] = statistics.section_loops;
    result["open_chains"] = statistics.open_chains;
    result["nodes_visited"] = statistics.nodes_visited;
    result["triangles_touched"] = statistics.triangles_touched;
    result["cap_steps"] = statistics.cap_steps;
    result["bytes_grown"] = statistics.bytes_grown;
    result["milliseconds"] = statistics.milliseconds();
    return result;
}

}  // namespace kerf::python
