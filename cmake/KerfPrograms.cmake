# What is installed of the programs: kerf; kerf-viewer, with what a desktop shows of it; the models and fruit, which the
# viewer finds from itself on.

include(GNUInstallDirs)

if(TARGET kerf)
  install(TARGETS kerf RUNTIME COMPONENT kerf)
  # Of what the program says of itself, so that they can't differ.
  set(completion ${PROJECT_BINARY_DIR}/completion/kerf)
  add_custom_command(OUTPUT ${completion} COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/completion
    COMMAND kerf completion bash > ${completion} DEPENDS kerf VERBATIM)
  add_custom_target(kerf_completion ALL DEPENDS ${completion})
  install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT kerf)
endif()
if(TARGET kerf-viewer)
  install(TARGETS kerf-viewer RUNTIME COMPONENT viewer)
  install(FILES packaging/kerf-viewer.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT viewer)
  install(FILES packaging/kerf-viewer.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
    COMPONENT viewer)
endif()
if(TARGET kerf OR TARGET kerf-viewer)
  install(DIRECTORY data/models data/fruit DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf COMPONENT data)
endif()
