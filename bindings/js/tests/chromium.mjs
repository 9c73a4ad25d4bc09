// Headless chromium for tests: a server of the package, and what a page shows.
import {spawn, spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const tests = dirname(fileURLToPath(import.meta.url));
export const dist = process.env.PLUMB_JS_DIST ?? join(tests, '../dist');
export const hasChromium = spawnSync('chromium', ['--version']).status === 0;

const types = {
  js: 'text/javascript',
  mjs: 'text/javascript',
  wasm: 'application/wasm',
  html: 'text/html',
  css: 'text/css'
};

/**
 * Serves folders, by default the package and the scripts of the tests, and a page, and hands what
 * is posted to `receive`.
 */
export async function serve(page, receive = () => {}, folders = [dist, tests]) {
  const server = createServer((request, response) => {
    if (request.method === 'POST') {
      let text = '';
      request.on('data', (part) => (text += part)).on('end', () => response.end() && receive(text));
      return;
    }
    const {pathname} =
        new URL(request.url, 'http://host');  // Dots that lead upwards are resolved here.
    const file = folders.map((folder) => join(folder, pathname))
                     .find((path) => statSync(path, {throwIfNoEntry: false})?.isFile());
    response.setHeader('content-type', types[pathname.split('.').at(-1)] ?? 'text/html');
    response.end(file === undefined ? page : readFileSync(file));
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  return server;
}

/**
 * The first text that a page posts: `await fetch('/shown', {method: 'POST', body: text})`. An
 * error that nobody catches is one.
 */
export async function shownBy(page, folders) {
  const watch = `<script>
    for (const name of ['error', 'unhandledrejection']) {
      addEventListener(name, (event) => {
        fetch('/shown', {method: 'POST', body: String(event.message ?? event.reason)});
      });
    }</script>`;
  let receive;
  const shown = new Promise((resolve) => (receive = resolve));
  const server =
      await serve(`<!doctype html><meta charset="utf-8">${watch}${page}`, receive, folders);
  const profile = mkdtempSync(join(tmpdir(), 'plumb-js-'));
  const browser = spawn(
      'chromium',
      [
        '--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`,
        `http://127.0.0.1:${server.address().port}/`
      ],
      {stdio: 'ignore'});
  const ended = new Promise((resolve) => browser.on('exit', resolve));
  try {
    return await Promise.race(
        [shown, ended.then(() => Promise.reject(new Error('chromium has ended')))]);
  } finally {
    browser.kill();
    await ended;
    server.closeAllConnections();
    server.close();
    rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100});
  }
}
