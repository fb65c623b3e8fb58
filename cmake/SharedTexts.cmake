# shared_texts(ROOM NAME=PATH[+PATH...]...): the texts under shaders/ as class templates reflectance::texts::NAME<T>,
# for the room's own files in "ROOM_texts.gen.h".
function(shared_texts room)
  set(shaders "${PROJECT_SOURCE_DIR}/shaders")
  set(header "${CMAKE_CURRENT_BINARY_DIR}/${room}_texts.gen.h")
  list(TRANSFORM ARGN REPLACE "^[^=]+=" "" OUTPUT_VARIABLE texts)
  string(REPLACE "+" ";" texts "${texts}")
  list(TRANSFORM texts PREPEND "${shaders}/")
  add_custom_command(OUTPUT "${header}"
    COMMAND make_texts "${shaders}" "${header}" ${ARGN}
    DEPENDS make_texts ${texts}
    COMMENT "Making C++ of the texts of ${room}")
  target_sources(reflectance_${room} PRIVATE "${header}")
  target_include_directories(reflectance_${room} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()
