# Writes a header that holds a SPIR-V binary's words: sh embed.sh FILE.spv NAME >NAME.h
set -e
bytes=$(wc -c <"$1")
printf '#pragma once\n#include "shaders/embed.h"\nNACRE_WORDS(%s, "%s", %d);\n' "$2" "$1" $((bytes / 4))
