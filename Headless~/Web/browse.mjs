// What the scripts that try pages in Chromium have in common.
import { chromium } from 'playwright-core';
import { join } from 'node:path';

export const launch = (executablePath, ...more) =>
  chromium.launch({ executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...more] });

export function check(holds, what) {
  if (!holds)
    throw new Error(what);
}

// True once an insect beats on a page.
export const flies = () => window.alate?.stage.columns.length > 0 && window.alate.state;

// Opens an address and waits until it is ready; what the console says of errors goes into problems.
export async function open(browser, address, problems, options, ready = flies) {
  const page = await browser.newPage(options);
  page.on('console', (message) => message.type() === 'error' && !isRefused(message.text()) && problems.push(message.text()));
  page.on('pageerror', (problem) => problems.push(problem.message));
  await page.goto(address);
  await page.waitForFunction(ready, null, { timeout: 90000 });
  return page;
}

// Waits until something holds on a page; what did not is named.
export async function wait(page, test, what, timeout) {
  try {
    await page.waitForFunction(test, what, { timeout });
  } catch (problem) {
    throw new Error(`${problem.message.split('\n')[0]} Not so: ${test}`);
  }
}

// What the browser itself says while the server is away.
function isRefused(text) {
  return text.includes('WebSocket connection') || text.includes('ERR_CONNECTION');
}

// Drops files on a page, as pairs of name and bytes.
export const drop = (page, ...files) => page.evaluate((all) => {
  const data = new DataTransfer();
  for (const [title, content] of all)
    data.items.add(new File([new Uint8Array(content)], title));
  dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
}, files.map(([name, bytes]) => [name, [...bytes]]));

// The line over the picture; empty for none.
export const line = (page) => page.evaluate(() => document.getElementById('line').hidden ? '' : document.getElementById('said').textContent);

// Runs cases and prints one line for each: "ok NAME" or "not ok NAME: reason", with a picture of the page in the folder.
export async function run(cases, names, { problems, folder, page }) {
  let bad = 0;
  for (const name of names) {
    try {
      await cases[name]();
      console.log(`ok ${name}`);
    } catch (problem) {
      bad++;
      console.log(`not ok ${name}: ${problem.message.split('\n')[0]}`);
      if (folder)
        await page?.screenshot({ path: join(folder, `${name}.png`) }).catch(() => { });
    }
  }
  for (const problem of problems) {
    bad++;
    console.log(`not ok console: ${problem}`);
  }
  return bad;
}
