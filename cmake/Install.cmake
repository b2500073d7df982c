include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS counterpart EXPORT counterpartTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/counterpart ${CMAKE_CURRENT_BINARY_DIR}/include/counterpart DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT counterpartTargets NAMESPACE counterpart:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/counterpart)

configure_package_config_file(cmake/counterpartConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/counterpart)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/counterpartConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/counterpartConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/counterpart)
