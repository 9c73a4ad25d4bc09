// typed_example.ts against the declarations of the package. PLUMB_JS_PEERS names a folder where npm
// installed TypeScript; skipped without.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  rmSync,
  symlinkSync,
  writeFileSync
} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

const tests = dirname(fileURLToPath(import.meta.url));
const dist = resolve(process.env.PLUMB_JS_DIST ?? join(tests, '../dist'));
const compiler = join(process.env.PLUMB_JS_PEERS || 'none', 'node_modules/typescript/bin/tsc');

test(
    'TypeScript accepts the example',
    {skip: !existsSync(compiler) || !existsSync(join(dist, 'index.d.ts')), timeout: 300000}, () => {
      const folder = mkdtempSync(join(tmpdir(), 'plumb-types-'));
      try {
        mkdirSync(join(folder, 'node_modules'));
        symlinkSync(dist, join(folder, 'node_modules/plumb'));
        cpSync(join(tests, 'typed_example.ts'), join(folder, 'example.ts'));
        writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
        writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({
          compilerOptions: {
            strict: true,
            noEmit: true,
            module: 'nodenext',
            target: 'es2022',
            lib: ['es2022', 'dom', 'esnext.disposable'],
            types: [],
            exactOptionalPropertyTypes: true,
            preserveSymlinks: true,
          },
          files: ['example.ts'],
        }));
        const {status, stdout} =
            spawnSync(process.execPath, [compiler, '-p', folder], {encoding: 'utf8'});
        assert.equal(status, 0, stdout);
      } finally {
        rmSync(folder, {recursive: true, force: true});
      }
    });
