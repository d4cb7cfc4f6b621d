# What was compiled before, here or in another folder, is not compiled again if ccache is installed.
option(KERF_CCACHE "Compile through ccache if it is installed" ${PROJECT_IS_TOP_LEVEL})

if(KERF_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(KERF_CCACHE_PROGRAM ccache)
  mark_as_advanced(KERF_CCACHE_PROGRAM)
  if(KERF_CCACHE_PROGRAM)
    # Its manual, "Precompiled headers": files that read one are only kept with these.
    set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${KERF_CCACHE_PROGRAM})
  endif()
endif()
