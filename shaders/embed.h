#pragma once

#include <cstdint>

/// NACRE_WORDS(NAME, FILE, COUNT): a file's words as `const std::uint32_t NAME[COUNT]`, read by the assembler. The
/// compiler would take five seconds for them as numbers.
#ifdef __APPLE__
#define NACRE_WORDS_SECTION "__TEXT,__const"
#else
#define NACRE_WORDS_SECTION ".rodata"
#endif
#define NACRE_WORDS(name, file, count)                                                                                 \
    asm(".pushsection " NACRE_WORDS_SECTION "\n.balign 4\nnacre_words_" #name ":\n.incbin \"" file "\"\n.popsection"); \
    extern const std::uint32_t name[count] asm("nacre_words_" #name)
