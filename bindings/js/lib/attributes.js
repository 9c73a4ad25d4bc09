// What belongs to the faces and corners of meshes: materials, groups, ids, and channels of numbers.
//
// A mesh of JavaScript has them in its member `attributes`. setAttributes() hands them to a mesh of
// the engine, and attributesOf() copies them out. Materials and groups come before the faces that
// refer to them, because the engine refuses an index of what is not there.
import {
  badArgument,
  copyOf,
  count,
  engine,
  inFrame,
  isWanted,
  real,
  shown,
  Struct,
  textAt
} from './memory.js';

const materialLayout = new Struct({
  name: 'pointer',
  has_color: 'bool',
  color_x: 'f64',
  color_y: 'f64',
  color_z: 'f64',
  color_w: 'f64',
  texture: 'pointer'
});

const planeLayout = new Struct({name: 'pointer', material: 'pointer', group: 'pointer', id: 'u32'});
const none = 0xffffffff;

const faceValues = {
  faceMaterial: 0,
  faceGroup: 1,
  faceId: 2
};
const [sourceOfFace, faceOfSource, flipped] = [3, 4, 5];
const [perCorner, perVertex] = [0, 1];

function record(value, what) {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value;
  throw badArgument(`${what} must be an object, not ${shown(value)}`);
}

function list(value, what) {
  if (Array.isArray(value)) return value;
  throw badArgument(`${what} must be an array, not ${shown(value)}`);
}

// ---- in

function colorOf(color, what) {
  if (list(color, what).length !== 4)
    throw badArgument(`${what} must have four numbers, not ${color.length}`);
  const [color_x, color_y, color_z, color_w] = color.map((part, i) => real(part, `${what}[${i}]`));
  return {has_color: true, color_x, color_y, color_z, color_w};
}

function materialOf(frame, material, what) {
  const {name, color, texture} = record(material, what);
  return frame.struct(materialLayout, {
    name: frame.text(name, `${what}.name`),
    texture: frame.text(texture, `${what}.texture`),
    ...(isWanted(color) ? colorOf(color, `${what}.color`) : {}),
  });
}

function addMaterial(frame, mesh, material, what) {
  frame.check('plumb_mesh_add_material', mesh, materialOf(frame, material, what), 0);
}

function addGroup(frame, mesh, name, what) {
  if (typeof name !== 'string') throw badArgument(`${what} must be a string, not ${shown(name)}`);
  frame.check('plumb_mesh_add_group', mesh, frame.text(name, what), 0);
}

function setChannel(frame, mesh, name, channel, place, what) {
  const {width, values} = record(channel, what);
  const rows = frame.records(
      Float64Array, values, Math.max(count(width, `${what}.width`), 1), `${what}.values`);
  frame.check(
      'plumb_mesh_set_channel', mesh, frame.text(name, what), width, place, rows.address,
      rows.count);
}

/** Gives a mesh of the engine the attributes of a mesh of JavaScript; undefined stands for none. */
export function setAttributes(frame, mesh, attributes) {
  if (!isWanted(attributes)) return;
  const given = record(attributes, 'attributes');
  list(given.materials ?? [], 'materials')
      .forEach((material, i) => addMaterial(frame, mesh, material, `materials[${i}]`));
  list(given.groups ?? [], 'groups')
      .forEach((name, i) => addGroup(frame, mesh, name, `groups[${i}]`));
  for (const [name, which] of Object.entries(faceValues)) {
    if (!isWanted(given[name])) continue;
    const {address, count: length} = frame.numbers(Uint32Array, given[name], name);
    frame.check('plumb_mesh_set_face_values', mesh, which, address, length);
  }
  const channels = record(given.channels ?? {}, 'channels');
  for (const [name, channel] of Object.entries(channels))
    setChannel(frame, mesh, name, channel, perCorner, `channels.${name}`);
  for (const [name, channel] of Object.entries(
           record(given.vertexChannels ?? {}, 'vertexChannels'))) {
    if (Object.hasOwn(channels, name))
      throw badArgument(`channels and vertexChannels have the same name ${shown(name)}`);
    setChannel(frame, mesh, name, channel, perVertex, `vertexChannels.${name}`);
  }
}

/** The struct of the attributes of the boundary of a half-space. */
export function planeSourceOf(frame, source) {
  const {name, material, group, id} = record(source, 'source');
  return frame.struct(planeLayout, {
    name: frame.text(name, 'source.name'),
    material: isWanted(material) ? materialOf(frame, material, 'source.material') : 0,
    group: frame.text(group, 'source.group'),
    id: isWanted(id) ? count(id, 'source.id') : none,
  });
}

// ---- out

function materialAt(frame, mesh, i) {
  const told = frame.struct(materialLayout);
  frame.check('plumb_mesh_material', mesh, i, told);
  const {name, has_color, color_x, color_y, color_z, color_w, texture} = materialLayout.read(told);
  return {
    name: textAt(name),
    color: has_color ? [color_x, color_y, color_z, color_w] : null,
    texture: textAt(texture),
  };
}

/** The values of all faces; null if the mesh has none. */
function valuesOf(mesh, which) {
  const faces = engine()._plumb_mesh_face_count(mesh) >>> 0;
  const address = engine()._plumb_mesh_face_values(mesh, which);
  return address === 0 ? null : copyOf(Uint32Array, address, faces);
}

function channelAt(mesh, i) {
  const corners = engine()._plumb_mesh_corner_count(mesh) >>> 0;
  const width = engine()._plumb_mesh_channel_width(mesh, i) >>> 0;
  const values = engine()._plumb_mesh_channel_values(mesh, i);
  return [
    textAt(engine()._plumb_mesh_channel_name(mesh, i)),
    {width, values: copyOf(Float64Array, values, width * corners)}
  ];
}

const times = (length, body) => Array.from({length: length >>> 0}, (_, i) => body(i));

/** The attributes of a mesh of the engine. */
export function attributesOf(mesh) {
  return inFrame(
      undefined,
      (frame) => ({
        materials:
            times(engine()._plumb_mesh_material_count(mesh), (i) => materialAt(frame, mesh, i)),
        groups: times(
            engine()._plumb_mesh_group_count(mesh),
            (i) => textAt(engine()._plumb_mesh_group(mesh, i))),
        ...Object.fromEntries(
            Object.entries(faceValues).map(([name, which]) => [name, valuesOf(mesh, which)])),
        channels: Object.fromEntries(
            times(engine()._plumb_mesh_channel_count(mesh), (i) => channelAt(mesh, i))),
      }));
}

/** Which face of which source each face of a mesh of the engine comes from. */
export function sourcesOf(mesh) {
  const values = (which) => valuesOf(mesh, which) ?? new Uint32Array(0);
  return {
    source: values(sourceOfFace),
    sourceFace: values(faceOfSource),
    isFlipped: Uint8Array.from(values(flipped)),
  };
}
