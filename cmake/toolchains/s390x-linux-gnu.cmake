# Linux on s390x, which is big-endian: packages g++-s390x-linux-gnu and qemu-user-static.
set(plumb_triplet s390x-linux-gnu)
set(plumb_qemu qemu-s390x-static)
include(${CMAKE_CURRENT_LIST_DIR}/debian-cross.cmake)
