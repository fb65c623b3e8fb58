# mpirun, on one machine: the figures of 1, 2 and 4 ranks are those of none, byte for byte; a cell that crashes costs itself; a rank
# that is killed costs nothing under --enable-recovery, and without it the next run goes on.
#   cmake -DPROGRAM=... -DMPIRUN=... -DDATA=... -DFOLDER=... -P mpi_sweep.cmake
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
# Tests may run as root and with more ranks than cores.
set(mpirun "${MPIRUN}" --oversubscribe --allow-run-as-root)
set(sweep sweep "${DATA}/mpi_study.json" --workers 1 --out)

function(run expected)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE exit OUTPUT_VARIABLE out ERROR_VARIABLE err
    TIMEOUT 120)
  if(NOT exit MATCHES "${expected}")
    message(FATAL_ERROR "${ARGN}\nexit ${exit}, not ${expected}\n${out}\n${err}")
  endif()
  set(err "${err}" PARENT_SCOPE)
endfunction()

function(same file)
  if(NOT EXISTS "${FOLDER}/${file}")
    message(FATAL_ERROR "${file} was not written: ${err}")
  endif()
  file(READ "${FOLDER}/${file}" found)
  file(READ "${FOLDER}/alone.csv" wanted)
  if(NOT found STREQUAL wanted)
    message(FATAL_ERROR "${file} differs from the figures of one process:\n${found}\n${wanted}")
  endif()
endfunction()

run(0 "${PROGRAM}" ${sweep} alone.csv)
foreach(ranks 1 2 4)
  run(0 ${mpirun} -n ${ranks} "${PROGRAM}" ${sweep} ranks_${ranks}.csv --pictures cells_${ranks})
  same(ranks_${ranks}.csv)
  if(NOT err MATCHES "24 cells, 0 of them from before\n$" OR NOT EXISTS "${FOLDER}/cells_${ranks}/cell_23.png")
    message(FATAL_ERROR "${ranks} ranks: ${err}")
  endif()
endforeach()

# Becomes the second rank, which is killed once lines are written.
file(WRITE "${FOLDER}/doomed.sh" "
(
    until [ \"$(cat \"$1\" 2>/dev/null | wc -l)\" -gt 4 ]; do sleep 0.01; done
    kill -KILL $$ && echo killed > \"$1.killed\"
) &
exec '${PROGRAM}' sweep '${DATA}/mpi_study.json' --workers 1 --out \"$1\"
")
run(0 ${mpirun} --enable-recovery -n 1 "${PROGRAM}" ${sweep} wounded.csv : -n 1 bash doomed.sh wounded.csv)
same(wounded.csv)
if(NOT EXISTS "${FOLDER}/wounded.csv.killed") # the planted fault
  message(FATAL_ERROR "no rank was killed, so this proves nothing")
endif()

run("[1-9]" ${mpirun} -n 1 "${PROGRAM}" ${sweep} broken.csv : -n 1 bash doomed.sh broken.csv)
run(0 "${PROGRAM}" ${sweep} broken.csv)
same(broken.csv)
if(err MATCHES " 0 of them from before")
  message(FATAL_ERROR "the first run left nothing: ${err}")
endif()
