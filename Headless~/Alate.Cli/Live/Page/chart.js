// Lift and drag over the last beats, as a running chart.
const BEATS = 3;

export class Chart {
  constructor(canvas) {
    this.canvas = canvas;
    this.points = [];
  }

  clear() {
    this.points = [];
  }

  add(column) {
    const at = column.beats + column.phase / (2 * Math.PI);
    if (this.points.length > 0 && at < this.points.at(-1).at)
      this.points = [];
    this.points.push({ at, lift: column.lift, drag: column.drag });
    while (this.points[0].at < at - BEATS)
      this.points.shift();
  }

  draw() {
    const ratio = devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (this.canvas.width !== Math.round(width * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const pen = this.canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    if (this.points.length < 2)
      return;
    const values = this.points.flatMap(({ lift, drag }) => [lift, drag, 0, 1]);
    const low = Math.floor(Math.min(...values)), high = Math.ceil(Math.max(...values)), left = 26, last = this.points.at(-1).at;
    const x = (at) => left + (width - left - 4) * (1 - (last - at) / BEATS), y = (value) => 6 + (height - 12) * (high - value) / (high - low);
    pen.font = '11px system-ui, sans-serif';
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    pen.lineWidth = 1;
    for (const value of new Set([low, 0, 1, high])) {
      pen.strokeStyle = style.getPropertyValue('--line');
      pen.fillStyle = style.getPropertyValue('--soft');
      pen.beginPath();
      pen.moveTo(left, y(value));
      pen.lineTo(width, y(value));
      pen.stroke();
      pen.fillText(String(value).replace('-', '−'), left - 6, y(value));
    }
    pen.lineWidth = 1.8;
    pen.lineJoin = 'round';
    for (const name of ['drag', 'lift']) {
      pen.strokeStyle = style.getPropertyValue(`--${name}`);
      pen.beginPath();
      this.points.forEach((point, k) => pen[k ? 'lineTo' : 'moveTo'](x(point.at), y(point[name])));
      pen.stroke();
    }
  }
}
