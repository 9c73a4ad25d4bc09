// The package in headless chromium, served over HTTP: node --test bindings/js/tests. Skipped where there is no chromium.
import assert from 'node:assert/strict';
import {execFile, spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import {basename, dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

const dist = process.env.PLUMB_JS_DIST ?? join(dirname(fileURLToPath(import.meta.url)), '../dist');
const hasChromium = spawnSync('chromium', ['--version']).status === 0;

// The last three are beyond every filter: collinear and subnormal, cocircular, and a hair beside a plane.
const page = `<!doctype html><body><script type="module">
import {orient2d, incircle, orient3d} from './predicates.js';
const signs = [
  orient2d(0, 0, 1, 0, 0, 1), orient2d(0, 5e-324, 5e-324, 0, 0, 0),
  incircle(1, 0, 0, 1, -1, 0, 0, -1), orient3d(1, 0, 0, 0, 1, 0, 0, 0, 1, 1 / 3, 1 / 3, 1 / 3),
].map(Math.sign);
document.body.textContent = 'signs ' + signs.join(' ');
</script></body>`;

test('chromium: signs that the exact stages decide', {skip: !hasChromium, timeout: 120000}, async () => {
  const {orient3d} = await import(join(dist, 'predicates.js'));
  const last = Math.sign(orient3d(1, 0, 0, 0, 1, 0, 0, 0, 1, 1 / 3, 1 / 3, 1 / 3));
  const server = createServer((request, response) => {
    const name = basename(request.url);
    const isScript = name.endsWith('.js');
    response.setHeader('content-type', isScript ? 'text/javascript' : 'text/html');
    response.end(isScript ? readFileSync(join(dist, name)) : page);
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  const profile = mkdtempSync(join(tmpdir(), 'plumb-js-'));
  try {
    const {stdout} = await promisify(execFile)('chromium', [
      '--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`, '--virtual-time-budget=20000', '--dump-dom',
      `http://127.0.0.1:${server.address().port}/`]);
    const shown = /signs ([-\d ]+)/.exec(stdout);
    assert.ok(shown, stdout);
    assert.deepEqual(shown[1].trim().split(' ').map(Number), [-1, 1, 0, last]);
  } finally {
    server.close();
    rmSync(profile, {recursive: true, force: true});
  }
});
