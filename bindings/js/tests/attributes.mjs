// Attributes of meshes stay with solids; in Node and in a browser, as core.mjs. Differences of
// cubes of a grid are compared with a count of unit squares; each face has to lie in its source
// face, which is decided with BigInt.
import {check, checkEqual, failure, randomNumbers} from './core.mjs';

const none = 0xffffffff;

// ---- scenes

/** Cells of a grid, as texts 'x,y,z' of their lower corners. */
function randomCells(random, count) {
  return new Set(
      Array.from({length: count}, () => [0, 1, 2].map(() => Math.floor(3 * random())).join()));
}

function meshOfCells({Solid}, cells) {
  const cubes = Array.from(cells, (cell) => {
    const low = cell.split(',').map(Number);
    return Solid.box(low, low.map((x) => x + 1));
  });
  return Solid.unionOf(cubes).toMesh();
}

const boxMesh = ({Solid}, low, high) => Solid.box([low, low, low], [high, high, high]).toMesh();

const faceCount = ({triangles}) => triangles.length / 3;

const cornerPlaces = (vertices, corners) => Float64Array.from(
    {length: 3 * corners.length}, (_, i) => vertices[3 * corners[Math.floor(i / 3)] + (i % 3)]);

/** A material, groups, ids, and the coordinates as channels. */
function paintOf(mesh, name, firstId = 0) {
  const {vertices, triangles} = mesh, faces = faceCount(mesh);
  return {
    materials: [{name, color: [1, 0.2, 0, 1]}],
    faceMaterial: new Uint32Array(faces),
    groups: ['even', 'odd'],
    faceGroup: Array.from({length: faces}, (_, f) => f % 2),
    faceId: Uint32Array.from({length: faces}, (_, f) => firstId + f),
    channels: {place: {width: 3, values: cornerPlaces(vertices, triangles)}},
    vertexChannels: {
      height: {width: 1, values: vertices.filter((_, i) => i % 3 === 2)},
    },
  };
}

const painted = ({Solid}, mesh, name, firstId) => Solid.fromMesh(
    mesh.vertices, mesh.triangles, {attributes: paintOf(mesh, name, firstId), sourceName: name});

// ---- oracles

/** The unit squares of the boundary of a - b that belong to a, and those of b alone. */
function squaresOfDifference(a, b) {
  const counts = [0, 0], isLeft = (cell) => a.has(cell) && !b.has(cell);
  for (const cell of [...a].filter(isLeft)) {
    for (const [axis, step] of [0, 1, 2].flatMap((i) => [[i, -1], [i, 1]])) {
      const beyond = cell.split(',').map((x, i) => Number(x) + (i === axis ? step : 0)).join();
      if (!isLeft(beyond)) ++counts[a.has(beyond) ? 1 : 0];
    }
  }
  return counts;
}

