# Ctrl-C during a run: exit 130, one sentence, no table, and a file from which the run goes on.
file(REMOVE "${FOLDER}/stopped.csv" "${FOLDER}/stopped.csv.lab" "${FOLDER}/resumed.csv")
execute_process(
  COMMAND timeout --signal=INT 2 "${PROGRAM}" goniometer vgrooves:slope=30 --bounces 3 --grid isotropic:5x5 --samples 16777216
    --out stopped.csv
  WORKING_DIRECTORY "${FOLDER}" ERROR_VARIABLE err OUTPUT_QUIET TIMEOUT 120)
if(EXISTS "${FOLDER}/stopped.csv" OR NOT err MATCHES
   "^reflectance: stopped after [0-9]+ paths; go on with 'reflectance goniometer --resume stopped.csv.lab --out stopped.csv'\n$")
  message(FATAL_ERROR "stderr:\n${err}")
endif()
execute_process(COMMAND "${PROGRAM}" goniometer --resume stopped.csv.lab --seconds 0.2 --out resumed.csv
  WORKING_DIRECTORY "${FOLDER}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS "${FOLDER}/resumed.csv")
  message(FATAL_ERROR "nothing was written")
endif()
