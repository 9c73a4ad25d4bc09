// What is tested in Node and in a browser alike: functions that take the package and fail by
// exceptions. Expected answers come from laws of sets, or from computations with BigInt that share
// no code with the engine.

export function check(condition, message = 'a condition does not hold') {
  if (!condition) throw new Error(message);
}

export function checkEqual(actual, expected, message = '') {
  const shown = (value) => JSON.stringify(value, (_, v) => (typeof v === 'bigint' ? `${v}n` : v));
  if (shown(actual) !== shown(expected))
    throw new Error(`${message} expected ${shown(expected)}, found ${shown(actual)}`);
}

/** Runs what has to throw a PlumbError with a code, and returns the error. */
export function failure(plumb, code, body) {
  try {
    body();
  } catch (error) {
    check(error instanceof plumb.PlumbError, `no PlumbError but ${error}`);
    checkEqual(error.code, code, error.message);
    return error;
  }
  throw new Error(`nothing failed; ${code} should have`);
}

/** Numbers from 0 to 1 that are the same in every run. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

// ---- oracles

/** Exact sums of integers and fractions, without reducing them. */
const add = ([a, b], [c, d]) => [a * d + c * b, b * d];
const sameFraction = (fraction, [p, q]) => fraction.numerator * q === p * fraction.denominator;

/** Six times the volume inside a mesh of integer coordinates. */
function sixVolumes({vertices, triangles}) {
  const corner = (i) => [0, 1, 2].map((axis) => BigInt(vertices[3 * i + axis]));
  let sum = 0n;
  for (let t = 0; t < triangles.length; t += 3) {
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] =
        [0, 1, 2].map((k) => corner(triangles[t + k]));
    sum += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
  }
  return sum;
}

/** Twice the area of a ring of integer points. */
function twoAreas(ring) {
  return ring.reduce((sum, [x, y], i) => {
    const [u, v] = ring[(i + 1) % ring.length];
    return sum + BigInt(x) * BigInt(v) - BigInt(y) * BigInt(u);
  }, 0n);
}

/** A closed chain around the origin through integer points, by angle. */
function star(random, corners) {
  return Array.from({length: corners}, (_, i) => {
    const angle = (2 * Math.PI * (i + 0.8 * random())) / corners, radius = 100 + 900 * random();
    return [Math.round(radius * Math.cos(angle)), Math.round(radius * Math.sin(angle))];
  });
}

function boxAt(plumb, random) {
  const low = [0, 1, 2].map(() => Math.floor(8 * random())),
        size = [0, 1, 2].map(() => 1 + Math.floor(5 * random()));
  return {
    solid: plumb.Solid.box(low, low.map((x, i) => x + size[i])),
    low,
    high: low.map((x, i) => x + size[i])
  };
}

const tetrahedron = {
  vertices: new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
  triangles: new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]),
};

// ---- cases

