# Writes OUT, a C++ file that holds the text of FILES by their paths below ROOT (render/shaders.h).
set(rows "")
foreach(file IN LISTS FILES)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${ROOT} OUTPUT_VARIABLE name)
  file(READ ${file} text)
  string(APPEND rows "    {\"${name}\", R\"lightbench(${text})lightbench\"},\n")
endforeach()
file(WRITE ${OUT} "// Generated: the sources of the program's shaders.
#include \"render/shaders.h\"
std::span<const lightbench::ShaderSource> lightbench::built_in_sources() {
  static constexpr ShaderSource rows[] = {
${rows}  };
  return rows;
}
")
