# Windows by mingw-w64: packages g++-mingw-w64-x86-64-posix and, to run programs, wine64.
#   -DPLUMB_SYSROOT=DIR   GMP, MPFR and the others, as cmake/toolchains/windows-libraries makes them
# Everything is linked statically: a program is one file (docs/platforms.md).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)

set(PLUMB_SYSROOT "$ENV{PLUMB_SYSROOT}" CACHE PATH "Libraries for Windows")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PLUMB_SYSROOT)
if(NOT EXISTS ${PLUMB_SYSROOT}/include/gmp.h)
  message(FATAL_ERROR "PLUMB_SYSROOT: no libraries there; cmake/toolchains/windows-libraries makes them")
endif()

# With threads of POSIX: the others of Debian's compilers have no std::thread.
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# A folder that is compiled as one unit has more sections than the usual format of objects can count.
set(CMAKE_CXX_FLAGS_INIT -Wa,-mbig-obj)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
set(CMAKE_FIND_ROOT_PATH ${PLUMB_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
find_program(PLUMB_WINE NAMES wine64 wine64-stable wine PATHS /usr/lib/wine NO_CMAKE_FIND_ROOT_PATH)
if(PLUMB_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${PLUMB_WINE})
endif()
