// The package in Node: the cases of core.mjs and attributes.mjs, and what a browser cannot tell:
// memory, the worker, the types. node --test bindings/js/tests; PLUMB_JS_DIST names the package.
// Skipped where the package has the predicates only.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {cases as ofAttributes} from './attributes.mjs';
import {cases, failure} from './core.mjs';

const dist = process.env.PLUMB_JS_DIST ?? join(dirname(fileURLToPath(import.meta.url)), '../dist');
const skip = !existsSync(join(dist, 'engine.wasm'));
const plumb = skip ? null : await import(join(dist, 'index.js'));

test('before init(), an error says what to do', {skip}, () => {
  const {message} = failure(plumb, 'NOT_READY', () => plumb.Solid.empty());
  assert.match(message, /init\(\)/);
  assert.equal(plumb.isReady(), false);
});

test('init() can fail and then succeed', {skip}, async () => {
  await assert.rejects(plumb.init({wasm: new URL('missing.wasm', import.meta.url)}));
  await Promise.all([plumb.init(), plumb.init()]);
  assert.equal(plumb.isReady(), true);
  assert.match(plumb.version(), /^\d+\.\d+\.\d+$/);
});

for (const [name, body] of Object.entries({...cases, ...ofAttributes}))
  test(name, {skip}, () => body(plumb));

test('objects that are disposed of leave no memory behind', {skip}, () => {
  const {Solid} = plumb;
  const cube = Solid.box([0, 0, 0], [1, 1, 1]), mesh = cube.toMesh();
  const round = () => {
    const solid = Solid.fromMesh(mesh.vertices, mesh.triangles),
          moved = solid.translated([0.5, 0, '1/3']);
    const sum = solid.union(moved);
    assert.ok(sum.volume().numerator > 0n);
    failure(plumb, 'SYNTAX', () => Solid.read('OFF\nx', {name: 'x.off'}));
    for (const each of [solid, moved, sum]) each.dispose();
  };
  for (let i = 0; i < 200; ++i) round();
  const before = process.memoryUsage().arrayBuffers;
  for (let i = 0; i < 10000 / 3; ++i) round();
  const growth = process.memoryUsage().arrayBuffers - before;
  assert.ok(growth < 2 ** 20, `${growth} bytes more after 10000 objects`);
});

/**
 * Runs a body and returns how many objects and blocks of the engine it made, and which are left.
 * The functions that make objects are given with the places of these among their parameters,
 * counted from the end, and with the functions that release them.
 */
async function liveObjects(makers, body) {
  const {engine} = await import(join(dist, 'memory.js'));
  const module = engine(), originals = {}, live = new Set();
  let made = 0;
  const replace = (name, wrapper) => {
    originals[name] ??= module[name];
    module[name] = wrapper(module[name]);
  };
  const note = (free, address) => {
    if (address === 0) return;
    live.add(`${free} ${address}`);
    ++made;
  };
  for (const [maker, results] of Object.entries(makers)) {
    replace(`_${maker}`, (call) => (...inputs) => {
      const status = call(...inputs);
      for (const [place, free] of Object.entries(results))
        if (status === 0) note(free, module.HEAPU32[inputs.at(-place) >>> 2]);
      return status;
    });
    for (const free of Object.values(results)) {
      replace(`_${free}`, (call) => (address) => {
        live.delete(`${free} ${address}`);
        call(address);
      });
    }
  }
  replace('_malloc', (call) => (size) => {
    const address = call(size);
    note('free', address >>> 0);
    return address;
  });
  replace('_free', (call) => (address) => {
    live.delete(`free ${address >>> 0}`);
    call(address);
  });
  try {
    body();
  } finally {
    Object.assign(module, originals);
  }
  return {made, left: [...live]};
}

const solidFree = 'plumb_solid_free', notesFree = 'plumb_notes_free';

test('what the last report of progress throws is thrown, and nothing is left', {skip}, async () => {
  const {Solid} = plumb, ball = Solid.ball(1, 5), other = ball.translated([0.5, 0.25, 0.125]);
  let reports = 0;
  ball.union(other, {onProgress: () => ++reports}).dispose();
  const reason = new RangeError('enough');
  const {engine} = await import(join(dist, 'memory.js')), report = engine().onProgress;
  assert.equal(typeof report, 'function');
  const original = engine()._plumb_solid_union;
  // A report after the operation is done is what no cancelling can stop any more.
  engine()._plumb_solid_union = (...inputs) => {
    const status = original(...inputs);
    report('last', 1, 1);
    return status;
  };
  try {
    const makers = {
      plumb_solid_union: {3: solidFree},
      plumb_context_new: {2: 'plumb_context_free'},
    };
    const {made, left} = await liveObjects(makers, () => {
      const onProgress = (phase) => {
        if (phase === 'last') throw reason;
      };
      assert.throws(() => ball.union(other, {onProgress}), reason);
    });
    assert.ok(made >= 3, 'the union was not made');
    assert.deepEqual(left, []);
  } finally {
    engine()._plumb_solid_union = original;
  }
});

