// All that the page of a scene shows, as the end of its address and as the command that films it:
// #scene=garden&look=10,12,4,0,1,0&set=Butterflies=12&set=Watch
const PROGRAM = 'dotnet run -c Release --project Headless~/Alate.Cli --';

const keyOf = ({ name, text }) => name ?? text;

// What is set on the sample's panel otherwise than it was at first: LABEL=VALUE of a slider, the words of a box that is pressed.
export function changes(first, controls) {
  const before = new Map(first.map((control) => [keyOf(control), control]));
  return controls.flatMap((control) => {
    const was = before.get(keyOf(control));
    if (control.kind === 'slider' && was?.value !== control.value)
      return [`${control.name}=${Number(control.value.toPrecision(6))}`];
    return control.kind === 'toggle' && was && was.on !== control.on ? [control.text] : [];
  });
}

// Degrees to the side and down, distance, and the point that is looked at.
const lookOf = ({ yaw, pitch, distance, target }) =>
  [yaw - 360 * Math.round(yaw / 360), pitch, distance, ...target].map((number) => Number(number.toFixed(3)) + 0);

export function write({ scene, camera, set }) {
  const parts = new URLSearchParams({ scene, look: lookOf(camera).join() });
  set.forEach((change) => parts.append('set', change));
  return `#${String(parts).replaceAll('%2C', ',').replaceAll('%3D', '=')}`;
}

// Null for an address that names no scene.
export function read(hash) {
  const parts = new URLSearchParams(hash.replace(/^#/, '')), look = (parts.get('look') ?? '').split(',').map(Number);
  if (!parts.get('scene'))
    return null;
  return { scene: parts.get('scene'), look: look.length === 6 && look.every(Number.isFinite) && look[2] > 0 ? look : null, set: parts.getAll('set') };
}

export function command({ scene, camera, set }) {
  const quote = (word) => (/^[\w=.,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
  return [PROGRAM, 'film --scene', quote(scene), ...set.map((change) => `--set ${quote(change)}`), `--look ${lookOf(camera).join()}`].join(' ');
}

// The way of a camera to where a link had it, as a hand would turn it.
export function turnTo(look, { yaw, pitch, distance, target }) {
  const [toYaw, toPitch, toDistance, ...toTarget] = look;
  return { yaw: toYaw - yaw, pitch: toPitch - pitch, zoom: toDistance / distance, move: toTarget.map((value, k) => value - target[k]) };
}
