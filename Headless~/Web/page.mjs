// Tries the scripts of the live view's page without a browser, each by itself. Prints one line a case: "ok NAME" or "not ok NAME: reason".
//   node page.mjs FOLDER      The folder holds the page's scripts, state.bin as a server sends it, and state.json as the tests read it.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const folder = process.argv[2], load = (name) => import(pathToFileURL(join(folder, name)).href);
const bytes = readFileSync(join(folder, 'state.bin')), told = JSON.parse(readFileSync(join(folder, 'state.json'), 'utf8'));
const { MAGIC, blend, colours, decode, floats, magicOf, wholes } = await load('format.js');
const { Arrows, heat, ramps } = await load('overlays.js');
const { Chart, slopesOf, ticks } = await load('chart.js'), { Live } = await load('live.js');
const buffer = () => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);

function near(value, wanted, what, within = 1e-5) {
  if (!(Math.abs(value - wanted) <= within * Math.max(1, Math.abs(wanted))))
    throw new Error(`${what}: ${value}, not ${wanted}`);
}

function all(values, wanted, what, within) {
  near(values.length, wanted.length, `${what}, length`);
  wanted.forEach((value, k) => near(values[k], value, `${what} ${k}`, within));
}

function same(values, wanted, what) {
  if (JSON.stringify(values) !== JSON.stringify(wanted))
    throw new Error(`${what}: ${JSON.stringify(values)}, not ${JSON.stringify(wanted)}`);
}

// The sRGB of linear light; opacity is none of it.
function encode(value, k) {
  return k % 4 === 3 ? value : value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
}

