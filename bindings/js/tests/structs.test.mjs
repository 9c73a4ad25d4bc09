// The layouts of structs in JavaScript are those of the header of C: same members, in the same
// order, of the same types. Members at the end may be missing, because struct_size tells C how many
// a caller knows. Needs no build.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

const js = join(dirname(fileURLToPath(import.meta.url)), '..');
const header =
    readFileSync(join(js, '../c/include/plumb.h'), 'utf8').replaceAll(/\/\*[^]*?\*\//g, '');

const typeOf = (declaration) => {
  if (declaration.includes('*')) return 'pointer';
  return {
    double: 'f64',
    bool: 'bool',
    int: 'i32',
    uint32_t: 'u32',
    size_t: 'u32',
    uint64_t: 'u64'
  }[declaration.split(' ')[0]];
};

/** {struct: 'name:type ...'} of the structs that begin with struct_size. */
function structsOfHeader() {
  const structs = {};
  for (const [, body, name] of header.matchAll(/typedef struct \w+ \{([^}]*)\} plumb_(\w+);/g)) {
    const members = body.split(';')
                        .map((line) => line.trim().replaceAll(/\s+/g, ' '))
                        .filter((line) => line !== '');
    if (members.shift() !== 'size_t struct_size') continue;
    structs[name] = members
                        .flatMap((member) => {
                          const [, label, length] = /(\w+)(?:\[(\d+)\])?$/.exec(member);
                          const type = typeOf(member);
                          if (length === undefined) return [`${label}:${type}`];
                          return Array.from(
                              {length: Number(length)},
                              (_, i) => `${label}_${'xyzw'[i]}:${type}`);
                        })
                        .join(' ');
  }
  return structs;
}

/** The member lists of all Structs in the scripts of the package. */
function structsOfScripts() {
  const found = [];
  for (const name of readdirSync(join(js, 'lib')).filter((file) => file.endsWith('.js'))) {
    const script = readFileSync(join(js, 'lib', name), 'utf8');
    for (const [, body] of script.matchAll(/new Struct\(\{([^}]*)\}\)/g)) {
      found.push([...body.matchAll(/(\w+): '(\w+)'/g)]
                     .map(([, member, type]) => `${member}:${type}`)
                     .join(' '));
    }
  }
  return found;
}

test('every layout is that of a struct of plumb.h', () => {
  const known = structsOfHeader(), used = structsOfScripts();
  assert.ok(used.length >= 15 && Object.keys(known).length >= 15, 'the layouts were not found');
  const lists = Object.values(known);
  for (const members of used) {
    assert.ok(
        lists.some((list) => `${list} `.startsWith(`${members} `)),
        `no struct of plumb.h begins with the members ${members}`);
  }
});
