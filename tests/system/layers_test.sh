#!/usr/bin/env bash
# .ci/layers finds every kind of include that it is there to find, and no other.
set -u
layers=$1/.ci/layers
failures=0

check() { # ok|bad PATH INCLUDE
  local tree
  tree=$(mktemp -d "$all/XXXXXX")
  mkdir -p "$tree/.ci" "$tree/$(dirname "$2")"
  cat >"$tree/.ci/layers.txt" <<'EOF'
predicates:
base:
dcel:
plane: sweep set
io: text plane
picture:
cli:
plane/nef2.h: set
plane/map.h: sweep
EOF
  echo "#include $3" >"$tree/$2"
  if "$layers" "$tree" >"$tree/out"; then result=ok; else result=bad; fi
  [ $result = "$1" ] && return
  echo "FAILED: $2 including $3 is $result, should be $1" >&2
  failures=$((failures + 1))
}

all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
e=engine/plumb
p=predicates/plumb/predicates
check ok $e/plane/sweep/a.h '"plumb/dcel/dcel.h"'
check ok $e/plane/sweep/a.h '"plumb/plane/sweep/b.h"'
check ok $e/plane/set/a.h '"plumb/plane/sweep/b.h"'
check ok $e/plane/nef2.cpp '"plumb/plane/set/b.h"'
check ok $e/plane/set/a.h '"plumb/plane/map.h"'
check ok $e/io/text/a.cpp '"plumb/predicates/sign.h"'
check ok $e/io/text/a.cpp '<nlohmann/json.hpp>'
check ok $e/io/text/a.h '<vector>'
check ok $p/a.h '<gmp.h>'
check ok $p/boost_rational.h '<boost/multiprecision/gmp.hpp>'
check ok $e/plumb.h '"plumb/plane/nef2.h"'
check ok tests/plane/a_test.cpp '"plumb/plane/map.h"'
check ok tests/plane/a_test.cpp '"generate/meshes.h"'
check ok tests/plane/a_test.cpp '"plumb/testing/map_defects.h"'
check ok $e/cli/a.cpp '"plumb/cli/session.h"'
check bad $e/cli/a.cpp '"session.h"'
check bad $e/cli/a.cpp '"engine/plumb/io/text/files.h"'
check bad $e/plane/sweep/a.h '"plumb/plane/set/b.h"'
check bad $e/plane/map.h '"plumb/plane/nef2.h"'
check bad $e/plane/sweep/a.cpp '"plumb/plane/unlisted.h"'
check bad $e/dcel/a.h '"plumb/plane/map.h"'
check bad $e/base/a.cpp '"plumb/dcel/dcel.h"'
check bad $e/base/a.cpp '"plumb/plumb.h"'
check bad $e/io/text/a.cpp '"plumb/picture/svg.h"'
check bad $p/a.h '"plumb/base/ids.h"'
check bad $p/a.cpp '"plumb/dcel/dcel.h"'
check bad $p/a.h '<boost/multiprecision/gmp.hpp>'
check bad $e/plane/set/a.h '"plumb/nowhere/a.h"'
check bad $e/plane/set/a.h '"plumb/testing/test_map.h"'
check bad $e/plane/set/a.cpp '"map.h"'
check bad $e/io/text/a.h '<nlohmann/json.hpp>'
check bad engine/a.cpp '<vector>'
check bad tests/plane/a_test.cpp '"engine/plumb/plane/map.h"'
check bad tests/plane/a_test.cpp '"plumb/cli/session/command.h"'
[ $failures = 0 ] && echo "layers: all cases passed"
exit $((failures > 0))
