# Writes OUT, a C++ file that holds the bytes of FILES and finds them by their names (measure/page.h).
set(arrays "")
set(rows "")
foreach(file IN LISTS FILES)
  cmake_path(GET file FILENAME name)
  string(MAKE_C_IDENTIFIER ${name} symbol)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND arrays "constexpr unsigned char ${symbol}[] = {\n${bytes}0};\n")
  string(APPEND rows "    {\"${name}\", {reinterpret_cast<const char*>(${symbol}), sizeof ${symbol} - 1}},\n")
endforeach()
file(WRITE ${OUT} "// Generated: the parts of the report's page.
#include \"measure/page.h\"
#include <utility>
namespace {
${arrays}
}
std::string_view lightbench::page_part(std::string_view name) {
  const std::pair<std::string_view, std::string_view> parts[] = {
${rows}  };
  for (const auto& [part, text] : parts)
    if (part == name) return text;
  return {};
}
")
