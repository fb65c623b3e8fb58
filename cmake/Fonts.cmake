# The typefaces that travel inside the program: Inter, from Debian's fonts-inter. It has Greek, subscripts, superscripts,
# arrows and the signs of formulas, and its italic sets the symbols.
function(find_font variable file)
  find_file(${variable} ${file}
    PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES opentype/inter truetype/inter inter
    DOC "Typeface ${file}")
  if(NOT ${variable})
    message(FATAL_ERROR "The typeface ${file} was not found; install it with: sudo apt-get install fonts-inter")
  endif()
endfunction()

find_font(REFLECTANCE_FONT_REGULAR Inter-Regular.otf)
find_font(REFLECTANCE_FONT_STRONG Inter-SemiBold.otf)
find_font(REFLECTANCE_FONT_ITALIC Inter-Italic.otf)
