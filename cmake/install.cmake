include(CMakePackageConfigHelpers)

install(TARGETS shprt EXPORT shprtTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS shprt_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY lib/shprt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/lib/shprt/base/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shprt/base)
install(EXPORT shprtTargets NAMESPACE shprt:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shprt)
configure_package_config_file(cmake/shprtConfig.cmake.in ${PROJECT_BINARY_DIR}/shprtConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shprt)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shprtConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shprtConfig.cmake ${PROJECT_BINARY_DIR}/shprtConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shprt)
