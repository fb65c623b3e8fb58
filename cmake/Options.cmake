# Flags that every target shares, carried by reflectance_options.
option(REFLECTANCE_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)
option(REFLECTANCE_SANITIZE "Build with the address and undefined behaviour sanitizers" OFF)
option(REFLECTANCE_FUZZ "Build the libFuzzer programs of the readers (Clang only)" OFF)
option(REFLECTANCE_COVERAGE "Build for coverage reports" OFF)
option(REFLECTANCE_BENCHMARKS "Build the benchmarks (Google Benchmark)" ON)

add_library(reflectance_options INTERFACE)
include(GNUInstallDirs)
# Other projects get the folder of the headers and the language; warnings and the like are this project's own.
target_include_directories(reflectance_options INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/reflectance>")
target_compile_features(reflectance_options INTERFACE cxx_std_20)
add_library(reflectance_flags INTERFACE)
target_link_libraries(reflectance_options INTERFACE $<BUILD_INTERFACE:reflectance_flags>)
target_compile_options(reflectance_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -Wconversion -Wpedantic>
  # GCC 12 warns of overlapping copies in "text" + std::string() that do not exist (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # IEEE values stay as they are (never -ffast-math); these two only let loops with selects vectorise.
  $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno -fno-trapping-math -ffp-contract=off>)
if(REFLECTANCE_WARNINGS_AS_ERRORS)
  target_compile_options(reflectance_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(REFLECTANCE_SANITIZE)
  # Instrumented code misleads GCC's flow analysis: it warns of uninitialised values in library headers that are not.
  target_compile_options(reflectance_flags INTERFACE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<COMPILE_LANGUAGE:CXX>>:-Wno-maybe-uninitialized>)
  target_compile_options(reflectance_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(reflectance_flags INTERFACE -fsanitize=address,undefined)
endif()
if(REFLECTANCE_FUZZ)
  # Counts which code an input reaches; the programs themselves link the fuzzer, see tests/fuzz.
  target_compile_options(reflectance_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>)
endif()
if(REFLECTANCE_COVERAGE)
  target_compile_options(reflectance_flags INTERFACE --coverage)
  target_link_options(reflectance_flags INTERFACE --coverage)
endif()

# room(NAME SOURCES ... LINKS ...): one room of core is one library; what it may include is what it links.
function(room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(ROOM_SOURCES)
    add_library(reflectance_${name} STATIC ${ROOM_SOURCES})
    target_link_libraries(reflectance_${name} PUBLIC reflectance_options ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
    set_target_properties(reflectance_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  else()
    add_library(reflectance_${name} INTERFACE)
    target_link_libraries(reflectance_${name} INTERFACE reflectance_options ${ROOM_LINKS})
  endif()
  set_target_properties(reflectance_${name} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY REFLECTANCE_ROOMS reflectance_${name})
endfunction()
