#!/usr/bin/env bash
# .ci/layers finds every kind of include that it is there to find, and no other.
set -u
layers=$1/.ci/layers
failures=0

check() { # ok|bad PATH INCLUDE
  local tree
  tree=$(mktemp -d "$all/XXXXXX")
  mkdir -p "$tree/$(dirname "$2")"
  echo "#include $3" >"$tree/$2"
  if "$layers" "$tree" >"$tree/out"; then result=ok; else result=bad; fi
  [ $result = "$1" ] && return
  echo "FAILED: $2 including $3 is $result, should be $1" >&2
  failures=$((failures + 1))
}

all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
check ok engine/plane/a.h '"plumb/dcel/dcel.h"'
check ok engine/plane/a.h '"plumb/plane/b.h"'
check ok engine/io/a.cpp '"plumb/predicates/sign.h"'
check ok engine/io/a.cpp '<nlohmann/json.hpp>'
check ok engine/io/a.h '<vector>'
check ok predicates/a.h '<boost/multiprecision/gmp.hpp>'
check ok tests/plane/a_test.cpp '"plumb/plane/map.h"'
check ok tests/plane/a_test.cpp '"generate/test_map.h"'
check ok tests/plane/a_test.cpp '"plumb/testing/map_defects.h"'
check ok engine/cli/a.cpp '"session.h"'
check bad engine/cli/a.cpp '"engine/io/input.h"'
check bad engine/dcel/a.h '"plumb/plane/map.h"'
check bad engine/base/a.cpp '"plumb/dcel/dcel.h"'
check bad engine/io/a.cpp '"plumb/picture/svg.h"'
check bad predicates/a.h '"plumb/base/ids.h"'
check bad predicates/a.cpp '"plumb/dcel/dcel.h"'
check bad engine/plane/a.h '"plumb/nowhere/a.h"'
check bad engine/plane/a.h '"plumb/testing/test_map.h"'
check bad engine/plane/a.cpp '"map.h"'
check bad engine/io/a.h '<nlohmann/json.hpp>'
check bad tests/plane/a_test.cpp '"engine/plane/map.h"'
check bad tests/plane/a_test.cpp '"plumb/cli/options.h"'
[ $failures = 0 ] && echo "layers: all cases passed"
exit $((failures > 0))
