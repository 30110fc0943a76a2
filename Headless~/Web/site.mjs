// Loads a static site in Chromium, from files at an address of its own. Prints "ok NAME" or "not ok NAME: reason".
//   node site.mjs CHROMIUM SITE
import { chromium } from 'playwright-core';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';

const [executablePath, site] = process.argv.slice(2), base = 'http://site.test/some/where/';
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json' };
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const page = await browser.newPage({ viewport: { width: 480, height: 320 } }), problems = [];
page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
page.on('pageerror', (problem) => problems.push(problem.message));
await page.route('http://site.test/**', (route) => {
  const name = new URL(route.request().url()).pathname.replace('/some/where/', '') || 'index.html', path = join(site, name);
  return existsSync(path) ? route.fulfill({ contentType: types[extname(name)] ?? 'application/octet-stream', body: readFileSync(path) }) : route.fulfill({ status: 404 });
});

let bad = 0;
async function attempt(name, action) {
  try {
    await action();
    console.log(`ok ${name}`);
  } catch (problem) {
    bad++;
    console.log(`not ok ${name}: ${problem.message.split('\n')[0]}`);
  }
}

function check(holds, what) {
  if (!holds)
    throw new Error(what);
}

const wait = (test, what) => page.waitForFunction(test, what, { timeout: 60000 });

await attempt('loads', async () => {
  await page.goto(base);
  await wait(() => window.alate?.stage.columns.length > 0 && window.alate.state);
  check(await page.isHidden('#save'), 'a control that needs the simulation is shown');
});
await attempt('beats', async () => {
  const look = () => page.evaluate(() => ({ time: alate.state.time, turn: alate.state.columns[0].beats + alate.state.columns[0].phase / (2 * Math.PI), hertz: alate.state.columns[0].hertz }));
  const one = await look();
  await page.waitForTimeout(1500);
  const other = await look();
  check(Math.abs((other.turn - one.turn) / (other.time - one.time) / other.hertz - 1) < 0.02, 'another frequency than is said');
});
await attempt('variants and parts', async () => {
  const variants = await page.$$eval('#variant option', (options) => options.map((option) => option.value));
  await page.selectOption('#variant', variants.at(-1));
  await wait((variant) => alate.panel.settings.variant === variant, variants.at(-1));
  await page.click('[data-show=compare]');
  await wait(() => alate.stage.columns.length === 4 && alate.state.columns.length === 4);
});
for (const problem of problems) {
  bad++;
  console.log(`not ok console: ${problem}`);
}
await browser.close();
process.exit(bad > 0 ? 1 : 0);
