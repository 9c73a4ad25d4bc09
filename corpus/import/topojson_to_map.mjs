// Turns one object of a TopoJSON file into a map: `n f`, n lines `x y`, f lines of 1-based indices.
//
//   node topojson_to_map.mjs [--clean] TOPOLOGY.json OBJECT > OUT.map
//
// 1. read_rings       every ring of every polygon, in file order, on the file's integer grid (times
//                     two, so that the midpoint of any edge is on the grid as well)
// 2. orient_rings     outer rings counter-clockwise, holes clockwise; rings without area are dropped
// 3. drop_defective   (--clean only) rings which no planar subdivision can hold: cut along or drawn
//                     across the antimeridian; then, of the rest, those which use a directed edge
//                     a second time, meet another edge elsewhere than at a common vertex, or
//                     bound one region together with another ring (a hole that touches its rim)
// 4. complement       what the rings leave uncovered: the twin of every directed edge without one,
//                     traced into cycles. These are the outer boundaries and the gaps, clockwise.
//
// A vertex is a grid point: equal coordinates are one vertex. Without --clean the data stays as
// published, defects and all; the points of dropped rings stay in the list as isolated vertices.

import { readFileSync } from 'node:fs';

const GRID_STEP = 2;

// ---- points

class PointTable {
  points = [];
  ids = new Map();

  id([x, y]) {
    const key = `${x} ${y}`;
    let id = this.ids.get(key);
    if (id === undefined) {
      id = this.points.length;
      this.ids.set(key, id);
      this.points.push([x, y]);
    }
    return id;
  }
}

// Exact: grid coordinates are below 2^18, so products stay far below 2^53.
function orientation([ax, ay], [bx, by], [cx, cy]) {
  return Math.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
}

function doubled_area(ring, points) {
  let sum = 0;
  for_each_edge(ring, (u, v) => {
    sum += points[u][0] * points[v][1] - points[u][1] * points[v][0];
  });
  return sum;
}

function for_each_edge(ring, visit) {
  for (let i = 0; i < ring.length; ++i) visit(ring[i], ring[(i + 1) % ring.length]);
}

const edge_key = (u, v) => `${u} ${v}`;
const undirected_key = (u, v) => (u < v ? edge_key(u, v) : edge_key(v, u));

// ---- 1. reading

// Arcs hold differences from point to point.
function absolute_arc(arc) {
  let x = 0;
  let y = 0;
  return arc.map(([dx, dy]) => [GRID_STEP * (x += dx), GRID_STEP * (y += dy)]);
}

// ~i stands for arc i backwards; neighbouring arcs share their end point.
function stitch(arc_indices, arcs, table) {
  const ring = [];
  for (const i of arc_indices) {
    const arc = i >= 0 ? arcs[i] : [...arcs[~i]].reverse();
    for (const id of arc.map((point) => table.id(point))) {
      if (ring.at(-1) !== id) ring.push(id);
    }
  }
  while (ring.length > 1 && ring[0] === ring.at(-1)) ring.pop();
  return ring;
}

function polygons_of(geometry) {
  if (geometry.type === 'Polygon') return [geometry.arcs];
  if (geometry.type === 'MultiPolygon') return geometry.arcs;
  throw new Error(`${geometry.type}: only polygons can be regions of a map`);
}

function read_rings(topology, object, table) {
  const arcs = topology.arcs.map(absolute_arc);
  return object.geometries.flatMap(polygons_of).flatMap((polygon) =>
    polygon.map((arc_indices, k) => ({
      is_hole: k > 0,
      ring: stitch(arc_indices, arcs, table),
    })),
  );
}

// ---- 2. orientation

function orient_rings(rings, points) {
  return rings
    .map(({ is_hole, ring }) => ({ is_hole, ring, area: doubled_area(ring, points) }))
    .filter(({ area }) => area !== 0)
    .map(({ is_hole, ring, area }) => (area < 0 === is_hole ? ring : [...ring].reverse()));
}

// ---- 3. defects

