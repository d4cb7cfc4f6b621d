# Debian packages by CPack, of what this build has (./run debs: of all). docs/library.md has the table of packages.
#
# The libraries are the MIT set. CGAL's caps are a package of their own, which puts itself in place; it and the
# programs, which have CGAL linked in, are GPL-3+, and their copyright files say so.

include(KerfManPages)
find_program(KERF_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kerf)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "The Kerf authors <${KERF_MAINTAINER_MAIL}>")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE kerf)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# A package of Kerf needs this very version of another: what they ask of one another is promised to nobody else.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_COMPONENTS_ALL "")

set(this_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# What changed, as text and as Debian writes it.
set(changes ${PROJECT_BINARY_DIR}/packaging)
add_custom_command(OUTPUT ${changes}/changelog.gz ${changes}/changelog.Debian.gz
  COMMAND ${KERF_PYTHON} ${PROJECT_SOURCE_DIR}/packaging/changelogs.py ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${changes}
    --version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE} --contact ${CPACK_PACKAGE_CONTACT}
  DEPENDS packaging/changelogs.py CHANGELOG.md VERBATIM)
add_custom_target(kerf_changelogs ALL DEPENDS ${changes}/changelog.gz ${changes}/changelog.Debian.gz)

# kerf_deb(COMPONENT PACKAGE SECTION SUMMARY DESCRIPTION [LIBRARY | PROGRAM] [NOTICES names...] [DEPENDS packages...]
# [RECOMMENDS ...] [SUGGESTS ...]): the package of what is installed with this component. What it links is found out.
macro(kerf_deb component package section summary description)
  cmake_parse_arguments(ARG "LIBRARY;PROGRAM" "" "NOTICES;DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${what_it_is}\n${description}")
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN ARG_${relation} ", " CPACK_DEBIAN_${upper}_PACKAGE_${relation})
  endforeach()
  if(ARG_LIBRARY OR ARG_PROGRAM)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON)
  endif()
  if(ARG_LIBRARY)
    set(CPACK_DEBIAN_${upper}_PACKAGE_MULTIARCH same)
    # A trigger: dpkg runs ldconfig once, after all packages. CPack makes scripts that call it, unless such are named: it
    # leaves out those that do not exist.
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packaging/triggers ${changes}/none/postinst ${changes}/none/postrm)
  endif()
  kerf_copyright(${changes}/${package}/copyright ${ARG_NOTICES})
  install(FILES ${changes}/${package}/copyright ${changes}/changelog.gz ${changes}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endmacro()

set(what_it_is [[
Kerf cuts triangle meshes by a plane. Both sides are closed meshes that can be
cut again, with normals, texture coordinates, materials, mass properties and
collision hulls. The time of a cut follows its section, not the mesh.
]])

kerf_deb(libraries libkerf${abi} libs "cuts triangle meshes by a plane in real time (shared libraries)" [[
These are the libraries, without code under the GPL.]]
  LIBRARY NOTICES ${KERF_NOTICES_LIBRARY})
set(suggested "")
if(TARGET kerf_component_caps_cgal)
  set(suggested "libkerf-caps-cgal-dev ${this_version}")
endif()
kerf_deb(development libkerf-dev libdevel "cuts triangle meshes by a plane in real time (development files)" [[
These are the headers, and the files by which CMake and pkg-config find the
libraries.]]
  DEPENDS "libkerf${abi} ${this_version}" SUGGESTS ${suggested})
if(TARGET kerf_component_caps_cgal)
  kerf_deb(caps_cgal_libraries libkerf-caps-cgal${abi} libs "exact caps of cut triangle meshes (shared library)" [[
This library closes sections that have holes or cross themselves exactly, with
CGAL. Programs that link it are under the GPL.]]
    LIBRARY NOTICES ${KERF_NOTICES_CAPS_CGAL} DEPENDS "libkerf${abi} ${this_version}")
  kerf_deb(caps_cgal_development libkerf-caps-cgal-dev libdevel
    "exact caps of cut triangle meshes (development files)" [[
This is Kerf's component caps_cgal for CMake. Programs that link it are under
the GPL.]]
    DEPENDS "libkerf-dev ${this_version}" "libkerf-caps-cgal${abi} ${this_version}")
endif()
if(TARGET kerf_python)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(python ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
  kerf_deb(python python3-kerf python "cuts triangle meshes by planes, from Python" [[
This is the Python package, for meshes that are NumPy arrays.]]
    PROGRAM NOTICES ${KERF_NOTICES_LIBRARY} pybind11
    DEPENDS "libkerf${abi} ${this_version}" "python3 (>= ${python})" "python3 (<< ${Python_VERSION_MAJOR}.${next_python})" "python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/python/prerm)
endif()
if(TARGET kerf)
  kerf_deb(kerf kerf utils "program that cuts, repairs and converts triangle meshes" [[
This is the command line program, for OBJ, PLY, STL, OFF, glTF and GLB files.]]
    PROGRAM NOTICES ${KERF_NOTICES_KERF} SUGGESTS "kerf-data ${this_version}")
  kerf_man_pages(kerf COMPONENT kerf SUBCOMMANDS)
endif()
if(TARGET kerf-viewer)
  kerf_deb(viewer kerf-viewer graphics "game of cutting fruit and giants, which are real meshes" [[
This is the game: fruit that is cut with the mouse, giants of up to four
million triangles, and a duel of two ways to cut. It throws models of your
own, too, and runs without a screen.]]
    PROGRAM NOTICES ${KERF_NOTICES_VIEWER} DEPENDS "kerf-data ${this_version}" RECOMMENDS fonts-lato fonts-dejavu-core)
  kerf_man_pages(kerf-viewer COMPONENT viewer)
endif()
if(TARGET kerf OR TARGET kerf-viewer)
  kerf_deb(data kerf-data graphics "models and fruit to cut" [[
These are fifteen models and the fruit of the game.]])
  set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_DATA_PACKAGE_MULTIARCH foreign)
endif()

include(CPack)
