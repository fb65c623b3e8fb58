# A run with facets of an own model goes on with the same text, and with no other.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
configure_file("${DATA}/own_flat.glsl" "${FOLDER}/facet.glsl" COPYONLY)

function(run expected)
  execute_process(COMMAND "${PROGRAM}" goniometer ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE exit OUTPUT_QUIET
    ERROR_VARIABLE err TIMEOUT 60)
  if(NOT exit EQUAL expected)
    message(FATAL_ERROR "${ARGN}\nexit ${exit}, not ${expected}\n${err}")
  endif()
  set(err "${err}" PARENT_SCOPE)
endfunction()

run(0 vgrooves:slope=30 --model-file facet.glsl --grid isotropic:3x3 --samples 1024 --out a.csv)
run(0 --resume a.csv.lab --model-file facet.glsl --samples 2048 --out b.csv)
run(0 vgrooves:slope=30 --model-file facet.glsl --grid isotropic:3x3 --samples 2048 --out c.csv)
file(READ "${FOLDER}/b.csv" resumed)
file(READ "${FOLDER}/c.csv" whole)
if(NOT resumed STREQUAL whole)
  message(FATAL_ERROR "a resumed run differs from a whole one:\n${resumed}\n${whole}")
endif()

run(2 --resume a.csv.lab --samples 4096 --out d.csv)
if(NOT err MATCHES "a.csv.lab: .*name it with --model-file\n$")
  message(FATAL_ERROR "${err}")
endif()
file(READ "${FOLDER}/facet.glsl" text) # the planted fault
string(REPLACE "return kd" "return 0.5 * kd" text "${text}")
file(WRITE "${FOLDER}/facet.glsl" "${text}")
run(2 --resume a.csv.lab --model-file facet.glsl --samples 4096 --out d.csv)
if(NOT err MATCHES "a.csv.lab: was measured on another vgrooves:slope=30 or with another text of facet")
  message(FATAL_ERROR "${err}")
endif()
