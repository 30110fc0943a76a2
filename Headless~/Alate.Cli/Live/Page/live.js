import { MAGIC, decode, magicOf } from './format.js';

// The simulation behind a web socket, which is opened before there is anything to draw with: what it tells is kept until somebody listens.
// Comes back by itself when the server does, with what was set before.
export class Live {
  constructor(wanted) {
    this.early = [];
    this.wait = 500;
    this.wanted = wanted ?? null;
    this.received = 0;
    this.open();
  }

  listen(listener) {
    this.listener = listener;
    this.early.splice(0).forEach((told) => this.tell(...told));
  }

  tell(name, ...values) {
    if (this.listener) {
      this.listener[name](...values);
      return;
    }
    // Of the states the last one is enough.
    if (name === 'state')
      this.early = this.early.filter(([other]) => other !== 'state');
    this.early.push([name, ...values]);
  }

  close() {
    clearTimeout(this.retry);
    this.socket.onclose = null;
    this.socket.close();
  }

  open() {
    this.socket = new WebSocket(`ws://${location.host}/live`);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => {
      this.wait = 500;
      this.tell('status', 'live');
      if (this.wanted)
        this.send(this.wanted);
    };
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = (event) => {
      this.tell('status', 'away', event.code === 1009 || event.code === 1007 ? event.reason : '');
      this.retry = setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(2 * this.wait, 4000);
    };
  }

  take(data) {
    if (typeof data !== 'string') {
      if (magicOf(data) !== MAGIC) {
        this.tell('file', data);
        return;
      }
      this.received++;
      this.tell('state', decode(data));
      return;
    }
    const message = JSON.parse(data);
    if (message.type === 'settings' || message.type === 'scene')
      this.remember(message.settings ?? message);
    this.tell(message.type, message);
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
