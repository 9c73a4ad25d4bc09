// The page: two meshes and an operation, or a layer and its repair.
//
// Everything is computed in a worker. `inputs` has what was dropped: solids as {name, solid,
// remarks}, or one layer. Solids keep the attributes of their files, so that pictures and written
// files have the colours of both. The result is shown in a frame without access to this page: a
// solid by the page that it writes of itself, a layer as a picture of its polygons.
import {connect} from '../worker.js';

const element = (id) => document.getElementById(id);
const plumb = await connect().catch((error) => {
  say(`The engine cannot be loaded: ${error.message}`, true);
  throw error;
});

let inputs = [], layer = null, result = null, running = null;

// ---- what the page says

function say(text, isError = false) {
  element('status').textContent = text;
  element('status').classList.toggle('error', isError);
}

function list(id, lines) {
  element(id).replaceChildren(
      ...lines.map((line) => Object.assign(document.createElement('li'), {textContent: line})));
}

function tell(facts) {
  element('facts').replaceChildren(...facts.flatMap(
      ([term, text]) =>
          [Object.assign(document.createElement('dt'), {textContent: term}),
           Object.assign(document.createElement('dd'), {textContent: text}),
  ]));
}

function show() {
  list('names', layer ? [layer.name] : inputs.map(({name}, i) => `${'AB'[i]}: ${name}`));
  element('solid-controls').hidden = inputs.length < 2;
  element('layer-controls').hidden = layer === null;
  element('run-controls').hidden = layer === null && inputs.length === 0;
  element('run').textContent = layer ? 'Repair' : inputs.length < 2 ? 'Show' : 'Compute';
  element('download-controls').hidden = result === null;
}

/** The format that was chosen stays chosen. */
function offer(formats) {
  const chosen = element('format').value;
  element('format').replaceChildren(
      ...formats.map((format) => new Option(format, format, false, format === chosen)));
}

function picture(html) { element('picture').srcdoc = html; }

// ---- reading

const isLayerFile = ({name}) => /\.(geojson|json|topojson|wkt)$/i.test(name);
/** Whether a file belongs to another one: colours of OBJ, arrays of glTF, textures. */
const isPart = ({name}) => /\.(mtl|bin|png|jpe?g)$/i.test(name);

/**
 * A solid of a file; a mesh that bounds none is mended if that is possible. Its defects, and what
 * the solid does not have of the file, are told.
 */
async function readSolid({name, bytes}, parts) {
  const notes = new Set();
  const options = {name, ...parts, onNote: ({text}) => notes.add(`${name}: ${text}`)};
  if (/\.nef$/i.test(name))
    return {name, solid: await plumb.Solid.read(bytes, options), remarks: [...notes]};
  const mesh = await plumb.readMesh(bytes, {...options, attributes: true});
  const defects = defectsOf(name, await plumb.checkMesh(mesh, {maxListed: 100}));
  const remarks = () => [...defects, ...notes];
  try {
    const solid = await plumb.Solid.read(bytes, {...options, keep: 'all'});
    return {name, solid, remarks: remarks()};
  } catch (error) {
    const mended = error.code === 'BAD_SHAPE' ? await plumb.repairMesh(mesh) : null;
    if (mended === null) throw error;
    const {welded, flipped, turned, filled} = mended.report;
    defects.push(`${name}: mended (welded points ${welded}, turned faces ${
        flipped + turned}, filled holes ${filled})`);
    return {name, solid: await solidOf(mesh, name, mended.repair), remarks: remarks()};
  }
}

function solidOf({vertices, triangles, faceBegin, corners, attributes}, name, repair) {
  const options = {attributes, sourceName: name, repair};
  return triangles ? plumb.Solid.fromMesh(vertices, triangles, options) :
                     plumb.Solid.fromPolygons(vertices, faceBegin, corners, options);
}

function defectsOf(name, report) {
  const counts = [
    ['borders', report.borders.length],
    ['holes', report.holes.length],
    ['crossing pairs of faces', report.crossingCount],
    ['degenerate faces', report.degenerate.length],
    ['faces that are there twice', report.doubled.length / 2],
    ['faces that disagree with their neighbours', report.flipped.length],
    ['components that are inside out', report.insideOut.length],
  ];
  return counts.filter(([, count]) => count > 0).map(([what,
                                                       count]) => `${name}: ${what}: ${count}`);
}