function uses_of_directed_edges(rings) {
  const uses = new Map();
  rings.forEach((ring, r) =>
    for_each_edge(ring, (u, v) => {
      const key = edge_key(u, v);
      if (!uses.has(key)) uses.set(key, []);
      uses.get(key).push(r);
    }),
  );
  return uses;
}

function rings_with_repeated_edges(rings) {
  return [...uses_of_directed_edges(rings).values()].filter((users) => users.length > 1).flat();
}

function is_between(p, a, b) {
  return (
    Math.min(a[0], b[0]) <= p[0] && p[0] <= Math.max(a[0], b[0]) &&
    Math.min(a[1], b[1]) <= p[1] && p[1] <= Math.max(a[1], b[1])
  );
}

// Whether two edges without a common vertex have a point in common.
function segments_meet(a, b, c, d) {
  const [o1, o2] = [orientation(a, b, c), orientation(a, b, d)];
  const [o3, o4] = [orientation(c, d, a), orientation(c, d, b)];
  if (o1 * o2 < 0 && o3 * o4 < 0) return true;
  return (
    (o1 === 0 && is_between(c, a, b)) || (o2 === 0 && is_between(d, a, b)) ||
    (o3 === 0 && is_between(a, c, d)) || (o4 === 0 && is_between(b, c, d))
  );
}

// Edges with a common vertex overlap when the shorter one runs along the other from there.
function edges_overlap(shared, p, q, points) {
  const [s, a, b] = [points[shared], points[p], points[q]];
  if (orientation(s, a, b) !== 0) return false;
  return (a[0] - s[0]) * (b[0] - s[0]) + (a[1] - s[1]) * (b[1] - s[1]) > 0;
}

function edges_meet([u, v], [w, z], points) {
  for (const [shared, p] of [[u, v], [v, u]]) {
    if (shared === w) return edges_overlap(shared, p, z, points);
    if (shared === z) return edges_overlap(shared, p, w, points);
  }
  return segments_meet(points[u], points[v], points[w], points[z]);
}

function undirected_edges(rings) {
  const edges = new Map();
  rings.forEach((ring, r) =>
    for_each_edge(ring, (u, v) => {
      const key = undirected_key(u, v);
      if (!edges.has(key)) edges.set(key, { ends: [u, v], users: [] });
      edges.get(key).users.push(r);
    }),
  );
  return [...edges.values()];
}

// Pairs whose x-ranges overlap, by a sweep over the left ends: enough for a map of this size.
function rings_with_meeting_edges(rings, points) {
  const edges = undirected_edges(rings).map((edge) => {
    const xs = edge.ends.map((id) => points[id][0]);
    return { ...edge, left: Math.min(...xs), right: Math.max(...xs) };
  });
  edges.sort((e, f) => e.left - f.left);
  const defective = [];
  let active = [];
  for (const edge of edges) {
    active = active.filter((other) => other.right >= edge.left);
    for (const other of active) {
      if (edges_meet(edge.ends, other.ends, points)) defective.push(...edge.users, ...other.users);
    }
    active.push(edge);
  }
  return defective;
}

// After a half-edge u -> v of a ring the rim of its region goes on along the first edge clockwise
// from v -> u; when that is another ring's, the two bound one region.
function rings_sharing_a_region(rings, points) {
  const around = rotation_system(rings, points);
  const uses = uses_of_directed_edges(rings);
  return rings.flatMap((ring, r) => {
    const strangers = new Set();
    for_each_edge(ring, (u, v) => {
      const users = uses.get(edge_key(v, clockwise_from(u, v, around)[0])) ?? [];
      users.filter((user) => user !== r).forEach((user) => strangers.add(user));
    });
    return strangers.size > 0 ? [r, ...strangers] : [];
  });
}

// The grid's x-range is the whole circle only when the file says -180 to 180.
function touches_antimeridian(ring, points, { scale, translate }) {
  const columns = [-180, 180].map((longitude) => (longitude - translate[0]) / scale[0]);
  const [west, east] = columns.map((column) => GRID_STEP * Math.round(column));
  return ring.some((id) => points[id][0] === west || points[id][0] === east);
}

