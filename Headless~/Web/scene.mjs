// Loads the page of a sample scene in Chromium and tries what a person would. Prints one line a case: "ok NAME" or "not ok NAME: reason".
//   node scene.mjs ADDRESS CHROMIUM FOLDER CASE...
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import * as browse from './browse.mjs';
import { check } from './browse.mjs';

const [address, executablePath, folder, ...wanted] = process.argv.slice(2);
const browser = await browse.launch(executablePath, '--enable-precise-memory-info', '--js-flags=--expose-gc');
const problems = [], page = await open({ width: 900, height: 500 });

function open(viewport) {
  return browse.open(browser, address, problems, { viewport }, () => Boolean(window.alate?.state));
}

const wait = (test, what, timeout = 30000) => browse.wait(page, test, what, timeout);
const camera = () => page.evaluate(() => alate.state.camera);
const later = () => page.waitForTimeout(700);

// How many pixels are not as the first one, how many colours there are, and how light it is.
const picture = () => page.evaluate(() => {
  alate.stage.render(true);
  const gl = alate.stage.renderer.getContext(), pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight), found = new Set();
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let other = 0, light = 0;
  const first = pixels.length - 4 * gl.drawingBufferWidth;
  for (let k = 0; k < pixels.length; k += 4) {
    other += [0, 1, 2].some((c) => pixels[k + c] !== pixels[first + c]) ? 1 : 0;
    light += pixels[k] + pixels[k + 1] + pixels[k + 2];
    found.add((pixels[k] >> 4) + 16 * (pixels[k + 1] >> 4) + 256 * (pixels[k + 2] >> 4));
  }
  return { share: 4 * other / pixels.length, light: light / pixels.length, colours: found.size };
});

async function choose(name, title) {
  await page.selectOption('#scene', name);
  await wait((text) => document.getElementById('title').textContent === text && alate.state, title, 90000);
}

async function slide(name, value) {
  await page.evaluate(([id, to]) => {
    const input = document.getElementById(`slider-${id}`);
    input.value = to;
    input.dispatchEvent(new Event('input'));
  }, [name, value]);
}

