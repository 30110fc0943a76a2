// Reads the states that the simulation sends: little-endian, metres, glTF's axes (X to the left of the insect, Y up, Z ahead).
//   u32 magic, u32 columns, f64 simulated seconds, u32 number, u32 1 with wakes + 2 with places
//   each column: f32 phase, u32 beats, f32 hertz, f32 lift, f32 drag (weights), f32 flap, f32 abdomen (radians up), u32 substeps of a beat, u32 wings
//   each wing: u32 vertices, u32 joints, f32 reach, f32 force x 3 (weights), f32 x 3 joints, f32 x 3 loads (weights),
//              i16 x 4 a vertex: place / reach, and attack in degrees * 256 + stretch in tenths of a per cent; i8 x 4 a vertex: normal
//   with wakes, behind the wings of each column: u32 sheets, none before the first are done, else as many as wings
//   each sheet: u32 rows, u32 points of a row, f32 reach, f32 strongest circulation (m²/s), i16 x 4 a point: place / reach, and circulation
//              behind it / strongest, positive as a wing sheds it that the air pushes up; the first row lies at the trailing edge
//   with places, behind that of each column: f32 x 3 from the perch to the middle of the thorax, f32 x 4 the body's turn (x y z w), u32 0 it flies,
//              1 tumbles, 2 lands, 3 sits
export const MAGIC = 0x54414c41, GLB = 0x46546c67;

export function magicOf(buffer) {
  return buffer.byteLength < 4 ? 0 : new DataView(buffer).getUint32(0, true);
}

export function decode(buffer) {
  const view = new DataView(buffer);
  const state = { time: view.getFloat64(8, true), number: view.getUint32(16, true), columns: [] }, flags = view.getUint32(20, true);
  let at = 24;
  const number = () => view.getFloat32((at += 4) - 4, true);
  const whole = () => view.getUint32((at += 4) - 4, true);
  const take = (Type, count) => {
    const values = new Type(buffer, at, count);
    at += values.byteLength;
    return values;
  };
  for (let left = view.getUint32(4, true); left > 0; left--) {
    const column = { phase: number(), beats: whole(), hertz: number(), lift: number(), drag: number(), flap: number(), abdomen: number(), substeps: whole(), wings: [], sheets: [] };
    for (let wings = whole(); wings > 0; wings--) {
      const vertices = whole(), joints = whole(), reach = number(), force = [number(), number(), number()];
      column.wings.push({
        vertices, reach, force, joints: take(Float32Array, 3 * joints), loads: take(Float32Array, 3 * joints),
        places: take(Int16Array, 4 * vertices), normals: take(Int8Array, 4 * vertices),
      });
    }
    for (let sheets = flags & 1 ? whole() : 0; sheets > 0; sheets--) {
      const rows = whole(), width = whole(), reach = number(), strongest = number();
      column.sheets.push({ rows, width, reach, strongest, places: take(Int16Array, 4 * rows * width) });
    }
    if (flags & 2)
      column.place = { at: [number(), number(), number()], turn: [number(), number(), number(), number()], doing: whole() };
    state.columns.push(column);
  }
  return state;
}

// A state between two, of which the numbers that are no places are the earlier one's.
export function blend(a, b, share) {
  const mix = (Type, one, other, skip) => {
    const mixed = new Type(one.length);
    for (let k = 0; k < mixed.length; k++)
      mixed[k] = skip && k % 4 === 3 ? one[k] : one[k] + share * (other[k] - one[k]);
    return mixed;
  };
  return {
    ...a, columns: a.columns.map((column, c) => {
      const next = b.columns[c], between = (x, y) => x + share * (y - x);
      return {
        ...column, lift: between(column.lift, next.lift), drag: between(column.drag, next.drag), flap: between(column.flap, next.flap),
        abdomen: between(column.abdomen, next.abdomen),
        wings: column.wings.map((wing, w) => ({
          ...wing, force: wing.force.map((value, k) => between(value, next.wings[w].force[k])),
          joints: mix(Float32Array, wing.joints, next.wings[w].joints), loads: mix(Float32Array, wing.loads, next.wings[w].loads),
          places: mix(Int16Array, wing.places, next.wings[w].places, true), normals: mix(Int8Array, wing.normals, next.wings[w].normals),
        })),
      };
    }),
  };
}

function bytes(text) {
  const raw = atob(text), values = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; k++)
    values[k] = raw.charCodeAt(k);
  return values;
}

export const floats = (text) => new Float32Array(bytes(text).buffer);
export const wholes = (text) => new Uint32Array(bytes(text).buffer);
export const blob = (text, type) => new Blob([bytes(text)], { type });

const light = Float32Array.from({ length: 256 }, (_, k) => k / 255 <= 0.04045 ? k / 255 / 12.92 : ((k / 255 + 0.055) / 1.055) ** 2.4);

// sRGB bytes as linear light.
export function colours(text) {
  const encoded = bytes(text), linear = new Float32Array(encoded.length);
  for (let k = 0; k < encoded.length; k++)
    linear[k] = k % 4 === 3 ? encoded[k] / 255 : light[encoded[k]];
  return linear;
}
