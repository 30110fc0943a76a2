// Lift and drag over the last beats, as a running chart.
const BEATS = 3, FEWEST = 8, LEFT = 40, RIGHT = 10, TOP = 8, BOTTOM = 34;

export class Chart {
  constructor(canvas) {
    this.canvas = canvas;
    this.points = [];
  }

  clear() {
    this.points = [];
  }

  add(column) {
    const at = column.beats + column.phase / (2 * Math.PI), last = this.points.at(-1);
    if (last && at < last.at)
      this.points = [];
    if (last && at === last.at)
      return;
    this.points.push({ at, lift: column.lift, drag: column.drag });
    while (this.points[0].at < at - BEATS)
      this.points.shift();
  }

  draw() {
    const ratio = devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const pen = this.canvas.getContext('2d'), style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(`--${name}`);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = '11px system-ui, sans-serif';
    if (this.points.length < 2)
      return;
    const values = this.points.flatMap(({ lift, drag }) => [lift, drag, 0, 1]), last = this.points.at(-1).at;
    const marks = ticks(Math.min(...values), Math.max(...values), height > 120 ? 6 : 4), low = marks[0], high = marks.at(-1);
    const right = width - RIGHT, bottom = height - BOTTOM;
    const x = (at) => LEFT + (right - LEFT) * (1 - (last - at) / BEATS), y = (value) => TOP + (bottom - TOP) * (high - value) / (high - low);
    pen.lineWidth = 1;
    pen.fillStyle = colour('soft');
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    for (const mark of marks) {
      line(pen, colour(mark === 0 ? 'edge' : 'line'), [[LEFT, y(mark)], [right, y(mark)]]);
      pen.fillText(`${number(mark)} ×`, LEFT - 6, y(mark));
    }
    pen.textAlign = 'center';
    for (let beats = -BEATS; beats <= 0; beats++) {
      line(pen, colour('edge'), [[x(last + beats), bottom], [x(last + beats), bottom + 4]]);
      pen.fillText(beats ? number(beats) : 'now', Math.min(x(last + beats), right - 2), bottom + 12);
    }
    pen.fillText('beats', (LEFT + right) / 2, bottom + 26);
    const span = last - this.points[0].at;
    if (this.points.length / span < FEWEST && span > 1) {
      pen.fillText('too fast to draw: slow it down', (LEFT + right) / 2, (TOP + bottom) / 2);
      return;
    }
    pen.lineWidth = 1.8;
    pen.lineJoin = 'round';
    for (const name of ['drag', 'lift'])
      curve(pen, colour(name), this.points.map((point) => [x(point.at), y(point[name])]));
  }

  // What the chart shows, in words.
  summary() {
    const mean = (name) => number(Number((this.points.reduce((sum, point) => sum + point[name], 0) / this.points.length).toFixed(2)));
    const shown = 'Lift and drag over the last three beats';
    return this.points.length < 2 ? shown : `${shown}; on average ${mean('lift')} and ${mean('drag')} times the weight`;
  }
}

const number = (value) => String(value).replace('-', '−');

// Round numbers from below the least to above the largest: at most as many as are asked for.
export function ticks(least, largest, most) {
  for (let step = 0.1, k = 0; ; step *= [2, 2.5, 2][k++ % 3]) {
    const first = Math.floor(least / step + 1e-6), last = Math.ceil(largest / step - 1e-6);
    if (last - first < most)
      return Array.from({ length: last - first + 1 }, (_, at) => Number(((first + at) * step).toPrecision(6)));
  }
}

function line(pen, colour, points) {
  pen.strokeStyle = colour;
  pen.beginPath();
  points.forEach(([x, y], k) => pen[k ? 'lineTo' : 'moveTo'](x, y));
  pen.stroke();
}

// Through all points, smooth, and nowhere beyond the two that it lies between (Fritsch and Carlson).
function curve(pen, colour, points) {
  const slopes = slopesOf(points);
  pen.strokeStyle = colour;
  pen.beginPath();
  points.forEach(([x, y], k) => {
    if (k === 0) {
      pen.moveTo(x, y);
      return;
    }
    const [px, py] = points[k - 1], third = (x - px) / 3;
    pen.bezierCurveTo(px + third, py + third * slopes[k - 1], x - third, y - third * slopes[k], x, y);
  });
  pen.stroke();
}

export function slopesOf(points) {
  const steps = points.slice(1).map(([x, y], k) => ({ width: x - points[k][0], slope: (y - points[k][1]) / (x - points[k][0]) }));
  return points.map((_, k) => {
    const before = steps[k - 1], after = steps[k];
    if (!before || !after)
      return (before ?? after).slope;
    if (before.slope * after.slope <= 0)
      return 0;
    const one = 2 * after.width + before.width, other = after.width + 2 * before.width;
    return (one + other) / (one / before.slope + other / after.slope);
  });
}
