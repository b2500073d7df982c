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
