import { axesOf } from './scene-look.js';

// Mouse, fingers and keys on the picture, as the sample's own camera takes them.
const PER_PIXEL = 0.3, PER_NOTCH = 0.0015, PER_KEY = 0.08, DEGREES = Math.PI / 180;

export class Hand {
  constructor(canvas, stage) {
    Object.assign(this, { canvas, stage, fingers: new Map() });
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    for (const name of ['pointerup', 'pointercancel'])
      canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      stage.look.turn({ zoom: Math.exp(PER_NOTCH * Math.min(Math.max(event.deltaY, -300), 300)) });
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  move(event) {
    const from = this.fingers.get(event.pointerId);
    if (!from || !this.stage.state)
      return;
    const before = this.shape();
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = this.shape(), across = after.middle[0] - before.middle[0], down = after.middle[1] - before.middle[1];
    if (this.fingers.size > 1 || event.shiftKey || event.buttons > 1)
      this.pan(across, down);
    else
      this.stage.look.turn({ yaw: PER_PIXEL * across, pitch: PER_PIXEL * down });
    if (before.span > 0 && after.span > 0)
      this.stage.look.turn({ zoom: before.span / after.span });
  }

  // Pixels by which what is looked at follows the hand.
  pan(across, down) {
    const view = this.stage.look.from(this.stage.state.camera), { right, up } = axesOf(view);
    const unit = 2 * view.distance * Math.tan(0.5 * DEGREES * view.opening) / this.canvas.clientHeight;
    this.stage.look.turn({ move: up.map((value, k) => unit * (down * value - across * right[k])) });
  }

  // Over the ground, by a share of the distance.
  key(event) {
    const steps = { w: [0, 1], s: [0, -1], a: [-1, 0], d: [1, 0] }, step = steps[event.key.toLowerCase()];
    if (!step || !this.stage.state || event.ctrlKey || event.metaKey || event.altKey)
      return;
    event.preventDefault();
    const view = this.stage.look.from(this.stage.state.camera), { right } = axesOf(view), far = PER_KEY * view.distance;
    this.stage.look.turn({ move: [far * (step[0] * right[0] - step[1] * right[2]), 0, far * (step[0] * right[2] + step[1] * right[0])] });
  }

  shape() {
    const [one, other] = [...this.fingers.values()];
    return other
      ? { middle: [0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1])], span: Math.hypot(one[0] - other[0], one[1] - other[1]) }
      : { middle: one, span: 0 };
  }
}
