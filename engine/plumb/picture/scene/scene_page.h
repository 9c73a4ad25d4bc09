// The page of scene_html.h: the text before the data, and the text after the data. The program
// works with WebGL 1 as it is; a library would be fifty times as long, in every file.
#pragma once

#include <string_view>

namespace plumb {

inline constexpr std::string_view kScenePageStyle = R"(<style>
html,body{height:100%;margin:0}
body{display:flex;flex-direction:column;font:16px/1.4 system-ui,sans-serif;color:#1d2733;background:#fff}
header,footer{padding:.6rem 1rem}
h1{font-size:1.15rem;margin:0 .6rem 0 0;display:inline;overflow-wrap:anywhere}
.kind{background:#3d4b59;color:#fff;border-radius:.4rem;padding:.1rem .5rem;white-space:nowrap}
.facts{margin:.3rem 0 0;color:#4a5560}
#view{flex:1;min-height:12rem;position:relative;border:solid #c3c9d0;border-width:1px 0}
canvas{position:absolute;width:100%;height:100%;touch-action:none;cursor:grab;display:block}
#none{padding:1rem}
ul{list-style:none;margin:0;padding:0;display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;font-size:.9rem}
li i{display:inline-block;width:1.2em;height:.8em;margin-right:.4em;vertical-align:-.05em}
li i.line{height:.2em;vertical-align:.25em}
li i.dot{width:.7em;height:.7em;border-radius:50%;border:2px solid;box-sizing:border-box}
#layers{display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;margin-top:.4rem}
#layers label{cursor:pointer}
p.help{margin:.3rem 0 0;color:#4a5560;font-size:.85rem}
</style>
)";

inline constexpr std::string_view kScenePageProgram = R"JS(
const canvas = document.querySelector('canvas');
const gl = canvas.getContext('webgl', {antialias: true, alpha: false});
if (!gl) document.getElementById('none').hidden = false;

const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const floats = text => new Float32Array(bytes(text).buffer);
const points = floats(scene.points), half = scene.half;
const colours = scene.colours;
const CUT = scene.cut;

const common = `precision highp float; varying vec3 place; varying vec3 colour;
  uniform vec3 box; uniform float fades;
  float strength() { vec3 s = abs(place) / box; float side = max(s.x, max(s.y, s.z));
    return fades < .5 ? 1. : clamp((1. - side) / .4, 0., 1.); }`;
const facetVertex = `attribute vec3 at; attribute vec3 normal; attribute vec3 paint;
  uniform mat3 turn; uniform vec4 move; uniform float flatness; varying vec3 place; varying vec3 colour;
  void main() { vec3 p = turn * at; vec3 n = turn * normal; if (n.z < 0.) n = -n;
    float lit = .74 + .36 * max(dot(n, normalize(vec3(-.5, .9, 1.))), 0.);
    colour = paint * mix(lit, 1., flatness); place = at;
    gl_Position = vec4(p.xy * move.xy + move.zw, -p.z * .25, 1.); }`;
const facetFragment = common + `uniform float veil;
  void main() { float s = strength();
    gl_FragColor = veil > 0. ? vec4(colour, veil) : vec4(mix(vec3(1.), colour, s), 1.); }`;
// Facets with an image, whose colours are multiplied by those of the facet.
const imageVertex = 'attribute vec2 spot; varying vec2 seen;' +
  facetVertex.replace('void main() {', 'void main() { seen = spot;');
const imageFragment = common + `uniform sampler2D image; varying vec2 seen;
  void main() { gl_FragColor = vec4(mix(vec3(1.), colour * texture2D(image, seen).rgb, strength()), 1.); }`;
const lineVertex = `attribute vec3 at; attribute vec3 other; attribute float side; attribute vec3 paint;
  attribute float wide; uniform mat3 turn; uniform vec4 move; uniform vec2 pixel;
  varying vec3 place; varying vec3 colour;
  void main() { vec3 p = turn * at; vec2 a = p.xy * move.xy + move.zw;
    vec2 d = ((turn * other).xy * move.xy + move.zw - a) / pixel;
    d = dot(d, d) > 0. ? normalize(d) : vec2(1., 0.);
    colour = paint; place = at;
    gl_Position = vec4(a + vec2(-d.y, d.x) * side * wide * pixel, -p.z * .25 - .005, 1.); }`;
const lineFragment = common + `uniform float part;
  void main() { gl_FragColor = vec4(colour, part * strength()); }`;
const dotVertex = `attribute vec3 at; attribute vec3 paint; attribute float hollow;
  uniform mat3 turn; uniform vec4 move; uniform float size;
  varying vec3 place; varying vec3 colour; varying float ring;
  void main() { vec3 p = turn * at; colour = paint; place = at; ring = hollow; gl_PointSize = size;
    gl_Position = vec4(p.xy * move.xy + move.zw, -p.z * .25 - .016, 1.); }`;
const dotFragment = common + `varying float ring;
  void main() { float r = length(gl_PointCoord - .5); if (r > .5) discard;
    gl_FragColor = vec4(ring > .5 && r < .3 ? vec3(1.) : colour, strength()); }`;

function program(vertex, fragment) {
  const p = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(shader));
    gl.attachShader(p, shader);
  }
  gl.linkProgram(p);
  return p;
}

// A batch: a program and a buffer for each of its attributes.
function batch(p, count, attributes) {
  const buffers = Object.entries(attributes).map(([name, [size, data]]) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return [gl.getAttribLocation(p, name), size, buffer];
  });
  return {p, count, buffers};
}

const point = i => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
const list = values => new Float32Array(values.flat());

// Layers: what is shown, and which of them colours the facets.
let shown = scene.shown;
const isShown = (layers, i) => !layers || (layers[i] & shown) !== 0;
const tints = scene.layers.map(layer => bytes(layer.tints));
const tinted = () => {
  for (let i = tints.length; i-- > 0;) if (shown >> i & 1 && tints[i].length) return tints[i];
};

// The texture of each patch while the facets have tints.
const textureOf = (() => {
  const group = scene.textures.length && new Uint32Array(bytes(scene.patchGroup).buffer);
  return i => group && tinted() ? scene.groups[group[i]].texture : undefined;
})();

function facets(p, wanted, ownColour, texture) {
  const tint = tinted(), group = tint && new Uint32Array(bytes(scene.patchGroup).buffer);
  const colourOf = i => tint ? [0, 1, 2].map(k => tint[3 * group[i] + k] / 255) : colours[paint[i]];
  const corners = new Uint32Array(bytes(scene.corners).buffer);
  const patch = new Uint32Array(bytes(scene.patch).buffer);
  const normals = floats(scene.normals), paint = bytes(scene.patchPaint);
  const chosen = [];
  for (let t = 0; t < patch.length; ++t) {
    if (wanted(paint[patch[t]]) && (ownColour || textureOf(patch[t]) === texture)) chosen.push(t);
  }
  const at = new Float32Array(9 * chosen.length), normal = at.slice(), colour = at.slice();
  chosen.forEach((t, i) => {
    const own = (ownColour || colourOf)(patch[t]);
    for (let k = 0; k < 3; ++k) {
      at.set(points.subarray(3 * corners[3 * t + k], 3 * corners[3 * t + k] + 3), 9 * i + 3 * k);
      normal.set(normals.subarray(3 * patch[t], 3 * patch[t] + 3), 9 * i + 3 * k);
      colour.set(own, 9 * i + 3 * k);
    }
  });
  const attributes = {at: [3, at], normal: [3, normal], paint: [3, colour]};
  if (texture !== undefined) {
    const places = floats(scene.texcoords), spot = new Float32Array(6 * chosen.length);
    chosen.forEach((t, i) => spot.set(places.subarray(6 * t, 6 * t + 6), 6 * i));
    attributes.spot = [2, spot];
  }
  return {...batch(p, 3 * chosen.length, attributes), texture};
}

// An image that repeats, which in WebGL 1 has powers of two as sides. It is white until it is there.
function imageOf(address) {
  const texture = gl.createTexture(), image = new Image();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4).fill(255));
  const most = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), 4096);
  const side = n => Math.min(most, 2 ** Math.ceil(Math.log2(n)));
  image.onload = () => {
    const page = document.createElement('canvas');
    [page.width, page.height] = [side(image.naturalWidth), side(image.naturalHeight)];
    page.getContext('2d').drawImage(image, 0, 0, page.width, page.height);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, page);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    redraw();
  };
  image.src = address;
  return texture;
}