const cases = {
  async droppedFolders() {
    const { filesOf, read } = await load('dropped.js'), names = async (...entries) => (await filesOf(dropOf(...entries))).map(({ name }) => name);
    same(await names(['a.obj', 1], ['b.png', 2]), ['a.obj', 'b.png'], 'files alone');
    same(await names(['moth', [['moth.insect.json', 1], ['.DS_Store', 9], ['wings', [['fore.obj', 1], ['fore.json', 1], ['fore.png', 1]]], ['.git', [['HEAD', 1]]]]], ['more.csv', 1]),
      ['moth.insect.json', 'fore.obj', 'fore.json', 'fore.png', 'more.csv'], 'a folder');
    const many = await filesOf(dropOf(['home', Array.from({ length: 1000 }, (_, k) => [`${k}.obj`, 1])]));
    same(many.length, 17, 'the first beyond the most');
    same(await read(many).catch((problem) => problem.message), 'These are more than 16 files; drop those of one insect.', 'too many');
    same(await filesOf({ files: [{ name: 'x' }], items: [{}] }), [{ name: 'x' }], 'where a browser tells no entries');
  },
  // A socket that tells before anybody listens: all of it in its order, and of the states the last one.
  early() {
    class Socket {
      static OPEN = 1;
      readyState = 1;
      sent = [];
      send(text) { this.sent.push(text); }
      close() { this.isClosed = true; }
    }
    Object.assign(globalThis, { WebSocket: Socket, location: { host: 'nowhere' } });
    const live = new Live({ speed: 2 }), { socket } = live, said = [];
    const listener = new Proxy({}, { get: (_, name) => (value) => said.push(name === 'state' ? `${name} ${value.time === told.time}` : `${name} ${value.type ?? value}`) });
    const say = (message) => socket.onmessage({ data: typeof message === 'string' ? JSON.stringify({ type: message }) : message });
    socket.onopen();
    ['hello', buffer(), 'scene', buffer(), buffer(), 'settings', buffer()].forEach(say);
    same(said, [], 'nobody listens');
    live.listen(listener);
    same(said, ['status live', 'hello hello', 'scene scene', 'settings settings', 'state true'], 'told once');
    ['error', buffer()].forEach(say);
    same(said.slice(5), ['error error', 'state true'], 'and at once from then on');
    same(socket.sent, ['{"speed":2}'], 'what was wanted');
    live.close();
    if (!socket.isClosed || socket.onclose)
      throw new Error('comes back after it was closed');
  },

  decode() {
    const state = decode(buffer()), [column] = state.columns;
    near(magicOf(buffer()), MAGIC, 'magic');
    near(magicOf(new ArrayBuffer(2)), 0, 'magic of two bytes');
    near(state.columns.length, told.columns, 'columns');
    near(state.time, told.time, 'time');
    for (const name of ['phase', 'beats', 'hertz', 'lift', 'drag', 'flap', 'abdomen', 'substeps'])
      near(column[name], told[name], name);
    near(column.wings.length, told.wings.length, 'wings');
    told.wings.forEach((wing, w) => {
      const read = column.wings[w];
      near(read.reach, wing.reach, 'reach');
      all(read.force, wing.force, 'force');
      all(read.joints, wing.joints, 'joints');
      all(read.loads, wing.loads, 'loads');
      near(read.vertices, wing.stretch.length, 'vertices');
      for (let k = 0; k < read.vertices; k++) {
        near(ramps.strain.of(read.places[4 * k + 3]), wing.stretch[k], 'stretch, per cent');
        near(ramps.attack.of(read.places[4 * k + 3]), wing.attack[k], 'attack, degrees');
        for (let c = 0; c < 3; c++)
          near(read.places[4 * k + c] / 32767 * read.reach, wing.places[3 * k + c], 'place, metres', 1e-6);
      }
    });
  },

  blend() {
    const wing = (x) => ({ reach: 2, force: [x, 2 * x, 0], joints: Float32Array.of(x, 0), loads: Float32Array.of(-x), places: Int16Array.of(100 * x, 0, 0, 7 * x), normals: Int8Array.of(0, 10 * x, 0, 0) });
    const at = (x) => ({ time: x, columns: [{ phase: x, lift: x, drag: 10 * x, flap: -x, abdomen: 2 * x, wings: [wing(x)] }] });
    const [column] = blend(at(1), at(3), 0.25).columns, [between] = column.wings;
    all([column.lift, column.drag, column.flap, column.abdomen, column.phase], [1.5, 15, -1.5, 3, 1], 'column');
    all([...between.force, between.joints[0], between.loads[0], between.places[0], between.normals[1]], [1.5, 3, 0, 1.5, -1.5, 150, 15], 'wing');
    near(between.places[3], 7, 'packed numbers are those of the earlier state');
  },

  async sheets() {
    // Two columns of two rows of three points, the second without a wake yet.
    const column = (sheets) => [...new Uint8Array(32), 0, 0, 0, 0, ...u32(sheets)], u32 = (...values) => new Uint8Array(Uint32Array.from(values).buffer);
    const f32 = (...values) => new Uint8Array(Float32Array.from(values).buffer);
    const points = Int16Array.from({ length: 24 }, (_, k) => k % 4 === 3 ? (k < 12 ? 32767 : -16384) : 1000 * k);
    const made = Uint8Array.from([...u32(MAGIC, 2, 0, 0, 7, 1), ...column(1), ...u32(2, 3), ...f32(0.5, 0.04), ...new Uint8Array(points.buffer), ...column(0)]);
    const [first, second] = decode(made.buffer).columns, [sheet] = first.sheets;
    near(second.sheets.length, 0, 'sheets of the second column');
    all([sheet.rows, sheet.width, sheet.reach, sheet.strongest], [2, 3, 0.5, 0.04], 'sheet');
    all([...sheet.places], [...points], 'places');

    const { Sheet, shade } = await load('overlays.js'), colour = new Float32Array(4);
    for (const { share, colour: wanted } of told.wakeColours) {
      shade(share, 1, colour, 0);
      all([...colour].map(encode), wanted, `colour of ${share}`, 1e-4);
      shade(share, 0.5, colour, 0);
      near(colour[3], wanted[3] / 2, 'half as dense where it is old');
    }
    const drawn = new Sheet(fake());
    drawn.set(sheet);
    const { position, color } = drawn.geometry.attributes;
    all([...position.array.subarray(0, 24)], [...points], 'places that are drawn');
    all([color.array[3], color.array[4 * 3 + 3]], [0.7, 0], 'dense at the edge, none at the end');
    all([...drawn.geometry.index.array.subarray(0, drawn.geometry.range[1])], [0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4], 'triangles');
  },

  texts() {
    const text = (values) => Buffer.from(values.buffer).toString('base64');
    all(floats(text(Float32Array.of(1.5, -2))), [1.5, -2], 'floats');
    all(wholes(text(Uint32Array.of(70000, 3))), [70000, 3], 'whole numbers');
    // Encoded again as sRGB they are the bytes; opacity is none of them.
    const linear = colours(text(Uint8Array.of(255, 0, 128, 51, 5, 60, 200, 255)));
    const encoded = [...linear].map((value, k) => 255 * encode(value, k));
    all(encoded, [255, 0, 128, 51, 5, 60, 200, 255], 'colours', 1e-3);
  },

  ramps() {
    const colour = new Float32Array(4), of = (ramp, value) => (heat(ramp, value, colour, 0), [...colour].slice(0, 3));
    for (const ramp of Object.values(ramps)) {
      all(of(ramp, ramp.low), ramp.light[0], 'low end');
      all(of(ramp, ramp.high), ramp.light.at(-1), 'high end');
      all(of(ramp, ramp.low - 5), ramp.light[0], 'below');
      all(of(ramp, 9 * ramp.high), ramp.light.at(-1), 'above');
      all(of(ramp, (ramp.low + ramp.high) / 8 + ramp.low * 0.75), ramp.light[0].map((value, c) => (value + ramp.light[1][c]) / 2), 'an eighth of the way');
    }
  },

  chart() {
    const drawn = [], pen = new Proxy({}, { get: (made, name) => made[name] ?? ((...values) => drawn.push([name, made.strokeStyle, ...values])), set: (made, name, value) => (made[name] = value, true) });
    globalThis.devicePixelRatio = 1;
    globalThis.document = { documentElement: {} };
    globalThis.getComputedStyle = () => ({ getPropertyValue: (name) => name });
    const chart = new Chart({ clientWidth: 200, clientHeight: 100, width: 0, height: 0, getContext: () => pen });
    same(chart.summary(), 'Lift and drag over the last three beats', 'a chart without a flight is named too');
    for (let k = 0; k <= 50; k++)
      chart.add({ beats: Math.floor(k / 10), phase: k % 10 / 10 * 2 * Math.PI, lift: 1 + k / 50, drag: -0.5 });
    near(chart.points.length, 31, 'three beats are kept');
    near(chart.points.at(-1).at, 5, 'beats');
    chart.draw();
    const line = (name) => drawn.filter(([what, style]) => (what === 'bezierCurveTo' || what === 'moveTo') && style === `--${name}`).map((call) => call.slice(-2));
    const lift = line('lift'), drag = line('drag');
    near(lift.length, 31, 'lift is drawn');
    if (!(lift.at(-1)[1] < lift[0][1] && lift[0][1] < drag[0][1]))
      throw new Error('more lift lies higher, and the drag below');
    if (!(lift[0][0] < lift.at(-1)[0]))
      throw new Error('time goes to the right');
    near(lift.at(-1)[1], 8, 'two weights at the top of a chart from -1 to 2');
    near(drag[0][1], 8 + 58 * 2.5 / 3, 'and minus a half above its bottom');
    const texts = drawn.filter(([what]) => what === 'fillText').map(([, , text]) => text);
    for (const text of ['−1 ×', '0 ×', '2 ×', '−3', '−1', 'now', 'beats'])
      near(texts.filter((one) => one === text).length, 1, `marks with ${text}`);
    chart.add({ beats: 5, phase: 0, lift: 9, drag: 9 });
    near(chart.points.length, 31, 'a flight that stands still adds nothing');
    chart.points = Array.from({ length: 7 }, (_, k) => ({ at: 0.4 * k, lift: 0, drag: 0 }));
    drawn.length = 0;
    chart.draw();
    near(line('lift').length, 0, 'too few states of a beat are no curve');
    chart.add({ beats: 0, phase: 0, lift: 0, drag: 0 });
    near(chart.points.length, 1, 'a flight that begins again begins a chart');
  },

  // Through each point, and between two never beyond them, so that no peak is drawn that was not there.
  slopes() {
    const points = [[0, 0], [1, 1], [2, 1], [4, 5], [5, 5.5], [6, 0]], slopes = slopesOf(points);
    points.slice(1).forEach(([x, y], k) => {
      const [px, py] = points[k], width = x - px, chord = (y - py) / width;
      for (let t = 0; t <= 1; t += 0.05) {
        const value = py * (1 - t) ** 3 + 3 * (py + width / 3 * slopes[k]) * t * (1 - t) ** 2 + 3 * (y - width / 3 * slopes[k + 1]) * t ** 2 * (1 - t) + y * t ** 3;
        if (value < Math.min(y, py) - 1e-9 || value > Math.max(y, py) + 1e-9)
          throw new Error(`${value} between ${py} and ${y}, of slope ${chord}`);
      }
    });
    all(slopesOf([[0, 1], [1, 3], [4, 9]]), [2, 2, 2], 'a straight line stays one');
  },

  ticks() {
    for (const [least, largest, most] of [[-0.3, 2.2, 6], [0, 1, 4], [-12, 37, 6], [-0.02, 1, 4], [-1, 2, 6], [0, 140, 5]]) {
      const marks = ticks(least, largest, most), step = marks[1] - marks[0];
      if (!(marks[0] <= least && marks.at(-1) >= largest && marks.length <= most && marks[1] > least && marks.at(-2) < largest))
        throw new Error(`${marks} for ${least} to ${largest}`);
      marks.forEach((mark, k) => near(mark, marks[0] + k * step, 'even steps', 1e-6));
      near([1, 2, 5].some((digit) => Math.abs(Math.log10(step / digit) % 1) < 1e-9), true, `a round step: ${step}`);
    }
  },

  // What is written is what is read, and what is no link of the page says nothing.
  async share() {
    const same = (found, wanted, what) => {
      if (JSON.stringify(found.map(String)) !== JSON.stringify(wanted))
        throw new Error(`${what}: ${found} in place of ${wanted}`);
    };
    const { read, write } = await load('share.js');
    const settings = { species: 'my-moth', variant: 'expressive', compare: true, wake: true, landing: false, paused: true, values: { slow: 0.073, speed: -1.25, substeps: 40, delay: 1 / 3 } };
    const link = read(write({ settings, view: [-0.68, 0.5, 4.12345], shown: new Set(['chart', 'skeleton']), theme: 'dark' }));
    const { species, variant, compare, wake, landing, values, ...others } = link.wanted;
    same([species, variant, compare, wake, landing, link.theme, ...link.shown], ['my-moth', 'expressive', 'true', 'true', 'false', 'dark', 'chart', 'skeleton'], 'settings');
    same(Object.keys(values), Object.keys(settings.values), 'sliders');
    Object.entries(settings.values).forEach(([name, number]) => near(values[name], number, name, 1e-6));
    same(link.view, ['-0.68', '0.5', '4.123'], 'camera');
    near(Object.keys(others).length, 0, 'a pause is not shared');
    const plain = read(write({ settings: { ...settings, compare: false, wake: false }, view: [0, 0, 4], shown: new Set(), theme: null }));
    same([plain.wanted.compare, plain.wanted.wake, plain.theme, plain.shown.length], ['false', 'false', 'null', '0'], 'nothing else');
    const odd = read('#species=monarch&view=1,x,3&speed=fast&theme=blue');
    same([odd.view, odd.theme, Object.keys(odd.wanted.values).length, 'variant' in odd.wanted], ['null', 'null', '0', 'false'], 'what is no number');
    same([read(''), read('#'), read('#top')], ['null', 'null', 'null'], 'no link');
  },

  async arrows() {
    const three = fake(), made = [];
    const { Stage } = await load('stage.js');
    const force = () => ({ object: {}, update() {}, set(...values) { made.push(values); } });
    const stage = Object.create(Stage.prototype);
    Object.assign(stage, { three, shown: { forces: true }, reach: 2 });
    const column = { sheets: [], skeleton: { geometry: { getAttribute: () => ({ array: [] }) } }, wings: [], loads: force(), forces: [force(), force()], abdomen: { rotation: {} } };
    stage.pose(column, { lift: 1.25, drag: 0.5, abdomen: 0.2, wings: [] });
    near(column.abdomen.rotation.x, 0.2, 'the abdomen goes up as it is told');
    all(made[0], [0, 0, 0, 0, 0, 1.25, 0, 0.7], 'lift goes up');
    all(made[1], [0, 0, 0, 0, 0, 0, -0.5, 0.7], 'drag goes to the rear');
    const placed = [];
    const arrows = new Arrows(three, 1, 0, 0.1);
    arrows.shafts.setMatrixAt = (k, values) => placed.push(values);
    arrows.heads.setMatrixAt = (k, values) => placed.push(values);
    arrows.set(0, 1, 2, 3, 0, 0, -4, 0.5);
    all(placed[0].from, [1, 2, 3], 'the shaft begins where it is told');
    near(placed[0].scale[1], 1.9, 'and is as long as the arrow but for half a head');
    all(placed[1].from, [1, 2, 3 - 1.84], 'the head ends where the arrow does');
    all(placed[1].along, [0, 0, -1], 'along the force');
  },
};

