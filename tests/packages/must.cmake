# must(WHAT COMMAND...): the command succeeds; its output is in `out`.
function(must what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE exit OUTPUT_VARIABLE printed ERROR_VARIABLE err)
  if(NOT exit STREQUAL "0")
    message(FATAL_ERROR "${what}: exit ${exit}\n${printed}\n${err}")
  endif()
  set(out "${printed}" PARENT_SCOPE)
endfunction()

# says(WHAT REGEX): `out` matches.
function(says what regex)
  if(NOT out MATCHES "${regex}")
    message(FATAL_ERROR "${what} does not match ${regex}:\n${out}")
  endif()
endfunction()
