import { MAGIC, decode, magicOf } from './format.js';

// Keeps what is told until somebody listens: all of it, and of the states the last one.
class Waiting {
  told = [];

  constructor() {
    ['hello', 'scene', 'settings', 'error', 'file', 'status'].forEach((name) => this[name] = (...values) => this.told.push([name, values]));
  }

  state(state) {
    this.last = state;
  }

  async tell(listener) {
    for (const [name, values] of this.told)
      await listener[name](...values);
    if (this.last)
      listener.state(this.last);
  }
}

// The simulation behind a web socket, which is opened before there is anything to draw with. Comes back by itself when the server does, with
// what was set before.
export class Live {
  constructor(wanted) {
    this.listener = new Waiting();
    this.wait = 500;
    this.wanted = wanted ?? null;
    this.received = 0;
    this.open();
  }

  listen(listener) {
    const waiting = this.listener;
    this.listener = listener;
    waiting.tell(listener);
  }

  close() {
    this.socket.onclose = null;
    this.socket.close();
  }

  open() {
    this.socket = new WebSocket(`ws://${location.host}/live`);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => {
      this.wait = 500;
      this.listener.status('live');
      if (this.wanted)
        this.send(this.wanted);
    };
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = (event) => {
      this.listener.status('away', event.code === 1009 || event.code === 1007 ? event.reason : '');
      setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(2 * this.wait, 4000);
    };
  }

  take(data) {
    if (typeof data !== 'string') {
      if (magicOf(data) !== MAGIC) {
        this.listener.file(data);
        return;
      }
      this.received++;
      this.listener.state(decode(data));
      return;
    }
    const message = JSON.parse(data);
    if (message.type === 'settings' || message.type === 'scene')
      this.remember(message.settings ?? message);
    this.listener[message.type](message);
  }

  remember({ species, variant, compare, paused, wake, landing, values }) {
    this.wanted = { species, variant, compare, paused, wake, landing, values };
  }

  set(change) {
    this.send(change);
  }

  // Files as pairs of name and content.
  drop(files) {
    if (this.socket.readyState !== WebSocket.OPEN)
      return;
    this.send({ files: files.map(([name]) => name) });
    for (const [, content] of files)
      this.socket.send(content);
  }

  save() {
    this.send({ save: true });
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN)
      this.socket.send(JSON.stringify(message));
  }
}
