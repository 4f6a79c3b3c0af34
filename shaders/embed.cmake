# Turns a SPIR-V binary into a header: cmake -DINPUT=FILE.spv -DOUTPUT=FILE.h -DNAME=NAME -P embed.cmake
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE ${OUTPUT} "#pragma once\ninline const std::uint32_t ${NAME}[] = {\n${words}};\n")
