#!/bin/sh
# Makes corpus/maps, corpus/scenes and the larger of corpus/solids again from the published packages (needs npm and node).
# The result is the same byte for byte; `git diff --exit-code corpus` shows it.
set -eu
cd "$(dirname "$0")"
packages=$(mktemp -d)
trap 'rm -rf "$packages"' EXIT
npm install --silent --no-save --prefix "$packages" us-atlas@3.0.1 world-atlas@2.0.2 bunny@1.0.1

convert() { # NAME TOPOLOGY OBJECT
  node topojson_to_map.mjs "$packages/node_modules/$2" "$3" >"../maps/$1.map"
  node topojson_to_map.mjs --clean "$packages/node_modules/$2" "$3" >"../maps/$1.clean.map"
}
convert us-counties us-atlas/counties-10m.json counties
convert us-states us-atlas/states-10m.json states
convert world-countries world-atlas/countries-110m.json countries
node solids.mjs bunny "$packages/node_modules/bunny/index.js" >../solids/bunny.off
node solids.mjs ball >../solids/ball.off
node scenes.mjs ..
