// Loads a static site in Chromium, as a file and from an address of its own. Prints "ok NAME" or "not ok NAME: reason".
//   node site.mjs CHROMIUM SITE
import * as browse from './browse.mjs';
import { check } from './browse.mjs';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [executablePath, site] = process.argv.slice(2), base = 'http://site.test/some/where/';
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json' };
const browser = await browse.launch(executablePath);
const page = await browser.newPage({ viewport: { width: 480, height: 320 } }), problems = [];
page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
page.on('pageerror', (problem) => problems.push(problem.message));
await page.route('http://site.test/**', (route) => {
  const name = new URL(route.request().url()).pathname.replace('/some/where/', '') || 'index.html', path = join(site, name);
  return existsSync(path) ? route.fulfill({ contentType: types[extname(name)] ?? 'application/octet-stream', body: readFileSync(path) }) : route.fulfill({ status: 404 });
});

const wait = (test, what) => browse.wait(page, test, what, 240000);

const cases = {
  async asAFile() {
    const file = await browser.newPage();
    await file.goto(pathToFileURL(join(site, 'index.html')).href);
    await file.waitForFunction(() => !document.getElementById('line').hidden, null, { timeout: 20000 });
    const said = await browse.line(file);
    check(said.includes('web server') && said.includes(`http.server -d "${site}`), said);
    await file.close();
  },
  async loads() {
    await page.goto(base);
    await wait(() => window.alate?.stage.columns.length > 0 && window.alate.state);
    check(await page.isHidden('#save'), 'a control that needs the simulation is shown');
  },
  async beats() {
    const look = () => page.evaluate(() => ({ time: alate.state.time, turn: alate.state.columns[0].beats + alate.state.columns[0].phase / (2 * Math.PI), hertz: alate.state.columns[0].hertz }));
    const one = await look();
    await page.waitForTimeout(1500);
    const other = await look();
    check(Math.abs((other.turn - one.turn) / (other.time - one.time) / other.hertz - 1) < 0.02, 'another frequency than is said');
  },
  async variantsAndParts() {
    const variants = await page.$$eval('#variant option', (options) => options.map((option) => option.value));
    await page.selectOption('#variant', variants.at(-1));
    await wait((variant) => alate.panel.settings.variant === variant, variants.at(-1));
    await page.click('[data-show=compare]');
    await wait(() => alate.stage.columns.length === 4 && alate.state.columns.length === 4);
  },
};

const bad = await browse.run(cases, Object.keys(cases), { problems });
await browser.close();
process.exit(bad > 0 ? 1 : 0);
