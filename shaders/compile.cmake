# lightbench_embed_shaders(TARGET ROOT FILES...): compiles GLSL entry points for Vulkan 1.3, validates the SPIR-V (scalar block layout) and
# embeds it. TARGET is a library that offers, through gpu/shader.h's ShaderCode, `find_shader("raster/surface.frag")`-like tables:
# a generated function `TARGET_table()` returns all of them by their path below ROOT.
function(lightbench_embed_shaders target root)
  set(out ${CMAKE_BINARY_DIR}/${target})
  set(includes "")
  set(rows "")
  set(spirv "")
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${root} OUTPUT_VARIABLE name)
    string(MAKE_C_IDENTIFIER ${name} symbol)
    set(spv ${out}/${name}.spv)
    cmake_path(GET spv PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(
      OUTPUT ${spv} ${spv}.h
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.3 -I${CMAKE_SOURCE_DIR}/shaders --depfile ${spv}.d -o ${spv} ${source}
      COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spv}
      COMMAND ${CMAKE_COMMAND} -D SPV=${spv} -D SYMBOL=${symbol} -P ${CMAKE_SOURCE_DIR}/shaders/embed.cmake
      DEPENDS ${source} ${CMAKE_SOURCE_DIR}/shaders/embed.cmake
      DEPFILE ${spv}.d
      COMMENT "shader ${name}"
      VERBATIM)
    list(APPEND spirv ${spv}.h)
    string(APPEND includes "#include \"${spv}.h\"\n")
    string(APPEND rows "    {\"${name}\", ${symbol}},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${out}/table.cpp CONTENT
"// Generated: the SPIR-V of every entry point below ${root}/.
#include \"gpu/shader_code.h\"
#include <cstdint>
namespace {
${includes}
}
std::span<const lightbench::gpu::ShaderCode> ${target}_table() {
  static const lightbench::gpu::ShaderCode rows[] = {
${rows}  };
  return rows;
}
" @ONLY)
  set_source_files_properties(${out}/table.cpp PROPERTIES OBJECT_DEPENDS "${spirv}")
  add_library(${target} STATIC ${out}/table.cpp ${spirv})
  target_link_libraries(${target} PRIVATE lightbench_options)
endfunction()
