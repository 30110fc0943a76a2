// Loads the live view in Chromium and tries what a person would. Prints one line a case: "ok NAME" or "not ok NAME: reason".
//   node view.mjs ADDRESS CHROMIUM FOLDER CASE...
import * as browse from './browse.mjs';
import { check } from './browse.mjs';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [address, executablePath, folder, ...wanted] = process.argv.slice(2);
const browser = await browse.launch(executablePath, '--enable-precise-memory-info', '--js-flags=--expose-gc');
const problems = [], page = await open({ width: 480, height: 360 });

function open(viewport) {
  return browse.open(browser, address, problems, { viewport });
}

const state = () => page.evaluate(() => {
  const { number, time, columns } = alate.state;
  return { number, time, count: columns.length, columns: columns.map((column) => ({ ...column, turn: column.beats + column.phase / (2 * Math.PI), wings: column.wings.length })) };
});
const wait = (test, what, timeout = 15000) => browse.wait(page, test, what, timeout);
const values = () => page.evaluate(() => alate.panel.settings.values);

async function slide(name, share) {
  await page.evaluate(([id, value]) => {
    const input = document.getElementById(id);
    input.value = value;
    input.dispatchEvent(new Event('input'));
  }, [`slider-${name}`, share]);
  await page.waitForTimeout(250);
}

// Largest and least of a number of the first column over some beats.
async function range(name, beats = 2.2) {
  return page.evaluate(([key, long]) => new Promise((done) => {
    const first = alate.state.columns[0], start = first.beats + first.phase / (2 * Math.PI);
    let low = Infinity, high = -Infinity, last = -1;
    const look = () => {
      const column = alate.state.columns[0];
      if (alate.state.number !== last) {
        last = alate.state.number;
        low = Math.min(low, column[key]);
        high = Math.max(high, column[key]);
      }
      if (column.beats + column.phase / (2 * Math.PI) - start > long)
        done({ low, high, range: high - low });
      else
        setTimeout(look, 5);
    };
    look();
  }), [name, beats]);
}

// How much of the picture is not paper.
async function painted(of = page) {
  return of.evaluate(() => {
    alate.stage.render(true);
    const { canvas, renderer } = alate.stage, gl = renderer.getContext(), pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let count = 0, red = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      count += pixels[k + 3] > 0;
      red += pixels[k];
    }
    return { share: 4 * count / pixels.length, red, width: canvas.width };
  });
}

const drop = (name, bytes) => browse.drop(page, [name, bytes]);
const line = () => browse.line(page);