async function take(files) {
  const layerFile = files.find(isLayerFile), whole = files.filter((file) => !isPart(file));
  if (whole.length === 0) throw new Error('Drop a mesh together with the files that it names.');
  if (layerFile) {
    const {name, bytes} = layerFile;
    [inputs, result] = [[], null];
    layer = {name, layer: await plumb.Layer.read(bytes, {name})};
  } else {
    const read = [], parts = files.filter(isPart).map(({name, bytes}) => [name, bytes]);
    const beside = parts.length > 0 ? {files: Object.fromEntries(parts)} : {};
    for (const file of whole.slice(0, 2)) read.push(await readSolid(file, beside));
    [inputs, layer, result] =
        [[...(inputs.length === 1 && read.length === 1 ? inputs : []), ...read], null, null];
  }
  list('defects', inputs.flatMap(({remarks}) => remarks));
  tell([]);
  show();
  await compute();
}

// ---- computing

async function compute() {
  running = new AbortController();
  element('stop').disabled = false;
  element('run').disabled = true;
  const options = {
    signal: running.signal,
    onProgress: (phase, done, total) =>
        say(total > 0 ? `Computing: ${phase}, ${Math.floor((100 * done) / total)} %` :
                        `Computing: ${phase}`),
  };
  const start = performance.now();
  try {
    say('Computing.');
    await (layer ? repair(options) : combine(options));
    say(`Done in ${((performance.now() - start) / 1000).toFixed(2)} s.`);
  } finally {
    element('stop').disabled = true;
    element('run').disabled = false;
    show();
  }
}

const fileName = (name, format) => `${name}.${format.split('-')[0]}`;

async function combine(options) {
  const [a, b] = inputs.map(({solid}) => solid), operation = element('operation').value;
  let solid = a;
  if (b !== undefined)
    solid = operation === 'hull' ? await plumb.Solid.hullOf([a, b], options) :
                                   await a[operation](b, options);
  result = {
    files: (format, onNote) => solid.writeFiles(fileName('result', format), {format, onNote})
  };
  offer(['3mf', 'glb', 'obj', 'ply', 'off', 'stl-binary', 'nef']);
  const [volume, {vertices, edges, facets}, isConvex] =
      await Promise.all([solid.volume(), solid.counts(), solid.isConvex()]);
  const exact = volume === null ? 'infinite' : `${volume}`;
  tell([
    ['volume', volume === null ? exact : `${volume.toNumber()}`],
    ...(exact.includes('/') && exact.length < 60 ? [['exactly', exact]] : []),
    ['vertices', vertices],
    ['edges', edges],
    ['facets', facets],
    ['convex', isConvex ? 'yes' : 'no'],
  ]);
  picture(await solid.toHtml({title: 'Result'}));
}

async function repair(options) {
  const {layer: repaired, report} =
      await layer.layer.repaired({...options, owner: element('owner').value});
  result = {files: async (format) => ({[fileName('layer', format)]: await repaired.write(format)})};
  offer(['geojson', 'topojson', 'wkt']);
  const shown = report.regions.filter(({kind}) => kind !== 'hole');
  list(
      'defects',
      shown.slice(0, 50).map(
          ({kind, area, features, owner}) =>
              `${kind} of ${Number(area.toNumber().toPrecision(6))} between features ${
                  features.map((f) => f + 1).join(', ')}, given to ${
                  owner === null ? 'none' : owner + 1}`));
  tell([
    ['features', await layer.layer.featureCount()],
    ['overlaps', shown.filter(({kind}) => kind === 'overlap').length],
    ['gaps', shown.filter(({kind}) => kind === 'gap').length],
  ]);
  picture(layerPage(await repaired.toGeoJson(), report.geoJson));
}

// ---- pictures of layers

function ringsOf(geometry) {
  if (!geometry) return [];
  if (geometry.type === 'GeometryCollection') return geometry.geometries.flatMap(ringsOf);
  if (geometry.type === 'Polygon') return geometry.coordinates;
  return geometry.type === 'MultiPolygon' ? geometry.coordinates.flat() : [];
}

const pathOf = (geometry) =>
    ringsOf(geometry).map((ring) => `M${ring.map(([x, y]) => `${x} ${- y}`).join('L')}Z`).join('');

