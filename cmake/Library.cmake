# reflectance::core for other CMake projects: find_package(Reflectance), target_link_libraries(... reflectance::core).
include(CMakePackageConfigHelpers)

set(library_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Reflectance")
get_property(rooms GLOBAL PROPERTY REFLECTANCE_ROOMS)
install(TARGETS reflectance_core reflectance_options ${rooms} EXPORT ReflectanceTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/reflectance" COMPONENT development)
install(EXPORT ReflectanceTargets NAMESPACE reflectance:: DESTINATION "${library_folder}" COMPONENT development)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/core" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/reflectance" COMPONENT development
  FILES_MATCHING PATTERN "*.h")
configure_package_config_file("${CMAKE_CURRENT_SOURCE_DIR}/ReflectanceConfig.cmake.in" "${made}/ReflectanceConfig.cmake"
  INSTALL_DESTINATION "${library_folder}")
write_basic_package_version_file("${made}/ReflectanceConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${made}/ReflectanceConfig.cmake" "${made}/ReflectanceConfigVersion.cmake" DESTINATION "${library_folder}"
  COMPONENT development)
