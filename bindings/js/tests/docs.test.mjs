// The examples of docs/javascript.md run, and docs/capabilities.md names every class, method and
// function of the package.
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

const tests = dirname(fileURLToPath(import.meta.url)), docs = join(tests, '../../../docs');
const dist = process.env.PLUMB_JS_DIST ?? join(tests, '../dist');
const skip = !existsSync(join(dist, 'engine.wasm'));

const pages = {
  'README.md': join(tests, '../../../README.md'),
  'docs/javascript.md': join(docs, 'javascript.md'),
  'README.md of the package': join(tests, '../README.md')
};
for (const [page, path] of Object.entries(pages)) {
  const examples = [...readFileSync(path, 'utf8').matchAll(/^```js\n([^]*?)^```/gm)]
                       .map(([, code]) => code)
                       .filter((code) => !code.includes('\'plumb/predicates\''));
  examples.forEach(
      (code, i) => test(`${page}: example ${i + 1}`, {skip, timeout: 120000}, async () => {
        const plumb = await import(join(dist, 'index.js')),
              {connect} = await import(join(dist, 'worker.js'));
        await plumb.init();
        const body = code.replaceAll(/^import .*$/gm, '');
        const AsyncFunction = (async () => {}).constructor;
        const writeFileSync = (path, bytes) => assert.ok(bytes.length > 0, path);
        const scope = {...plumb, connect, assert, writeFileSync};
        await new AsyncFunction(...Object.keys(scope), body)(...Object.values(scope));
      }));
  test(`${page} has examples`, () => assert.ok(examples.length > 0));
}

/** The names in the column JavaScript of all tables. */
function named() {
  const names = [];
  let column = -1;
  for (const line of readFileSync(join(docs, 'capabilities.md'), 'utf8').split('\n')) {
    const cells = line.split('|').slice(1, -1).map((cell) => cell.trim());
    if (cells[0] === 'Capability')
      column = cells.indexOf('JavaScript');
    else if (column >= 0 && cells.length > column)
      names.push(...[...cells[column].matchAll(/`([^`]+)`/g)].map(([, name]) => name));
  }
  return names;
}

test('docs/capabilities.md names what there is, and nothing else', {skip}, async () => {
  const modules = [await import(join(dist, 'index.js')), await import(join(dist, 'worker.js'))];
  const isInternal = (name) => ['prototype', 'length', 'name', 'prefix', 'free', 'width', 'cells',
                                'info', 'constructor', 'toString']
                                   .includes(name);
  const existing = new Set(), classes = [];
  for (const [name, thing] of modules.flatMap(Object.entries)) {
    if (/^[a-z]/.test(name))
      existing.add(name);
    else
      classes.push(name);
    for (let level = thing; /^[A-Z]/.test(name) && level !== Function.prototype && level !== Error;
         level = Object.getPrototypeOf(level)) {
      if (name === 'PointSet') break;
      const members =
          [...Object.getOwnPropertyNames(level), ...Object.getOwnPropertyNames(level.prototype)];
      members.filter((member) => !isInternal(member))
          .forEach((member) => existing.add(`${name}.${member}`));
    }
  }
  existing.delete('serve');
  const patterns = named();
  const matches = (pattern) =>
      new RegExp(`^${pattern.replaceAll('.', '\\.').replaceAll('*', '.*')}$`);
  const all = [...existing];
  assert.ok(all.length > 150 && patterns.length > 80);
  assert.deepEqual(
      patterns.filter(
          (pattern) => ![...all, ...classes].some((name) => matches(pattern).test(name))),
      [], 'these do not exist');
  const ofHandles = new Set(['dispose', 'isDisposed']);
  assert.deepEqual(
      all.filter(
             (name) => !ofHandles.has(name.split('.')[1]) &&
                 !patterns.some((pattern) => matches(pattern).test(name)))
          .sort(),
      [], 'these are in no row');
});