function lines(p, wanted) {
  let ends = new Uint32Array(bytes(scene.ends).buffer), paint = bytes(scene.linePaint);
  if (scene.lineLayers) {
    const layers = bytes(scene.lineLayers);
    ends = ends.filter((_, i) => isShown(layers, i >> 1));
    paint = paint.filter((_, i) => isShown(layers, i));
  }
  ends = ends.filter((_, i) => wanted(paint[i >> 1]));
  paint = paint.filter(wanted);
  const n = paint.length, at = new Float32Array(18 * n), other = at.slice(), colour = at.slice();
  const side = new Float32Array(6 * n), wide = side.slice();
  for (let i = 0; i < n; ++i) {
    const corners = [[0, 1], [0, -1], [1, 1], [0, -1], [1, -1], [1, 1]];
    corners.forEach(([end, s], k) => {
      at.set(point(ends[2 * i + end]), 18 * i + 3 * k);
      other.set(point(ends[2 * i + 1 - end]), 18 * i + 3 * k);
      colour.set(colours[paint[i]], 18 * i + 3 * k);
      side[6 * i + k] = end ? -s : s;
      wide[6 * i + k] = scene.wide[paint[i]];
    });
  }
  let length = 0;
  for (let i = 0; i < n; ++i) {
    const a = point(ends[2 * i]), b = point(ends[2 * i + 1]);
    length += Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  const lines = batch(p, 6 * n, {at: [3, at], other: [3, other], paint: [3, colour], side: [1, side], wide: [1, wide]});
  return {...lines, length};
}

function dots(p) {
  const layers = scene.dotLayers && bytes(scene.dotLayers), keep = (_, i) => isShown(layers, i);
  const at = [...new Uint32Array(bytes(scene.dots).buffer)].filter(keep);
  const paint = [...bytes(scene.dotPaint)].filter(keep);
  return batch(p, at.length, {at: [3, list(at.map(point))], paint: [3, list(paint.map(i => colours[i]))],
                              hollow: [1, list(paint.map(i => i === scene.hollow ? 1 : 0))]});
}

// Text: the groups are drawn once more, small, each in a colour that is its number; a text goes where what is
// seen of its group is widest.
const over = document.createElement('canvas'), pen = over.getContext('2d');
over.style.pointerEvents = 'none';
const showsText = () => scene.layers.some((layer, i) => layer.text && shown >> i & 1);
const SMALL = 2;  // pixels of the page for one of the small picture

function numbered(p) {
  if (!showsText()) return {count: 0};
  const group = new Uint32Array(bytes(scene.patchGroup).buffer);
  return facets(p, () => true, i => [1, 2, 3].map(k => ((group[i] + 1) >> 8 * (3 - k) & 255) / 255));
}

let small;
function smallTarget(w, h) {
  if (small && small.w === w && small.h === h) return small;
  if (small) [gl.deleteFramebuffer(small.frame), gl.deleteTexture(small.texture), gl.deleteRenderbuffer(small.depth)];
  small = {w, h, frame: gl.createFramebuffer(), texture: gl.createTexture(), depth: gl.createRenderbuffer()};
  gl.bindTexture(gl.TEXTURE_2D, small.texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, w, h, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  gl.bindRenderbuffer(gl.RENDERBUFFER, small.depth);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, w, h);
  gl.bindFramebuffer(gl.FRAMEBUFFER, small.frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, small.texture, 0);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, small.depth);
  return small;
}

