# What is installed: headers, a library for each component, the files by which CMake and pkg-config find them.
#
# The library's own code is built in rooms; a component is the objects of some rooms, so that users see few files. They
# are shared libraries if BUILD_SHARED_LIBS says so.
#
# | component          | library       | needs                   |
# |--------------------|---------------|-------------------------|
# | mesh caps linear   | kerf          | the C++ library         |
# | halfedge           | kerf_halfedge | OpenMesh                |
# | caps_cgal          | kerf_caps_cgal| GMP, MPFR; it is GPL    |
# | io                 | kerf_io       | the C++ library         |
# | c                  | kerf_c        | the C++ library         |
# | shapes             | kerf_shapes   | the C++ library         |
# | proxy              | kerf_proxy    | Bullet's LinearMath     |

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(KERF_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/kerf)

# kerf_component(NAME ROOMS targets... [NEEDS libraries...] [BASE]): the library of a component. All but the base link it.
function(kerf_component name)
  cmake_parse_arguments(ARG "BASE" "" "ROOMS;NEEDS" ${ARGN})
  set(target kerf_component_${name})
  set(objects "")
  foreach(room ${ARG_ROOMS})
    list(APPEND objects $<TARGET_OBJECTS:${room}>)
  endforeach()
  set_property(GLOBAL APPEND PROPERTY KERF_PACKED_ROOMS ${ARG_ROOMS})
  add_library(${target} ${objects})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name} OUTPUT_NAME kerf_${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(BUILD_SHARED_LIBS)
    target_link_options(${target} PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/kerf.map
      LINKER:-Bsymbolic-functions LINKER:--no-undefined LINKER:--as-needed)
    # Components lie beside one another.
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/kerf.map
      INSTALL_RPATH "$ORIGIN")
  else()
    target_compile_definitions(${target} INTERFACE KERF_STATIC)
  endif()
  if(ARG_BASE)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME kerf)
  else()
    target_link_libraries(${target} PUBLIC kerf_component_linear)
  endif()
  target_link_libraries(${target} PRIVATE ${ARG_NEEDS})
  # What is GPL is installed by itself, so that what is MIT can be packed without it.
  set(export kerf-targets)
  set(part "")
  if(name STREQUAL caps_cgal)
    set(export kerf-caps_cgal-targets)
    set(part caps_cgal_)
  endif()
  install(TARGETS ${target} EXPORT ${export}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${part}libraries NAMELINK_COMPONENT ${part}development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${part}development)
  set(KERF_COMPONENTS ${KERF_COMPONENTS} ${name} PARENT_SCOPE)
endfunction()

set(KERF_COMPONENTS "")
kerf_component(linear BASE ROOMS
  kerf_core_support kerf_core_mesh kerf_core_geometry kerf_core_repair kerf_core_caps kerf_core_section_closer
  kerf_core_cutting kerf_core_sections kerf_core_fracture kerf_core_linear kerf_core_back_ends kerf_api)
kerf_component(io ROOMS kerf_core_files kerf_core_io kerf_core_drawings kerf_io)
kerf_component(c ROOMS kerf_c)
target_link_libraries(kerf_component_c PUBLIC kerf_component_io)
kerf_component(shapes ROOMS kerf_core_shapes kerf_shapes)
if(TARGET kerf::core::halfedge)
  kerf_component(halfedge ROOMS
    kerf_core_halfedge_universe kerf_core_halfedge_cut kerf_core_halfedge_handover kerf_core_halfedge
    kerf_core_halfedge_component
    NEEDS OpenMeshCore)
  target_link_options(kerf_component_halfedge INTERFACE LINKER:-u,kerf_component_halfedge)
endif()
if(TARGET kerf::core::proxy)
  kerf_component(proxy ROOMS kerf_core_proxy kerf_proxy NEEDS LinearMath)
endif()
if(TARGET kerf::core::caps_cgal)
  kerf_component(caps_cgal ROOMS kerf_core_caps_cgal NEEDS gmp mpfr)
  target_link_options(kerf_component_caps_cgal INTERFACE LINKER:-u,kerf_component_caps_cgal)
endif()

# A room that a packed one links, and that no component has, would be missed by its users' linkers only.
get_property(packed_rooms GLOBAL PROPERTY KERF_PACKED_ROOMS)
foreach(room ${packed_rooms})
  get_target_property(links ${room} LINK_LIBRARIES)
  foreach(link ${links})
    if(TARGET ${link})
      get_target_property(real ${link} ALIASED_TARGET)
      get_target_property(kind ${link} TYPE)
      if(real AND kind STREQUAL STATIC_LIBRARY AND NOT real IN_LIST packed_rooms)
        message(FATAL_ERROR "${room} links ${real}, which is a room of no component (cmake/KerfPackage.cmake)")
      endif()
    endif()
  endforeach()
endforeach()

install(DIRECTORY include/kerf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT kerf-targets NAMESPACE kerf:: DESTINATION ${KERF_CMAKE_FOLDER} COMPONENT development)
if(TARGET kerf_component_caps_cgal)
  install(EXPORT kerf-caps_cgal-targets NAMESPACE kerf:: DESTINATION ${KERF_CMAKE_FOLDER} COMPONENT caps_cgal_development)
endif()
configure_package_config_file(cmake/kerf-config.cmake.in ${PROJECT_BINARY_DIR}/kerf-config.cmake
  INSTALL_DESTINATION ${KERF_CMAKE_FOLDER} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kerf-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kerf-config.cmake ${PROJECT_BINARY_DIR}/kerf-config-version.cmake
  DESTINATION ${KERF_CMAKE_FOLDER} COMPONENT development)

# For pkg-config. What puts itself in place is linked though nobody refers to it.
file(RELATIVE_PATH KERF_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" KERF_PC_PREFIX "${KERF_PC_PREFIX}")
set(KERF_PC_LIBS "")
set(KERF_PC_DEFINES "")
if(BUILD_SHARED_LIBS)
  string(APPEND KERF_PC_LIBS "-Wl,--push-state,--no-as-needed ")
else()
  set(KERF_PC_DEFINES " -DKERF_STATIC")
  if(TARGET kerf_component_halfedge)
    string(APPEND KERF_PC_LIBS "-Wl,-u,kerf_component_halfedge ")
  endif()
endif()
foreach(component c io shapes halfedge proxy)
  if(TARGET kerf_component_${component})
    string(APPEND KERF_PC_LIBS "-lkerf_${component} ")
  endif()
endforeach()
string(APPEND KERF_PC_LIBS "-lkerf")
if(BUILD_SHARED_LIBS)
  string(APPEND KERF_PC_LIBS " -Wl,--pop-state")
else()
  foreach(component halfedge:OpenMeshCore proxy:LinearMath)
    string(REPLACE ":" ";" component ${component})
    list(GET component 0 name)
    list(GET component 1 library)
    if(TARGET kerf_component_${name})
      string(APPEND KERF_PC_LIBS " -l${library}")
    endif()
  endforeach()
endif()
configure_file(cmake/kerf.pc.in ${PROJECT_BINARY_DIR}/kerf.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/kerf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
