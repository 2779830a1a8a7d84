# cmake -DOUT=FILE.cpp "-DFILES=a;b" -P embed.cmake: the files' text as string literals, by their names.
set(text "#include \"sim/html/assets.h\"\n\nnamespace artu::sim {\n\nstd::string_view html_asset(std::string_view name) {\n")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} content)
  string(APPEND text "  if (name == \"${name}\") return R\"asset(${content})asset\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace artu::sim\n")
file(WRITE ${OUT} "${text}")
