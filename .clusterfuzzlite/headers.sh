#!/bin/sh
# Boost and nlohmann/json, headers only, into /usr/local.
set -eu
fetch() { # URL
  curl -sSfL "$1" | tar xz -C /tmp
}
fetch https://archives.boost.io/release/1.83.0/source/boost_1_83_0.tar.gz
cp -r /tmp/boost_1_83_0/boost /usr/local/include/
fetch https://github.com/nlohmann/json/archive/refs/tags/v3.11.2.tar.gz
cmake -S /tmp/json-3.11.2 -B /tmp/json -DJSON_BuildTests=OFF && cmake --install /tmp/json
rm -rf /tmp/boost_1_83_0 /tmp/json*
