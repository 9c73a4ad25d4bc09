# Linux of another processor by Debian's cross compilers. A file beside this one sets plumb_triplet and plumb_qemu and includes it.
#   -DPLUMB_SYSROOT=DIR   the libraries of that processor, as cmake/toolchains/sysroot makes them
# Tests and the steps of the build that call the program run it by qemu-user-static (docs/platforms.md).
set(CMAKE_SYSTEM_NAME Linux)
string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR ${plumb_triplet})

# The compiler is also tried in projects of CMake's own, which read this file again and know no cache.
set(PLUMB_SYSROOT "$ENV{PLUMB_SYSROOT}" CACHE PATH "Libraries of the other processor")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PLUMB_SYSROOT)
if(NOT EXISTS ${PLUMB_SYSROOT}/usr/include)
  message(FATAL_ERROR "PLUMB_SYSROOT: no libraries there; cmake/toolchains/sysroot makes them")
endif()

set(CMAKE_C_COMPILER ${plumb_triplet}-gcc)
set(CMAKE_CXX_COMPILER ${plumb_triplet}-g++)
set(CMAKE_LIBRARY_ARCHITECTURE ${plumb_triplet})
set(CMAKE_SYSROOT ${PLUMB_SYSROOT})
set(CMAKE_FIND_ROOT_PATH ${PLUMB_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR ${plumb_qemu};-L;${PLUMB_SYSROOT})
