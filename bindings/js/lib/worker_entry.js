// The script of the worker that connect() starts.
import * as plumb from './index.js';
import {serve} from './worker.js';

if (typeof self === 'object' && typeof self.postMessage === 'function') {
  const answer = serve(plumb, (message, handed) => self.postMessage(message, handed));
  self.addEventListener('message', ({data}) => answer(data));
} else {
  const {parentPort} = await import('node:worker_threads');
  const answer = serve(plumb, (message, handed) => parentPort.postMessage(message, handed));
  parentPort.on('message', answer);
}
