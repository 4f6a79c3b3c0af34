# Run by CPack on the files that it packs.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/nacre.1)
foreach(page ${pages})
    execute_process(COMMAND gzip -9n ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