function groupsSeen(w, h, uniforms) {
  const target = smallTarget(w, h), pixels = new Uint8Array(4 * w * h), group = new Int32Array(w * h);
  gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
  gl.viewport(0, 0, w, h);
  gl.clearColor(0, 0, 0, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.disable(gl.BLEND);
  show(shapes.numbered, gl.TRIANGLES, {...uniforms, flatness: 1, veil: 0});
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  for (let i = 0; i < group.length; ++i) group[i] = (pixels[4 * i] << 16 | pixels[4 * i + 1] << 8 | pixels[4 * i + 2]) - 1;
  return group;
}

// For each group the place farthest from others: two passes over the neighbours.
function widest(group, w, h) {
  const far = new Float32Array(group.length).fill(w + h);
  const look = (x, y, dx, dy, step) => {
    const i = y * w + x, u = x + dx, v = y + dy, j = v * w + u;
    const edge = u < 0 || v < 0 || u >= w || v >= h || group[i] !== group[j];
    far[i] = Math.min(far[i], edge ? step : far[j] + step);
  };
  for (let y = 0; y < h; ++y) for (let x = 0; x < w; ++x) {
    look(x, y, -1, 0, 1); look(x, y, 0, -1, 1); look(x, y, -1, -1, Math.SQRT2); look(x, y, 1, -1, Math.SQRT2);
  }
  for (let y = h; y-- > 0;) for (let x = w; x-- > 0;) {
    look(x, y, 1, 0, 1); look(x, y, 0, 1, 1); look(x, y, 1, 1, Math.SQRT2); look(x, y, -1, 1, Math.SQRT2);
  }
  const best = new Map();
  group.forEach((g, i) => {
    if (g >= 0 && !(best.has(g) && far[best.get(g)] >= far[i])) best.set(g, i);
  });
  return [...best].map(([g, i]) => ({g, x: i % w + .5, y: Math.floor(i / w) + .5, room: far[i]}));
}

function writeTexts(w, h, dense, uniforms) {
  [over.width, over.height] = [canvas.width, canvas.height];
  if (!showsText()) return;
  const sw = Math.ceil(w / SMALL), sh = Math.ceil(h / SMALL);
  pen.scale(dense, dense);
  Object.assign(pen, {textAlign: 'center', textBaseline: 'middle', lineJoin: 'round', strokeStyle: '#fff',
                      fillStyle: '#121a24'});
  for (const {g, x, y, room} of widest(groupsSeen(sw, sh, uniforms), sw, sh)) {
    const text = scene.groups[g].text, half = Math.hypot(.36 * text.length, .4);
    const size = Math.min(18, 2 * SMALL * room / half / 2);
    if (size < 5) continue;
    pen.font = `600 ${Math.max(size, 10)}px system-ui, sans-serif`;
    pen.lineWidth = Math.max(size, 10) * .3;
    const at = [x / sw * w, h - y / sh * h];
    pen.strokeText(text, ...at);
    pen.fillText(text, ...at);
  }
}

function multiply(a, b) {  // columns, as WebGL has them
  const c = [];
  for (let j = 0; j < 3; ++j) for (let i = 0; i < 3; ++i) {
    c.push(a[i] * b[3 * j] + a[3 + i] * b[3 * j + 1] + a[6 + i] * b[3 * j + 2]);
  }
  return c;
}
const about = (u, v, angle) => {  // turns axis u towards axis v
  const m = [1, 0, 0, 0, 1, 0, 0, 0, 1], s = Math.sin(angle), c = Math.cos(angle);
  m[4 * u] = m[4 * v] = c; m[3 * u + v] = s; m[3 * v + u] = -s;
  return m;
};

let turn, zoom, shift, frame = 0;
function reset() { turn = scene.turn.slice(); zoom = 1; shift = [0, 0]; redraw(); }
function redraw() { if (gl && !frame) frame = requestAnimationFrame(draw); }

let shapes, programs, images;
function prepare() {
  programs ??= {facet: program(facetVertex, facetFragment), line: program(lineVertex, lineFragment),
                dot: program(dotVertex, dotFragment), image: program(imageVertex, imageFragment)};
  images ??= scene.textures.map(imageOf);
  shapes = {solid: facets(programs.facet, paint => paint !== CUT), cut: facets(programs.facet, paint => paint === CUT),
            lines: lines(programs.line, paint => paint < scene.curve),
            images: images.map((_, k) => facets(programs.image, () => true, undefined, k)),
            curves: lines(programs.line, paint => paint >= scene.curve), dots: dots(programs.dot),
            numbered: numbered(programs.facet)};
}

function offerLayers() {
  scene.layers.forEach((layer, i) => {
    const label = document.createElement('label'), box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = shown >> i & 1;
    box.addEventListener('change', () => { shown ^= 1 << i; prepare(); redraw(); });
    label.append(box, ' ' + layer.name);
    document.getElementById('layers').append(label);
  });
}

function show(shape, mode, uniforms) {
  if (!shape.count) return;
  gl.useProgram(shape.p);
  for (const [name, value] of Object.entries(uniforms)) {
    const at = gl.getUniformLocation(shape.p, name);
    if (value.length === 9) gl.uniformMatrix3fv(at, false, value);
    else if (value.length) gl['uniform' + value.length + 'fv'](at, value);
    else gl.uniform1f(at, value);
  }
  if (shape.texture !== undefined) gl.bindTexture(gl.TEXTURE_2D, images[shape.texture]);
  for (const [at, size, buffer] of shape.buffers) {
    if (at < 0) continue;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, 0, 0);
  }
  gl.drawArrays(mode, 0, shape.count);
  for (const [at] of shape.buffers) if (at >= 0) gl.disableVertexAttribArray(at);
}

