# embed_files(TARGET FUNCTION NAME=PATH...): carries files inside TARGET, read through
# std::span<const reflectance::EmbeddedFile> reflectance::FUNCTION(). The assembler includes the bytes as they are.
function(embed_files target function)
  set(assembly "    .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(paths "")
  set(index 0)
  foreach(pair IN LISTS ARGN)
    string(REGEX MATCH "^([^=]+)=(.+)$" ok "${pair}")
    set(name "${CMAKE_MATCH_1}")
    set(path "${CMAKE_MATCH_2}")
    set(symbol "${function}_${index}")
    string(APPEND assembly
      "    .global ${symbol}_begin\n    .global ${symbol}_end\n    .balign 16\n"
      "${symbol}_begin:\n    .incbin \"${path}\"\n${symbol}_end:\n    .byte 0\n")
    string(APPEND declarations "extern const char ${symbol}_begin[], ${symbol}_end[];\n")
    string(APPEND entries "    {\"${name}\", {${symbol}_begin, static_cast<std::size_t>(${symbol}_end - ${symbol}_begin)}},\n")
    list(APPEND paths "${path}")
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND assembly "    .section .note.GNU-stack,\"\",@progbits\n")
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${function}.gen.S" CONTENT "${assembly}" @ONLY)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${function}.gen.cpp" @ONLY CONTENT
"// Made by cmake/Embed.cmake; do not edit.
#include \"core/base/embedded.h\"

extern \"C\" {
${declarations}}

namespace reflectance {

std::span<const EmbeddedFile> ${function}();

std::span<const EmbeddedFile> ${function}()
{
    static const EmbeddedFile files[] = {
${entries}    };
    return files;
}

} // namespace reflectance
")
  set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${function}.gen.S" PROPERTIES OBJECT_DEPENDS "${paths}")
  target_sources(${target} PRIVATE
    "${CMAKE_CURRENT_BINARY_DIR}/${function}.gen.S" "${CMAKE_CURRENT_BINARY_DIR}/${function}.gen.cpp")
endfunction()
