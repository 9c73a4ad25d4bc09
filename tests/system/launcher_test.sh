#!/usr/bin/env bash
# ./plumb against a machine made of stubs: which packages it asks for, when it builds, what it prints.
# The compiler, apt and dpkg are small scripts that write what they were asked into a file `calls`.
set -u
source_root=$1
failures=0

expect() { # DESCRIPTION CONDITION...
  local description=$1
  shift
  "$@" && return
  echo "FAILED ($case): $description" >&2
  failures=$((failures + 1))
}

stub() { # NAME, body on stdin
  { echo '#!/bin/bash' && cat; } >"$machine/bin/$1"
  chmod +x "$machine/bin/$1"
}

# A fresh machine and a checkout with one source file.
new_machine() {
  case=$1
  machine=$(mktemp -d "$all/XXXXXX")
  mkdir -p "$machine"/{bin,src/engine,src/predicates}
  cp "$source_root"/{plumb,packages.debian.txt} "$machine/src"
  cp -r "$source_root/cmake" "$machine/src"
  touch "$machine/src/CMakeLists.txt" "$machine/src/engine/a.cpp" "$machine/calls"
  find "$machine/src" -exec touch -d '1 hour ago' {} +
  export MACHINE=$machine
  stub dpkg-query <<<'[ -e "$MACHINE/installed" ] && echo installed'
  stub apt-get <<<'echo "apt-get $*" >>"$MACHINE/calls"; [[ $* != *install* ]] || touch "$MACHINE/installed"'
  stub id <<<'echo "${FAKE_UID:-0}"'
  stub flock <<<'[ "$1" = 8 ] || exec /usr/bin/flock "$@"'
  stub cmake <<'STUB'
echo "cmake $*" >>"$MACHINE/calls"
echo "compiler output"
[ ! -e "$MACHINE/broken" ] || exit 1
while [ $# -gt 0 ]; do
  case $1 in
    -B) touch "$2/build.ninja"; echo "CMAKE_HOME_DIRECTORY:INTERNAL=$MACHINE/src" >"$2/CMakeCache.txt" ;;
    --build) printf '#!/bin/sh\necho "ran $*"\nexit 7\n' >"$2/plumb"; chmod +x "$2/plumb"; sleep 0.2 ;;
  esac
  shift
done
STUB
}

launch() {
  PATH="$machine/bin:$PATH" "$machine/src/plumb" "$@" >"$machine/out" 2>"$machine/err"
  status=$?
}

builds() { grep -c -- '--build' "$machine/calls"; }
nothing_printed_but() { [ "$(cat "$machine/out")" = "$1" ]; }

all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
unset PLUMB_BUILD_DIR

new_machine "without root"
FAKE_UID=1000 launch --version
expect "exit status is 2" [ $status = 2 ]
expect "stdout is empty" nothing_printed_but ""
expect "the apt line names every package" grep -q "apt-get install.* g++ .*libgmp-dev" "$machine/err"
expect "the check's packages are not asked for" [ "$(grep -c valgrind "$machine/err")" = 0 ]
expect "nothing was installed or built" [ ! -s "$machine/calls" ]

new_machine "first call as root"
launch map check file
expect "the program's own exit status" [ $status = 7 ]
expect "stdout is the program's" nothing_printed_but "ran map check file"
expect "update before install" [ "$(sed -n '1s/.*update/update/p;2s/.* install .*/install/p' "$machine/calls" | xargs)" = "update install" ]
expect "build output is on stderr" grep -q "compiler output" "$machine/err"
expect "one build" [ "$(builds)" = 1 ]

case="second call"
launch again
expect "stdout is the program's" nothing_printed_but "ran again"
expect "stderr is empty" [ ! -s "$machine/err" ]
expect "no second build" [ "$(builds)" = 1 ]

case="a source changed"
touch "$machine/src/engine/a.cpp"
launch again
expect "built again" [ "$(builds)" = 2 ]
expect "without a word" [ ! -s "$machine/err" ]
launch again
expect "and once only" [ "$(builds)" = 2 ]

case="a source was removed"
rm "$machine/src/engine/a.cpp"
launch again
expect "built again" [ "$(builds)" = 3 ]

case="a source is broken"
touch "$machine/broken" "$machine/src/engine/a.cpp"
launch again
expect "exit status is 70" [ $status = 70 ]
expect "stdout is empty" nothing_printed_but ""
expect "the reason is on stderr" grep -q "compiler output" "$machine/err"
rm "$machine/broken"
launch again
expect "mended" nothing_printed_but "ran again"

new_machine "two calls at once"
for i in 1 2 3; do
  PATH="$machine/bin:$PATH" "$machine/src/plumb" "$i" >"$machine/out.$i" 2>/dev/null &
done
wait
expect "one build" [ "$(builds)" = 1 ]
expect "all ran" [ "$(cat "$machine"/out.{1,2,3} | xargs)" = "ran 1 ran 2 ran 3" ]

new_machine "another build directory"
PLUMB_BUILD_DIR=$machine/elsewhere launch x
expect "the program is there" [ -x "$machine/elsewhere/plumb" ]
expect "and ran" nothing_printed_but "ran x"

new_machine "a place that cannot be written"
PLUMB_BUILD_DIR=$machine/calls/no FAKE_UID=1000 launch x
expect "packages are asked for first" grep -q "apt-get install" "$machine/err"
PLUMB_BUILD_DIR=$machine/calls/no launch x
expect "exit status is 2" [ $status = 2 ]
expect "says what to do" grep -q PLUMB_BUILD_DIR "$machine/err"
expect "stdout is empty" nothing_printed_but ""

new_machine "a directory configured from elsewhere"
mkdir -p "$machine/src/build/release"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=/gone" >"$machine/src/build/release/CMakeCache.txt"
touch "$machine/src/build/release/build.ninja"
launch x
expect "is configured afresh" grep -q -- "--fresh" "$machine/calls"

new_machine "called through a link"
ln -s "$machine/src/plumb" "$machine/bin/plumb-link"
PATH="$machine/bin:$PATH" "$machine/bin/plumb-link" x >"$machine/out" 2>/dev/null
expect "finds its sources" nothing_printed_but "ran x"

[ $failures = 0 ] && echo "launcher: all cases passed"
exit $((failures > 0))