const cornersOf = ({vertices, triangles}, face) => [0, 1, 2].map((k) => {
  const v = triangles[3 * face + k];
  return [0, 1, 2].map((axis) => vertices[3 * v + axis]);
});
const cross =
    (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
const minus = (p, q) => p.map((x, i) => x - q[i]);

const unit = 2 ** 60;
/** A point in units of 1 / unit; coordinates such as a third, rounded, are whole in them. */
const exactly = (point) => point.map((x) => BigInt(x * unit));

/** Twice the vector area of a triangle. */
function normalOf(corners) {
  const [p, q, r] = corners.map(exactly);
  return cross(minus(q, p), minus(r, p));
}

const dot = (u, v) => u.reduce((sum, x, i) => sum + x * v[i], 0n);

/** Whether a triangle lies in the plane of another one. */
function isInPlane(corners, of) {
  const normal = normalOf(of);
  return corners.every((p) => dot(minus(exactly(p), exactly(of[0])), normal) === 0n);
}

const isSame = (values, expected, bound) =>
    values.length === expected.length && values.every((x, i) => Math.abs(x - expected[i]) <= bound);

// ---- cases

export const cases = {
  'each face of a difference is a part of its source'(plumb) {
    const random = randomNumbers(11);
    let flipped = 0;
    for (const pieces of ['same attributes', 'same face', 'apart', 'same attributes']) {
      const cells = [randomCells(random, 20), randomCells(random, 9)];
      const meshes = cells.map((set) => meshOfCells(plumb, set));
      const [first, second] =
          meshes.map((mesh, i) => painted(plumb, mesh, ['first', 'second'][i], 1000 * i));
      const rest = first.difference(second), made = rest.toMeshWithAttributes({pieces});
      const {source, sourceFace, isFlipped, attributes} = made, areas = [0, 0];
      checkEqual(attributes.materials.map(({name}) => name), ['first', 'second']);
      for (let f = 0; f < source.length; ++f) {
        const from = source[f], corners = cornersOf(made, f);
        const origin = cornersOf(meshes[from], sourceFace[f]);
        check(isInPlane(corners, origin), `face ${f} is not in the plane of its source face`);
        const side = dot(normalOf(corners), normalOf(origin));
        check(side !== 0n && isFlipped[f] === (side < 0n ? 1 : 0), `the side of face ${f}`);
        check(isFlipped[f] === from, 'what was subtracted is seen from the other side');
        checkEqual(attributes.faceMaterial[f], from, 'the colour of the cut:');
        checkEqual(attributes.faceId[f], sourceFace[f] + 1000 * from, 'the id:');
        checkEqual(attributes.faceGroup[f], sourceFace[f] % 2 + 2 * from, 'the group:');
        areas[from] +=
            Math.abs(normalOf(corners).reduce((sum, x) => sum + Number(x), 0)) / 2 / unit ** 2;
        flipped += isFlipped[f];
      }
      const squares = squaresOfDifference(...cells);
      check(isSame(areas, squares, 1e-12), `areas ${areas}, expected ${squares}`);
      check(source.every((from, f) => f === 0 || source[f - 1] <= from), 'sorted by sources');
      const {place, height} = attributes.channels,
                    places = cornerPlaces(made.vertices, made.triangles);
      check(place.width === 3 && isSame(place.values, places, 1e-14), 'places');
      check(isSame(height.values, places.filter((_, i) => i % 3 === 2), 1e-14), 'heights');
      check(plumb.Solid.fromMesh(made.vertices, made.triangles, {mayBeEmpty: true})
                .equals(rest.regularization()));
    }
    check(flipped > 20, `only ${flipped} faces are flipped`);
  },

  'materials and groups of all sources follow each other'(plumb) {
    const {Solid} = plumb;
    const united = painted(plumb, boxMesh(plumb, 0, 2), 'red')
                       .union(painted(plumb, boxMesh(plumb, 1, 3), 'blue'));
    checkEqual(united.sources(), ['red', 'blue']);
    const made = united.toMeshWithAttributes();
    checkEqual(made.attributes.materials, [
      {name: 'red', color: [1, 0.2, 0, 1], texture: ''},
      {name: 'blue', color: [1, 0.2, 0, 1], texture: ''}
    ]);
    checkEqual(made.attributes.groups, ['even', 'odd', 'even', 'odd']);
    // What came out can go in again: the same ids at the same places.
    const again = Solid.fromMesh(
        made.vertices, made.triangles, {attributes: made.attributes, sourceName: 'again'});
    check(again.equals(united));
    const same = again.toMeshWithAttributes({pieces: 'apart'});
    const {faceId} = made.attributes;
    check(same.attributes.faceId.every((id, f) => id === faceId[same.sourceFace[f]]));
    checkEqual(again.withSource(made, 'other').sources(), ['other']);
    checkEqual(again.withSource({...made, attributes: undefined}).sources(), ['']);
  },

  'polygons keep their corners'({Solid}) {
    const points =
        Float64Array.from({length: 24}, (_, i) => (Math.floor(i / 3) >> (2 - i % 3)) & 1);
    const corners = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3];
    const begin = [0, 4, 8, 12, 16, 20, 24], weights = corners.map((_, i) => i);
    const attributes = {
      faceId: [0, 1, 2, 3, none, 5],
      channels: {
        place: {width: 3, values: cornerPlaces(points, corners)},
        weight: {width: 1, values: weights}
      }
    };
    const made =
        Solid.fromPolygons(points, begin, corners, {attributes}).toPolygonsWithAttributes();
    checkEqual([made.corners.length, made.faceBegin.length], [24, 7]);
    const {place, weight} = made.attributes.channels;
    checkEqual(Array.from(place.values), Array.from(cornerPlaces(made.vertices, made.corners)));
    checkEqual(Array.from(weight.values).sort((a, b) => a - b), weights);
    checkEqual(Array.from(made.attributes.faceId).sort((a, b) => a - b), [0, 1, 2, 3, 5, none]);
    checkEqual(
        [made.attributes.materials, made.attributes.faceMaterial, made.attributes.faceGroup],
        [[], null, null]);
  },

  'sources go through maps, and floats are floats'(plumb) {
    const moved = painted(plumb, boxMesh(plumb, 0, 1), 'red').translated(['1/3', 0, 0]);
    const {vertices, triangles, attributes} = moved.toMeshWithAttributes();
    const places = cornerPlaces(vertices, triangles).map((x, i) => x - (i % 3 === 0 ? 1 / 3 : 0));
    check(isSame(attributes.channels.place.values, places, 1e-15), 'the places before the map');
    const floats = moved.toMeshWithAttributes({floats: true}).vertices;
    check(floats.every((x) => x === Math.fround(x)) && floats.includes(Math.fround(1 / 3)));
    failure(plumb, 'USAGE', () => moved.toPolygonsWithAttributes({floats: true}));
    failure(plumb, 'BAD_ARGUMENT', () => moved.toMeshWithAttributes({pieces: 'some'}));
    failure(plumb, 'BAD_ARGUMENT', () => moved.complement().toMeshWithAttributes());
  },

  'only solids with attributes have sources'(plumb) {
    const {Solid} = plumb, {vertices, triangles} = boxMesh(plumb, 0, 2),
          other = boxMesh(plumb, 1, 3);
    const plain = Solid.fromMesh(vertices, triangles);
    const traced =
        Solid.fromMesh(other.vertices, other.triangles, {attributes: {}, sourceName: 'traced'});
    checkEqual([plain.sources(), traced.sources()], [[], ['traced']]);
    checkEqual(Solid.fromMesh(vertices, triangles, {attributes: null}).sources(), []);
    checkEqual(Solid.fromMesh(vertices, triangles, {keep: 'all'}).sources(), ['']);
    const both = plain.union(traced),
          {source, sourceFace, attributes} = both.toMeshWithAttributes();
    checkEqual([...new Set(source)], [0, none]);
    check(source.every((from, f) => (from === none) === (sourceFace[f] === none)));
    checkEqual(attributes, {
      materials: [],
      groups: [],
      faceMaterial: null,
      faceGroup: null,
      faceId: null,
      channels: {}
    });
    checkEqual(Solid.fromBytes(both.toBytes()).sources(), [], 'bytes hold the set alone:');
    const nothing = traced.difference(traced).toMeshWithAttributes();
    checkEqual(
        [nothing.source.length, nothing.isFlipped.length, nothing.triangles.length], [0, 0, 0]);
  },

  'attributes that do not fit are refused'(plumb) {
    const {Solid} = plumb, {vertices, triangles} = boxMesh(plumb, 0, 1);
    const numbers = (width, count) => ({width, values: new Float64Array(width * count)});
    const refused = [
      ['BAD_ARGUMENT', {faceId: new Uint32Array(11)}, /values has 11 .*12 faces/],
      ['BAD_ARGUMENT', {faceId: [-2, ...new Array(11).fill(0)]}, /faceId\[0\] is -2/],
      ['BAD_ARGUMENT', {faceId: new Array(12).fill(0.5)}, /faceId\[0\] is 0.5/],
      ['BAD_ARGUMENT', {faceId: 3}, /faceId must be/],
      ['BAD_INDEX', {faceMaterial: new Uint32Array(12)}, /values\[0\] is 0/],
      ['BAD_INDEX', {groups: ['a'], faceGroup: new Uint32Array(12).fill(1)}, /there are only 1/],
      ['BAD_ARGUMENT', {channels: {a: numbers(1, 12)}}, /12 .*36 corners/],
      ['BAD_ARGUMENT', {channels: {a: {width: 2, values: [1, 2, 3]}}}, /no multiple of 2/],
      ['BAD_ARGUMENT', {channels: {a: numbers(0, 36)}}, /width is 0/],
      ['BAD_ARGUMENT', {channels: {a: [1, 2]}}, /channels\.a must be an object/],
      ['BAD_ARGUMENT', {vertexChannels: {a: numbers(2, 36)}}, /36 .*8 points/],
      ['BAD_ARGUMENT', {channels: {a: numbers(1, 36)}, vertexChannels: {a: numbers(1, 8)}}, /same/],
      ['NOT_FINITE', {channels: {a: {width: 1, values: new Float64Array(36).fill(NaN)}}}, /finite/],
      ['BAD_ARGUMENT', {materials: [{color: [0, 0, 2, 1]}]}, /0 to 1/],
      ['BAD_ARGUMENT', {materials: [{color: [0, 0, 1]}]}, /materials\[0\]\.color.*four/],
      ['BAD_ARGUMENT', {materials: [{color: '#f00'}]}, /materials\[0\]\.color/],
      ['BAD_ARGUMENT', {materials: {}}, /materials must be an array/],
      ['BAD_ARGUMENT', {groups: [1]}, /groups\[0\]/],
      ['BAD_ARGUMENT', 'red', /attributes must be an object/],
    ];
    for (const [code, attributes, text] of refused) {
      const {message} =
          failure(plumb, code, () => Solid.fromMesh(vertices, triangles, {attributes}));
      check(text.test(message), `${text}: ${message}`);
    }
    failure(plumb, 'BAD_ARGUMENT', () => Solid.fromMesh(vertices, triangles, {keep: 'some'}));
  },

  'files keep attributes'(plumb) {
    const {Solid, readMesh, writeMesh, writeMeshFiles, lostAttributes} = plumb;
    const rest = painted(plumb, boxMesh(plumb, 0, 2), 'red')
                     .difference(painted(plumb, boxMesh(plumb, 1, 3), 'blue', 100));
    const made = rest.toMeshWithAttributes(), ids = [...new Set(made.attributes.faceId)].sort();
    const notes = [], ply = rest.write('ply', {onNote: ({text}) => notes.push(text)});
    check(notes.some((text) => text.includes('groups')), 'PLY has ids, and no groups');
    check(lostAttributes(made, 'ply').includes('groups') && lostAttributes(made, 'stl') !== '');
    checkEqual(lostAttributes({...made, attributes: {}}, 'ply'), '');
    for (const keep of ['none', 'colours', 'ids', 'all']) {
      const read = Solid.read(ply, {name: 'a.ply', keep});
      check(read.equals(rest.closure()));
      const {faceId} = read.toMeshWithAttributes().attributes;
      checkEqual(
          faceId === null ? null : [...new Set(faceId)].sort(),
          ['none', 'colours'].includes(keep) ? null : ids, keep);
      checkEqual(read.sources(), keep === 'none' ? [] : ['a.ply']);
    }
    const {'b.obj': obj, 'b.mtl': mtl, ...others} = rest.writeFiles('b.obj');
    checkEqual(Object.keys(others), []);
    check(new TextDecoder().decode(mtl).includes('newmtl blue'));
    const colours = (solid) => {
      const {source, attributes} = solid.toMeshWithAttributes();
      return [...new Set(Array.from(source, (_, f) => {
               const {name, color} = attributes.materials[attributes.faceMaterial[f]];
               return `${name} ${color}`;
             }))].sort();
    };
    const read = Solid.read(obj, {name: 'b.obj', files: {'b.mtl': mtl}, keep: 'all'});
    checkEqual(read.sources(), ['b.obj'], 'names of sources have no folder:');
    checkEqual(colours(read), ['blue 1,0.2,0,1', 'red 1,0.2,0,1']);
    for (const format of ['3mf', 'glb']) {
      const copy = Solid.read(rest.write(format), {name: `c.${format}`, keep: 'colours'});
      checkEqual(
          colours(copy).map((line) => line.replace(/^\S* /, '')).at(-1), '1,0.2,0,1', format);
    }
    const mesh = readMesh(writeMesh(made, 'ply'), {name: 'd.ply', attributes: true});
    checkEqual(Array.from(mesh.attributes.faceId), Array.from(made.attributes.faceId));
    check(readMesh(writeMesh(made, 'ply'), {name: 'd.ply'}).attributes === undefined);
    checkEqual(Object.keys(writeMeshFiles(made, 'e.obj')).sort(), ['e.mtl', 'e.obj']);
    checkEqual(Object.keys(writeMeshFiles({...made, attributes: {}}, 'e.obj')), ['e.obj']);
    checkEqual(Object.keys(rest.writeFiles('f', {format: 'stl-binary'})), ['f']);
    failure(plumb, 'BAD_ARGUMENT', () => rest.writeFiles('../f.obj'));
    failure(plumb, 'BAD_ARGUMENT', () => rest.writeFiles('-', {format: 'off'}));
    failure(plumb, 'UNKNOWN_FORMAT', () => rest.writeFiles('f.xyz'));
  },

  'colours of a mesh that is mended, and of a model'(plumb) {
    const {Solid, readCsg, repairMesh} = plumb, mesh = boxMesh(plumb, 0, 1);
    const turned = mesh.triangles.slice();
    turned.subarray(0, 3).reverse();
    const attributes = {...paintOf(mesh, 'red'), channels: {}};
    const {repair} = repairMesh({vertices: mesh.vertices, triangles: turned});
    check(repair.reorient && repair.doubled === 'keep');
    const mended = Solid.fromMesh(mesh.vertices, turned, {attributes, repair});
    check(mended.volume().equals(1));
    checkEqual([...new Set(mended.toMeshWithAttributes().attributes.faceMaterial)], [0]);
    const model = readCsg('color([1, 0, 0, 1]) { cube(size = 2); }');
    const {faceMaterial, materials} = model.toMeshWithAttributes().attributes;
    check(faceMaterial.every((i) => `${materials[i].color}` === '1,0,0,1'));
  },

  'a repaired mesh keeps its attributes'(plumb) {
    const {repairMesh} = plumb, mesh = boxMesh(plumb, 0, 1), {vertices} = mesh;
    const triangles = mesh.triangles.slice(3);  // Without the first face, and face 2 is flipped.
    triangles.subarray(6, 9).reverse();
    const torn = {vertices, triangles};
    const {mesh: mended} =
        repairMesh({...torn, attributes: paintOf(torn, 'red', 50)}, {fillHoles: 3});
    const {materials, faceMaterial, faceId, faceGroup, channels} = mended.attributes;
    checkEqual(materials.map(({name}) => name), ['red']);
    const old = faceCount(torn);
    check(faceCount(mended) === old + 1);
    checkEqual([...faceMaterial], [...Array(old).fill(0), none]);
    checkEqual([...faceId], [...Array(old).keys()].map((f) => f + 50).concat(none));
    checkEqual([...faceGroup], [...Array(old).keys()].map((f) => f % 2).concat(none));
    checkEqual(
        [...channels.place.values],
        [...cornerPlaces(vertices, mended.triangles.slice(0, 3 * old)), ...Array(9).fill(0)]);
    checkEqual(
        [...channels.height.values].slice(0, 3 * old),
        [...channels.place.values].filter((_, i) => i % 3 === 2).slice(0, 3 * old));
    check(!('attributes' in repairMesh(torn, {fillHoles: 3}).mesh));
  },

  'convex parts keep attributes'(plumb) {
    const {Solid} = plumb, corner = Solid.box([1, 1, -1], [9, 9, 9]);
    const mesh = Solid.box([0, 0, 0], [3, 3, 1]).difference(corner).toMesh();
    const parts = painted(plumb, mesh, 'bent', 50).decompose({closed: true});
    check(parts.length === 2);
    for (const part of parts) {
      checkEqual(part.sources(), ['bent']);
      const {source, sourceFace, attributes} = part.toMeshWithAttributes();
      source.forEach(
          (s, f) => checkEqual(attributes.faceId[f], s === none ? none : sourceFace[f] + 50));
      checkEqual(source.filter((s) => s === none).length, 2);
    }
  },

  'half-spaces give their cuts attributes'(plumb) {
    const {Solid} = plumb, body = painted(plumb, boxMesh(plumb, 0, 2), 'wood');
    const source = {name: 'saw', material: {name: 'end grain'}, group: 'cuts', id: 77};
    const cut = body.intersection(Solid.halfSpace([0, 0, 1, -1], {closed: false, source}));
    checkEqual(cut.sources(), ['wood', 'saw']);
    const {vertices, triangles, source: from, attributes} = cut.toMeshWithAttributes();
    const {materials, faceMaterial, groups, faceGroup, faceId} = attributes;
    let cuts = 0;
    from.forEach((s, f) => {
      const corners = [...triangles.slice(3 * f, 3 * f + 3)];
      checkEqual(s === 1, corners.every((v) => vertices[3 * v + 2] === 1));
      if (s !== 1) return;
      ++cuts;
      checkEqual(
          [materials[faceMaterial[f]].name, groups[faceGroup[f]], faceId[f]],
          ['end grain', 'cuts', 77]);
    });
    checkEqual(cuts, 6);  // The diagonals of the sides, which have channels, end on the cut.
    checkEqual(Solid.halfSpace([0, 0, 1, -1], {source: {}}).sources(), ['']);
    checkEqual(Solid.halfSpace([0, 0, 1, -1]).sources(), []);
    failure(plumb, 'BAD_ARGUMENT', () => Solid.halfSpace([0, 0, 1, -1], {source: 'saw'}));
    failure(plumb, 'BAD_ARGUMENT', () => Solid.halfSpace([0, 0, 1, -1], {source: {id: -1}}));
  },

  'fewer corners of plane sets'(plumb) {
    const {PlaneSet} = plumb, square = PlaneSet.box([0, 0], [8, 8]);
    const toothed = PlaneSet.polygon([[0, 0], [8, 0], [8, 8], [5, 8], [4, '17/2'], [3, 8], [0, 8]]);
    check(toothed.simplified({tolerance: 0.5}).equals(square));
    const {set, report} = toothed.simplifiedWithReport({tolerance: 0.5});
    check(set.equals(square) && report.bordersMoved >= 0.5 && report.bordersMoved < 1);
    checkEqual([report.cornersBefore, report.cornersAfter], [7, 4]);
    check(toothed.simplified({tolerance: 0.5, within: 0.25}).equals(toothed));
    check(toothed.simplified({tolerance: 0}).equals(toothed));
    check(toothed.simplified({kept: 1}).equals(toothed));
    const disk = PlaneSet.disk(10, 200), within = 0.1, rough = disk.simplified({within});
    check(rough.counts().vertices < 60, 'fewer corners');
    check(
        disk.isSubsetOf(rough.offset(1.01 * within)) &&
        rough.isSubsetOf(disk.offset(1.01 * within)));
    failure(plumb, 'BAD_ARGUMENT', () => toothed.simplified({tolerance: -1}));
    failure(plumb, 'BAD_ARGUMENT', () => toothed.complement().simplified());
  },

  'the arithmetic is tested'({selfTest}) {
    const {isOk, notes} = selfTest();
    check(isOk && notes.every(({isWarning}) => !isWarning), JSON.stringify(notes));
  },
};
