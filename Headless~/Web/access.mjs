// Tries the live view as people do who see little, use no mouse or hold a phone. Prints "ok NAME" or "not ok NAME: reason".
//   node access.mjs ADDRESS CHROMIUM FOLDER CASE...
import * as browse from './browse.mjs';
import { check } from './browse.mjs';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [address, executablePath, folder, ...wanted] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const sizes = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } }, modes = ['light', 'dark'];
const browser = await browse.launch(executablePath), problems = [];
const open = (viewport, colorScheme) => browse.open(browser, address, problems, { viewport, colorScheme });
const page = await open(sizes.desktop, 'light');

// Tries something in each mode at each size.
async function everywhere(action) {
  for (const [size, viewport] of Object.entries(sizes)) {
    for (const mode of modes) {
      const shown = await open(viewport, mode);
      await action(shown, `${size}, ${mode}`);
      await shown.close();
    }
  }
}

async function violations(shown, where) {
  await shown.evaluate(axe);
  const { violations: found, passes } = await shown.evaluate(() => axe.run());
  check(passes.length > 20, `${where}: ${passes.length} rules alone were tried`);
  check(found.length === 0, `${where}: ${found.map(({ id, nodes }) => `${id} at ${nodes[0].target}`).join(', ')}`);
}

const bad = (shown) => browse.drop(shown, ['bad.obj', Buffer.from('v 0 0 0\nf 1 2 9\n')]);
const wait = (shown, test, what) => browse.wait(shown, test, what, 240000);
const distance = () => page.evaluate(() => alate.stage.camera.position.length());
const angles = () => page.evaluate(() => {
  const { x, y, z } = alate.stage.camera.position;
  return [Math.atan2(x, z), Math.atan2(y, Math.hypot(x, z))];
});

// The middle one of the contrasts of what is drawn with the ground behind it, by the formula of WCAG.
const contrast = (shown, part) => shown.evaluate((name) => {
  const { stage } = alate, [column] = stage.columns, wings = new Set(column.wings.map((wing) => wing.mesh));
  const hidden = [];
  column.group.traverse((object) => {
    if (object !== column.group && (name === 'body') === (wings.has(object) || !object.isMesh) && object.visible) {
      object.visible = false;
      hidden.push(object);
    }
  });
  stage.render(true);
  const gl = stage.renderer.getContext(), { drawingBufferWidth: width, drawingBufferHeight: height } = gl, pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  hidden.forEach((object) => { object.visible = true; });
  const light = (red, green, blue) => [red, green, blue].map((value) => value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4)
    .reduce((sum, value, k) => sum + value * [0.2126, 0.7152, 0.0722][k], 0);
  const paper = getComputedStyle(document.documentElement).getPropertyValue('--paper').trim(), ground = light(...[1, 3, 5].map((at) => parseInt(paper.slice(at, at + 2), 16)));
  const found = [];
  for (let k = 0; k < pixels.length; k += 4) {
    if (pixels[k + 3] > 200) {
      const one = light(...pixels.subarray(k, k + 3));
      found.push((Math.max(one, ground) + 0.05) / (Math.min(one, ground) + 0.05));
    }
  }
  return { count: found.length, middle: found.sort((a, b) => a - b)[found.length >> 1] };
}, part);

