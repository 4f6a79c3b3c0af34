# vcpkg has no port of gemmi. Commit and hash are those that github.com/dtriand/vcpkg-registry states for 0.7.0; vcpkg refuses
# an archive with another hash.
vcpkg_from_github(
    OUT_SOURCE_PATH source
    REPO project-gemmi/gemmi
    REF 32ed5769405f4f76ea1404d12bf9e8ba63113b8f
    SHA512 578c8c08eaa8a27922b526c42b92797b5f12ab5e2e368a7f9e9f5e73840d3a428d445e382a925311114404c0f751087204dededed2eaef224e847b50ee23adc5
)
# The library alone: neither program nor Python module.
vcpkg_cmake_configure(SOURCE_PATH ${source} OPTIONS -DBUILD_GEMMI_PROGRAM=OFF -DUSE_PYTHON=OFF -DBUILD_SHARED_LIBS=OFF)
vcpkg_cmake_install()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share
     ${CURRENT_PACKAGES_DIR}/lib/cmake ${CURRENT_PACKAGES_DIR}/debug/lib/cmake)
vcpkg_install_copyright(FILE_LIST ${source}/LICENSE.txt)
