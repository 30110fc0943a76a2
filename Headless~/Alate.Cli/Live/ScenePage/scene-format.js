// Reads the states of a sample that plays: little-endian, with the units and axes of Unity (X right, Y up, Z ahead), linear light.
//   u32 magic, u32 number, f64 seconds that have passed
//   u32 number of the last look that it has, f32 yaw, pitch (degrees), distance, f32 x 3 target, f32 opening (degrees), nearest depth,
//   f32 x 3 light behind all
//   f32 x 3 each: light from sky, equator and ground, direction to the sun, light of the sun; u32 1 with shadows; u32 lamps, each f32 x 3
//   place, f32 x 3 light, f32 range
//   u32 meshes that are new or changed, each: u32 number, u32 1 whole + 2 coordinates + 4 colours + 8 baked + 16 joints, u32 vertices, u32
//   parts, f32 x 3 places, i8 x 4 normals; whole ones then f32 x 2 coordinates, f32 x 4 colours, f32 x 2 baked, f32 x 4 joints where they
//   have them, and each part: u32 indices, u32 x indices
//   u32 meshes that are gone: u32 numbers
//   u32 textures, each: u32 number, u32 0 colours or 1 numbers, u32 width, u32 height, u8 x 4 or f32 x 4 texels, rows from below
//   u32 textures that are gone: u32 numbers
//   u32 draws, each: u32 mesh, part, picture, map (0 none), u32 1 skinned + 2 baked + 4 colours + 8 two-sided + 16 translucent + 32 without a
//   shadow + 64 cut by opacity, f32 through, gloss, shine, f32 x 4 underside, u32 instances, f32 x 24 an instance: three rows of the matrix, tint, and rows of the loop and of the next, or the first joint
export const MAGIC = 0x53414c41, INSTANCE = 24;
export const SKINNED = 1, BAKED = 2, COLOURS = 4, TWO_SIDED = 8, TRANSLUCENT = 16, SHADOWLESS = 32, CUT = 64;

export function decode(buffer) {
  const view = new DataView(buffer);
  let at = 16;
  const number = () => view.getFloat32((at += 4) - 4, true);
  const whole = () => view.getUint32((at += 4) - 4, true);
  const take = (Type, count) => {
    const values = new Type(buffer, at, count);
    at += values.byteLength;
    return values;
  };
  const place = () => [number(), number(), number()];
  const list = (read) => Array.from({ length: whole() }, read);
  if (view.getUint32(0, true) !== MAGIC)
    throw new Error('That is no state of a scene.');
  return {
    number: view.getUint32(4, true), time: view.getFloat64(8, true),
    camera: { look: whole(), yaw: number(), pitch: number(), distance: number(), target: place(), opening: number(), nearest: number() },
    behind: place(),
    light: {
      sky: place(), equator: place(), ground: place(), sunFrom: place(), sun: place(), hasShadows: whole() === 1,
      lamps: list(() => ({ place: place(), light: place(), range: number() })),
    },
    meshes: list(() => {
      const mesh = { number: whole() }, flags = whole(), vertices = whole(), parts = whole();
      Object.assign(mesh, { isWhole: (flags & 1) > 0, vertices, places: take(Float32Array, 3 * vertices), normals: take(Int8Array, 4 * vertices) });
      if (!mesh.isWhole)
        return mesh;
      const some = (flag, size) => flags & flag ? take(Float32Array, size * vertices) : null;
      return { ...mesh, coordinates: some(2, 2), colours: some(4, 4), baked: some(8, 2), joints: some(16, 4), parts: Array.from({ length: parts }, () => take(Uint32Array, whole())) };
    }),
    goneMeshes: list(whole),
    maps: list(() => {
      const map = { number: whole(), isNumbers: whole() === 1, width: whole(), height: whole() };
      return { ...map, texels: take(map.isNumbers ? Float32Array : Uint8Array, 4 * map.width * map.height) };
    }),
    goneMaps: list(whole),
    draws: list(() => {
      const draw = { mesh: whole(), part: whole(), picture: whole(), map: whole(), flags: whole(), through: number(), gloss: number(), shine: number(), underside: [...place(), number()], count: whole() };
      return { ...draw, instances: take(Float32Array, INSTANCE * draw.count) };
    }),
  };
}
