// A web socket to the simulation, which is opened before there is anything to draw with: what it tells is kept until somebody listens.
// Comes back by itself when the server does. Says why where the server closed it for a reason.
const REASONS = [1007, 1008, 1009];

export class Link {
  constructor() {
    this.early = [];
    this.wait = 500;
    this.received = 0;
    this.open();
  }

  listen(listener) {
    this.listener = listener;
    this.early.splice(0).forEach((told) => this.tell(...told));
  }

  tell(name, ...values) {
    if (this.listener)
      this.listener[name](...values);
    else
      this.keep(name, ...values);
  }

  keep(...told) {
    this.early.push(told);
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
      this.opened();
    };
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = (event) => {
      this.tell('status', 'away', REASONS.includes(event.code) ? event.reason : '');
      this.retry = setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(2 * this.wait, 4000);
    };
  }

  opened() {
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN)
      this.socket.send(JSON.stringify(message));
  }
}
