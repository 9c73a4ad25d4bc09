// Prints one of the larger solids of corpus/solids as OFF: node solids.mjs bunny PACKAGE | ball.
import {createRequire} from 'node:module';

const require = createRequire(import.meta.url);

function off(points, faces) {
  const lines = ['OFF', `${points.length} ${faces.length} 0`];
  for (const p of points) lines.push(p.join(' '));
  for (const f of faces) lines.push(`${f.length} ${f.join(' ')}`);
  return lines.join('\n') + '\n';
}

/// The bunny with z upwards instead of y.
function bunny(path) {
  const {positions, cells} = require(path);
  return off(positions.map(([x, y, z]) => [x, -z, y]), cells);
}

/// An icosahedron cut three times, its corners moved to a sphere.
function ball(centre, radius) {
  const g = (1 + Math.sqrt(5)) / 2;
  let points = [[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g],
                [0, -1, -g], [0, 1, -g], [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]];
  let faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
               [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
               [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]];
  for (let depth = 0; depth < 3; ++depth) {
    const middles = new Map();
    const middle = (a, b) => {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (!middles.has(key)) {
        middles.set(key, points.length);
        points.push(points[a].map((x, i) => (x + points[b][i]) / 2));
      }
      return middles.get(key);
    };
    faces = faces.flatMap(([a, b, c]) => {
      const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      return [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]];
    });
  }
  const onto = p => {
    const length = Math.hypot(...p);
    return p.map((x, i) => Number((centre[i] + radius * x / length).toFixed(4)));
  };
  return off(points.map(onto), faces);
}

const [what, path] = process.argv.slice(2);
process.stdout.write(what === 'bunny' ? bunny(path) : ball([2.4, -1.8, 5.6], 2.8));