/** What tells notes, and the functions of C that make objects meanwhile. */
const noting = {
  'Solid.read': {
    makers: {plumb_solid_read: {4: solidFree, 3: notesFree}},
    call: ({Solid}, options) => Solid.read(
        'COFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n',
        {name: 'a.off', ...options}),
  },
  'readMesh': {
    makers: {plumb_mesh_read: {4: 'plumb_mesh_free', 3: notesFree}},
    call: ({readMesh}, options) =>
        readMesh('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n', {name: 'a.obj', ...options}),
  },
  'Solid.write': {
    makers: {plumb_solid_write: {4: 'plumb_bytes_free', 3: notesFree}},
    call: ({Solid}, options) => {
      const inner = Solid.hull(new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1])).interior();
      inner.write('off', options);
    },
  },
  'PlaneSet.read': {
    makers: {plumb_plane_set_read: {4: 'plumb_plane_set_free', 3: notesFree}},
    call: ({PlaneSet}, options) => PlaneSet.read('POINT Z(3 3 5)', options),
  },
  'Layer.read': {
    makers: {plumb_layer_read: {4: 'plumb_layer_free', 3: notesFree}},
    call: ({Layer}, options) =>
        Layer.read('GEOMETRYCOLLECTION(POLYGON((0 0,1 0,0 1,0 0)),POINT(3 3))', options),
  },
};

for (const [name, {makers, call}] of Object.entries(noting)) {
  test(`${name}: an exception of onNote is thrown, and nothing is left`, {skip}, async () => {
    const reason = new RangeError('enough');
    const onNote = () => {
      throw reason;
    };
    const {made, left} =
        await liveObjects(makers, () => assert.throws(() => call(plumb, {onNote}), reason));
    assert.ok(made > 2, 'nothing was made');
    assert.deepEqual(left, []);
  });
}

test('a report that cannot be written leaves nothing behind', {skip}, async () => {
  const cannotWrite = 101;  // PLUMB_CANNOT_WRITE of plumb.h.
  const {Layer} = plumb;
  const layer = Layer.read(
      'GEOMETRYCOLLECTION(POLYGON((0 0,4 0,4 4,0 4,0 0)),' +
      'POLYGON((3 0,7 0,7 4,3 4,3 0)))');
  const makers = {
    plumb_layer_repair_with: {4: 'plumb_layer_free', 3: 'plumb_layer_report_free'},
    plumb_layer_check_with: {3: 'plumb_layer_report_free'},
    plumb_layer_report_area: {2: 'plumb_numbers_free'},
  };
  const {engine} = await import(join(dist, 'memory.js'));
  const original = engine()._plumb_layer_report_write;
  engine()._plumb_layer_report_write = () => cannotWrite;
  try {
    for (const use of ['repaired', 'check']) {
      const {made, left} =
          await liveObjects(makers, () => failure(plumb, 'CANNOT_WRITE', () => layer[use]()));
      assert.ok(made > 3, 'nothing was made');
      assert.deepEqual(left, [], use);
    }
  } finally {
    engine()._plumb_layer_report_write = original;
  }
});

test('attributes leave nothing behind, and neither do refused ones', {skip}, async () => {
  const {Solid, lostAttributes, writeMesh} = plumb, meshFree = 'plumb_mesh_free';
  const {vertices, triangles} = Solid.box([0, 0, 0], [1, 1, 1]).toMesh();
  const attributes = {
    materials: [{name: 'red', color: [1, 0, 0, 1]}],
    faceMaterial: new Uint32Array(12),
    vertexChannels: {place: {width: 3, values: vertices}}
  };
  const late = {...attributes, vertexChannels: {place: {width: 2, values: vertices}}};
  const makers = {
    plumb_mesh_from_triangles: {2: meshFree},
    plumb_solid_from_mesh: {3: solidFree},
    plumb_solid_with_source: {2: solidFree},
    plumb_solid_write_file: {3: notesFree},
    plumb_solid_to_mesh_with_attributes: {4: meshFree},
  };
  const {made, left} = await liveObjects(makers, () => {
    const solid = Solid.fromMesh(vertices, triangles, {attributes});
    const mesh = solid.toMeshWithAttributes(), again = solid.withSource(mesh);
    assert.ok(writeMesh(mesh, 'ply').length > 0 && lostAttributes(mesh, 'off').length > 0);
    assert.deepEqual(Object.keys(solid.writeFiles('a.obj')).sort(), ['a.mtl', 'a.obj']);
    for (const each of [solid, again]) each.dispose();
    failure(plumb, 'BAD_ARGUMENT', () => Solid.fromMesh(vertices, triangles, {attributes: late}));
    failure(plumb, 'UNKNOWN_FORMAT', () => writeMesh(mesh, 'xyz'));
  });
  assert.ok(made > 20, 'nothing was made');
  assert.deepEqual(left, []);
});

