// Layers: features with polygons, ids and properties.
import {takeNumbers} from './fraction.js';
import {addressOf, Handle, wrap} from './handle.js';
import {
  badArgument,
  constant,
  copyOf,
  count,
  decode,
  engine,
  inFrame,
  isWanted,
  real,
  shown,
  Struct,
  takeBytes,
  takeIndices,
  taken,
} from './memory.js';
import {PlaneSet} from './plane_set.js';
import {readOptions, self, simplified} from './sets.js';

const owners = ['longest border', 'largest', 'smallest', 'first', 'lowest id'];
const kinds = ['overlap', 'gap', 'hole', 'crossing', 'nesting'];
const pairsKept = ['all', 'first', 'both', 'first only'];
const none = 0xffffffff;
const optionsLayout = new Struct({
  owner: 'i32',
  enclosed_only: 'bool',
  gaps_below: 'f64',
  ranks: 'pointer',
  rank_count: 'u32',
  preferences: 'pointer',
  preference_count: 'u32',
});

/** The options of a check or a repair, as a struct of C. */
function layerOptions(frame, layer, {owner, gapsBelow, enclosedOnly, ranks, preferences}) {
  const noArray = {address: 0, count: 0};
  const numbers = isWanted(ranks) ? frame.numbers(Uint32Array, ranks, 'ranks') : noArray;
  const features = preferences.map((pair) => {
    if (!Array.isArray(pair) || pair.length !== 2)
      throw badArgument(`a preference must be a pair of features, not ${shown(pair)}`);
    return pair.map((feature) => (typeof feature === 'string' ? layer.find(feature) : feature));
  });
  const pairs = frame.records(Uint32Array, features.flat(), 2, 'preferences');
  return frame.struct(optionsLayout, {
    owner: constant(owners, owner, 'owner'),
    enclosed_only: enclosedOnly,
    gaps_below: real(gapsBelow, 'gapsBelow'),
    ranks: numbers.address,
    rank_count: numbers.count,
    preferences: pairs.address,
    preference_count: pairs.count,
  });
}

/** Features with polygons, ids and properties, such as countries. */
export class Layer extends Handle {
  static free = 'plumb_layer_free';

  static read(data, options = {}) {
    return inFrame(options, (frame) => {
      const bytes = frame.bytes(
          typeof data === 'object' && data !== null && data.type !== undefined ?
              JSON.stringify(data) :
              data,
          'the file');
      const {address, notes} = frame.makeWithNotes(
          'plumb_layer_read', bytes.address, bytes.count, readOptions(frame, options),
          frame.text(options.object, 'object'));
      frame.tell(notes);
      return wrap(Layer, address);
    });
  }
  static voronoi(points, box, options) {
    return inFrame(options, (frame) => {
      const sites = frame.doubles(points, 2, 'points'), corners = frame.doubles(box, 4, 'the box');
      if (corners.count !== 1)
        throw badArgument(
            'the box must have four numbers: x, y of its lower left and upper right corners');
      return wrap(
          Layer, frame.make('plumb_layer_voronoi', sites.address, sites.count, corners.address));
    });
  }
  static ofFaces(set, options) {
    return inFrame(
        options,
        (frame) =>
            wrap(Layer, frame.make('plumb_layer_of_faces', addressOf(set, PlaneSet, 'set'))));
  }

  /** These features, and then those of another layer. */
  joined(other, options) {
    return inFrame(
        options,
        (frame) => wrap(
            Layer, frame.make('plumb_layer_join', self(this), addressOf(other, Layer, 'other'))));
  }
  /** The parts of a set that come from these features. */
  parts(set, options) {
    return inFrame(
        options,
        (frame) => wrap(
            Layer, frame.make('plumb_layer_parts', self(this), addressOf(set, PlaneSet, 'set'))));
  }

  get featureCount() { return engine()._plumb_layer_feature_count(self(this)) >>> 0; }
  ids() { return jsonOfFeatures(this, 'plumb_layer_id'); }
  properties() { return jsonOfFeatures(this, 'plumb_layer_properties'); }
  get crs() {
    return inFrame(
        undefined,
        (frame) => decode(takeBytes(frame.makeBriefly('plumb_layer_crs', self(this)))));
  }
  /** The index of the feature with this id, or else with this name. */
  find(idOrName) {
    return inFrame(undefined, (frame) => {
      const feature = frame.block(4);
      frame.check('plumb_layer_find', self(this), frame.text(idOrName, 'idOrName'), feature);
      return frame.u32(feature);
    });
  }
  write(format, options) {
    return inFrame(
        options,
        (frame) =>
            takeBytes(frame.make('plumb_layer_write', self(this), frame.text(format, 'format'))));
  }
  toGeoJson(options) { return JSON.parse(decode(this.write('geojson', options))); }

