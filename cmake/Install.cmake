include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/counterpart)

# One file of targets per component, so that a component asks for nothing that only others need.
foreach(component core io render)
  install(TARGETS counterpart_${component} EXPORT counterpart-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT counterpart-${component} NAMESPACE counterpart:: DESTINATION ${package_folder})
endforeach()
install(DIRECTORY include/counterpart ${CMAKE_CURRENT_BINARY_DIR}/include/counterpart DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

configure_package_config_file(cmake/counterpartConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/counterpartConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfigVersion.cmake
        DESTINATION ${package_folder})

# The man page and completions come from the program itself, so they say what --help says.
if(COUNTERPART_CLI AND NOT CMAKE_CROSSCOMPILING)
  set(manual ${CMAKE_CURRENT_BINARY_DIR}/manual)
  file(MAKE_DIRECTORY ${manual})
  add_custom_command(OUTPUT ${manual}/counterpart.1 ${manual}/counterpart.bash ${manual}/_counterpart ${manual}/counterpart.fish
    COMMAND counterpart_cli manual man > ${manual}/counterpart.1
    COMMAND counterpart_cli manual bash > ${manual}/counterpart.bash
    COMMAND counterpart_cli manual zsh > ${manual}/_counterpart
    COMMAND counterpart_cli manual fish > ${manual}/counterpart.fish
    DEPENDS counterpart_cli VERBATIM)
  add_custom_target(counterpart_manual ALL DEPENDS ${manual}/counterpart.1)
  install(FILES ${manual}/counterpart.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${manual}/counterpart.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME counterpart)
  foreach(folder site-functions vendor-completions)  # Debian's zsh looks into the second where the prefix is /usr
    install(FILES ${manual}/_counterpart DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
  endforeach()
  install(FILES ${manual}/counterpart.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()

# `cpack` in the build folder: a .deb that depends on the libraries it was linked with, and a .tar.gz.
if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_PACKAGE_NAME counterpart)
  set(CPACK_PACKAGE_CONTACT "The counterpart authors")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Dense correspondence of triangle meshes")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_GENERATOR DEB TGZ)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  include(CPack)
endif()
