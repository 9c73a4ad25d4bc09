// The package as npm packs and installs it: the example of its README, in Node and in a browser.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {dist, hasChromium, shownBy} from './chromium.mjs';

const readme = join(dirname(fileURLToPath(import.meta.url)), '../README.md');
const [, example] = /^```js\n([^]*?)^```/m.exec(readFileSync(readme, 'utf8'));
const hasNpm = spawnSync('npm', ['--version']).status === 0;
const skip = !hasNpm || !existsSync(join(dist, 'engine.wasm'));
let folder = null;

function run(program, ...words) {
  const {status, stdout, stderr} = spawnSync(program, words, {cwd: folder, encoding: 'utf8'});
  assert.equal(status, 0, `${program} ${words.join(' ')}: ${stderr}`);
  return stdout;
}

before(() => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), 'plumb-install-'));
  mkdirSync(join(folder, 'packed'));
  writeFileSync(join(folder, 'package.json'), '{"type": "module", "private": true}');
  const [{filename}] =
      JSON.parse(run('npm', 'pack', '--json', '--pack-destination', 'packed', resolve(dist)));
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', `./packed/${filename}`);
});
after(() => folder !== null && rmSync(folder, {recursive: true, force: true}));

test('the example of the README in Node', {skip}, () => {
  writeFileSync(join(folder, 'example.js'), example);
  assert.equal(run(process.execPath, 'example.js').trim(), '1 1');
});

test(
    'the example of the README in chromium', {skip: skip || !hasChromium, timeout: 120000},
    async () => {
      const page = `<script type="importmap">
          {"imports": {"plumb": "/node_modules/plumb/index.js"}}</script>
          <script>
          console.log = (...words) => fetch('/shown', {method: 'POST', body: words.join(' ')});
          </script>
          <script type="module">${example}</script>`;
      assert.equal(await shownBy(page, [folder]), '1 1');
    });
