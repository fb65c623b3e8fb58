# core_alone holds every room of core: neither it nor any library that it loads may be a window library.
# The explorer does link GLFW, so the same look at it must find one: else this check is blind.
set(window_libraries "libglfw|libimgui|libX11|libwayland-client|libGLX|libSDL")

function(window_libraries_of program found)
  file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}" RESOLVED_DEPENDENCIES_VAR libraries
    UNRESOLVED_DEPENDENCIES_VAR unresolved)
  list(APPEND libraries ${unresolved})
  list(LENGTH libraries count)
  if(count EQUAL 0)
    message(FATAL_ERROR "${program} seems to load no library at all: the check cannot see.")
  endif()
  list(FILTER libraries INCLUDE REGEX "${window_libraries}")
  set(${found} "${libraries}" PARENT_SCOPE)
endfunction()

window_libraries_of("${PROGRAM}" of_program)
if(NOT of_program)
  message(FATAL_ERROR "No window library found in the explorer, which has one: the check is blind.")
endif()

window_libraries_of("${CORE_ALONE}" of_core)
if(of_core)
  message(FATAL_ERROR "core must know no window, but it loads: ${of_core}")
endif()
