# The target `api`: pages about the public headers, made by Doxygen where it is installed. A warning fails it.
find_program(DOXYGEN_PROGRAM doxygen DOC "Doxygen, for the target api")
if(DOXYGEN_PROGRAM)
  configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
  add_custom_target(api COMMAND "${DOXYGEN_PROGRAM}" "${PROJECT_BINARY_DIR}/Doxyfile" COMMENT "Writing pages of the public headers")
endif()
