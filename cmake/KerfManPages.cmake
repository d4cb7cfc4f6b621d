# Man pages, written from what the programs say of themselves: they can't differ.

find_program(KERF_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

# kerf_man_pages(TARGET COMPONENT component [SUBCOMMANDS]): makes and installs the page of a program, and one for each
# of its commands. Which commands there are is known when it is built: a folder is installed.
function(kerf_man_pages target)
  cmake_parse_arguments(ARG "SUBCOMMANDS" "COMPONENT" "" ${ARGN})
  set(folder ${PROJECT_BINARY_DIR}/man/${target})
  set(script ${PROJECT_SOURCE_DIR}/packaging/man_pages.py)
  set(flags "")
  if(ARG_SUBCOMMANDS)
    set(flags --subcommands)
  endif()
  add_custom_command(OUTPUT ${folder}/${target}.1.gz
    COMMAND ${KERF_PYTHON} ${script} $<TARGET_FILE:${target}> ${folder} ${flags}
    DEPENDS ${target} ${script} VERBATIM)
  add_custom_target(${target}_man_pages ALL DEPENDS ${folder}/${target}.1.gz)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${ARG_COMPONENT})
endfunction()