test('objects that nobody disposed of are released by the garbage collector', {skip}, async () => {
  const {Solid} = plumb;
  const {setFlagsFromString} = await import('node:v8');
  setFlagsFromString('--expose-gc');
  const collect = (await import('node:vm')).runInNewContext('gc');
  const ball = Solid.ball(1, 4), bytes = ball.memoryBytes();
  const before = process.memoryUsage().arrayBuffers;
  let made = 0;
  for (let i = 0; i < 60; ++i) {
    for (let k = 0; k < 5; ++k) made += ball.translated([i, k, 0]).memoryBytes();
    collect();
    await new Promise((resume) => setImmediate(resume));
  }
  const growth = process.memoryUsage().arrayBuffers - before;
  assert.ok(made > 200 * bytes && growth < made / 4, `${growth} of ${made} bytes were kept`);
});

// ---- the worker

async function withWorker(body) {
  const {connect} = await import(join(dist, 'worker.js'));
  const remote = await connect();
  try {
    await body(remote);
  } finally {
    remote.terminate();
  }
}

test(
    'the worker gives the same answers', {skip, timeout: 120000},
    () => withWorker(async (remote) => {
      const a = await remote.Solid.box([0, 0, 0], [1, 1, new plumb.Fraction(1, 3)]);
      const b = await a.translated(['1/2', 0, 0]);
      const sum = await remote.Solid.unionOf([a, b]);
      assert.equal(String(await sum.volume()), '1/2');
      const here = plumb.Solid.fromBytes(await sum.toBytes());
      assert.ok(here.equals(plumb.Solid.box([0, 0, 0], ['3/2', 1, '1/3'])));
      const {vertices, triangles, report} = await sum.toMesh();
      assert.ok(
          vertices instanceof Float64Array && triangles instanceof Uint32Array &&
          report.roundedVertices >= 0);
      const parts = await sum.decompose();
      assert.equal((await parts[0].counts()).volumes, 2);
      const map = await remote.Map.fromCycles([[0, 0], [1, 0], [0, 1]], [[0, 1, 2], [2, 1, 0]]);
      assert.equal(await (await map.check()).isValid(), true);
      assert.deepEqual(
          await remote.checkMesh({vertices, triangles}).then(({isClosed}) => isClosed), true);
      const attributes = {
        materials: [{name: 'red', color: [1, 0, 0, 1]}],
        faceMaterial: new Uint32Array(triangles.length / 3)
      };
      const red = await remote.Solid.fromMesh(vertices, triangles, {attributes, sourceName: 'a'});
      const traced = await red.toMeshWithAttributes();
      assert.deepEqual(await red.sources(), ['a']);
      assert.ok(traced.attributes.faceMaterial.every((i) => i === 0) && traced.source.length > 0);
      assert.equal(Object.keys(await remote.writeMeshFiles(traced, 'a.obj')).length, 2);
    }));

test(
    'the worker hands errors over', {skip, timeout: 120000},
    () => withWorker(async (remote) => {
      const {PlumbError} = await import(join(dist, 'index.js'));
      await assert.rejects(
          remote.Solid.read('OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n', {name: 'bad.off'}),
          (error) => error instanceof PlumbError && error.code === 'SYNTAX' && error.line === 5 &&
              error.file === 'bad.off');
      const box = await remote.Solid.box([0, 0, 0], [1, 1, 1]);
      await box.dispose();
      await assert.rejects(box.volume(), {code: 'BAD_ARGUMENT'});
      await assert.rejects(remote.Solid.nothing(), {code: 'BAD_ARGUMENT'});
      remote.terminate();
      await assert.rejects(remote.Solid.empty(), {code: 'CANCELLED'});
    }));

