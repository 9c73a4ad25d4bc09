# Linux on arm64 (AArch64): packages g++-aarch64-linux-gnu and qemu-user-static.
set(plumb_triplet aarch64-linux-gnu)
set(plumb_qemu qemu-aarch64-static)
include(${CMAKE_CURRENT_LIST_DIR}/debian-cross.cmake)
