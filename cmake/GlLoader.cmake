# glad 2 writes the OpenGL loader at build time: nothing generated is kept in the tree. Every context has its own table
# of functions (--mx), so that contexts of different makers live in one process. --reproducible: no download.
find_program(GLAD_PROGRAM glad PATHS /usr/bin NO_DEFAULT_PATH DOC "glad 2, Debian package python3-glad")
if(NOT GLAD_PROGRAM)
  find_program(GLAD_PROGRAM glad REQUIRED)
endif()

set(glad_folder "${PROJECT_BINARY_DIR}/glad")
add_custom_command(OUTPUT "${glad_folder}/include/glad/gl.h"
  COMMAND "${GLAD_PROGRAM}" --api gl:core=3.3 --extensions GL_KHR_debug,GL_ARB_get_program_binary --out-path "${glad_folder}" --reproducible --quiet
          c --mx --header-only > "${PROJECT_BINARY_DIR}/glad.log" 2>&1
  DEPENDS "${CMAKE_CURRENT_LIST_FILE}"
  COMMENT "Making the OpenGL loader")
add_custom_target(glad_header DEPENDS "${glad_folder}/include/glad/gl.h")

add_library(reflectance_glad INTERFACE)
add_dependencies(reflectance_glad glad_header)
target_include_directories(reflectance_glad SYSTEM INTERFACE "${glad_folder}/include")
