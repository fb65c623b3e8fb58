# Another project finds the installed core, links it, and its program computes what the formula says.
include("${CMAKE_CURRENT_LIST_DIR}/must.cmake")
file(REMOVE_RECURSE "${SCRATCH}")

must("cmake --install" "${CMAKE_COMMAND}" --install "${BUILD}" --component development --prefix "${SCRATCH}/installed")
must("configuring the example" "${CMAKE_COMMAND}" -S "${EXAMPLES}" -B "${SCRATCH}/build" -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_PREFIX_PATH=${SCRATCH}/installed" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
must("building the example" "${CMAKE_COMMAND}" --build "${SCRATCH}/build")
must("the example" "${SCRATCH}/build/lobe")
# In the mirror direction: K (N.L) of the default K, and ks (R.V)^n = 0.5; 10 degrees off, 0.5 cos(10)^40 = 0.2711.
if(NOT out MATCHES "^0 degrees: ([0-9.]+)\n10 degrees: ([0-9.]+)\n")
  message(FATAL_ERROR "the example prints ${out}")
endif()
set(beside "${CMAKE_MATCH_2}") # the next match forgets it
string(REGEX REPLACE "^0\\." "" mirror "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^0\\." "" beside "${beside}")
math(EXPR fall "${mirror} - ${beside}")
if(NOT fall MATCHES "^22896[0-9]$")
  message(FATAL_ERROR "from the mirror direction to 10 degrees beside it the highlight falls by 0.${fall}, not by 0.22896:\n${out}")
endif()

# No file of the installed library leads back to where it was built.
file(GLOB_RECURSE configs "${SCRATCH}/installed/*.cmake")
foreach(config IN LISTS configs)
  file(READ "${config}" text)
  if(text MATCHES "${BUILD}")
    message(FATAL_ERROR "${config} names the build folder")
  endif()
endforeach()
