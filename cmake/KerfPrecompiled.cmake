# Headers of others that most files include, compiled once.
#
# Not those that a few files need: GCC instantiates in each file what a compiled header has asked for (CLI11: 8 s, JSON:
# 1 s), used or not.
#
# Off by default in Kerf's own builds: a file that forgets an include compiles all the same if the header is among these.
# The presets in which the code is only run turn it on; those in which it is checked (`clang`) do not.
option(KERF_PRECOMPILE "Compile the headers of the standard library, GLM and GoogleTest once for all targets"
  ${KERF_IN_A_PROJECT})

set(KERF_PRECOMPILED_HEADERS
  <algorithm> <array> <bit> <charconv> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
  <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <tuple> <unordered_map> <utility>
  <vector> <glm/common.hpp> <glm/geometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp>)

# Owns the compiled headers NAME.gch, for targets with the flags of kerf_flags and no others.
function(kerf_precompiled_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBS" ${ARGN})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE kerf_flags ${ARG_LIBS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

if(KERF_PRECOMPILE)
  # ccache can only look into a header that was compiled before with these options.
  target_compile_options(kerf_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
  kerf_precompiled_headers(kerf_precompiled HEADERS ${KERF_PRECOMPILED_HEADERS} LIBS glm::glm)
  if(KERF_BUILD_TESTS)
    kerf_precompiled_headers(kerf_precompiled_tests
      HEADERS ${KERF_PRECOMPILED_HEADERS} <gtest/gtest.h> <rapidcheck/gtest.h>
      LIBS glm::glm GTest::gtest kerf_rapidcheck kerf_cold_flags)
  endif()
endif()

# kerf_precompile(TARGET [_tests]): TARGET reads these headers compiled, a test GoogleTest's and RapidCheck's, too. It must
# have no compiler flags of its own.
function(kerf_precompile target)
  if(KERF_PRECOMPILE)
    list(JOIN ARGN "" kind)
    target_precompile_headers(${target} REUSE_FROM kerf_precompiled${kind})
  endif()
endfunction()
