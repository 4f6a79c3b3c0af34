# Read by CPack for each kind of package: Debian's go to /usr, the archive to wherever it is unpacked.
if(CPACK_GENERATOR STREQUAL "DEB")
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
else()
    set(CPACK_PACKAGING_INSTALL_PREFIX "")
endif()
