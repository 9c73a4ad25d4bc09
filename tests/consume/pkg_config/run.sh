#!/bin/sh
# Compiles the consumer with nothing but what pkg-config says: run.sh PREFIX_LIBDIR SOURCE OUT CXX
set -eu
export PKG_CONFIG_PATH="$1/pkgconfig"
# shellcheck disable=SC2046
"$4" -std=c++20 $(pkg-config --cflags plumb) "$2" -o "$3" $(pkg-config --libs plumb)
LD_LIBRARY_PATH="$1" "$3"
