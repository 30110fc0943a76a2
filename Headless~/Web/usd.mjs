// Plays USD files by three.js in Chromium beside the GLB files of the same bakes, and saves a picture of each.
//   node usd.mjs CHROMIUM FOLDER [FILE.usda FILE.glb]...
// A line for each pair: the clips, and how far their corners of triangles are apart at most, metres.
import { chromium } from 'playwright-core';
import { readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [executablePath, folder, ...pairs] = process.argv.slice(2), three = join(dirname(fileURLToPath(import.meta.url)), 'node_modules', 'three');
const types = { '.js': 'text/javascript', '.png': 'image/png', '.glb': 'model/gltf-binary' };
const html = `<!DOCTYPE html><style>body{margin:0;background:#f7f4ec}</style><canvas id=c width=640 height=512></canvas>
<script type=importmap>{"imports":{"three":"/three/build/three.module.js"}}</script>
<script type=module>
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { USDLoader } from '/three/examples/jsm/loaders/USDLoader.js';
function corners(insect, animations, name, turns) {
  const mixer = new THREE.AnimationMixer(insect), clip = animations.find((one) => one.name === name), places = [];
  mixer.clipAction(clip).play();
  mixer.setTime(turns * clip.duration);
  insect.updateMatrixWorld(true);
  insect.traverse((mesh) => {
    if (!mesh.isMesh)
      return;
    mesh.skeleton?.update();
    const index = mesh.geometry.index, count = index ? index.count : mesh.geometry.attributes.position.count;
    for (let k = 0; k < count; k++) {
      const place = mesh.getVertexPosition(index ? index.getX(k) : k, new THREE.Vector3()).applyMatrix4(mesh.matrixWorld);
      places.push(place.x, place.y, place.z);
    }
  });
  mixer.stopAllAction();
  return { places, seconds: clip.duration };
}
window.compare = async (usd, glb) => {
  const scene = await new USDLoader().loadAsync(usd), { scene: other, animations } = await new GLTFLoader().loadAsync(glb);
  let farthest = 0, longer = 0;
  for (const { name } of animations) {
    for (const turns of [0, 0.13, 0.25, 0.5, 0.71]) {
      const a = corners(scene, scene.animations, name, turns), b = corners(other, animations, name, turns);
      longer = Math.max(longer, Math.abs(a.seconds - b.seconds));
      if (a.places.length !== b.places.length)
        throw new Error(a.places.length + ' and ' + b.places.length + ' coordinates');
      for (let k = 0; k < a.places.length; k++)
        farthest = Math.max(farthest, Math.abs(a.places[k] - b.places[k]));
    }
  }
  const renderer = new THREE.WebGLRenderer({ canvas: document.getElementById('c'), antialias: true, alpha: true, preserveDrawingBuffer: true });
  const stage = new THREE.Scene(), camera = new THREE.PerspectiveCamera(26, 1.25, 0.001, 10), mixer = new THREE.AnimationMixer(scene);
  stage.add(scene, new THREE.HemisphereLight(0xffffff, 0xb9ad98, 2.4));
  mixer.clipAction(scene.animations[0]).play();
  mixer.setTime(0.1 * scene.animations[0].duration);
  const box = new THREE.Box3().setFromObject(scene), middle = box.getCenter(new THREE.Vector3());
  camera.position.set(0.4, 0.6, 0.7).normalize().multiplyScalar(1.9 * box.getSize(new THREE.Vector3()).length()).add(middle);
  camera.lookAt(middle);
  renderer.render(stage, camera);
  return { farthest, longer, clips: scene.animations.map((clip) => clip.name), meshes: animations.length };
};
window.ready = true;
</script>`;
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
let bad = 0;
for (let k = 0; k + 1 < pairs.length; k += 2) {
  const [usd, glb] = pairs.slice(k, k + 2), page = await browser.newPage({ viewport: { width: 640, height: 512 } });
  page.on('pageerror', (problem) => { bad++; console.log(`not ok ${usd}: ${problem.message}`); });
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !message.text().includes('GL Driver')
    && (bad++, console.log(`not ok ${usd}: ${message.text()}`)));
  await page.route('http://usd.test/**', (route) => {
    const path = decodeURIComponent(new URL(route.request().url()).pathname);
    if (path === '/favicon.ico')
      return route.fulfill({ status: 204 });
    if (path === '/')
      return route.fulfill({ contentType: 'text/html', body: html });
    const file = path.startsWith('/three/') ? join(three, path.replace('/three/', '')) : path === '/file.glb' ? glb : join(dirname(usd), basename(path));
    return route.fulfill({ contentType: types[file.slice(file.lastIndexOf('.'))] ?? 'text/plain', body: readFileSync(file) });
  });
  await page.goto('http://usd.test/');
  await page.waitForFunction(() => window.ready, null, { timeout: 60000 });
  console.log(JSON.stringify(await page.evaluate(([a, b]) => window.compare(a, b), [`/${basename(usd)}`, '/file.glb'])));
  await page.screenshot({ path: join(folder, `${basename(usd, '.usda')}.png`) });
  await page.close();
}
await browser.close();
process.exit(bad > 0 ? 1 : 0);
