# Turns a SPIR-V binary into a header: sh embed.sh FILE.spv NAME
printf '#pragma once\ninline const std::uint32_t %s[] = {\n' "$2"
od -An -v -tx4 "$1" | sed 's/  */,0x/g; s/^,//; s/$/,/'
printf '};\n'
