# What was compiled before, here or in another folder, is not compiled again if ccache is installed.
option(KERF_CCACHE "Compile through ccache if it is installed" ${PROJECT_IS_TOP_LEVEL})

if(KERF_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(KERF_CCACHE_PROGRAM ccache)
  mark_as_advanced(KERF_CCACHE_PROGRAM)
  if(KERF_CCACHE_PROGRAM)
    # Its manual: files that read a precompiled header are only kept with this sloppiness ("Precompiled headers"), and a
    # clone in another folder finds what was compiled here if paths are taken from the base folder on ("Compiling in
    # different directories").
    set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=true
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${KERF_CCACHE_PROGRAM})
  endif()
endif()
