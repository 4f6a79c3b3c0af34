# Cross-builds for arm64 Linux with Debian's g++-aarch64-linux-gnu: tools/check_arm64 uses it.
# NACRE_ARM64_ROOT is a folder of unpacked arm64 packages; what is built runs by qemu-aarch64-static.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES NACRE_ARM64_ROOT)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # notes on what GCC 10 changed
set(CMAKE_SYSROOT ${NACRE_ARM64_ROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH ${NACRE_ARM64_ROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Libraries that libraries need, and those that Debian's alternatives would link to.
set(arm64_libraries ${NACRE_ARM64_ROOT}/usr/lib/aarch64-linux-gnu)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-rpath-link,${arm64_libraries} -Wl,-rpath-link,${arm64_libraries}/blas \
-Wl,-rpath-link,${arm64_libraries}/lapack -Wl,--allow-shlib-undefined")
# The Python module: this machine's interpreter is asked, for headers and the name of the other one's modules.
set(Python_INCLUDE_DIR ${NACRE_ARM64_ROOT}/usr/include/python3.11)
set(PYTHON_MODULE_EXTENSION .cpython-311-aarch64-linux-gnu.so CACHE INTERNAL "")
set(PYBIND11_PYTHON_EXECUTABLE_LAST /usr/bin/python3 CACHE INTERNAL "")
# Runs what the build itself needs; its libraries' folders are named as below the root.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${NACRE_ARM64_ROOT}
    -E LD_LIBRARY_PATH=/usr/lib/aarch64-linux-gnu/blas:/usr/lib/aarch64-linux-gnu/lapack)