  /**
   * `gapsBelow`: by default a ten thousandth of the diagonal of the layer, and no small lakes.
   */
  check({gapsBelow = -1, enclosedOnly = false, ...options} = {}) {
    return inFrame(options, (frame) => {
      const asked = layerOptions(
          frame, this, {owner: 'first', gapsBelow, enclosedOnly, ranks: null, preferences: []});
      return reportOf(frame.make('plumb_layer_check_with', self(this), asked), this, frame);
    });
  }
  /** `ranks` need the owner 'first'. `preferences`: [winner, loser], ... */
  repaired({
    owner = 'longest border',
    gapsBelow = -1,
    enclosedOnly = false,
    ranks = null,
    preferences = [],
    ...options
  } = {}) {
    return inFrame(options, (frame) => {
      const asked = layerOptions(frame, this, {owner, gapsBelow, enclosedOnly, ranks, preferences});
      const out = frame.block(4), report = frame.block(4);
      frame.check('plumb_layer_repair_with', self(this), asked, out, report, frame.context());
      const layer = wrap(Layer, frame.u32(out));
      try {
        return {layer, report: reportOf(frame.u32(report), this, frame)};
      } catch (error) {
        layer.dispose();
        throw error;
      }
    });
  }
  /** `groups` has a group for each feature; null leaves a feature out. */
  dissolved(groups, options) {
    return inFrame(options, (frame) => {
      const numbers =
          Array.from(groups, (group) => (group === null ? none : count(group, 'a group')));
      const {address, count: length} = frame.numbers(Uint32Array, numbers, 'groups');
      const groupCount =
          numbers.reduce((most, group) => (group === none ? most : Math.max(most, group + 1)), 0);
      return wrap(
          Layer, frame.make('plumb_layer_dissolve', self(this), address, length, groupCount));
    });
  }
  simplified(options) { return this.simplifiedWithReport(options).layer; }
  simplifiedWithReport(options) {
    return inFrame(options, (frame) => {
      const {made, report} = simplified(frame, 'plumb_layer_simplify_with_report', this, options);
      return {layer: wrap(Layer, made), report};
    });
  }
  overlaid(other, {pairs = 'all', ...options} = {}) {
    return inFrame(options, (frame) => {
      const out = frame.block(4), made = frame.block(4);
      frame.check(
          'plumb_layer_overlay', self(this), addressOf(other, Layer, 'other'),
          constant(pairsKept, pairs, 'pairs'), out, made, frame.context());
      const flat = takeIndices(frame.u32(made));
      const feature = (index) => (index === none ? null : index);
      return {
        layer: wrap(Layer, frame.u32(out)),
        pairs: Array.from(
            {length: flat.length / 2}, (_, i) => [feature(flat[2 * i]), feature(flat[2 * i + 1])]),
      };
    });
  }
}

function jsonOfFeatures(layer, name) {
  return Array.from({length: layer.featureCount}, (_, i) => inFrame(undefined, (frame) => {
                                                    const text = decode(takeBytes(
                                                        frame.makeBriefly(name, self(layer), i)));
                                                    return text === '' ? null : JSON.parse(text);
                                                  }));
}

/** A report as an object; it is released. */
function reportOf(report, layer, frame) {
  return taken(report, 'plumb_layer_report_free', () => factsOf(report, layer, frame));
}

function factsOf(report, layer, frame) {
  const length = frame.block(4), place = frame.block(16);
  const regions = Array.from({length: engine()._plumb_layer_report_count(report) >>> 0}, (_, i) => {
    const features = engine()._plumb_layer_report_features(report, i, length);
    const hasPlace = engine()._plumb_layer_report_place(report, i, place) !== 0;
    const owner = engine()._plumb_layer_report_owner(report, i) >>> 0;
    return {
      kind: kinds[engine()._plumb_layer_report_kind(report, i)],
      isOpen: engine()._plumb_layer_report_is_open(report, i) !== 0,
      area: takeNumbers(frame.makeBriefly('plumb_layer_report_area', report, i))[0],
      width: engine()._plumb_layer_report_width(report, i),
      features: Array.from(copyOf(Uint32Array, features, frame.u32(length))),
      owner: owner === none ? null : owner,
      at: hasPlace ? Array.from(copyOf(Float64Array, place, 2)) : null,
    };
  });
  const write = (format) => decode(takeBytes(
      frame.make('plumb_layer_report_write', report, self(layer), frame.text(format, 'format'))));
  return {
    hasDefects: engine()._plumb_layer_report_has_defects(report) !== 0,
    regions,
    text: write('text'),
    geoJson: JSON.parse(write('geojson')),
  };
}
