# Headers as string literals: cmake -DOUTPUT=FILE -DROOT=INCLUDE_FOLDER -DNAMES=isocast/a.h,isocast/b.h -P embed_headers.cmake
# writes the table that cuda/formula_program.cpp includes.
string(REPLACE "," ";" NAMES "${NAMES}")
set(text "// made by cmake/embed_headers.cmake\n")
foreach(name IN LISTS NAMES)
  file(READ ${ROOT}/${name} content)
  string(APPEND text "{\"${name}\", R\"ISO_HEADER(${content})ISO_HEADER\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
