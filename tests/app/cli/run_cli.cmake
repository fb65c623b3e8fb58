# Runs the program as a user would, from another folder, and checks what came out.
#   cmake -DPROGRAM=... -DFOLDER=... -DEXIT=0 [-DOUT=REGEX] [-DERR=REGEX] [-DINPUT=FILE] [-DMADE=FILE] [-DNOT_MADE=FILE]
#         [-DLINES=1] -P run_cli.cmake -- ARGS...
set(ENV{XDG_CACHE_HOME} "${FOLDER}/../cache") # of the tests, not of who runs them
set(arguments "")
set(seen FALSE)
foreach(index RANGE 1 ${CMAKE_ARGC})
  if(seen AND index LESS CMAKE_ARGC)
    list(APPEND arguments "${CMAKE_ARGV${index}}")
  elseif("${CMAKE_ARGV${index}}" STREQUAL "--")
    set(seen TRUE)
  endif()
endforeach()

file(REMOVE_RECURSE "${FOLDER}") # what an earlier run left must not pass for this one's
file(MAKE_DIRECTORY "${FOLDER}")
set(input "")
if(INPUT)
  set(input INPUT_FILE "${INPUT}")
endif()
execute_process(COMMAND "${PROGRAM}" ${arguments} WORKING_DIRECTORY "${FOLDER}" ${input}
  RESULT_VARIABLE exit OUTPUT_VARIABLE out ERROR_VARIABLE err TIMEOUT 300)

if(NOT "${exit}" STREQUAL "${EXIT}")
  message(FATAL_ERROR "expected exit ${EXIT}\nexit: ${exit}\nstdout:\n${out}\nstderr:\n${err}")
endif()
if(OUT AND NOT out MATCHES "${OUT}")
  message(FATAL_ERROR "stdout does not match ${OUT}\nstdout:\n${out}\nstderr:\n${err}")
endif()
if(ERR AND NOT err MATCHES "${ERR}")
  message(FATAL_ERROR "stderr does not match ${ERR}\nstderr:\n${err}")
endif()
if(EXIT EQUAL 2)
  # Bad input is one sentence: one line that begins with the program's name. Bad rows of a file have one each.
  if(NOT LINES)
    set(LINES 1)
  endif()
  string(REGEX MATCHALL "\n" lines "${err}")
  list(LENGTH lines count)
  if(NOT count EQUAL LINES OR NOT err MATCHES "^reflectance: ")
    message(FATAL_ERROR "expected ${LINES} line(s) 'reflectance: ...' on stderr, found:\n${err}")
  endif()
endif()
if(MADE AND NOT EXISTS "${FOLDER}/${MADE}")
  message(FATAL_ERROR "${MADE} was not written")
endif()
if(NOT_MADE AND EXISTS "${FOLDER}/${NOT_MADE}")
  message(FATAL_ERROR "${NOT_MADE} was written")
endif()