const cases = {
  // From the address to an insect in the picture, on a page of its own, and to the still picture before, while no other page is open.
  async first() {
    const times = [], still = [];
    await page.goto('about:blank');
    for (let k = 0; k < 3; k++) {
      const other = await open({ width: 1280, height: 800 });
      still.push(await other.evaluate(() => new Promise((done) => {
        new PerformanceObserver((list) => list.getEntries().filter(({ identifier }) => identifier === 'first').forEach(({ renderTime }) => done(renderTime)))
          .observe({ type: 'element', buffered: true });
        setTimeout(() => done(0), 2000);
      })));
      check(still[k] > 0, 'no still picture is shown first');
      check(await other.evaluate(() => document.getElementById('first') === null), 'the still picture has gone');
      const { share } = await painted(other);
      times.push(await other.evaluate(() => performance.now()));
      check(share > 0.003, `the insect covers ${share} of the first picture`);
      await other.close();
    }
    await page.goto(address);
    await page.waitForFunction(browse.flies, null, { timeout: 90000 });
    console.log(`# still picture after ${still.map((time) => (time / 1000).toFixed(2)).join(', ')} s`);
    console.log(`# first picture after ${times.map((time) => (time / 1000).toFixed(2)).join(', ')} s`);
  },
  async beats() {
    const one = await state();
    await page.waitForTimeout(900);
    const other = await state(), hertz = (other.columns[0].turn - one.columns[0].turn) / (other.time - one.time);
    check(Math.abs(hertz / other.columns[0].hertz - 1) < 0.03, `${hertz} beats a second, ${other.columns[0].hertz} said`);
    const { share } = await painted();
    check(share > 0.003 && share < 0.6, `the insect covers ${share} of the picture`);
  },
  async rate() {
    await page.waitForTimeout(2500);
    const rate = await page.evaluate(() => alate.rate);
    check(rate >= 25, `${rate} states a second`);
    console.log(`# ${rate} states a second`);
  },
  async slow() {
    await slide('slow', 0.9);
    const one = await state(), before = Date.now();
    await page.waitForTimeout(1000);
    const speed = ((await state()).time - one.time) / ((Date.now() - before) / 1000), said = (await values()).slow;
    check(speed > 0.6 * said && speed < 1.4 * said, `time passes at ${speed}, ${said} said`);
    await slide('slow', 0.75);
  },
  async speed() {
    await slide('speed', 0);
    await page.waitForTimeout(400);
    const rest = (await state()).columns[0].hertz;
    await slide('speed', 0.8);
    await page.waitForTimeout(900);
    const fast = (await state()).columns[0].hertz;
    check(fast > rest, `${rest} Hz at rest, ${fast} Hz in fast flight`);
    await page.click('#reset');
  },
  async wind() {
    const calm = await range('drag');
    await slide('wind', 1);
    await range('drag', 1);
    const windy = await range('drag');
    check(windy.high > calm.high + 0.05, `drag up to ${calm.high} in calm air, ${windy.high} in a head wind`);
    await page.click('#reset');
  },
  async amplitude() {
    await slide('amplitude', 0.2);
    await range('flap', 1.5);
    const small = await range('flap');
    await slide('amplitude', 0.67);
    await range('flap', 1.5);
    const large = await range('flap');
    check(large.range > 1.8 * small.range, `flaps by ${small.range} and ${large.range}`);
    await page.click('#reset');
  },
  async frequency() {
    const before = (await state()).columns[0].hertz;
    await slide('frequency', 1);
    await range('flap', 1.2);
    const after = (await state()).columns[0].hertz;
    check(Math.abs(after / before - 2) < 0.02, `${before} and ${after} Hz`);
    await page.click('#reset');
  },
  async elasticity() {
    await range('flap', 1);
    const bend = () => page.evaluate(() => Math.max(...alate.state.columns[0].wings[0].places.filter((_, k) => k % 4 === 3).map((packed) => packed & 255)));
    const most = async () => {
      let found = 0;
      for (let k = 0; k < 25; k++) {
        found = Math.max(found, await bend());
        await page.waitForTimeout(60);
      }
      return found;
    };
    await slide('elasticity', 1);
    await range('flap', 1);
    const stiff = await most();
    await slide('elasticity', 0);
    await range('flap', 1);
    const soft = await most();
    check(soft > stiff, `stretches by ${stiff / 10} % stiff, ${soft / 10} % soft`);
    await page.click('#reset');
  },
  async delay() {
    // The trailing joints of the outer chain against the leading ones, over a beat.
    const lag = () => page.evaluate(() => new Promise((done) => {
      const seen = [], start = alate.state.columns[0].beats;
      const look = () => {
        const column = alate.state.columns[0], wing = column.wings[0], n = wing.joints.length / 3;
        seen.push(Math.abs(wing.joints[3 * (n - 1) + 1] - wing.joints[1 + 12]));
        if (column.beats > start + 1)
          done(Math.max(...seen));
        else
          setTimeout(look, 10);
      };
      look();
    }));
    await slide('delay', 0);
    await range('flap', 1.2);
    const none = await lag();
    await slide('delay', 0.8);
    await range('flap', 1.2);
    const late = await lag();
    check(Math.abs(late - none) > 0.02 * none, `trailing edge off by ${none} and ${late}`);
    await page.click('#reset');
  },
  async substeps() {
    await slide('substeps', 0.5);
    const said = (await values()).substeps;
    await page.waitForTimeout(200);
    check((await state()).columns[0].substeps === said && said > 40, `${said} substeps said`);
    await page.click('#reset');
  },
  async pause() {
    await page.click('#pause');
    await page.waitForTimeout(300);
    const one = await state();
    await page.waitForTimeout(400);
    check((await state()).time === one.time, 'time passes in a pause');
    await page.click('#pause');
    await wait((time) => alate.state.time > time, one.time);
  },
  async comparison() {
    await page.click('[data-show=compare]');
    await wait(() => alate.state.columns.length === 4 && alate.stage.columns.length === 4);
    check((await page.$$eval('#labels span', (labels) => labels.length)) === 4, 'four labels');
    let share = 0;
    for (let k = 0; k < 20 && share <= 0.01; k++) {
      share = Math.max(share, (await painted()).share);
      await page.waitForTimeout(200);
    }
    check(share > 0.01, `four insects: ${share} of the picture`);
    await page.click('[data-show=compare]');
    await wait(() => alate.state.columns.length === 1 && alate.stage.columns.length === 1);
  },
  // Pictures of an insect that nobody waits for any more come late: what is shown stays the one that was chosen last.
  async order() {
    await page.evaluate(() => {
      const read = window.createImageBitmap;
      let isFirst = true;
      window.createImageBitmap = async (...what) => {
        if (isFirst) {
          isFirst = false;
          await new Promise((done) => setTimeout(done, 3000));
        }
        return read(...what);
      };
    });
    await page.selectOption('#species', 'swallowtail');
    await page.selectOption('#species', 'firefly');
    await wait(() => alate.scene?.name === 'firefly');
    await page.waitForTimeout(4000);
    const name = await page.evaluate(() => alate.scene.name);
    check(name === 'firefly', `${name} is taken for what is shown`);
    await page.selectOption('#species', 'monarch');
    await wait(() => alate.scene?.name === 'monarch');
  },
  async overlays() {
    await page.click('#pause');
    await page.waitForTimeout(300);
    const plain = (await painted()).red;
    for (const name of ['skeleton', 'loads', 'attack', 'strain', 'forces']) {
      await page.click(`[data-show=${name}]`);
      await page.waitForTimeout(120);
      const shown = (await painted()).red;
      check(shown !== plain, `${name} changes nothing`);
      if (name !== 'attack')
        await page.click(`[data-show=${name}]`);
    }
    check((await page.getAttribute('[data-show=attack]', 'aria-pressed')) === 'false', 'two fields at once');
    await page.click('[data-show=chart]');
    await page.click('#pause');
    await page.waitForTimeout(800);
    const inked = await page.evaluate(() => {
      const canvas = document.getElementById('curves'), pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      return pixels.filter((_, k) => k % 4 === 3 && pixels[k] > 0).length;
    });
    check(inked > 300, 'the chart is empty');
    await page.click('[data-show=chart]');
  },
  async wake() {
    const plain = (await state()).columns[0].sheets.length;
    check(plain === 0, 'a wake that nobody asked for');
    await page.focus('[data-show=wake]');
    await page.keyboard.press('Enter');
    await wait(() => alate.state.columns[0].sheets.length === 2 && alate.state.columns[0].sheets[0].rows > 8);
    check((await page.getAttribute('[data-show=wake]', 'aria-pressed')) === 'true', 'the button does not show it');
    await page.click('#pause');
    await page.waitForTimeout(1200);
    check((await page.textContent('#legend-title')).includes('wake'), 'no legend');
    const shown = await painted();
    await page.click('[data-show=wake]');
    await wait(() => alate.state.columns[0].sheets.length === 0);
    await page.waitForTimeout(1200);
    const { share, red } = await painted();
    check(shown.share > share && shown.red !== red, `covers ${shown.share} with a wake, ${share} without`);
    check(await page.isHidden('#legend'), 'a legend without a wake');
    await page.click('#pause');
  },
  async species() {
    const names = await page.$$eval('#species option', (options) => options.map((option) => option.value));
    check(names.length >= 6, `${names.length} species`);
    for (const name of names) {
      await page.selectOption('#species', name);
      await wait((title) => alate.scene?.name === title && alate.stage.columns[0]?.wings.length === alate.state.columns[0].wings.length, name, 30000);
      const variants = await page.$$eval('#variant option', (options) => options.map((option) => option.value));
      await page.selectOption('#variant', variants.at(-1));
      await wait((variant) => alate.panel.settings.variant === variant, variants.at(-1));
      await page.waitForTimeout(400);
      check((await painted()).share > 0.005, `${name} is not seen`);
      check(!await line(), `${name}: ${await line()}`);
    }
    await page.selectOption('#species', names[0]);
    await wait((title) => alate.scene?.name === title, names[0]);
  },
  async files() {
    await drop('wing.png', readFileSync(join(folder, 'wing.png')));
    await wait(() => alate.scene?.name === 'wing', null, 30000);
    check((await state()).columns[0].wings === 2, 'a wing of each side');
    check((await line()).includes('confidence'), await line());
    await drop('mesh.obj', readFileSync(join(folder, 'mesh.obj')));
    await wait(() => alate.scene?.name === 'mesh', null, 30000);
    await page.click('#save');
    await wait(() => alate.saved > 10000, null, 30000);
    await page.click('#catalogue');
    await wait(() => alate.scene?.name !== 'mesh');
  },
  // A photograph lies as the camera was held: the same wing stored on its side, with the turn in its EXIF, flies as the upright one.
  async photographs() {
    const jpeg = (turned) => page.evaluate(async ([content, isTurned]) => {
      const image = await createImageBitmap(new Blob([new Uint8Array(content)], { type: 'image/png' })), canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
      const [width, height] = [image.width, image.height + 60];
      Object.assign(canvas, isTurned ? { width: height, height: width } : { width, height });
      pen.fillStyle = '#fff';
      pen.fillRect(0, 0, canvas.width, canvas.height);
      if (isTurned)
        pen.transform(0, -1, 1, 0, 0, width);
      pen.drawImage(image, 0, 0);
      const bytes = new Uint8Array(await (await new Promise((done) => canvas.toBlob(done, 'image/jpeg', 0.95))).arrayBuffer());
      // Orientation 6: turn it a quarter to the right.
      const exif = [0xff, 0xe1, 0, 34, 0x45, 0x78, 0x69, 0x66, 0, 0, 0x4d, 0x4d, 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0];
      return isTurned ? [...bytes.slice(0, 2), ...exif, ...bytes.slice(2)] : [...bytes];
    }, [[...readFileSync(join(folder, 'wing.png'))], turned]);
    const look = async (name, bytes) => {
      await drop(name, bytes);
      await wait((title) => alate.scene?.name === title && alate.stage.textures.length > 0, name.split('.')[0], 30000);
      check((await line()).includes('confidence'), await line());
      return page.evaluate(() => ({ width: alate.stage.textures[0].image.width, height: alate.stage.textures[0].image.height, reach: alate.scene.reach }));
    };
    const upright = await look('upright.jpg', await jpeg(false)), turned = await look('turned.JPG', await jpeg(true));
    check(upright.height === upright.width + 60, `${upright.width} by ${upright.height}`);
    check(turned.width === upright.width && turned.height === upright.height && Math.abs(turned.reach / upright.reach - 1) < 0.01, JSON.stringify([upright, turned]));
    await page.click('#catalogue');
    await wait(() => alate.scene?.name === 'monarch');
  },
  async insects() {
    const file = (name) => [name, readFileSync(join(folder, name))];
    await browse.drop(page, file('mine.insect.json'));
    await wait(() => document.getElementById('said').textContent.includes("it names 'mine.obj'"));
    await browse.drop(page, file('mine.skeleton.json'), file('mine.insect.json'), file('mine.obj'));
    await wait(() => alate.scene?.name === 'mine' && alate.stage.columns[0]?.wings.length === 2, null, 30000);
    check((await page.inputValue('#species')) === 'mine' && (await page.textContent('#title')) === 'My moth', 'it is not in the list');
    check(await page.isHidden('#catalogue'), 'it is taken for a wing');
    await page.selectOption('#species', 'monarch');
    await wait(() => alate.scene?.name === 'monarch');
  },
  async landing() {
    await page.click('#landing');
    await wait(() => alate.state.columns[0].place && alate.stage.columns[0].perch);
    await page.evaluate(() => alate.source.set({ values: { slow: 1 } }));
    check(await page.isHidden('[data-show=wake]') && await page.isHidden('#slider-speed') && await page.isVisible('#slider-slow'), 'what nothing computes can be set');
    const far = await page.evaluate(() => Math.hypot(...alate.state.columns[0].place.at));
    check(far > 0.3, `begins ${far} m from the flower`);
    await wait(() => alate.state.columns[0].place.doing === 3, null, 60000);
    await page.waitForTimeout(1200);
    check((await page.textContent('#readout')).startsWith('sitting'), await page.textContent('#readout'));
    const { from, to } = await page.evaluate(() => ({ from: alate.stage.columns[0].perch.object.position.toArray(), to: alate.stage.columns[0].group.position.toArray() }));
    check(Math.hypot(...from.map((value, k) => value - to[k])) < 0.2, `${to} is not on ${from}`);
    await page.click('#landing');
    await wait(() => !alate.state.columns[0].place && !alate.stage.columns[0].perch);
    check(await page.isVisible('[data-show=wake]') && await page.isVisible('#slider-speed'), 'the sliders do not come back');
    await page.selectOption('#species', 'snailfish');
    await wait(() => alate.scene?.name === 'snailfish');
    check(await page.isDisabled('#landing'), 'a fish that lands');
    await page.selectOption('#species', 'monarch');
    await wait(() => alate.scene?.name === 'monarch');
  },
  async badFiles() {
    const before = await page.evaluate(() => alate.scene.name);
    await drop('bad.obj', Buffer.from('v 0 0 0\nf 1 2 9\n'));
    await wait(() => document.getElementById('line').textContent.includes('bad.obj: line 2'));
    await drop('bad.png', Buffer.from([0x89, 0x50, 0x4e, 0x47, 1, 2, 3]));
    await wait(() => document.getElementById('line').textContent.includes('bad.png: it'));
    await page.evaluate(() => {
      const data = new DataTransfer();
      data.items.add(new File([new Uint8Array(17 << 20)], 'huge.obj'));
      dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
    });
    await wait(() => document.getElementById('line').textContent.includes('larger than 16 MB'));
    check((await page.evaluate(() => alate.scene.name)) === before, 'the insect is another one');
  },
  // The page as the manual shows it, at the middle of a downstroke.
  async picture() {
    await page.setViewportSize({ width: 1000, height: 600 });
    for (const name of ['skeleton', 'chart'])
      await page.click(`[data-show="${name}"]`);
    await page.waitForTimeout(4000);
    await wait(() => Math.abs(alate.state.columns[0].phase - 1.2) < 0.15);
    await page.click('#pause');
    await page.mouse.move(5, 5);
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(folder, 'page.png') });
    await page.click('#pause');
    for (const name of ['skeleton', 'chart'])
      await page.click(`[data-show="${name}"]`);
    await page.setViewportSize({ width: 480, height: 360 });
  },
  async phone() {
    const phone = await open({ width: 390, height: 780 });
    const sizes = await phone.evaluate(() => ({ page: document.documentElement.scrollWidth, stage: document.getElementById('stage').clientHeight }));
    check(sizes.page <= 390 && sizes.stage > 250, JSON.stringify(sizes));
    await phone.close();
  },
  // The server ends when the file 'stop' appears, and another one starts at the same port when 'start' does.
  async reconnect() {
    await slide('amplitude', 0.3);
    const said = (await values()).amplitude;
    writeFileSync(join(folder, 'stop'), '');
    await wait(() => alate.status === 'away');
    check((await line()).includes('has stopped'), await line());
    writeFileSync(join(folder, 'start'), '');
    await wait(() => alate.status === 'live' && !document.getElementById('line').textContent.includes('stopped'), null, 30000);
    await page.waitForTimeout(1500);
    check((await values()).amplitude === said, `amplitude ${(await values()).amplitude} instead of ${said}`);
    await page.click('#reset');
  },
  async memory() {
    for (const name of ['chart', 'strain', 'loads', 'wake'])
      await page.click(`[data-show=${name}]`);
    await page.waitForTimeout(10000);
    // The least of some moments, as a state that has just come is no growth.
    const used = async () => {
      const found = [];
      for (let k = 0; k < 5; k++) {
        found.push(await page.evaluate(() => {
          gc();
          return performance.memory.usedJSHeapSize / 1e6;
        }));
        await page.waitForTimeout(200);
      }
      return Math.min(...found);
    };
    const before = await used();
    writeFileSync(join(folder, 'before'), '');
    await page.waitForTimeout(120000);
    writeFileSync(join(folder, 'after'), '');
    const after = await used();
    console.log(`# ${before.toFixed(1)} MB before two minutes, ${after.toFixed(1)} MB after`);
    check(after < before + 2, `${before} MB before two minutes, ${after} MB after`);
  },
};

const bad = await browse.run(cases, wanted, { problems, folder, page });
await browser.close();
process.exit(bad > 0 ? 1 : 0);
