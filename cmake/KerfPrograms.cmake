# What is installed of the programs: kerf; kerf-viewer, with what a desktop shows of it; the models and fruit, which the
# viewer finds from itself on.

include(GNUInstallDirs)

if(TARGET kerf)
  install(TARGETS kerf RUNTIME COMPONENT kerf)
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
