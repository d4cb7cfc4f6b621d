# Flags that every Kerf target compiles with.
#
# -ffp-contract=off: a fused multiply-add rounds once where the source says twice, so the same expression inlined
# in two places would give two answers and the back ends would not agree bit for bit (docs/floating-point.md).
#
# -fno-tree-slp-vectorize: GCC 12, from -O2, takes a pair of doubles that is rounded to float and widened again for the
# pair itself; the rounding is lost.
set(KERF_ROUNDING_OPTIONS -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

add_library(kerf_flags INTERFACE)
target_compile_features(kerf_flags INTERFACE cxx_std_20)
target_compile_options(kerf_flags INTERFACE ${KERF_ROUNDING_OPTIONS} -fno-fast-math
  # A project may do without them: inside, OpenMesh and mesh files need them.
  -frtti -fexceptions
  # For plug-ins and shared libraries; the same for all targets, because compiled headers go by it. GCC must still inline:
  # nobody replaces a function of ours at run time.
  -fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  -Wall -Wextra -Wpedantic -Wconversion
  # In a unity build the files of a target would shadow one another's constants, and none is the main file, whose unnamed
  # namespaces may be bases.
  $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>,-Wshadow>
  # What GCC counts as a conversion: the signs of indices are not.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
# A plug-in that holds the static library shows nothing of it, and can be unloaded: what is unique in a process stays.
# (Shared libraries show one another the library's own code; cmake/kerf.map says what.)
target_compile_options(kerf_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
if(NOT (KERF_INSTALL AND BUILD_SHARED_LIBS))
  target_compile_options(kerf_flags INTERFACE -fvisibility=hidden -fvisibility-inlines-hidden)
endif()
if(KERF_WERROR)
  target_compile_options(kerf_flags INTERFACE -Werror)
endif()
if(KERF_SANITIZE)
  target_compile_options(kerf_flags INTERFACE -fsanitize=${KERF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/sanitize-ignore.txt>
    # GCC's manual: sanitizers cause false positives of this warning (here in OpenMesh's headers).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(kerf_flags INTERFACE -fsanitize=${KERF_SANITIZE})
endif()

# For what compiles slowly and runs once, as test files and command lines, or no faster for more optimisation: files of
# 300 k triangles are read within the noise of one another at -O1, -O2 and -O3, but -O3 compiles for twice as long. (Where
# the work of the library is done, and in tests/support, the optimisation is that of the build.)
set(KERF_COLD_OPTIMIZATION -O1 CACHE STRING "Optimisation of test files, mesh files and command lines in builds that are optimised")
add_library(kerf_cold_flags INTERFACE)
target_compile_options(kerf_cold_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:${KERF_COLD_OPTIMIZATION}>)

# Where nobody compiles a second time: headers are read once, and a change of one file compiles all of its target again.
option(KERF_UNITY_TESTS "Compile the files of each test program as one" OFF)
# Somebody's project compiles the library once, and waits for it.
option(KERF_UNITY_LIBRARY "Compile the files of each of the library's targets as one" ${KERF_IN_A_PROJECT})

# The files of each target that this folder makes from here on, as one.
macro(kerf_compile_as_one)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 0)
endmacro()

# kerf_library(NAME [COLD] SOURCES...): a static library kerf_NAME with the alias kerf::NAME. Its own files write includes of
# the library from src/; what users of it see is up to the caller. COLD: see kerf_cold_flags.
function(kerf_library name)
  cmake_parse_arguments(ARG "COLD" "" "" ${ARGN})
  add_library(kerf_${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
  add_library(kerf::${name} ALIAS kerf_${name})
  target_compile_features(kerf_${name} PUBLIC cxx_std_20)
  target_include_directories(kerf_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(kerf_${name} PRIVATE $<BUILD_INTERFACE:kerf_flags>)
  if(ARG_COLD)
    target_link_libraries(kerf_${name} PRIVATE $<BUILD_INTERFACE:kerf_cold_flags>)
  else()
    kerf_precompile(kerf_${name})
  endif()
  if(KERF_UNITY_LIBRARY)
    set_target_properties(kerf_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

# kerf_core_library(NAME [COLD] SOURCES...): a part of the library's own code, kerf_core_NAME with the alias kerf::core::NAME. What
# links it sees its headers, and must round as they do.
function(kerf_core_library name)
  kerf_library(core_${name} ${ARGN})
  add_library(kerf::core::${name} ALIAS kerf_core_${name})
  target_include_directories(kerf_core_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_compile_options(kerf_core_${name} INTERFACE ${KERF_ROUNDING_OPTIONS})
endfunction()