export const cases = {
  'two cubes: the volume of their union is exact'({Solid, Fraction}) {
    const a = Solid.box([0, 0, 0], [1, 1, 1]),
          b = Solid.box(['1/3', '1/3', '1/3'], ['4/3', '4/3', '4/3']);
    check(a.union(b).volume().equals(new Fraction(2n * 27n - 8n, 27n)));
    check(Solid.unionOf([a, b]).equals(b.union(a)));
  },

  'laws of sets of space'({Solid}) {
    const random = randomNumbers(1);
    for (let round = 0; round < 6; ++round) {
      const [a, b, c] = [0, 1, 2].map(() => boxAt({Solid}, random).solid);
      const p = round % 2 === 0 ? a : a.interior(), q = b;
      check(
          p.union(q).complement().equals(p.complement().intersection(q.complement())), 'De Morgan');
      check(p.difference(q).equals(p.intersection(q.complement())), 'difference');
      check(
          p.symmetricDifference(q).equals(p.union(q).difference(p.intersection(q))),
          'symmetric difference');
      check(
          p.intersection(q.union(c)).equals(p.intersection(q).union(p.intersection(c))),
          'distributivity');
      check(p.boundary().equals(p.closure().difference(p.interior())), 'boundary');
      check(p.exterior().equals(p.complement().interior()), 'exterior');
      check(p.regularization().equals(p.interior().closure()), 'regularization');
      check(p.intersection(q).isSubsetOf(p) && p.isSubsetOf(p.union(q)), 'inclusion');
      check(p.union(q).audit() === null, 'audit');
      const volumes = [p.union(q), p.intersection(q), p, q].map((set) => set.volume());
      const [either, both, first, second] =
          volumes.map(({numerator, denominator}) => [numerator, denominator]);
      const left = add(either, both), right = add(first, second);
      check(left[0] * right[1] === right[0] * left[1], 'volumes add up');
      check(
          Solid.evaluate('(A + B) * !C', {A: p, B: q, C: c}).equals(p.union(q).difference(c)),
          'expression');
      check(Solid.evaluate('A @ B', {A: p, B: q}).equals(p.minkowskiSum(q)), 'sum in expression');
    }
    check(Solid.empty().isEmpty() && Solid.whole().isWhole() && Solid.whole().volume() === null);
    check(Solid.unionOf([]).isEmpty() && Solid.intersectionOf([]).isWhole());
  },

  'laws of sets of the plane and of the sphere'({PlaneSet, SphereSet}) {
    const random = randomNumbers(2);
    for (let round = 0; round < 8; ++round) {
      const a = PlaneSet.polygon(star(random, 9)),
            b = PlaneSet.polygon(star(random, 7), {closed: false}).translated([200, '1/7']);
      check(
          a.union(b).complement().equals(a.complement().intersection(b.complement())), 'De Morgan');
      check(a.difference(b).union(a.intersection(b)).equals(a), 'parts');
      check(
          a.symmetricDifference(b).equals(a.union(b).difference(a.intersection(b))),
          'symmetric difference');
      check(PlaneSet.fromBytes(a.union(b).toBytes()).equals(a.union(b)), 'bytes');
      const vector = () => [0, 1, 2].map(() => Math.round(9 * random()) - 4.5);
      const p = SphereSet.halfSpheres([vector(), vector()]),
            q = SphereSet.halfSphere(vector(), {closed: false});
      check(
          p.union(q).complement().equals(p.complement().intersection(q.complement())),
          'De Morgan on the sphere');
      check(p.difference(q).union(p.intersection(q)).equals(p), 'parts on the sphere');
    }
  },

  'volumes and areas are those of the arrays'({Solid, PlaneSet, Fraction}) {
    const random = randomNumbers(3);
    for (let round = 0; round < 8; ++round) {
      const ring = star(random, 5 + round), expected = twoAreas(ring);
      const set = PlaneSet.polygon(ring);
      check(sameFraction(set.area(), [expected, 2n]), 'area');
      check(sameFraction(set.extruded(3).volume(), [3n * expected, 2n]), 'prism');
      check(set.extruded(3).slice(1).equals(set), 'slice');
      check(set.extruded(3).shadow().equals(set), 'shadow');
      const {solid, low, high} = boxAt({Solid}, random);
      const other = boxAt({Solid}, random).solid;
      const mesh = solid.difference(other).regularization().toMesh();
      check(
          sameFraction(solid.difference(other).volume(), [sixVolumes(mesh), 6n]),
          'volume of the mesh');
      check(
          Solid.fromMesh(mesh.vertices, mesh.triangles)
              .equals(solid.difference(other).regularization()),
          'mesh back to solid');
      checkEqual(
          solid.boundingBox(),
          {low: low.map((x) => new Fraction(x)), high: high.map((x) => new Fraction(x))});
    }
  },

  'points are inside where the half-spaces say so'({Solid, PlaneSet}) {
    const random = randomNumbers(4);
    const planes = Array.from(
        {length: 12},
        () => [random() - 0.5, random() - 0.5, random() - 0.5, -0.2 - 0.2 * random()]);
    const solid = Solid.halfSpaces(planes.flat()), box = Solid.box([-2, -2, -2], [2, 2, 2]);
    const points =
        Float64Array.from({length: 3 * 400}, () => Math.round(64 * (3 * random() - 1.5)) / 64);
    const inside = solid.intersection(box).containsPoints(points);
    const grid = 2n ** 60n;  // All factors are multiples of 2^-60, so that signs are exact.
    const whole = (x) => BigInt(Math.round(x * 2 ** 30)) * 2n ** 30n +
        BigInt(Math.round((x * 2 ** 30 - Math.round(x * 2 ** 30)) * 2 ** 30));
    let count = 0;
    for (let i = 0; i < 400; ++i) {
      const p = points.subarray(3 * i, 3 * i + 3);
      const expected = planes.every(
          ([a, b, c, d]) => whole(a) * whole(p[0]) + whole(b) * whole(p[1]) +
                  whole(c) * whole(p[2]) + whole(d) * grid <=
              0n);
      checkEqual(inside[i], expected ? 1 : 0, `point ${p}:`);
      count += expected ? 1 : 0;
    }
    check(count > 10 && count < 390, 'the points do not test anything');
    const set = PlaneSet.box([0, 0], [1, 1]);
    checkEqual(Array.from(set.containsPoints([0, 0, 1, 0.5, 2, 0])), [1, 1, 0]);
    check(!set.interior().contains([0, '1/2']) && set.interior().contains(['1e-300', '1/2']));
  },

  'rays and cells'({Solid}) {
    const box = Solid.box([0, 0, 0], ['1/3', 1, 1]);
    const hit = box.shoot([-1, 0.5, 0.5], [1, 0, 0]);
    checkEqual(
        [hit.cell.kind, hit.cell.isInside, hit.point.map(String)],
        ['facet', true, ['0', '1/2', '1/2']]);
    check(box.interior().shootToBoundary([-1, 0.5, 0.5], [1, 0, 0]).cell.isInside === false);
    check(box.shoot([-1, 5, 5], [1, 0, 0]) === null);
    checkEqual(
        [[0, 0, 0], [0, 0, '1/2'], [0, 0.5, 0.5], ['1/6', 0.5, 0.5]].map(
            (point) => box.locate(point).kind),
        ['vertex', 'edge', 'facet', 'volume']);
  },

  'files of solids hold them'({Solid, readMesh}) {
    const solid = Solid.box([0, 0, 0], [4, 4, 2])
                      .difference(Solid.box([1, 1, -1], [3, 3, 3]))
                      .regularization();
    for (const format
             of ['off', 'obj', 'stl', 'stl-binary', 'ply', 'ply-text', 'glb', '3mf', 'nef']) {
      const bytes = solid.write(format);
      check(bytes.length > 100, format);
      check(
          Solid.read(bytes, {name: `a.${format.split('-')[0]}`}).equals(solid),
          `${format} by its name`);
      if (format !== 'nef')
        check(readMesh(bytes, {name: `a.${format.split('-')[0]}`}).vertices.length > 0, format);
    }
    check(Solid.fromBytes(solid.toBytes()).equals(solid));
    const half = Solid.halfSpace([1, 2, 3, '1/3'], {closed: false});
    check(Solid.fromBytes(half.toBytes()).equals(half), 'an unbounded set');
    const halves = Solid.readHalfSpaces('1 0 0 -1 closed\n-1 0 0 0 open\n');
    check(halves.equals(Solid.halfSpace([1, 0, 0, -1])
                            .intersection(Solid.halfSpace([-1, 0, 0, 0], {closed: false}))));
  },

  'files of plane sets hold them'({PlaneSet}) {
    const set = PlaneSet.box([0, 0], [4, 4]).difference(PlaneSet.box([1, 1], [2, 3])).closure();
    for (const format of ['wkt', 'wkb', 'geojson', 'nef2']) {
      check(PlaneSet.read(set.write(format), {name: `a.${format}`}).equals(set), format);
      check(PlaneSet.read(set.write(format)).equals(set), `${format} by its content`);
    }
    check(
        PlaneSet.read(set.toWkt()).equals(set) &&
        PlaneSet.read(JSON.stringify(set.toGeoJson())).equals(set));
    check(PlaneSet.read(set.write('dxf'), {name: 'a.dxf'}).equals(set), 'dxf');
    check(
        PlaneSet.read('POLYGON((0 0,0.1 0,0 0.1,0 0))', {exactDecimals: true}).area().toString() ===
        '1/200');
  },

  'glTF with a file beside it'({Solid}) {
    const glb = Solid.box([0, 0, 0], [1, 2, 3]).write('glb');
    const view = new DataView(glb.buffer), length = view.getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
    json.buffers[0].uri = 'box.bin';
    const solid = Solid.read(
        JSON.stringify(json),
        {name: 'box.gltf', files: {'box.bin': glb.subarray(20 + length + 8)}});
    checkEqual(solid.volume().toString(), '6');
  },

  'pictures and pages'({Solid, PlaneSet}) {
    const ball = Solid.ball(1, 2), disk = PlaneSet.disk(1, 12);
    check(ball.toHtml({title: 'A ball'}).includes('A ball') && disk.toHtml().startsWith('<!'));
    const png = ball.draw('png');
    checkEqual(Array.from(png.subarray(1, 4)), [80, 78, 71]);
    check(new TextDecoder().decode(disk.draw('svg')).includes('<svg'));
    check(Solid.drawMany([ball, ball.translated([3, 0, 0])], 'glb').length > 1000);
  },

  'errors have a code and a place'(plumb) {
    const {Solid, PlaneSet, Map, Fraction} = plumb;
    const text = 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n';
    const error = failure(plumb, 'SYNTAX', () => Solid.read(text, {name: 'bad.off'}));
    checkEqual([error.file, error.line, error.column], ['bad.off', 5, 3]);
    check(error.message.startsWith('bad.off:5:3: ') && error.message.endsWith(error.reason));
    const map =
        failure(plumb, 'SYNTAX', () => Map.read('3 1\n0 0\nx 0\n0 1\n1 2 3\n', {name: 'bad.map'}));
    check(map.file === 'bad.map' && map.line === 3 && !map.message.includes('/'), map.message);
    failure(
        plumb, 'NOT_FINITE',
        () => Solid.fromMesh(tetrahedron.vertices.map(() => NaN), tetrahedron.triangles));
    failure(plumb, 'NOT_FINITE', () => Solid.box([0, 0, 0], [1, 1, Infinity]));
    failure(plumb, 'BAD_INDEX', () => Solid.fromMesh(tetrahedron.vertices, [0, 1, 9]));
    failure(
        plumb, 'BAD_SHAPE',
        () => Solid.fromMesh(tetrahedron.vertices, tetrahedron.triangles.subarray(3)));
    failure(plumb, 'UNKNOWN_FORMAT', () => Solid.empty().write('step'));
    failure(plumb, 'BAD_ARGUMENT', () => Solid.whole().toMesh());
    for (const wrong
             of [() => new Solid(),
                () => Solid.empty().union(PlaneSet.empty()),
                () => Solid.empty().union(null),
                () => Solid.box([0, 0], [1, 1, 1]),
                () => Solid.fromMesh([0, 0, 0, 1], []),
                () => Solid.fromMesh(tetrahedron.vertices, [0, 1.5, 2]),
                () => Solid.ball('x'),
                () => Solid.fromMesh(tetrahedron.vertices, [0, -1, 2]),
                () => Solid.fromMesh(7, []),
                () => Solid.read(7),
                () => Solid.unionOf(7),
                () => Solid.empty().transformed([[1, 0, 0, 0]]),
                () => Fraction.from({}),
                () => new Fraction(1, 0),
                () => PlaneSet.disk(1, -1),
                () => Solid.read('', {files: {'../a': ''}, name: 'b'}),
                () => Solid.empty().decompose({method: 'none'}),
                () => Solid.empty().union(Solid.empty(), {signal: 7}),
    ])
      failure(plumb, 'BAD_ARGUMENT', wrong);
    failure(plumb, 'SYNTAX', () => Fraction.from('1/2/3'));
  },

  'what was disposed of cannot be used'(plumb) {
    const {Solid} = plumb;
    const solid = Solid.box([0, 0, 0], [1, 1, 1]), other = solid.copy();
    solid.dispose();
    solid.dispose();
    check(solid.isDisposed && !other.isDisposed && other.volume().equals(1));
    failure(plumb, 'BAD_ARGUMENT', () => solid.volume());
    failure(plumb, 'BAD_ARGUMENT', () => other.union(solid));
    if (Symbol.dispose) {
      other[Symbol.dispose]();
      check(other.isDisposed);
    }
  },

  'limits, progress and signals'(plumb) {
    const {Solid} = plumb;
    const ball = Solid.ball(1, 6).rotated([1, 2, 3], 10), other = ball.rotated([3, 1, 2], 20);
    failure(plumb, 'RESOURCE_LIMIT', () => ball.union(other, {memoryLimit: 1000}));
    failure(plumb, 'RESOURCE_LIMIT', () => ball.minkowskiSum(other, {timeout: 1e-6}));
    const phases = [];
    const sum = ball.union(
        other,
        {onProgress: (phase, done, total) => phases.push([phase, done <= total || total === 0])});
    check(
        sum.isSubsetOf(Solid.unionOf([ball, other])), 'the result does not depend on the callback');
    check(
        phases.length > 0 && phases.every(([phase, isInOrder]) => phase.length > 0 && isInOrder),
        'progress');
    const reason = new RangeError('enough');
    let thrown = null;
    try {
      ball.union(other, {
        onProgress: () => {
          throw reason;
        }
      });
    } catch (error) {
      thrown = error;
    }
    check(thrown === reason, 'an exception of the callback is thrown by the operation');
    const controller = new AbortController();
    try {
      ball.union(other, {signal: controller.signal, onProgress: () => controller.abort(reason)});
      thrown = null;
    } catch (error) {
      thrown = error;
    }
    check(thrown === reason, 'a signal stops the operation');
    check(ball.union(other).equals(sum), 'the next operation is whole');
  },

  'convex parts and Minkowski sums'({Solid, PlaneSet}) {
    const bent = Solid.box([0, 0, 0], [3, 3, 1]).difference(Solid.box([1, 1, -1], [9, 9, 9], {
      closed: false
    }));
    const parts = bent.decompose();
    check(
        parts.length === 2 && Solid.unionOf(parts).equals(bent) &&
        parts[0].intersection(parts[1]).isEmpty());
    check(bent.decompose({closed: true}).every((part) => part.isConvex() && part.isClosed()));
    check(!bent.convexity().isConvex && bent.convexity().reflexEdges === 1);
    const sum =
        Solid.box([0, 0, 0], [1, 2, 3]).minkowskiSum(Solid.box([-1, -1, -1], ['1/2', 0, 0]));
    check(sum.equals(Solid.box([-1, -1, -1], ['3/2', 2, 3])));
    check(sum.minkowskiErosion(Solid.box([-1, -1, -1], ['1/2', 0, 0]))
              .equals(Solid.box([0, 0, 0], [1, 2, 3])));
    const ring =
        PlaneSet.box([0, 0], [6, 6]).difference(PlaneSet.box([2, 2], [4, 4], {closed: false}));
    const bend = PlaneSet.polygon([[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]]),
          best = bend.decompose({method: 'optimal', closed: true});
    check(best.length === 2 && PlaneSet.unionOf(best).equals(bend));
    check(PlaneSet.unionOf(ring.decompose()).equals(ring));
    check(ring.minkowskiSum(PlaneSet.box([0, 0], [1, 1])).area().equals(49 - 1));
  },

  'distances are those of boxes'(plumb) {
    const {Solid, PlaneSet} = plumb, random = randomNumbers(5);
    const gap = (a, b, i) => BigInt(Math.max(0, a.low[i] - b.high[i], b.low[i] - a.high[i]));
    let apart = 0;
    for (let round = 0; round < 20; ++round) {
      const [a, b] = [boxAt(plumb, random), boxAt(plumb, random)];
      const p = a.solid.interior(), found = p.distance(b.solid);
      const expected = [0, 1, 2].reduce((sum, i) => sum + gap(a, b, i) ** 2n, 0n);
      check(found.squared.equals(expected), 'of solids');
      check(p.closure().contains(found.points[0]) && b.solid.contains(found.points[1]), 'points');
      checkEqual(p.locate(found.points[0]).index, found.cells[0].index, 'the first cell:');
      checkEqual(b.solid.locate(found.points[1]), found.cells[1], 'the second cell:');
      const flat = ({low, high}) => PlaneSet.box(low.slice(0, 2), high.slice(0, 2));
      const inPlane = flat(a).distance(flat(b));
      check(inPlane.squared.equals(gap(a, b, 0) ** 2n + gap(a, b, 1) ** 2n), 'of plane sets');
      check(flat(a).contains(inPlane.points[0]) && flat(b).contains(inPlane.points[1]));
      apart += expected > 0n ? 1 : 0;
    }
    check(apart > 3 && apart < 20, 'the boxes do not test anything');
    failure(plumb, 'BAD_ARGUMENT', () => Solid.whole().distance(Solid.empty()));
    failure(plumb, 'BAD_ARGUMENT', () => PlaneSet.empty().distance(PlaneSet.whole()));
    failure(plumb, 'BAD_ARGUMENT', () => Solid.whole().distance(PlaneSet.whole()));
  },

  'offsets of solids are sums with a ball'(plumb) {
    const {Solid} = plumb, box = Solid.box([0, 0, 0], [4, 5, 6]);
    for (const rounds of [0, 2]) {
      const ball = Solid.ball(1, rounds);
      check(box.offset(1, {rounds}).equals(box.minkowskiSum(ball)), 'grown');
      check(box.offset(-1, {rounds}).equals(box.minkowskiErosion(ball)), 'shrunk');
    }
    check(box.offset(-1).equals(Solid.box([1, 1, 1], [3, 4, 5])), 'faces move by the distance');
    failure(plumb, 'BAD_ARGUMENT', () => box.offset(1, {rounds: 8}));
    failure(plumb, 'NOT_FINITE', () => box.offset(NaN));
  },

  'models'({Solid, PlaneSet, readCsg}) {
    const plate = PlaneSet.box([0, 0], [40, 20]).offset(2, {circleSegments: 32});
    const holes = PlaneSet.unionOf([8, 32].map((x) => PlaneSet.disk(3).translated([x, 10])));
    const bracket = plate.difference(holes).extruded(5);
    check(bracket.genus() === 2 && bracket.components().length === 1);
    check(bracket.slice('1/3').equals(plate.difference(holes).closure()));
    check(
        bracket.rotated([1, 1, 0], 30).volume().equals(bracket.volume()),
        'rotations are exactly orthogonal');
    check(bracket.mirrored([1, 2, 3]).mirrored([1, 2, 3]).equals(bracket));
    check(bracket.scaled('1/3').volume().equals(
        `${bracket.volume().numerator}/${bracket.volume().denominator * 27n}`));
    check(bracket.isSubsetOf(bracket.convexHull()) && bracket.convexHull().isConvex());
    check(
        Solid.torus(3, 1).genus() === 1 && Solid.cylinder(2, 1, {topRadius: 0}).isConvex() &&
        Solid.sphere(2, 12).isConvex());
    const resized = bracket.resized([10, 0, 0], {automatic: [false, true, true]}).boundingBox();
    check(
        resized.high[0].numerator * resized.low[0].denominator -
                resized.low[0].numerator * resized.high[0].denominator ===
            10n * resized.high[0].denominator * resized.low[0].denominator,
        'resized');
    checkEqual(
        readCsg('difference() { cube(size = 2); cube(size = 1); }').volume().toString(), '7');
    check(readCsg('square(size = 2);').area().equals(4) && readCsg('group();') === null);
    const part = Solid.box([0, 0, 0], [2, 2, 2]).section([0, 0, 1, -1]);
    check(part.equals(Solid.box([0, 0, 0], [2, 2, 1])));
  },

  'maps'({Map, PlaneSet, overlay}) {
    const points = [[0, 0], [2, 0], [2, 2], [0, 2]];
    const report = Map.fromCycles(points, [[0, 1, 2, 3], [3, 2, 1, 0]]).check();
    check(
        report.isValid && report.verdict === 'valid' &&
        report.select([1]).equals(PlaneSet.box([0, 0], [2, 2])));
    const {origin, next, face, faceCount} = report.dcel();
    check(origin.length === 8 && faceCount === 2 && next.every((h, i) => face[h] === face[i]));
    const moved =
        Map.fromCycles(points.map(([x, y]) => [x + 1, y]), [[0, 1, 2, 3]]).check({outer: 'infer'});
    const found = overlay(report, moved);
    checkEqual(found.areas().map(String).sort(), ['0', '2', '2', '2']);
    check(found.regions().length === 4 && found.dcel().faceCount === 4);
    const crossing = Map.fromCycles([[0, 0], [3, 3], [3, 0], [0, 1]], [[0, 1, 2, 3]]).check();
    const defects = crossing.defects().filter(({kind}) => kind === 'crossing');
    checkEqual(
        [defects.length, defects[0].point.map(String), crossing.counts().defects.crossing],
        [1, ['3/4', '3/4'], 1]);
    check(
        crossing.toString().includes('3/4') && crossing.toHtml().startsWith('<!') &&
        defects[0].hint.length > 10);
    const copy = Map.read(report.map().write(), {name: 'copy.map'});
    checkEqual([copy.cycles(), Array.from(copy.points())], [report.map().cycles(), points.flat()]);
  },

  'layers'({Layer, PlaneSet}) {
    const square = (x) => ({
      type: 'Feature',
      properties: {x},
      geometry: {type: 'Polygon', coordinates: [[[x, 0], [x + 4, 0], [x + 4, 4], [x, 4], [x, 0]]]},
    });
    const layer = Layer.read({type: 'FeatureCollection', features: [square(0), square(3)]});
    check(layer.check().hasDefects && layer.featureCount === 2);
    const {layer: repaired, report} = layer.repaired({owner: 'first'});
    checkEqual(
        report.regions.map(({kind, area, features, owner}) => [kind, `${area}`, features, owner]),
        [['overlap', '4', [0, 1], 0]]);
    check(!repaired.check().hasDefects);
    checkEqual(repaired.properties(), [{x: 0}, {x: 3}]);
    checkEqual(repaired.dissolved([0, 0]).featureCount, 1);
    const {layer: pieces, pairs} = layer.overlaid(
        Layer.read({type: 'FeatureCollection', features: [square(2)]}), {pairs: 'both'});
    checkEqual([pieces.featureCount, pairs], [2, [[0, 0], [1, 0]]]);
    checkEqual(Layer.voronoi([1, 1, 3, 1, 2, 3], [0, 0, 4, 4]).featureCount, 3);
    check(layer.simplified({tolerance: 0}).toGeoJson().features.length === 2);
    const {layer: same, report: told} = layer.simplifiedWithReport({within: 1e-9});
    checkEqual([same.featureCount, told.overlaps], [2, 1]);
    check(told.bordersMoved <= 1e-9);
    checkEqual(layer.joined(layer).featureCount, 4);
    checkEqual(layer.parts(PlaneSet.box([2, 0], [20, 4])).properties(), [{x: 0}, {x: 3}, null]);
  },

  'layers: the options of a repair'(plumb) {
    const {Layer} = plumb;
    const square = (id, name, from, to) => ({
      type: 'Feature',
      id,
      properties: {name},
      geometry: {
        type: 'Polygon',
        coordinates: [[[from, 0], [to, 0], [to, 4], [from, 4], [from, 0]]],
      },
    });
    // A slit that opens to the outside at both ends.
    const layer = Layer.read({
      type: 'FeatureCollection',
      features: [square(9, 'west', 0, 4), square(2, 'east', 4.0625, 8)],
    });
    const owner = (options) => {
      const {layer: made, report} = layer.repaired({gapsBelow: 0.25, ...options});
      check(!made.check({gapsBelow: 0.25}).hasDefects);
      checkEqual(report.regions.map(({kind, isOpen}) => [kind, isOpen]), [['gap', true]]);
      return report.regions[0].owner;
    };
    checkEqual([owner({owner: 'first'}), owner({owner: 'lowest id'})], [0, 1]);
    checkEqual(owner({owner: 'first', ranks: [1, 0]}), 1);
    checkEqual(owner({preferences: [[1, 0]]}), 1);
    checkEqual(owner({preferences: [['east', '9']]}), 1);
    checkEqual([layer.find('east'), layer.find('9')], [1, 0]);
    check(layer.check({gapsBelow: 0.25}).regions[0].isOpen);
    for (const found
             of [layer.check({gapsBelow: 0.25, enclosedOnly: true}),
                 layer.repaired({gapsBelow: 0.25, enclosedOnly: true}).report])
      checkEqual([found.hasDefects, found.regions.length], [false, 0]);
    for (const wrong
             of [{ranks: [1, 0]}, {owner: 'first', ranks: [0]}, {preferences: [[0, 2]]},
                 {preferences: [['north', 0]]}, {preferences: [0, 1]}])
      failure(plumb, 'BAD_ARGUMENT', () => layer.repaired(wrong));
  },

  'layers: crossings and coordinate reference systems'({Layer}) {
    const crs = {type: 'name', properties: {name: 'EPSG:2056'}};
    const coordinates = [[[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]]];
    const layer = Layer.read({
      type: 'FeatureCollection',
      crs,
      features: [{type: 'Feature', properties: null, geometry: {type: 'Polygon', coordinates}}],
    });
    const {layer: repaired, report} = layer.repaired();
    checkEqual(
        report.regions.map(({kind, features, owner, at}) => [kind, features, owner, at]),
        [['crossing', [0], null, [1, 1]]]);
    check(report.hasDefects && !repaired.check().hasDefects);
    for (const made of [layer, repaired, repaired.dissolved([0]), repaired.overlaid(layer).layer])
      checkEqual([made.crs, made.toGeoJson().crs], [crs.properties.name, crs]);
    checkEqual(Layer.read('POLYGON((0 0,1 0,0 1,0 0))').crs, '');
  },

  'meshes: check and repair'({checkMesh, repairMesh, readMesh, writeMesh, delaunay}) {
    const open = {vertices: tetrahedron.vertices, triangles: tetrahedron.triangles.subarray(3)};
    const report = checkMesh(open);
    check(!report.isClosed && report.borders.length === 1 && report.borders[0].length === 3);
    check(checkMesh(tetrahedron).isClosed);
    const repaired = repairMesh(open, {fillHoles: 3});
    check(
        repaired.report.filled === 1 && repaired.report.isClosed &&
        checkMesh(repaired.mesh).isClosed);
    check(repairMesh(open).report.isClosed);
    const back = readMesh(writeMesh(tetrahedron, 'ply'), {name: 'a.ply'});
    checkEqual(
        [Array.from(back.vertices), Array.from(back.triangles)],
        [Array.from(tetrahedron.vertices), Array.from(tetrahedron.triangles)]);
    checkEqual(delaunay([0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5]).length, 12);
  },

  'surfaces'({Scene, Solid}) {
    const {vertices, triangles} = Solid.ball(1, 3).toMesh();
    const scene = Scene.fromMesh(vertices, triangles);
    const corners = [0, 40, 90].map((face) => scene.addPoint(face, ['1/3', '1/3']));
    check(scene.addPolygon(corners) === 0 && scene.polygonCount === 1);
    scene.setOutside(200);
    const path = scene.geodesic(corners[0], corners[1]);
    check(path.points.length === 3 * (path.faces.length + 1));
    const shortest = scene.geodesic(corners[0], corners[1], {shortest: true});
    check(shortest.length > 0 && shortest.length <= path.length * (1 + 1e-12));
    const division = scene.divide();
    const {cells, shapes} = division.counts();
    check(cells === 2 && shapes === 1 && division.audit() === null);
    let area = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] =
          [0, 1, 2].map((k) => vertices.subarray(3 * triangles[i + k], 3 * triangles[i + k] + 3));
      const u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
      area += Math.hypot(
                  u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) /
          2;
    }
    check(Math.abs(division.area(0) + division.area(1) - area) < 1e-9 * area, 'areas of cells');
    const cap = division.select('A');
    check(cap.cellCount === 1 && cap.loopCount === 1 && (cap.has(0) !== cap.has(1)));
    check(
        division.toMesh().cells.length * 3 === division.toMesh().triangles.length &&
        cap.toScene().polygonCount === 1);
    check(division.toHtml().startsWith('<!'));
  },

  'plane sets: shapes, rounding, triangles'({PlaneSet}) {
    const set = PlaneSet.polygon([[0, 0], [1, 0], ['1/3', '1/3']]);
    const {set: rounded, report} = set.rounded();
    check(
        report.verticesMoved === 0 && rounded.contains([1 / 3, 1 / 3]) &&
        report.largestMove < 1e-15);
    const grid = set.rounded({step: '1/4'}).set.shapes();
    check(
        Array.from(grid.points).every((x) => Number.isInteger(4 * x)) &&
        grid.polygonBegin.length === 2);
    const {triangles, vertices} =
        PlaneSet.box([0, 0], [3, 3]).difference(PlaneSet.box([1, 1], [2, 2])).triangulated();
    checkEqual(
        sixVolumes({vertices: vertices.map((x, i) => (i % 3 === 2 ? 1 : x)), triangles}).toString(),
        `${2n * 8n}`);
    check(
        PlaneSet.polygons([[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [2, 1], [2, 2], [1, 2]]])
            .area()
            .equals(15),
        'odd winding numbers');
    check(PlaneSet.hull(new Float64Array([0, 0, 2, 0, 1, 1, 2, 2, 0, 2]))
              .equals(PlaneSet.box([0, 0], [2, 2])));
    check(
        PlaneSet.polyline([[0, 0], [2, 2]]).contains([1, 1]) &&
        PlaneSet.line([1, -1, 0]).contains(['1/7', '1/7']));
  },

  'fractions'({Fraction}) {
    const random = randomNumbers(5);
    for (let i = 0; i < 3000; ++i) {
      const exponent = Math.floor(2140 * random()) - 1074;
      const x = (random() + random() * 2 ** -32) * 2 ** Math.min(exponent, 1023);
      check(Fraction.from(x).toNumber() === x && Fraction.from(-x).toNumber() === -x, `${x}`);
    }
    for (const x of [5e-324, 2 ** -1022, Number.MAX_VALUE, 1 / 3, 0.1, 1e22, 2 ** 53 + 2])
      check(Fraction.from(x).toNumber() === x, `${x}`);
    // A decimal text is rounded correctly by the language.
    for (let i = 0; i < 2000; ++i) {
      const text = `${Math.floor(1e9 * random())}.${Math.floor(1e9 * random())}e${
          Math.floor(660 * random()) - 340}`;
      check(Fraction.from(text).toNumber() === Number(text), text);
    }
    check(
        new Fraction(2n ** 1025n).toNumber() === Infinity &&
        new Fraction(1n, 2n ** 1076n).toNumber() === 0);
    check(
        new Fraction(2n ** 54n + 1n).toNumber() === 2 ** 54 &&
        new Fraction(2n ** 54n + 3n).toNumber() === 2 ** 54 + 4);
    checkEqual(
        [new Fraction(6, -4), Fraction.from('.5'), Fraction.from('-1.50e-1')].map(String),
        ['-3/2', '1/2', '-3/20']);
  },
};
