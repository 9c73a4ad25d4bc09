// The package in headless chromium, served over HTTP: node --test bindings/js/tests. Skipped where
// there is no chromium.
import assert from 'node:assert/strict';
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {cases as ofAttributes} from './attributes.mjs';
import {dist, hasChromium, shownBy} from './chromium.mjs';
import {cases} from './core.mjs';

// The last three are beyond every filter: collinear and subnormal, cocircular, and a hair beside a
// plane.
const page = `<script type="module">
import {orient2d, incircle, orient3d} from './predicates.js';
const signs = [
  orient2d(0, 0, 1, 0, 0, 1), orient2d(0, 5e-324, 5e-324, 0, 0, 0),
  incircle(1, 0, 0, 1, -1, 0, 0, -1), orient3d(1, 0, 0, 0, 1, 0, 0, 0, 1, 1 / 3, 1 / 3, 1 / 3),
].map(Math.sign);
await fetch('/shown', {method: 'POST', body: signs.join(' ')});
</script>`;

test(
    'chromium: signs that the exact stages decide', {skip: !hasChromium, timeout: 120000},
    async () => {
      const {orient3d} = await import(join(dist, 'predicates.js'));
      const last = Math.sign(orient3d(1, 0, 0, 0, 1, 0, 0, 0, 1, 1 / 3, 1 / 3, 1 / 3));
      const text = await shownBy(page);
      assert.deepEqual(text.split(' ').map(Number), [-1, 1, 0, last]);
    });

// Each case shows its name if it passes, and what failed otherwise; then there is the worker.
const engine = `<script type="module">
import * as plumb from './index.js';
import {connect} from './worker.js';
import {cases} from './core.mjs';
import {cases as ofAttributes} from './attributes.mjs';
await plumb.init();
const lines = [];
for (const [name, body] of Object.entries({...cases, ...ofAttributes})) {
  try {
    body(plumb);
  } catch (error) {
    lines.push(name + ': ' + error);
  }
}
const remote = await connect();
const box = await remote.Solid.box([0, 0, 0], [1, 1, '1/3']);
lines.push('worker ' + String(await box.volume()));
await fetch('/shown', {method: 'POST', body: lines.join('; ')});
</script>`;

test(
    'chromium: the cases of core.mjs and attributes.mjs, and the worker',
    {skip: !hasChromium || !existsSync(join(dist, 'engine.wasm')), timeout: 300000}, async () => {
      assert.ok(Object.keys(cases).length > 15 && Object.keys(ofAttributes).length > 8);
      assert.equal(await shownBy(engine), 'worker 1/3');
    });