test(
    'the worker reports progress, and a signal stops it', {skip, timeout: 120000},
    () => withWorker(async (remote) => {
      const a = await remote.Solid.ball(1, 6), b = await a.translated([0.5, 0.25, 0.125]);
      const phases = [], large = await remote.Solid.ball(1, 7);
      const moved = await large.translated([0.5, 0.25, 0.125]);
      await large.union(moved, {onProgress: (phase) => phases.push(phase)});
      assert.ok(phases.length > 0);
      const controller = new AbortController(), reason = new RangeError('enough');
      const call = a.minkowskiSum(b, {signal: controller.signal});
      setTimeout(() => controller.abort(reason), 200);
      const start = performance.now();
      await assert.rejects(call, reason);
      assert.ok((await b.counts()).volumes === 2, 'the next call has its turn');
      assert.ok(performance.now() - start < 20000, 'the operation went on');
      await assert.rejects(a.union(b, {signal: AbortSignal.abort(reason)}), reason);
    }));

test('the worker loads the engine from where it is told', {skip, timeout: 120000}, async () => {
  const {connect} = await import(join(dist, 'worker.js'));
  const bytes = readFileSync(join(dist, 'engine.wasm'));
  const file = pathToFileURL(join(dist, 'engine.wasm'));
  const places = [await WebAssembly.compile(bytes), bytes, file];
  for (const wasm of places) {
    const remote = await connect({wasm});
    assert.match(await remote.version(), /^\d/);
    remote.terminate();
  }
  await assert.rejects(connect({wasm: new URL('missing.wasm', import.meta.url)}));
});

test('after a trap, everything says that the engine has stopped', {skip}, () => {
  const script = `
    const {init, isReady, Solid} = await import('./index.js');
    const {engine} = await import('./memory.js');
    await init();
    const solid = Solid.ball(1), codes = [];
    engine()._plumb_solid_volume = () => { throw new WebAssembly.RuntimeError('unreachable'); };
    for (const use of [() => solid.volume(), () => solid.counts(), () => Solid.empty()]) {
      try {
        use();
      } catch ({code, message}) {
        codes.push(code + ' ' + message.includes('unreachable'));
      }
    }
    solid.dispose();
    console.log(codes.join(), isReady());`;
  const {stdout, stderr} = spawnSync(
      process.execPath, ['--input-type=module', '-e', script], {cwd: dist, encoding: 'utf8'});
  assert.equal(stdout.trim(), 'INTERNAL true,INTERNAL true,INTERNAL true false', stderr);
});

// ---- types

/** {class: names of members}, and under '' the names of functions, of the declarations. */
function declared() {
  const text =
      readFileSync(join(dist, 'index.d.ts'), 'utf8').replaceAll(/\/\*[^]*?\*\/|\/\/.*/g, '');
  const names = {
    '': new Set([...text.matchAll(/^export function (\w+)/gm)].map(([, name]) => name))
  };
  for (const [, name, body] of text.matchAll(
           /^export (?:abstract )?class (\w+)[^{]*\{\n([^]*?)^\}/gm)) {
    names[name] = new Set(
        [...body.matchAll(/^  (static |readonly |private )*(\w+)[(:?]/gm)]
            .filter(([line]) => !line.includes('constructor'))
            .map(([line, , member]) => (line.includes('static ') ? `static ${member}` : member)));
  }
  return names;
}

/** The same of what the module exports. */
function exported() {
  const names = {'': new Set()};
  const isInternal = (name) => ['prototype', 'length', 'name', 'prefix', 'free', 'width', 'cells',
                                'info', 'constructor']
                                   .includes(name);
  for (const [name, thing] of Object.entries(plumb)) {
    if (!/^[A-Z]/.test(name)) {
      names[''].add(name);
      continue;
    }
    names[name] = new Set([
      ...Object.getOwnPropertyNames(thing)
          .filter((member) => !isInternal(member))
          .map((member) => `static ${member}`),
      ...Object.getOwnPropertyNames(thing.prototype).filter((member) => !isInternal(member)),
    ]);
  }
  return names;
}

test('everything has a type, and every type is there', {skip}, () => {
  const types = declared(), things = exported();
  assert.deepEqual(Object.keys(types).sort(), Object.keys(things).sort());
  const inherited = new Set(['empty', 'whole', 'point', 'points', 'unionOf', 'intersectionOf'].map(
      (name) => `static ${name}`));
  const fields = new Set(['code', 'reason', 'file', 'line', 'column', 'numerator', 'denominator']);
  for (const [name, members] of Object.entries(things)) {
    const ofClass =
        new Set([...types[name]].filter((member) => !fields.has(member) && !inherited.has(member)));
    const present = [...members].filter((member) => !inherited.has(member) && member !== 'without');
    assert.deepEqual([...ofClass].sort(), present.sort(), name);
  }
});
