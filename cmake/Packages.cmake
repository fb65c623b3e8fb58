# cpack: Debian packages (one per component) and a relocatable archive of the program.
set(CPACK_PACKAGE_NAME reflectance)
set(CPACK_PACKAGE_VENDOR "the authors of the Reflectance Explorer")
set(CPACK_PACKAGE_CONTACT "${REFLECTANCE_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "understand, compare and trust reflectance models")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_THREADS 0)

# The archive unpacks anywhere; in a Debian package the same files lie below /usr.
set(CPACK_COMPONENTS_ALL program development)
if(TARGET reflectance_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/cmake/PackagesByKind.cmake")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME reflectance)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
# Opened while running: OpenGL without a window.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libosmesa6 | libegl1, libgl1-mesa-dri")
# Opened while running as well, where mpirun starts the program.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "openmpi-bin, libopenmpi3")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "The explorer drags a light over a surface and shows what a formula does.\nIt follows the picture through illumination, surface and sensor, with every\nparameter, unit and source at hand, and measures what each model costs and\nhow far each arithmetic is from the truth.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libreflectance-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libglm-dev, libopenmesh-dev, nlohmann-json3-dev, libpng-dev, libopenexr-dev, libembree-dev, libtbb-dev, libceres-dev, libxsimd-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Headers and static libraries of reflectance::core for other CMake projects:\nfind_package(Reflectance).")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-reflectance)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "Reflectance models, measured tables and pictures of the Reflectance Explorer\nfor numpy: import reflectance.")
include(CPack)
