import { MAGIC, decode, magicOf } from './format.js';

// The simulation behind a web socket. Comes back by itself when the server does, with what was set before.
export class Live {
  constructor(listener, wanted) {
    this.listener = listener;
    this.wait = 500;
    this.wanted = wanted ?? null;
    this.received = 0;
    this.open();
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
