# Writes the commit of SOURCE to HEADER, if it changed.
cmake_minimum_required(VERSION 3.25)
# Git distrusts trees of other users. Who builds such a tree's code already trusts it.
execute_process(COMMAND git -c safe.directory=* -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
    set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once
#define NACRE_COMMIT \"@commit@\"
#define NACRE_VERSION \"@VERSION@\"
" @ONLY)