function scaleOf(width, height) {
  const reach = scene.flat ? scene.half.map(Math.abs) : null;
  const fit = reach ? Math.min(width / reach[0], height / reach[1]) / 2.2
                    : Math.min(width, height) / (2.2 * scene.reach);
  return fit * zoom;
}

function draw() {
  frame = 0;
  const dense = window.devicePixelRatio || 1;
  canvas.width = Math.round(canvas.clientWidth * dense);
  canvas.height = Math.round(canvas.clientHeight * dense);
  const w = canvas.clientWidth, h = canvas.clientHeight, s = scaleOf(w, h);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  const shared = {turn, move: [2 * s / w, 2 * s / h, 2 * shift[0] / w, 2 * shift[1] / h], box: half,
                  fades: scene.fades ? 1 : 0};
  gl.disable(gl.BLEND);
  show(shapes.solid, gl.TRIANGLES, {...shared, flatness: scene.flat ? 1 : 0, veil: 0});
  for (const shape of shapes.images) show(shape, gl.TRIANGLES, {...shared, flatness: 0});
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  const length = shapes.lines.length * s, room = .12 * w * h / Math.max(length, 1);
  const thin = Math.min(1, Math.max(room, .5) / 2);
  show(shapes.lines, gl.TRIANGLES, {...shared, pixel: [thin / w, thin / h],
                                    part: Math.min(1, Math.max(room / .5, .15))});
  show(shapes.curves, gl.TRIANGLES, {...shared, pixel: [1 / w, 1 / h], part: 1});
  show(shapes.dots, gl.POINTS, {...shared, size: (shapes.dots.count > 40 ? 6 : 10) * dense});
  gl.depthMask(false);
  gl.enable(gl.CULL_FACE);
  show(shapes.cut, gl.TRIANGLES, {...shared, flatness: 0, veil: .3});
  gl.disable(gl.CULL_FACE);
  gl.depthMask(true);
  if (scene.layers.length) writeTexts(w, h, dense, shared);
}

