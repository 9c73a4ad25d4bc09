// Writes the scenes of corpus/scenes, and the torus that some are drawn on: node scenes.mjs CORPUS.
import {readFileSync, writeFileSync} from 'node:fs';

const corpus = process.argv[2];
const write = (name, text) => writeFileSync(`${corpus}/scenes/${name}`, text);
const scene = (name, value) => write(name, JSON.stringify(value) + '\n');

// ---------------------------------------------------------------- a torus of squares, each two triangles

const kRing = 48, kTube = 24, kThin = 0.45;
const lines = [];
for (let i = 0; i < kRing; ++i) {
  for (let j = 0; j < kTube; ++j) {
    const s = 2 * Math.PI * i / kRing, t = 2 * Math.PI * j / kTube, r = 1 + kThin * Math.cos(t);
    const p = [r * Math.cos(s), r * Math.sin(s), kThin * Math.sin(t)];
    lines.push('v ' + p.map(x => Number(x.toFixed(6)) + 0).join(' '));
  }
}
for (let i = 0; i < kRing; ++i) {
  for (let j = 0; j < kTube; ++j) {
    const at = (a, b) => a % kRing * kTube + b % kTube + 1;
    lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  }
}
write('torus.obj', lines.join('\n') + '\n');

/// Where it lies: around the ring, around the tube, in squares.
function onTorus(x, y) {
  const wrap = (a, n) => (a % n + n) % n;
  const i = Math.floor(x), j = Math.floor(y), u = x - i, v = y - j;
  const square = 2 * (wrap(i, kRing) * kTube + wrap(j, kTube));
  const weight = w => Number(w.toFixed(4));
  return v <= u ? [square, weight(u - v), weight(v)] : [square + 1, weight(u), weight(v - u)];
}
class Drawing {
  points = [];
  polygons = [];
  polygon(points) {
    this.polygons.push(points.map(p => this.points.push(p) - 1));
    return this.polygons.length - 1;
  }
}
const ring = (n, at) => [...Array(n).keys()].map(k => at(2 * Math.PI * k / n));
const around = (x, y, r, n = 24, wave = 0, waves = 5) => ring(n, a => {
  const radius = r * (1 + wave * Math.cos(waves * a));
  return onTorus(x + radius * Math.cos(a), y + radius * Math.sin(a) * .8);
});

{
  const d = new Drawing();
  const a = d.polygon(around(39.3, 5.2, 6.1));
  const b = d.polygon(around(45.1, 6.4, 5.3, 40, .3));
  const first = d.polygon(ring(8, t => onTorus(33.25, 24 * (1 - t / (2 * Math.PI)) + .3)));
  const second = d.polygon(ring(8, t => onTorus(41.6, 24 * t / (2 * Math.PI) + .3)));
  scene('torus.json', {model: 'torus.obj', points: d.points, polygons: d.polygons, shapes: [[a], [b], [first, second]]});
}
{
  const d = new Drawing();
  d.polygon(ring(8, t => onTorus(33.25, 24 * t / (2 * Math.PI) + .3)));
  d.polygon(ring(12, t => onTorus(48 * t / (2 * Math.PI) + .4, 5.3)));
  scene('torus-loops.json', {model: 'torus.obj', points: d.points, polygons: d.polygons});
}

// ---------------------------------------------------------------- the bunny, seen as pictures show it

const text = readFileSync(`${corpus}/solids/bunny.off`, 'utf8').split('\n').filter(l => l && l[0] !== '#');
const [vertexCount, faceCount] = text[1].split(' ').map(Number);
const vertices = text.slice(2, 2 + vertexCount).map(l => l.split(' ').map(Number));
const faces = text.slice(2 + vertexCount, 2 + vertexCount + faceCount).map(l => l.split(' ').slice(1, 4).map(Number));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = a => a.map(x => x / Math.hypot(...a));
const viewer = unit([0.55, -0.9, 0.62]), right = unit([-viewer[1], viewer[0], 0]);
const up = [viewer[1] * right[2] - viewer[2] * right[1], viewer[2] * right[0] - viewer[0] * right[2],
            viewer[0] * right[1] - viewer[1] * right[0]];
const seen = vertices.map(p => [dot(p, right), dot(p, up), dot(p, viewer)]);
const [low, high] = [0, 1].map(k => [Math.min, Math.max].map(f => f(...seen.map(p => p[k])))).reduce(
    ([l, h], [a, b]) => [[...l, a], [...h, b]], [[], []]);

/// The nearest face at a place of the picture, from 0 to 1 to the right and upwards.
function onBunny(x, y) {
  const q = [low[0] + x * (high[0] - low[0]), low[1] + y * (high[1] - low[1])];
  let best = null;
  faces.forEach((face, f) => {
    const [a, b, c] = face.map(v => seen[v]);
    const cross = (p, r, s) => (r[0] - p[0]) * (s[1] - p[1]) - (r[1] - p[1]) * (s[0] - p[0]);
    const area = cross(a, b, c);
    if (area <= 0) return;
    const u = cross(a, q, c) / area, v = cross(a, b, q) / area;
    if (u < 0 || v < 0 || u + v > 1) return;
    const depth = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
    if (!best || depth > best.depth) best = {depth, point: [f, Number(u.toFixed(4)), Number(v.toFixed(4))]};
  });
  if (!best) throw Error(`nothing is seen at ${x}, ${y}`);
  return best.point;
}
const blob = (x, y, r, n, wave = 0, waves = 5) => ring(n, a => {
  const radius = r * (1 + wave * Math.cos(waves * a));
  return onBunny(x + radius * Math.cos(a), y + radius * Math.sin(a));
});
{
  const d = new Drawing();
  d.polygon(blob(.5, .36, .19, 30));
  d.polygon(blob(.63, .27, .17, 40, .3));
  d.polygon(blob(.56, .33, .07, 16));
  scene('bunny.json', {model: '../solids/bunny.off', points: d.points, polygons: d.polygons});
}
