// Shows GLB files by three.js in Chromium and saves a picture of each.
//   node glb.mjs CHROMIUM FOLDER [FILE TURNS ASIDE ABOVE]...
import { chromium } from 'playwright-core';
import { readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [executablePath, folder, ...shots] = process.argv.slice(2), three = join(dirname(fileURLToPath(import.meta.url)), 'node_modules', 'three');
const html = `<!DOCTYPE html><style>body{margin:0;background:#f7f4ec}</style><canvas id=c width=640 height=512></canvas>
<script type=importmap>{"imports":{"three":"/three/build/three.module.js"}}</script>
<script type=module>
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
window.show = async (url, turns, aside, above) => {
  const renderer = new THREE.WebGLRenderer({ canvas: document.getElementById('c'), antialias: true, alpha: true, preserveDrawingBuffer: true });
  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(26, 1.25, 0.001, 10);
  const { scene: insect, animations } = await new GLTFLoader().loadAsync(url);
  scene.add(insect, new THREE.HemisphereLight(0xffffff, 0xb9ad98, 1.8));
  const mixer = new THREE.AnimationMixer(insect), clip = animations[0];
  mixer.clipAction(clip).play();
  mixer.setTime(turns * clip.duration);
  const box = new THREE.Box3().setFromObject(insect), middle = box.getCenter(new THREE.Vector3()), size = box.getSize(new THREE.Vector3()).length();
  const s = aside * Math.PI / 180, a = above * Math.PI / 180;
  camera.position.set(Math.cos(a) * Math.sin(s), Math.sin(a), Math.cos(a) * Math.cos(s)).multiplyScalar(size).add(middle);
  camera.lookAt(middle);
  const key = new THREE.DirectionalLight(0xffffff, 2);
  key.position.copy(camera.position).add(new THREE.Vector3(0, size, 0));
  key.target.position.copy(middle);
  scene.add(key, key.target);
  renderer.render(scene, camera);
};
window.ready = true;
</script>`;
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
let bad = 0;
for (let k = 0; k + 3 < shots.length; k += 4) {
  const [file, turns, aside, above] = shots.slice(k, k + 4), page = await browser.newPage({ viewport: { width: 640, height: 512 } });
  page.on('pageerror', (problem) => { bad++; console.log(`not ok ${file}: ${problem.message}`); });
  page.on('console', (message) => message.type() === 'error' && (bad++, console.log(`not ok ${file}: ${message.text()}`)));
  await page.route('http://glb.test/**', (route) => {
    const path = new URL(route.request().url()).pathname;
    if (path === '/favicon.ico')
      return route.fulfill({ status: 204 });
    if (path === '/')
      return route.fulfill({ contentType: 'text/html', body: html });
    return path === '/file.glb' ? route.fulfill({ contentType: 'model/gltf-binary', body: readFileSync(file) })
      : route.fulfill({ contentType: 'text/javascript', body: readFileSync(join(three, path.replace('/three/', ''))) });
  });
  await page.goto('http://glb.test/');
  await page.waitForFunction(() => window.ready, null, { timeout: 60000 });
  await page.evaluate(([...shot]) => window.show('/file.glb', ...shot), [Number(turns), Number(aside), Number(above)]);
  await page.screenshot({ path: join(folder, `${basename(dirname(file))}.png`) });
  await page.close();
}
await browser.close();
process.exit(bad > 0 ? 1 : 0);
