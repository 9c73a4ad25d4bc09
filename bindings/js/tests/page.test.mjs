// The page in headless chromium, from files to the download, as a visitor uses it: in a frame that
// this test drives.
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {dist, hasChromium, shownBy} from './chromium.mjs';

const corpus = join(dirname(fileURLToPath(import.meta.url)), '../../../corpus/solids');
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
  for (const [name, data] of Object.entries(files))
    transfer.items.add(new frame.contentWindow.File([data], name));
  at('files').files = transfer.files;
  at('files').dispatchEvent(new frame.contentWindow.Event('change'));
};
const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt());
// What the download button saves in a format, {name: bytes in base64}, and what is said then.
const saved = async (format) => {
  const blobs = [], names = [];
  frame.contentWindow.URL.createObjectURL = (blob) => (blobs.push(blob), 'data:,');
  frame.contentWindow.HTMLAnchorElement.prototype.click = function() { names.push(this.download); };
  again();
  at('format').value = format;
  at('download').click();
  await said('Saved');
  const files = {};
  for (const [i, blob] of blobs.entries()) {
    const bytes = new Uint8Array(await blob.arrayBuffer());
    files[names[i]] = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  }
  return {files, text: at('status').textContent};
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
    return {
      union,
      difference: facts(),
      names: lines('names'),
      file: atob((await saved('off')).files['result.off']),
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

/** The middle and the colour of each triangle. */
function paintedMiddles({vertices, triangles, attributes}) {
  return Array.from({length: triangles.length / 3}, (_, f) => {
    const corners = [0, 1, 2].map((k) => triangles[3 * f + k]);
    const middle =
        [0, 1, 2].map((axis) => corners.reduce((sum, v) => sum + vertices[3 * v + axis], 0) / 3);
    const {color} = attributes.materials[attributes.faceMaterial[f]];
    return {middle, colour: color.slice(0, 3).map((part) => part.toFixed(2)).join()};
  });
}

test('colours of two files are shown and saved', {skip, timeout: 200000}, async () => {
  const plumb = await import(join(dist, 'index.js'));
  await plumb.init();
  const {Solid, writeMesh} = plumb;
  // The checkerboard is a cube of side 8 at the origin; a red ball takes its corner away.
  const text = (name) => readFileSync(join(corpus, name), 'utf8');
  const board = {
    'board.obj': text('checkerboard.obj'),
    'checkerboard.mtl': text('checkerboard.mtl')
  };
  const ball = Solid.sphere(4, 24).toMesh(), red = {name: 'red', color: [0.8, 0.2, 0.2, 1]};
  const attributes = {materials: [red], faceMaterial: new Uint32Array(ball.triangles.length / 3)};
  const base64 = (format) =>
      Buffer.from(writeMesh({...ball, attributes}, format)).toString('base64');
  const balls = {'3mf': base64('3mf'), glb: base64('glb')};
  const found = await shown(`
    at('operation').value = 'difference';
    const board = ${JSON.stringify(board)}, results = {};
    for (const [format, bytes] of Object.entries(${JSON.stringify(balls)})) {
      again();
      give({...board, ['ball.' + format]: bytesOf(bytes)});
      await said('Done');
      const picture = at('picture').srcdoc, saves = {};
      for (const kind of ['obj', '3mf', 'glb', 'stl-binary']) saves[kind] = await saved(kind);
      results[format] = {picture, saves, names: lines('names'), remarks: lines('defects')};
    }
    return results;`);
  const expected = ['0.15,0.18,0.25', '0.80,0.20,0.20', '0.95,0.93,0.88'];
  for (const [format, {picture, saves, names, remarks}] of Object.entries(found)) {
    assert.deepEqual(names, ['A: board.obj', `B: ball.${format}`]);
    assert.deepEqual(remarks, []);
    // The picture has colours of three bytes each; the first one is that of no colour.
    const [, tints] = /"tints":"([^"]*)"/.exec(picture);
    assert.equal(Buffer.from(tints, 'base64').toString('hex').slice(6), '262e40f2ede0cc3333');
    for (const [kind, {files, text}] of Object.entries(saves)) {
      const bytes = Object.fromEntries(
          Object.entries(files).map(([name, base64]) => [name, Buffer.from(base64, 'base64')]));
      if (kind === 'stl-binary') {
        assert.match(text, /materials/, 'the colours that STL lacks are named');
        continue;
      }
      const name = `result.${kind}`;
      assert.deepEqual(Object.keys(bytes), kind === 'obj' ? ['result.mtl', name].sort() : [name]);
      const solid = Solid.read(bytes[name], {name, files: bytes, keep: 'colours'});
      const middles = paintedMiddles(solid.toMeshWithAttributes());
      const colours = new Set(middles.map(({colour}) => colour));
      assert.deepEqual([...colours].sort(), expected, `${format}, ${kind}`);
      for (const {middle, colour} of middles) {
        const isCut = middle.every((x) => x > 1e-9 && x < 8 - 1e-9);
        assert.equal(colour === '0.80,0.20,0.20', isCut, `${colour} at ${middle}`);
      }
    }
  }
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