function rotate(x, y) { turn = multiply(about(1, 2, y), multiply(about(2, 0, x), turn)); redraw(); }
function pan(x, y) { shift = [shift[0] + x, shift[1] - y]; redraw(); }
function enlarge(by, x = 0, y = 0) {  // about a place, from the middle of the picture
  const last = zoom;
  zoom = Math.min(200, Math.max(.2, zoom * by));
  shift = [x + (shift[0] - x) * zoom / last, y + (shift[1] - y) * zoom / last];
  redraw();
}
const fromMiddle = (x, y) => {
  const r = canvas.getBoundingClientRect();
  return [x - r.left - r.width / 2, r.top + r.height / 2 - y];
};

const held = new Map();
canvas.addEventListener('pointerdown', e => {
  canvas.setPointerCapture(e.pointerId);
  held.set(e.pointerId, [e.clientX, e.clientY]);
});
for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, e => held.delete(e.pointerId));
canvas.addEventListener('pointermove', e => {
  const last = held.get(e.pointerId);
  if (!last) return;
  const now = [e.clientX, e.clientY], x = now[0] - last[0], y = now[1] - last[1];
  if (held.size === 1) {
    if (scene.flat || e.shiftKey || e.buttons & 6) pan(x, y);
    else rotate(x / 150, y / 150);
  } else {
    const [other] = [...held].filter(([id]) => id !== e.pointerId).map(([, at]) => at);
    const apart = at => Math.hypot(at[0] - other[0], at[1] - other[1]);
    pan(x / 2, y / 2);
    if (apart(last) > 0) enlarge(apart(now) / apart(last), ...fromMiddle((now[0] + other[0]) / 2, (now[1] + other[1]) / 2));
  }
  held.set(e.pointerId, now);
});
canvas.addEventListener('wheel', e => {
  e.preventDefault();
  enlarge(Math.exp(-e.deltaY * (e.deltaMode ? .05 : .0015)), ...fromMiddle(e.clientX, e.clientY));
}, {passive: false});
canvas.addEventListener('contextmenu', e => e.preventDefault());
canvas.addEventListener('dblclick', reset);
canvas.addEventListener('keydown', e => {
  const step = .12, steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  if (e.key in steps) {
    const [x, y] = steps[e.key];
    if (scene.flat) pan(-40 * x, -40 * y); else rotate(step * x, step * y);
  } else if (e.key === '+' || e.key === '=') enlarge(1.2);
  else if (e.key === '-') enlarge(1 / 1.2);
  else if (e.key === '0') reset();
  else return;
  e.preventDefault();
});
if (gl) {
  if (scene.layers.length) canvas.after(over);
  prepare();
  offerLayers();
  new ResizeObserver(redraw).observe(canvas);
  reset();
}
)JS";

}  // namespace plumb
