# A saved picture is made again from what it carries, equal in every byte; another scene makes another file.
#   cmake -DPROGRAM=... -DFOLDER=... -DSCENE=two_surfaces.json -P kept_picture.cmake
set(ENV{XDG_CACHE_HOME} "${FOLDER}/../cache")
file(MAKE_DIRECTORY "${FOLDER}")
function(render)
  execute_process(COMMAND "${PROGRAM}" render ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE exit ERROR_VARIABLE err
    TIMEOUT 300)
  if(NOT exit EQUAL 0)
    message(FATAL_ERROR "render ${ARGN} ended with ${exit}:\n${err}")
  endif()
endfunction()
function(same a b expected)
  file(SHA256 "${FOLDER}/${a}" hash_a)
  file(SHA256 "${FOLDER}/${b}" hash_b)
  if((hash_a STREQUAL hash_b) AND NOT expected)
    message(FATAL_ERROR "${a} and ${b} are equal, and should not be")
  elseif(NOT (hash_a STREQUAL hash_b) AND expected)
    message(FATAL_ERROR "${a} and ${b} differ")
  endif()
endfunction()

render(sphere --size 50x40 --samples 9 --set n=90 --light point:1,2,2:3 --out gl.png)
render(gl.png --out gl_again.png)
same(gl.png gl_again.png TRUE)
render(gl.png --set n=91 --out gl_other.png) # planted
same(gl.png gl_other.png FALSE)

render(mug --size 40x40 --precision float --camera orbit=20,30 --out cpu.exr)
render(cpu.exr --out cpu_again.exr)
same(cpu.exr cpu_again.exr TRUE)

foreach(variant B side wipe difference)
  render(${SCENE} --size 41x30 --variant ${variant} --divider 0.3 --out ${variant}.png)
  render(${variant}.png --out ${variant}_again.png)
  same(${variant}.png ${variant}_again.png TRUE)
endforeach()
same(B.png side.png FALSE)

render(sphere --size 40x40 --term specular --out term.png)
render(term.png --out term_again.png)
same(term.png term_again.png TRUE)
render(term.png --term all --out whole.png)
same(term.png whole.png FALSE)

render(sphere --size 40x40 --lens float --out lens.png)
render(lens.png --out lens_again.png)
same(lens.png lens_again.png TRUE)