/** The features in turn of six colours, and what was repaired in red. */
function layerPage(features, defects) {
  const points = features.features.flatMap(({geometry}) => ringsOf(geometry).flat());
  const range = (axis) => points.reduce(
      ([low, high], p) => [Math.min(low, p[axis]), Math.max(high, p[axis])], [Infinity, -Infinity]);
  const [x0, x1] = range(0), [y0, y1] = range(1), margin = 0.03 * Math.max(x1 - x0, y1 - y0);
  const colours = ['#a6cee3', '#b2df8a', '#fdd9a0', '#cab2d6', '#ffff99', '#d9d9d9'];
  const shapes = features.features.map(
      ({geometry}, i) =>
          `<path d="${pathOf(geometry)}" fill="${colours[i % colours.length]}" stroke="#444"/>`);
  const marks = defects.features.map(
      ({geometry}) =>
          `<path d="${pathOf(geometry)}" fill="#e31a1c" stroke="#e31a1c" stroke-width="3"/>`);
  return `<!doctype html><style>body{margin:0}
    svg{display:block;width:100%;height:100vh;background:#fff}
    path{vector-effect:non-scaling-stroke;fill-rule:evenodd}
    </style><svg viewBox="${x0 - margin} ${- y1 - margin} ${x1 - x0 + 2 * margin} ${
      y1 - y0 + 2 * margin}">${shapes.join('')}${marks.join('')}</svg>`;
}

// ---- controls

/** Runs what a control does, and says what goes wrong. */
function doing(action) {
  return async (...inputsOfEvent) => {
    try {
      await action(...inputsOfEvent);
    } catch (error) {
      say(error.name === 'AbortError' ? 'Stopped.' : error.message, error.name !== 'AbortError');
    }
  };
}

async function filesOf(fileList) {
  return Promise.all([...fileList].map(
      async (file) => ({name: file.name, bytes: new Uint8Array(await file.arrayBuffer())})));
}

const drop = element('drop');
for (const name of ['dragover', 'dragleave', 'drop']) {
  document.addEventListener(name, (event) => {
    event.preventDefault();
    drop.classList.toggle('over', name === 'dragover');
  });
}
document.addEventListener(
    'drop',
    doing(
        async ({dataTransfer}) =>
            dataTransfer.files.length > 0 && take(await filesOf(dataTransfer.files))));
element('files').addEventListener('change', doing(async ({target}) => {
                                    const files = await filesOf(target.files);
                                    target.value = '';
                                    if (files.length > 0) await take(files);
                                  }));
element('run').addEventListener('click', doing(compute));
element('stop').addEventListener('click', () => running?.abort());
element('swap').addEventListener('click', doing(async () => {
                                   inputs.reverse();
                                   show();
                                   await compute();
                                 }));
element('operation').addEventListener('change', doing(compute));
element('owner').addEventListener('change', doing(compute));
/**
 * Saves the files of the result, and says what they lack: an OBJ file has its colours beside it.
 */
async function download() {
  const notes = [];
  const files = await result.files(element('format').value, ({text}) => notes.push(text));
  for (const [name, bytes] of Object.entries(files)) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
  say([`Saved ${Object.keys(files).join(' and ')}.`, ...notes].join(' '));
}
element('download').addEventListener('click', doing(download));

/** A solid as a 3MF file in one colour. */
async function colouredFile(name, solid, color) {
  const {vertices, triangles} = await solid.toMesh();
  const attributes = {
    materials: [{name, color}],
    faceMaterial: new Uint32Array(triangles.length / 3),
  };
  const bytes = await plumb.writeMesh({vertices, triangles, attributes}, '3mf');
  return {name: `${name}.3mf`, bytes};
}

async function showExample() {
  const ring = await plumb.Solid.torus(3, 1);
  const ball = await (await plumb.Solid.sphere(2, 24)).translated([3, 0, 0]);
  element('operation').value = 'difference';
  await take([
    await colouredFile('ring', ring, [0.2, 0.6, 1, 1]),
    await colouredFile('ball', ball, [1, 0.6, 0.2, 1]),
  ]);
}
element('example-solids').addEventListener('click', doing(showExample));
element('example-layer')
    .addEventListener(
        'click', doing(async () => {
          const plots = [
            [[0, 0], [4, 0], [4, 4], [0, 4]],
            [[3.8, 0], [9, 0], [9, 4], [3.8, 4]],
            [[0, 4], [2, 4.002], [4, 4], [5, 4], [5, 8], [0, 8]],
            [[5, 4], [9, 4], [9, 8], [5, 8]],
            [[0, 8], [9, 8], [9, 9.5], [0, 9.5]],
          ];
          const features =
              plots.map((ring, i) => ({
                          type: 'Feature',
                          properties: {plot: i + 1},
                          geometry: {type: 'Polygon', coordinates: [[...ring, ring[0]]]},
                        }));
          await take([{
            name: 'plots.geojson',
            bytes: new TextEncoder().encode(JSON.stringify({type: 'FeatureCollection', features}))
          }]);
        }));

say('Ready.');
if (['#example-solids', '#example-layer'].includes(location.hash))
  element(location.hash.slice(1)).click();
