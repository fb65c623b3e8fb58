# Ctrl-C during a long render: exit 130, one sentence, no half-written file.
execute_process(
  COMMAND timeout --signal=INT 2 "${PROGRAM}" render --size 8192x8192 --samples 64 --backend cpu --out interrupted.exr
  WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE exit ERROR_VARIABLE err TIMEOUT 120)
file(GLOB left "${FOLDER}/*interrupted*")
if(NOT err MATCHES "^reflectance: stopped; nothing was written\n$" OR left)
  message(FATAL_ERROR "exit: ${exit}\nleft: ${left}\nstderr:\n${err}")
endif()