const cases = {
  // Chromium finds no other name, and the page asks for none.
  async offline() {
    const alone = await browse.launch(executablePath, '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1'), asked = [];
    const context = await alone.newContext();
    context.on('request', (request) => asked.push(request.url()));
    const shown = await browse.open(context, address, problems);
    shown.on('websocket', (socket) => asked.push(socket.url()));
    for (const name of ['compare', 'chart', 'strain', 'wake'])
      await shown.click(`[data-show=${name}]`);
    await shown.selectOption('#species', 'dragonfly');
    await wait(shown, () => alate.scene?.name === 'dragonfly' && alate.stage.columns.length === 4);
    const others = asked.filter((url) => !url.startsWith(address) && !url.startsWith(address.replace('http', 'ws')) && !/^(blob|data):/.test(url));
    check(asked.length > 8 && asked.some((url) => url.includes('three')) && others.length === 0, `${asked.length} requests; to others: ${others}`);
    await alone.close();
  },
  // Where three.js is on no disk and the public server cannot be reached.
  async withoutThree() {
    const shown = await browser.newPage({ viewport: sizes.desktop });
    await shown.route('**/three/**', (route) => route.abort());
    await shown.goto(address);
    await wait(shown, () => !document.getElementById('line').hidden);
    const said = await browse.line(shown);
    check(said.includes('npm ci --prefix Headless~/Web') && said.includes('-- view'), said);
    await shown.close();
  },
  async axe() {
    await everywhere(async (shown, where) => {
      await violations(shown, where);
      for (const name of ['compare', 'chart', 'strain'])
        await shown.click(`[data-show=${name}]`);
      await wait(shown, () => alate.stage.columns.length === 4);
      await bad(shown);
      await wait(shown, () => document.getElementById('said').textContent.includes('bad.obj'));
      await violations(shown, `${where}, with all shown`);
    });
  },
  async overflow() {
    await everywhere(async (shown, where) => {
      await shown.click('[data-show=chart]');
      await shown.click('[data-show=strain]');
      const { beyond, ...least } = await shown.evaluate(() => {
        const box = (id) => document.getElementById(id).getBoundingClientRect();
        const outer = [...document.querySelectorAll('button, select, input:not([type=file]), output, h1, h2, label, figure')].filter((part) => {
          const { left, right, width } = part.getBoundingClientRect();
          return width > 0 && (left < 0 || right > innerWidth + 0.5);
        });
        const chart = box('chart'), legend = box('legend');
        return {
          beyond: outer.map((part) => part.id || part.textContent), across: document.documentElement.scrollWidth - innerWidth, down: document.documentElement.scrollHeight - innerHeight,
          stage: box('stage').height, apart: chart.right <= legend.left || chart.left >= legend.right || chart.top >= legend.bottom || chart.bottom <= legend.top,
        };
      });
      check(beyond.length === 0 && least.across <= 0 && least.down <= 0 && least.stage > 300 && least.apart, `${where}: ${JSON.stringify({ beyond, ...least })}`);
    });
  },
  // What axe cannot tell: texts on colours that are mixed, and what WebGL draws.
  async contrast() {
    for (const mode of modes) {
      const shown = await open(sizes.desktop, mode), low = await shown.evaluate(() => {
        const style = getComputedStyle(document.documentElement);
        const light = (name) => [1, 3, 5].map((at) => parseInt(style.getPropertyValue(`--${name}`).trim().slice(at, at + 2), 16) / 255)
          .map((value) => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4).reduce((sum, value, k) => sum + value * [0.2126, 0.7152, 0.0722][k], 0);
        const pairs = [['ink', 'panel', 4.5], ['soft', 'panel', 4.5], ['accent', 'panel', 4.5], ['panel', 'accent', 4.5], ['lift', 'panel', 3], ['drag', 'panel', 3], ['edge', 'panel', 3]];
        return pairs.map(([one, other, least]) => [one, other, (Math.max(light(one), light(other)) + 0.05) / (Math.min(light(one), light(other)) + 0.05), least]).filter(([, , ratio, least]) => ratio < least);
      });
      check(low.length === 0, `${mode}: ${low.join('; ')}`);
      for (const name of await shown.$$eval('#species option', (options) => options.map((option) => option.value))) {
        await shown.selectOption('#species', name);
        await wait(shown, (title) => alate.scene?.name === title && alate.stage.columns[0]?.wings.length === alate.state.columns[0].wings.length, name);
        const { count, middle } = await contrast(shown, 'body');
        console.log(`# body of ${name}, ${mode}: ${middle.toFixed(2)} over ${count} pixels`);
        check(count > 300 && middle > 1.5, `${mode}: the body of ${name} has a contrast of ${middle} over ${count} pixels`);
      }
      await browse.drop(shown, ['mesh.obj', readFileSync(join(folder, 'mesh.obj'))]);
      await wait(shown, () => alate.scene?.name === 'mesh' && alate.stage.columns[0]?.wings[0].count > 0);
      const { count, middle } = await contrast(shown, 'wings');
      console.log(`# dropped wing, ${mode}: ${middle.toFixed(2)} over ${count} pixels`);
      check(count > 3000 && middle > 1.5, `${mode}: a dropped wing has a contrast of ${middle} over ${count} pixels`);
      await shown.close();
    }
  },
  // Everything by the keys alone.
  async keyboard() {
    await page.focus('#canvas');
    const [aside, above] = await angles(), far = await distance();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowUp');
    const [left, up] = await angles();
    check(left < aside - 0.05 && up > above + 0.05, `turned from ${[aside, above]} to ${[left, up]}`);
    await page.keyboard.press('+');
    check(await distance() < 0.95 * far, 'plus does not come nearer');
    for (let k = 0; k < 40; k++)
      await page.keyboard.press('-');
    check(Math.abs(await distance() - 12) < 1e-6, 'minus ends where scrolling does');
    await page.keyboard.press('Home');
    check(Math.abs(await distance() - far) < 1e-6, 'Home goes back');
    await page.keyboard.press(' ');
    await wait(page, () => alate.panel.settings.paused);
    await page.keyboard.press(' ');
    await wait(page, () => !alate.panel.settings.paused);
    const reached = new Set();
    for (let k = 0; k < 60; k++) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.dataset.show));
    }
    const all = await page.$$eval('button, select, input, canvas[tabindex]', (parts) => parts.filter((part) => part.getClientRects().length > 0).map((part) => part.id || part.dataset.show));
    check(all.length > 20 && all.every((name) => reached.has(name)), `no way to ${all.filter((name) => !reached.has(name))}`);
    await page.focus('[data-show=skeleton]');
    await page.keyboard.press('Enter');
    check(await page.getAttribute('[data-show=skeleton]', 'aria-pressed') === 'true', 'Enter does not press a button');
    await page.keyboard.press(' ');
  },
  async sliders() {
    const spoken = (name) => page.getAttribute(`#slider-${name}`, 'aria-valuetext');
    check(await spoken('speed') === '1.3 metres a second', await spoken('speed'));
    check(await spoken('delay') === '0.15 half beats' && await spoken('substeps') === '16', `${await spoken('delay')}, ${await spoken('substeps')}`);
    await page.focus('#slider-speed');
    await page.keyboard.press('End');
    await wait(page, () => alate.panel.settings.values.speed === 5);
    check(await spoken('speed') === '5 metres a second', await spoken('speed'));
    await page.keyboard.press('ArrowLeft');
    await wait(page, () => alate.panel.settings.values.speed < 5);
    check(Number((await spoken('speed')).split(' ')[0]) < 5, await spoken('speed'));
    await page.click('#reset');
    await wait(page, () => alate.panel.settings.values.speed === 1.3);
  },
  // Another browser that opens the link shows the same.
  async share() {
    const look = (shown) => shown.evaluate(() => {
      const { species, variant, compare, wake, values } = alate.panel.settings;
      return JSON.stringify({ species, variant, compare, wake, values, view: alate.stage.view.map((number) => Number(number.toFixed(2))), shown: alate.stage.shown, pressed: [...document.querySelectorAll('#overlays [aria-pressed=true]')].map((chip) => chip.dataset.show), theme: document.documentElement.dataset.theme });
    });
    const one = await open(sizes.desktop, 'light');
    await one.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await one.selectOption('#species', 'dragonfly');
    await wait(one, () => alate.scene?.name === 'dragonfly');
    await one.selectOption('#variant', 'expressive');
    await wait(one, () => alate.panel.settings.variant === 'expressive');
    await one.focus('#slider-speed');
    await one.keyboard.press('End');
    await wait(one, () => alate.panel.settings.values.speed === 5);
    for (const name of ['wake', 'chart', 'strain'])
      await one.click(`[data-show=${name}]`);
    await one.focus('#canvas');
    for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowDown', '+'])
      await one.keyboard.press(key);
    await one.click('#theme');
    await wait(one, () => alate.panel.settings.wake);
    await one.click('#share');
    await wait(one, () => document.getElementById('said').textContent.includes('copied'));
    const link = await one.evaluate(() => navigator.clipboard.readText()), wanted = await look(one);
    check(link === one.url() && link.startsWith(`${address}#species=dragonfly`), link);
    const other = await browse.open(browser, link, problems, { viewport: sizes.phone });
    const restored = () => wait(other, () => alate.scene?.name === 'dragonfly' && alate.panel.settings.values.speed === 5 && alate.panel.settings.wake);
    await restored();
    check(await look(other) === wanted, `${await look(other)} instead of ${wanted}`);
    await other.evaluate(() => { location.hash = '#species=firefly'; });
    await wait(other, () => alate.scene?.name === 'firefly' && !alate.panel.settings.wake);
    check(await other.evaluate(() => document.querySelectorAll('#overlays [aria-pressed=true]').length) === 0, 'more is shown than the link says');
    await other.evaluate((text) => { location.href = text; }, link);
    await restored();
    check(await look(other) === wanted, `pasted: ${await look(other)} instead of ${wanted}`);
    await one.close();
    await other.close();
  },
  // A line stays until it is answered, and goes then.
  async errors() {
    const told = async () => {
      await bad(page);
      await wait(page, () => document.getElementById('said').textContent.includes('bad.obj: line 2'));
    };
    await told();
    await page.waitForTimeout(10500);
    check(await browse.line(page), 'it went by itself');
    await page.focus('#slider-speed');
    await page.keyboard.press('ArrowRight');
    await wait(page, () => document.getElementById('line').hidden);
    await told();
    await page.keyboard.press('Escape');
    check(!await browse.line(page), 'Escape does not close it');
    await told();
    await page.focus('#dismiss');
    await page.keyboard.press('Enter');
    check(!await browse.line(page), 'its button does not close it');
    check(await page.evaluate(() => document.activeElement.id) === 'canvas', 'the keys are nowhere afterwards');
    await told();
    await page.selectOption('#species', 'firefly');
    await wait(page, () => alate.scene?.name === 'firefly' && document.getElementById('line').hidden);
    await page.selectOption('#species', 'monarch');
    await wait(page, () => alate.scene?.name === 'monarch');
  },
};

const failed = await browse.run(cases, wanted, { problems, folder, page });
await browser.close();
process.exit(failed > 0 ? 1 : 0);
