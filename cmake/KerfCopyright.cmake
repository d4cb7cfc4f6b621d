# The copyright file of what is installed, in Debian's machine-readable format: Kerf's own licence, and a notice for
# each library of others of which code is compiled in (packaging/notices) with the licences that these name
# (packaging/licences). CGAL is GPL, and what it is compiled into is GPL as a whole.

# kerf_copyright(FILE notices...): writes it.
function(kerf_copyright file)
  set(folder ${PROJECT_SOURCE_DIR}/packaging)
  set(licence Expat)
  set(whole "")
  if("cgal" IN_LIST ARGN)
    string(CONCAT whole "License: GPL-3+\n"
      "Comment: Kerf is under the Expat licence (MIT). CGAL's triangulations, which are\n"
      " compiled in, are under the GPL, version 3 or later: so is this as a whole.\n")
  endif()
  string(CONCAT text "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
    "Upstream-Name: Kerf\n${whole}\nFiles: *\nCopyright: 2026 The Kerf authors\nLicense: Expat\n")
  foreach(notice ${ARGN})
    file(READ ${folder}/notices/${notice} one)
    string(APPEND text "\n${one}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/notices/${notice})
  endforeach()
  string(REGEX MATCHALL "\nLicense: [^\n]+" lines "${text}")
  string(REGEX REPLACE "\nLicense: | and " ";" names "${lines}")
  list(REMOVE_DUPLICATES names)
  list(REMOVE_ITEM names "")
  foreach(name ${names})
    file(READ ${folder}/licences/${name} one)
    string(APPEND text "\n${one}")
  endforeach()
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
endfunction()

# Of which libraries' code each part is made.
set(KERF_NOTICES_LIBRARY glm json)
set(KERF_NOTICES_CAPS_CGAL glm cgal)
set(KERF_NOTICES_KERF glm json cli11)
if(TARGET kerf::core::halfedge)
  list(APPEND KERF_NOTICES_LIBRARY openmesh)
  list(APPEND KERF_NOTICES_KERF openmesh)
endif()
if(TARGET kerf::core::caps_cgal)
  list(APPEND KERF_NOTICES_KERF cgal)
endif()
set(KERF_NOTICES_VIEWER ${KERF_NOTICES_KERF} bullet imgui eigen)
if(TARGET kerf::core::proxy)
  list(APPEND KERF_NOTICES_LIBRARY bullet)
endif()

# Whoever installs without packages gets them, too.
include(GNUInstallDirs)
function(kerf_install_copyright part target)
  if(TARGET ${target})
    string(TOUPPER ${part} upper)
    kerf_copyright(${PROJECT_BINARY_DIR}/copyright/${part} ${KERF_NOTICES_${upper}})
    install(FILES ${PROJECT_BINARY_DIR}/copyright/${part} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kerf/copyright
      COMPONENT notices)
  endif()
endfunction()
kerf_install_copyright(library kerf_component_linear)
kerf_install_copyright(caps_cgal kerf_component_caps_cgal)
kerf_install_copyright(kerf kerf)
kerf_install_copyright(viewer kerf-viewer)
