// Sets of directions.
import {vector, vectors, withNumbers} from './fraction.js';
import {wrap} from './handle.js';
import {inFrame, Struct} from './memory.js';
import {describe, PointSet} from './sets.js';

/** A set of directions: of vectors, all of whose positive multiples are the same direction. */
export class SphereSet extends PointSet {
  static prefix = 'plumb_sphere_set';
  static free = 'plumb_sphere_set_free';
  static width = 3;
  static cells = ['point', 'arc', 'face'];
  static info = new Struct({
    points: 'u32',
    arcs: 'u32',
    faces: 'u32',
    marked_faces: 'u32',
    bytes: 'u32',
    is_empty: 'bool',
    is_whole: 'bool',
    is_closed: 'bool',
    is_open: 'bool',
  });

  static halfSphere(normal, options) { return SphereSet.halfSpheres([normal], options); }
  static halfSpheres(normals, {closed = true, ...options} = {}) {
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, vectors(normals, 3, 'normals'), 'normals',
            (numbers) =>
                wrap(SphereSet, frame.make('plumb_sphere_set_half_spheres', numbers, closed))));
  }
  static circle(normal) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vector(normal, 3, 'the normal'), 'the normal',
            (numbers) => wrap(SphereSet, frame.makeBriefly('plumb_sphere_set_circle', numbers))));
  }
  static polygon(corners, {closed = true} = {}) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vectors(corners, 3, 'corners'), 'corners',
            (numbers) =>
                wrap(SphereSet, frame.makeBriefly('plumb_sphere_set_polygon', numbers, closed))));
  }
  static arc(from, to, {closed = true} = {}) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vectors([from, to], 3, 'ends'), 'ends',
            (numbers) =>
                wrap(SphereSet, frame.makeBriefly('plumb_sphere_set_arc', numbers, closed))));
  }

  counts() {
    const {points, arcs, faces, marked_faces: markedFaces} = describe(this);
    return {points, arcs, faces, markedFaces};
  }
}
