// Tries the scripts of the page of a sample scene without a browser. Prints one line a case: "ok NAME" or "not ok NAME: reason".
//   node scene-page.mjs FOLDER      The folder holds scene-format.js, scene-look.js, scene-share.js, state.bin as a server sends it, and state.json as the tests read it.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const folder = process.argv[2], load = (name) => import(pathToFileURL(join(folder, name)).href);
const bytes = readFileSync(join(folder, 'state.bin')), told = JSON.parse(readFileSync(join(folder, 'state.json'), 'utf8'));
const { COLOURS, INSTANCE, TWO_SIDED, decode } = await load('scene-format.js'), { Look, axesOf, eyeOf } = await load('scene-look.js');
const sharing = await load('scene-share.js');
const state = decode(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));

function all(values, wanted, what, within = 1e-4) {
  if (values.length !== wanted.length || values.some((value, k) => !(Math.abs(value - wanted[k]) <= within * Math.max(1, Math.abs(wanted[k])))))
    throw new Error(`${what}: ${[...values]}, not ${wanted}`);
}

function same(values, wanted, what) {
  if (JSON.stringify(values) !== JSON.stringify(wanted))
    throw new Error(`${what}: ${JSON.stringify(values)}, not ${JSON.stringify(wanted)}`);
}

const cases = {
  state() {
    same(state.meshes.map(({ number, joints, parts }) => [number, (joints?.length ?? 0) / 4, parts.map(({ length }) => length)]), told.meshes.map(({ number, joints, parts }) => [number, joints, parts]), 'meshes');
    state.meshes.forEach(({ places }, k) => all([places.reduce((sum, value) => sum + value, 0)], [told.meshes[k].sum], `places of mesh ${k}`));
    same(state.maps.map(({ number, isNumbers, width, height, texels }) => [number, width, height, isNumbers ? texels.length / 4 : 0, isNumbers ? 0 : texels.length]), told.maps, 'textures');
    same(state.draws.map(({ mesh, part, picture, map, flags }) => [mesh, part, picture, map, flags]), told.draws.map(({ ids }) => ids), 'draws');
    state.draws.forEach(({ shine, underside, instances, count }, k) => {
      all(underside, told.draws[k].underside, `underside ${k}`);
      all([shine, instances[3], instances[7], instances[11], instances[INSTANCE * (count - 1) + 12]], [told.draws[k].shine, ...told.draws[k].first, told.draws[k].tint], `draw ${k}`);
    });
    same(state.draws.some(({ flags }) => flags & COLOURS && flags & TWO_SIDED), true, 'ground with colours');
    all(state.light.lamps.map(({ range }) => range), told.lamps, 'lamps');
    same([state.goneMeshes, state.goneMaps], [[], []], 'nothing is gone');
  },
  other() {
    let said = '';
    try {
      decode(new ArrayBuffer(16));
    } catch (problem) {
      said = problem.message;
    }
    same(said, 'That is no state of a scene.', 'other bytes');
  },
  camera() {
    all(eyeOf(state.camera), told.eye, 'the eye', 1e-3);
    const { right, up, ahead } = axesOf(state.camera);
    all([...right, ...up, ...ahead], [...told.right, ...told.up, ...told.ahead], 'the axes', 1e-4);
    same(state.camera.look, told.look, 'the look that it has');
  },
  // What the hand did is drawn at once, and only until the sample has it.
  look() {
    let now = 0;
    Object.assign(globalThis, { performance: { now: () => now } });
    const look = new Look(), from = { yaw: 10, pitch: 80, distance: 2, target: [1, 2, 3] };
    look.turn({ yaw: 5, pitch: 20 });
    look.turn({ yaw: 1, zoom: 0.5, move: [1, 0, 0] });
    same(look.told(), null, 'too early');
    now = 50;
    same(look.from(from), { yaw: 16, pitch: 89, distance: 1, target: [2, 2, 3] }, 'before it is told');
    same(look.told(), [1, 6, 20, 0.5, 1, 0, 0], 'told');
    same(look.told(), null, 'told twice');
    same(look.from(from).yaw, 16, 'until it is answered');
    look.turn({ zoom: 1e-9 });
    look.answered(1);
    same(look.from(from), { ...from, distance: 0.05 }, 'what comes later stays');
    look.clear();
    same(look.from(from), from, 'another scene');
  },
  // An address says what is set and where the camera looks, and a command does so for the shell; a hand that goes the way of a link is there.
  link() {
    const slider = (name, value) => ({ kind: 'slider', name, text: `${name}: ${value}`, value }), box = (text, on) => ({ kind: 'toggle', text, on });
    const first = [{ kind: 'label', text: 'Garden' }, slider('Butterflies', 8), slider("Wind's push", 0.5), box('Watch', false), box('Shy & quick', true)];
    const now = [{ kind: 'label', text: 'Night' }, slider('Butterflies', 12.3456789), slider("Wind's push", 1), box('Watch', true), box('Shy & quick', true)];
    const camera = { yaw: 730.12345, pitch: -12, distance: 4.2, target: [1, -0, 3.00004] };
    const set = sharing.changes(first, now), link = sharing.write({ scene: 'garden', camera, set });
    same(set, ['Butterflies=12.3457', "Wind's push=1", 'Watch'], 'changes');
    same(sharing.changes(first, first), [], 'nothing is changed');
    same(link, "#scene=garden&look=10.123,-12,4.2,1,0,3&set=Butterflies=12.3457&set=Wind%27s+push=1&set=Watch", 'address');
    same(sharing.read(link), { scene: 'garden', look: [10.123, -12, 4.2, 1, 0, 3], set }, 'read again');
    same(sharing.read(sharing.write({ scene: 'garden', camera, set: ['Shy & quick'] })).set, ['Shy & quick'], 'signs of addresses');
    same(['', '#species=monarch', '#look=1,2,3,4,5,6'].map(sharing.read), [null, null, null], 'no scene');
    same(['1,2,3', '1,2,0,4,5,6', '1,2,x,4,5,6'].map((look) => sharing.read(`#scene=swarm&look=${look}`).look), [null, null, null], 'no camera');
    same(sharing.command({ scene: 'garden', camera, set }), "dotnet run -c Release --project Headless~/Alate.Cli -- film --scene garden --set Butterflies=12.3457 --set 'Wind'\\''s push=1' --set Watch --look 10.123,-12,4.2,1,0,3", 'command');
    const look = new Look(), from = { yaw: 100, pitch: 3, distance: 8, target: [5, 6, 7] };
    look.turn(sharing.turnTo([10.123, -12, 4.2, 1, 0, 3], from));
    const { yaw, pitch, distance, target } = look.from(from);
    all([yaw, pitch, distance, ...target], [10.123, -12, 4.2, 1, 0, 3], 'where the link looks');
  },
};

for (const [name, run] of Object.entries(cases)) {
  try {
    run();
    console.log(`ok ${name}`);
  } catch (problem) {
    console.log(`not ok ${name}: ${problem.message}`);
    process.exitCode = 1;
  }
}
