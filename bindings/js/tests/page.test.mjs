// The page in headless chromium, from files to the download, as a visitor uses it: in a frame that
// this test drives.
import assert from 'node:assert/strict';
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {dist, hasChromium, shownBy} from './chromium.mjs';

const skip = !hasChromium || !existsSync(join(dist, 'page/index.html'));

/**
 * A page that opens the package's page in a frame and posts what `steps`, a script, returns as
 * JSON.
 */
const driver = (steps) =>
    `<iframe id="page" src="/page/index.html" style="width:900px;height:700px"></iframe>
    <script type="module">
const frame = document.getElementById('page');
const at = (id) => frame.contentDocument?.getElementById(id);
const until = async (condition) => {
  while (!condition()) await new Promise((resume) => setTimeout(resume, 20));
};
const said = (start) => until(() => at('status')?.textContent.startsWith(start));
const facts = () => Object.fromEntries([...at('facts').querySelectorAll('dt')].map(
    (dt) => [dt.textContent, dt.nextSibling.textContent]));
const lines = (id) => [...at(id).children].map(({textContent}) => textContent);
const give = (files) => {
  const transfer = new frame.contentWindow.DataTransfer();
  for (const [name, text] of Object.entries(files))
    transfer.items.add(new frame.contentWindow.File([text], name));
  at('files').files = transfer.files;
  at('files').dispatchEvent(new frame.contentWindow.Event('change'));
};
const again = () => (at('status').textContent = '');
const corner = (x, i) => [x + (i & 1), (i >> 1) & 1, i >> 2].join(' ');
const box = (x, n) => 'OFF\\n8 ' + n + ' 0\\n' +
    [0, 1, 2, 3, 4, 5, 6, 7].map((i) => corner(x, i)).join('\\n') +
    '\\n4 0 2 3 1\\n4 4 5 7 6\\n4 0 1 5 4\\n4 2 6 7 3\\n4 0 4 6 2\\n' +
    (n === 6 ? '4 1 3 7 5\\n' : '');
await said('Ready');
const result = await (async () => {${steps}})();
await fetch('/shown', {method: 'POST', body: JSON.stringify(result)});
</script>`;

const shown = async (steps) => {
  const text = await shownBy(driver(steps));
  return text.startsWith('{') ? JSON.parse(text) : assert.fail(text);
};

test(
    'two meshes: operations, facts, the picture and the file', {skip, timeout: 200000},
    async () => {
      const found = await shown(`
    give({'a.off': box(0, 6), 'b.off': box(0.5, 6)});
    await said('Done');
    const union = facts();
    again();
    at('operation').value = 'difference';
    at('operation').dispatchEvent(new frame.contentWindow.Event('change'));
    await said('Done');
    const saved = new Promise((resolve) => {
      frame.contentWindow.URL.createObjectURL = (blob) => (blob.text().then(resolve), 'data:,');
    });
    at('format').value = 'off';
    at('download').click();
    return {
      union,
      difference: facts(),
      names: lines('names'),
      file: await saved,
      picture: at('picture').srcdoc.length
    };`);
      assert.equal(found.union.volume, '1.5');
      assert.deepEqual(
          [found.difference.volume, found.difference.vertices, found.difference.convex],
          ['0.5', '8', 'yes']);
      assert.deepEqual(found.names, ['A: a.off', 'B: b.off']);
      assert.ok(found.file.startsWith('OFF\n8 6 '), found.file.slice(0, 40));
      assert.ok(found.picture > 10000);
    });

test(
    'an open mesh is mended, and a broken file is an error with its place', {skip, timeout: 200000},
    async () => {
      const found = await shown(`
    give({'open.off': box(0, 5)});
    await said('Done');
    const defects = lines('defects'), volume = facts().volume;
    give({'bad.off': 'OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 x 0\\n3 0 1 2\\n'});
    await until(() => at('status').classList.contains('error'));
    return {defects, volume, error: at('status').textContent};`);
      assert.equal(found.volume, '1');
      assert.ok(
          found.defects.some((line) => line.includes('borders: 1')) &&
          found.defects.some((line) => line.includes('mended')));
      assert.ok(found.error.startsWith('bad.off:5:3: '), found.error);
    });

test('a layer: overlaps and gaps are found and repaired', {skip, timeout: 200000}, async () => {
  const found = await shown(`
    at('example-layer').click();
    await said('Done');
    return {facts: facts(), defects: lines('defects'), picture: at('picture').srcdoc};`);
  assert.deepEqual(found.facts, {features: '5', overlaps: '1', gaps: '1'});
  assert.equal(found.defects.length, 2);
  assert.equal(found.picture.split('<path').length - 1, 5 + 2);
});
