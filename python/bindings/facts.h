#pragma once

#include "arrays.h"

#include <kerf/mass.h>
#include <kerf/mesh.h>
#include <kerf/statistics.h>

#include <pybind11/pybind11.h>

// Small structs of the library as dictionaries and tuples, of which python/kerf makes its own.

namespace kerf::python {

/// Facts, repairs, and a sentence of the repairs.
pybind11::tuple report_tuple(const MeshReport& report);
/// Name, base colour, image.
pybind11::tuple material_tuple(const Material& material);
pybind11::dict mass_dict(const MassProperties& mass);
pybind11::dict statistics_dict(const CutStatistics& statistics);

}  // namespace kerf::python
