#!/bin/sh
# Compiles the C consumer with nothing but what pkg-config says: run.sh PREFIX_LIBDIR SOURCE OUT CC
set -eu
export PKG_CONFIG_PATH="$1/pkgconfig"
# shellcheck disable=SC2046
"$4" -std=c99 -pedantic -Wall -Werror $(pkg-config --cflags plumb-c) "$2" -o "$3" $(pkg-config --libs plumb-c)
LD_LIBRARY_PATH="$1" "$3"
