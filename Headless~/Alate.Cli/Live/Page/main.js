import { Baked } from './baked.js';
import { Chart } from './chart.js';
import * as dropped from './dropped.js';
import * as keys from './keys.js';
import { Live } from './live.js';
import { load } from './loader.js';
import * as message from './message.js';
import { say } from './message.js';
import { ramps, wake } from './overlays.js';
import { Panel } from './panel.js';
import * as share from './share.js';
import { choose, chosen, isDark } from './theme.js';

const get = (id) => document.getElementById(id), isLive = document.documentElement.dataset.mode === 'live';
let link = share.read(location.hash);
const live = isLive ? new Live(link?.wanted) : null;

async function makeStage() {
  const [THREE, { OrbitControls }, { Stage }] = await Promise.all([import('three'), import('three/orbit'), import('./stage.js')]);
  return new Stage(THREE, OrbitControls, get('canvas'));
}

function labels(scene) {
  get('labels').replaceChildren(...(scene.columns.length > 1 ? scene.columns : []).map(({ title, description }) => {
    const label = document.createElement('span'), small = document.createElement('small');
    small.textContent = description;
    label.append(title, small);
    return label;
  }));
}

function place(stage) {
  const height = get('canvas').clientHeight, figures = ['chart', 'legend'].map(get).filter((figure) => !figure.hidden), names = [...get('labels').children];
  const top = names.length > 0 ? document.querySelector('header').offsetTop + document.querySelector('header').offsetHeight + 4 : 0;
  const bottom = figures.length > 0 ? height - Math.min(...figures.map((figure) => figure.offsetTop)) : 0;
  const free = Math.max(height - top - bottom, height / 4), { across, down } = stage.grid(get('canvas').clientWidth, free);
  let room = 0;
  names.forEach((label, k) => {
    label.style.left = `${100 * (k % across + 0.5) / across}%`;
    label.style.top = `${top + Math.floor(k / across) * free / down + 4}px`;
    label.style.width = `${92 / across}%`;
    room = Math.max(room, label.offsetHeight + 8);
  });
  Object.assign(stage, { room, inset: { top, bottom }, isOld: true });
}

// Of the colours of the mesh, or of those of the wake.
function legend(field, state) {
  const strongest = state?.columns.flatMap(({ sheets }) => sheets ?? []).reduce((most, sheet) => Math.max(most, sheet.strongest), 0);
  const isHidden = !field && !strongest, isChanged = get('legend').hidden !== isHidden;
  get('legend').hidden = isHidden;
  if (isChanged)
    place(stage);
  if (get('legend').hidden)
    return;
  const most = Number((1e4 * strongest).toPrecision(2)), ramp = field ? ramps[field] : { ...wake, stops: [wake.stops[0], `${wake.stops[0]}00`, wake.stops[1]], low: `−${most}`, high: most, unit: ' cm²/s' };
  const pen = get('ramp').getContext('2d'), shade = pen.createLinearGradient(0, 0, 200, 0);
  ramp.stops.forEach((stop, k) => shade.addColorStop(k / (ramp.stops.length - 1), stop));
  pen.clearRect(0, 0, 200, 10);
  pen.fillStyle = shade;
  pen.fillRect(0, 0, 200, 10);
  get('legend-title').textContent = ramp.title;
  get('ramp-low').textContent = `${ramp.low}${ramp.unit}`;
  get('ramp-high').textContent = `${ramp.high}${ramp.unit}${ramp.isOpen ? ' and more' : ''}`;
}

const stage = await load(makeStage, isLive ? 'view' : 'site DIR');
if (!stage)
  live?.close();