function drop_defective(rings, points, transform) {
  const whole = rings.filter((ring) => !touches_antimeridian(ring, points, transform));
  const defective = new Set([
    ...rings_with_repeated_edges(whole),
    ...rings_with_meeting_edges(whole, points),
    ...rings_sharing_a_region(whole, points),
  ]);
  return whole.filter((_, r) => !defective.has(r));
}

// ---- 4. complement

// Directions as a full turn in two halves, compared exactly by a cross product.
function compare_directions([ax, ay], [bx, by]) {
  const half = (x, y) => (y > 0 || (y === 0 && x > 0) ? 0 : 1);
  return half(ax, ay) - half(bx, by) || Math.sign(bx * ay - by * ax);
}

// For every vertex its neighbours in counter-clockwise order.
function rotation_system(rings, points) {
  const neighbours = new Map();
  const add = (u, v) => {
    if (!neighbours.has(u)) neighbours.set(u, new Set());
    neighbours.get(u).add(v);
  };
  rings.forEach((ring) => for_each_edge(ring, (u, v) => (add(u, v), add(v, u))));
  const direction = (u, v) => [points[v][0] - points[u][0], points[v][1] - points[u][1]];
  return new Map(
    [...neighbours].map(([u, set]) => [
      u,
      [...set].sort((a, b) => compare_directions(direction(u, a), direction(u, b))),
    ]),
  );
}

function missing_twins(rings) {
  const used = uses_of_directed_edges(rings);
  const missing = new Set();
  rings.forEach((ring) =>
    for_each_edge(ring, (u, v) => {
      if (!used.has(edge_key(v, u))) missing.add(edge_key(v, u));
    }),
  );
  return missing;
}

// The neighbours of v clockwise from u, u itself last.
function clockwise_from(u, v, around) {
  const spokes = around.get(v);
  const start = spokes.indexOf(u);
  return spokes.map((_, k) => spokes.at((start - k - 1) % spokes.length));
}

// After u -> v comes the first missing edge clockwise from v -> u: it bounds the same uncovered
// piece of the plane.
function next_missing(u, v, around, missing) {
  const w = clockwise_from(u, v, around).find((spoke) => missing.has(edge_key(v, spoke)));
  if (w === undefined) throw new Error(`vertex ${v + 1}: an uncovered piece does not close`);
  return w;
}

function complement(rings, points) {
  const around = rotation_system(rings, points);
  const missing = missing_twins(rings);
  const visited = new Set();
  const cycles = [];
  for (const edge of missing) {
    const cycle = [];
    let [u, v] = edge.split(' ').map(Number);
    for (; !visited.has(edge_key(u, v)); [u, v] = [v, next_missing(u, v, around, missing)]) {
      visited.add(edge_key(u, v));
      cycle.push(u);
    }
    if (cycle.length > 0) cycles.push(cycle);
  }
  return cycles;
}

// ---- output

function renumber(cycles, points) {
  const table = new PointTable();
  return { cycles: cycles.map((c) => c.map((id) => table.id(points[id]))), points: table.points };
}

function print_map(cycles, points) {
  const lines = [`${points.length} ${cycles.length}`];
  lines.push(...points.map((point) => point.join(' ')));
  lines.push(...cycles.map((cycle) => cycle.map((id) => id + 1).join(' ')));
  process.stdout.write(lines.join('\n') + '\n');
}

function main(args) {
  const clean = args[0] === '--clean';
  const [file, name] = clean ? args.slice(1) : args;
  const topology = JSON.parse(readFileSync(file, 'utf8'));
  const table = new PointTable();
  let rings = read_rings(topology, topology.objects[name], table);
  rings = orient_rings(rings, table.points);
  if (clean) rings = drop_defective(rings, table.points, topology.transform);
  const cycles = [...rings, ...complement(rings, table.points)];
  const result = clean ? renumber(cycles, table.points) : { cycles, points: table.points };
  print_map(result.cycles, result.points);
}

main(process.argv.slice(2));
