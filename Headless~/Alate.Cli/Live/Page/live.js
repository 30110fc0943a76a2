import { MAGIC, decode, magicOf } from './format.js';
import { Link } from './link.js';

// The simulation of an insect, which comes back with what was set before.
export class Live extends Link {
  constructor(wanted) {
    super();
    this.wanted = wanted ?? null;
  }

  // Of the states the last one is enough.
  keep(name, ...values) {
    if (name === 'state')
      this.early = this.early.filter(([other]) => other !== 'state');
    super.keep(name, ...values);
  }

  opened() {
    if (this.wanted)
      this.send(this.wanted);
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
}