// As much of three.js as arrows need: what is composed is kept as it is.
function fake() {
  class Vector3 {
    constructor(x = 0, y = 0, z = 0) { this.set(x, y, z); }
    set(x, y, z) { return Object.assign(this, { x, y, z }); }
    setScalar(s) { return this.set(s, s, s); }
    normalize() { const l = Math.hypot(this.x, this.y, this.z) || 1; return this.set(this.x / l, this.y / l, this.z / l); }
    addScaledVector(v, s) { return this.set(this.x + s * v.x, this.y + s * v.y, this.z + s * v.z); }
    get array() { return [this.x, this.y, this.z]; }
  }
  class Quaternion { setFromUnitVectors(a, b) { return Object.assign(this, { to: b.array }); } }
  class Matrix4 { compose(from, turn, scale) { return { from: from.array, along: turn.to, scale: scale.array }; } }
  class Geometry {
    attributes = {};
    translate() { return this; }
    dispose() {}
    setAttribute(name, values) { this.attributes[name] = values; }
    getAttribute(name) { return this.attributes[name]; }
    setIndex(values) { this.index = values; }
    setDrawRange(...range) { this.range = range; }
  }
  class BufferAttribute { constructor(array) { this.array = array; } }
  class Mesh { scale = { setScalar() {} }; }
  class Plain { add() {} }
  class Instanced { constructor() { this.instanceMatrix = {}; } }
  return { Vector3, Quaternion, Matrix4, CylinderGeometry: Geometry, ConeGeometry: Geometry, BufferGeometry: Geometry, BufferAttribute, Group: Plain, Mesh, MeshBasicMaterial: Plain, InstancedMesh: Instanced };
}

// What a browser tells of a file or folder that is dropped; folders give their entries in parts of two.
function entryOf(name, content) {
  if (!Array.isArray(content))
    return { name, isFile: true, isDirectory: false, file: (done) => done({ name, size: content }) };
  return {
    name, isFile: false, isDirectory: true,
    createReader() {
      const left = content.map((inner) => entryOf(...inner));
      return { readEntries: (done) => setTimeout(() => done(left.splice(0, 2))) };
    },
  };
}

function dropOf(...entries) {
  return { files: entries.map(([name]) => ({ name })), items: entries.map((entry) => ({ webkitGetAsEntry: () => entryOf(...entry) })) };
}

for (const [name, run] of Object.entries(cases)) {
  try {
    await run();
    console.log(`ok ${name}`);
  } catch (problem) {
    console.log(`not ok ${name}: ${problem.message}`);
    process.exitCode = 1;
  }
}
