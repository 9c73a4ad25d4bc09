// Flattened models of OpenSCAD.
import {wrap} from './handle.js';
import {inFrame} from './memory.js';
import {PlaneSet} from './plane_set.js';
import {readOptions, withFiles} from './sets.js';
import {Solid} from './solid.js';

/**
 * Evaluates a model (.csg). Gives a Solid, a PlaneSet, or null for a model without geometry.
 * `files` has the files that it imports.
 */
export function readCsg(data, {name = 'model.csg', files = {}, ...options} = {}) {
  return inFrame(
      options, (frame) => withFiles({...files, [name]: data}, () => {
                 const solid = frame.block(4), set = frame.block(4), notes = frame.block(4);
                 const below = 0;
                 frame.check(
                     'plumb_csg_read_file', frame.text(name, 'name'), readOptions(frame, options),
                     below, solid, set, notes, frame.context());
                 frame.tell(frame.notes(notes));
                 if (frame.u32(solid) !== 0) return wrap(Solid, frame.u32(solid));
                 return frame.u32(set) !== 0 ? wrap(PlaneSet, frame.u32(set)) : null;
               }));
}
