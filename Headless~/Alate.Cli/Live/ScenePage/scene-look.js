// The camera of the sample, and how a hand on the page turns it: drawn at once, told to the sample, which answers with its own.
const DEGREES = Math.PI / 180, STEEPEST = 89, NEAREST = 0.05, FARTHEST = 1000, GATHERED = 30;

// Directions to the right, up and ahead.
export function axesOf({ yaw, pitch }) {
  const [sy, cy, sp, cp] = [Math.sin(yaw * DEGREES), Math.cos(yaw * DEGREES), Math.sin(pitch * DEGREES), Math.cos(pitch * DEGREES)];
  return { right: [cy, 0, -sy], up: [sy * sp, cp, cy * sp], ahead: [sy * cp, -sp, cy * cp] };
}

export function eyeOf(view) {
  const { ahead } = axesOf(view);
  return view.target.map((value, k) => value - view.distance * ahead[k]);
}

export class Look {
  constructor() {
    this.number = 0;
    this.clear();
  }

  clear() {
    Object.assign(this, { waiting: [], gathered: null, isMoved: true });
  }

  // Degrees to the side and down, factor of the distance, and way of the point that is looked at.
  turn({ yaw = 0, pitch = 0, zoom = 1, move = [0, 0, 0] }) {
    const now = this.gathered ??= { number: ++this.number, yaw: 0, pitch: 0, zoom: 1, move: [0, 0, 0], since: performance.now() };
    Object.assign(now, { yaw: now.yaw + yaw, pitch: now.pitch + pitch, zoom: now.zoom * zoom, move: now.move.map((value, k) => value + move[k]) });
    this.isMoved = true;
  }

  // What is to be told now, as the message has it; null for nothing.
  told() {
    const now = this.gathered;
    if (!now || performance.now() - now.since < GATHERED)
      return null;
    this.gathered = null;
    this.waiting.push(now);
    return [now.number, now.yaw, now.pitch, now.zoom, ...now.move];
  }

  answered(number) {
    this.waiting = this.waiting.filter((look) => look.number > number);
  }

  // The sample's camera with what it does not know yet.
  from(camera) {
    return [...this.waiting, this.gathered].filter(Boolean).reduce((view, look) => ({
      ...view, yaw: view.yaw + look.yaw, pitch: Math.min(Math.max(view.pitch + look.pitch, -STEEPEST), STEEPEST),
      distance: Math.min(Math.max(view.distance * look.zoom, NEAREST), FARTHEST), target: view.target.map((value, k) => value + look.move[k]),
    }), camera);
  }
}
