# Writes SPV.h beside SPV: the words of the module as a constant array named SYMBOL.
file(READ ${SPV} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE ${SPV}.h "constexpr std::uint32_t ${SYMBOL}[] = {\n${words}};\n")