const cases = {
  async plays() {
    await wait((time) => alate.state.time > time + 0.5, await page.evaluate(() => alate.state.time));
    const { share, colours } = await picture();
    check(share > 0.1 && colours > 12, `${share} of the picture, ${colours} colours`);
  },
  async rate() {
    await page.waitForTimeout(4000);
    const rate = await page.evaluate(() => alate.rate);
    check(rate >= 15, `${rate} states a second`);
    console.log(`# ${rate} states a second`);
  },
  // The camera turns as the sample's own does.
  async hand() {
    const one = await camera(), canvas = page.locator('#canvas');
    await page.mouse.move(150, 200);
    await page.mouse.down();
    await page.mouse.move(250, 180, { steps: 4 });
    await page.mouse.up();
    await wait(([yaw, pitch]) => Math.abs(alate.state.camera.yaw - yaw - 30) < 0.1 && Math.abs(alate.state.camera.pitch - pitch + 6) < 0.1, [one.yaw, one.pitch]);
    await page.mouse.wheel(0, -200);
    await wait((distance) => Math.abs(alate.state.camera.distance / distance - Math.exp(-0.3)) < 0.02, one.distance);
    const two = await camera();
    await page.keyboard.down('Shift');
    await page.mouse.down();
    await page.mouse.move(210, 200, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up('Shift');
    await wait((target) => Math.hypot(...alate.state.camera.target.map((value, k) => value - target[k])) > 0.1, two.target);
    await later();
    const three = await camera();
    check(three.yaw === two.yaw, 'it turns as it moves');
    await canvas.focus();
    await page.keyboard.press('ArrowLeft');
    await wait((yaw) => Math.abs(alate.state.camera.yaw - yaw - 7.5) < 0.1, three.yaw);
    await page.keyboard.press('w');
    await wait(([x, , z]) => Math.abs(Math.hypot(alate.state.camera.target[0] - x, alate.state.camera.target[2] - z) / alate.state.camera.distance - 0.08) < 0.01, three.target);
    await page.keyboard.press('Home');
    await wait(({ yaw, pitch, distance }) => alate.state.camera.yaw === yaw && alate.state.camera.pitch === pitch && alate.state.camera.distance === distance, one);
  },
  async panel() {
    const { light } = await picture();
    await slide('dusk', 1);
    await wait(() => document.querySelector('label[for=slider-dusk]').textContent === 'Dusk: 1.00');
    await later();
    const night = (await picture()).light;
    check(night < 0.5 * light, `light of ${night} at night, ${light} by day`);
    await slide('dusk', 0.2);
    await slide('butterflies', 0);
    await wait(() => document.querySelector('label[for=slider-butterflies]').textContent.startsWith('Butterflies: 0'));
    const fewer = await page.evaluate(() => alate.state.draws.length);
    await slide('butterflies', 8);
    await wait((count) => alate.state.draws.length > count + 8, fewer);
  },
  async pause() {
    await page.click('#pause');
    await wait(() => document.getElementById('pause').textContent === 'Go on');
    const before = await page.evaluate(() => alate.state.time);
    await later();
    check(await page.evaluate(() => alate.state.time) === before, 'time goes on');
    await page.click('#pause');
    await wait((time) => alate.state.time > time, before);
  },
  // What the painter of the films makes of it at this moment is compared by the tests.
  async painter() {
    await page.click('#pause');
    await wait(() => document.getElementById('pause').textContent === 'Go on');
    await later();
    const text = await page.evaluate(() => {
      alate.stage.render(true);
      return document.getElementById('canvas').toDataURL('image/png');
    });
    writeFileSync(join(folder, 'canvas.png'), Buffer.from(text.split(',')[1], 'base64'));
    writeFileSync(join(folder, 'shown'), '');
    for (let k = 0; !existsSync(join(folder, 'painted')) && k < 600; k++)
      await page.waitForTimeout(100);
    await page.click('#pause');
  },
  // What one page copies another one shows: in a page that is opened anew, and in one whose address is changed.
  async link() {
    await slide('butterflies', 5);
    await wait(() => document.querySelector('label[for=slider-butterflies]').textContent.startsWith('Butterflies: 5'));
    await page.focus('#canvas');
    await page.keyboard.press('ArrowLeft');
    await later();
    await page.click('#share');
    await wait(() => location.hash.startsWith('#scene=garden&look='));
    const hash = await page.evaluate(() => location.hash), one = await camera();
    check(hash.includes('set=Butterflies=5'), hash);
    await page.goto('about:blank');
    await page.goto(address + hash);
    await wait(() => document.querySelector('label[for=slider-butterflies]')?.textContent.startsWith('Butterflies: 5'), null, 90000);
    await wait((yaw) => Math.abs((alate.state.camera.yaw - yaw) % 360) < 0.01, one.yaw);
    const two = await camera();
    check(Math.abs(two.distance - one.distance) < 0.01 && Math.hypot(...two.target.map((value, k) => value - one.target[k])) < 0.01, JSON.stringify([one, two]));
    await page.evaluate(() => { location.hash = '#scene=swarm&look=30,10,20,0,1,0'; });
    await wait(() => document.getElementById('title').textContent === 'Swarm' && alate.state, null, 90000);
    await wait(() => Math.abs(alate.state.camera.yaw - 30) < 0.01 && Math.abs(alate.state.camera.distance - 20) < 0.01);
    await page.evaluate(() => history.replaceState(null, '', location.pathname));
    await choose('garden', 'Garden');
  },
  async scenes() {
    for (const [name, title] of [['comparison', 'Comparison'], ['insects', 'Insects'], ['meadow', 'Meadow'], ['monarch', 'Monarch'], ['own-wing', 'Your own wing'], ['swarm', 'Swarm']]) {
      await choose(name, title);
      await wait(() => alate.state.time > 2, null, 90000);
      if (process.env.ALATE_SCENE_PICTURES)
        await page.screenshot({ path: join(process.env.ALATE_SCENE_PICTURES, `${name}.png`) });
      const { share, colours } = await picture();
      check(share > 0.005 && colours > 3, `${name}: ${share} of the picture, ${colours} colours`);
      console.log(`# ${name}: ${await page.evaluate(() => `${alate.state.draws.length} draws, ${alate.state.draws.reduce((sum, { count }) => sum + count, 0)} instances, ${alate.rate} states a second`)}`);
    }
    await choose('garden', 'Garden');
  },
  async access() {
    const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
    await page.evaluate(axe);
    for (const theme of ['light', 'dark']) {
      await page.evaluate((name) => { document.documentElement.dataset.theme = name; }, theme);
      const bad = await page.evaluate(async () => (await axe.run()).violations.map(({ id, nodes }) => `${id} at ${nodes[0].target}`));
      check(bad.length === 0, `${theme}: ${bad}`);
    }
  },
  // The page as the manual shows it.
  async picture() {
    await page.setViewportSize({ width: 1000, height: 600 });
    await wait(() => alate.state.time > 12, null, 90000);
    await page.click('#pause');
    await page.mouse.move(5, 5);
    await later();
    await page.screenshot({ path: join(folder, 'page.png') });
    await page.click('#pause');
    await page.setViewportSize({ width: 900, height: 500 });
  },
  async phone() {
    await page.setViewportSize({ width: 390, height: 844 });
    await later();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= 390, `the page is ${wide} pixels wide`);
    await page.setViewportSize({ width: 900, height: 500 });
  },
  async memory() {
    // The least of some moments: states that come and go are no growth.
    const heap = () => page.evaluate(async () => {
      let least = Infinity;
      for (let k = 0; k < 12; k++) {
        await new Promise((done) => setTimeout(done, 230));
        gc();
        least = Math.min(least, performance.memory.usedJSHeapSize / 1e6);
      }
      return least;
    });
    await page.waitForTimeout(3000);
    const before = await heap();
    await page.waitForTimeout(30000);
    const after = await heap();
    check(after < before + 3, `${before} MB, then ${after} MB`);
    console.log(`# ${before.toFixed(1)} MB, ${after.toFixed(1)} MB after 30 s`);
  },
};

const failed = await browse.run(cases, wanted, { problems, folder, page });
await browser.close();
process.exit(failed > 0 ? 1 : 0);
