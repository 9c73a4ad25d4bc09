// Every file that package.json names is in the package, whole or with the predicates only.
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

const tests = dirname(fileURLToPath(import.meta.url));
const dist = process.env.PLUMB_JS_DIST ?? join(tests, '../dist');

test('package.json names what is there', {skip: !existsSync(dist)}, () => {
  const {types, exports, files, sideEffects = []} =
      JSON.parse(readFileSync(join(dist, 'package.json'), 'utf8'));
  const named = [types, ...Object.values(exports), ...files, ...sideEffects]
                    .flatMap((entry) => typeof entry === 'object' ? Object.values(entry) : [entry])
                    .filter((path) => path !== undefined && !path.includes('*'));
  assert.ok(named.length > 4);
  for (const path of named) assert.ok(existsSync(join(dist, path)), path);
});