if (stage) {
  const chart = new Chart(get('curves')), shown = new Set();
  let latest = null, rate = 0, counted = 0, full = 0;

  const actions = {
    set: (change) => source.set(change),
    save: () => source.save(),
    home: () => stage.home(),
    share: async () => {
      const isCopied = await share.copy(share.write({ settings: panel.settings, view: stage.view, shown, theme: chosen() }));
      say(isCopied ? 'A link with all settings is copied.' : 'The address of this page has all settings now: copy it.', 'note');
    },
    show: (name, on) => {
      if (name === 'compare' || name === 'wake') {
        source.set({ [name]: on });
        return;
      }
      if (on && ramps[name]) {
        Object.keys(ramps).forEach((other) => {
          shown.delete(other);
          panel.press(other, false);
        });
      }
      shown[on ? 'add' : 'delete'](name);
      panel.press(name, on);
      stage.shown = { field: Object.keys(ramps).find((field) => shown.has(field)), skeleton: shown.has('skeleton'), loads: shown.has('loads'), forces: shown.has('forces') };
      legend(stage.shown.field, latest);
      get('chart').hidden = !shown.has('chart');
      place(stage);
      if (latest)
        stage.setState(latest);
    },
    drop: async (transfer) => {
      try {
        await actions.files(await dropped.filesOf(transfer));
      } catch (problem) {
        say(`What was dropped cannot be read: ${problem.message}`, 'note bad');
      }
    },
    files: async (files) => {
      if (!isLive || files.length === 0)
        return;
      say(files.length > 1 || /\.json$/i.test(files[0].name) ? 'Reading the insect …' : `${files[0].name}: laying a skeleton into it …`);
      try {
        source.drop(await dropped.read([...files]));
      } catch (problem) {
        say(problem.message, 'note bad');
      }
    },
  };
  const panel = new Panel(actions);
  keys.listen(get('canvas'), stage, () => actions.set({ paused: !panel.settings?.paused }));
  message.listen();
  stage.dress(isDark());
  addEventListener('theme', () => stage.dress(isDark()));

  const listener = {
    hello: (hello) => panel.hello(hello),
    scene: async (scene) => {
      document.title = `${scene.title} – Alate`;
      get('title').textContent = scene.title;
      get('canvas').setAttribute('aria-label', `${scene.title} in flight`);
      get('catalogue').hidden = !scene.own;
      say(scene.remark, 'note');
      panel.show(scene.settings);
      if (scene.settings.landing)
        ['loads', 'attack', 'strain'].filter((name) => shown.has(name)).forEach((name) => actions.show(name, false));
      chart.clear();
      full = Math.max(scene.columns.findIndex((column) => column.title === 'Full model'), 0);
      labels(scene);
      if (!await stage.setScene(scene))
        return;
      alate.scene = scene;
      place(stage);
      if (latest)
        stage.setState(latest);
    },
    settings: (settings) => {
      message.answered();
      panel.show(settings);
    },
    state: (state) => {
      latest = state;
      counted++;
      stage.setState(state);
      chart.add(state.columns[full]);
    },
    error: ({ message }) => say(message, 'note bad'),
    file: (content) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([content], { type: 'model/gltf-binary' }));
      link.download = `${get('title').textContent.toLowerCase().replaceAll(' ', '-')}.glb`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
      alate.saved = content.byteLength;
    },
    status: (status, reason) => {
      alate.status = status;
      get('status').textContent = { live: 'live', baked: 'baked', away: 'not connected' }[status];
      if (status === 'away')
        say(reason || 'The simulation has stopped. This page goes on when it is started again.', 'bad');
      else
        say(null);
    },
  };
  const alate = window.alate = { stage, panel, get state() { return latest; }, get rate() { return rate; }, status: 'connecting' };
  const restore = () => {
    if (link?.theme)
      choose(link.theme);
    if (link?.view)
      stage.view = link.view;
    link?.shown.filter((name) => document.querySelector(`[data-show="${CSS.escape(name)}"]`)).forEach((name) => actions.show(name, true));
  };
  const source = live ?? new Baked(listener, link?.wanted);
  alate.source = source;
  live?.listen(listener);
  restore();
  addEventListener('hashchange', () => {
    link = share.read(location.hash);
    if (!link)
      return;
    [...shown].forEach((name) => actions.show(name, false));
    source.set(link.wanted);
    restore();
  });

  setInterval(() => {
    rate = counted;
    counted = 0;
    if (alate.status === 'live')
      get('status').textContent = `live, ${rate} states/s`;
    const column = latest?.columns[full];
    if (column)
      get('readout').replaceChildren(...readout(column, panel.settings?.values.slow ?? 1));
    if (shown.has('chart'))
      get('curves').setAttribute('aria-label', chart.summary());
    legend(stage.shown.field, latest);
  }, 1000);
  addEventListener('resize', () => place(stage));
  const draw = () => {
    stage.render();
    if (latest && stage.columns.length > 0)
      get('first')?.remove();
    if (shown.has('chart'))
      chart.draw();
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
}

function readout(column, slow) {
  const bold = document.createElement('b'), doing = ['', 'tumbling', 'landing', 'sitting'][column.place?.doing ?? 0], slower = 1 / slow;
  bold.textContent = doing || `${Number(column.hertz.toPrecision(3))} beats a second`;
  return [bold, slower < 1.05 ? '\nin its own time' : `\nshown ${Number(slower.toPrecision(2))} times slower`];
}
