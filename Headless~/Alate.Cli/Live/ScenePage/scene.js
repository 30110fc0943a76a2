import * as keys from './keys.js';
import { Link } from './link.js';
import { load } from './loader.js';
import * as message from './message.js';
import { say } from './message.js';
import { decode } from './scene-format.js';
import { SamplePanel } from './scene-panel.js';
import * as sharing from './scene-share.js';
import { copy } from './share.js';
import { toggle } from './theme.js';

const get = (id) => document.getElementById(id);

// The sample that plays behind the socket. Every state counts: each tells only what is new.
class Sample extends Link {
  take(data) {
    if (typeof data !== 'string') {
      this.received++;
      this.tell('state', decode(data));
      return;
    }
    const told = JSON.parse(data);
    this.tell(told.type, told);
  }
}

const sample = new Sample();
const stage = await load(async () => {
  const [THREE, { SceneStage }, { Hand }] = await Promise.all([import('three'), import('./scene-stage.js'), import('./scene-hand.js')]);
  const made = new SceneStage(THREE, get('canvas'));
  new Hand(get('canvas'), made);
  return made;
}, 'view --scene NAME');
if (!stage)
  sample.close();
if (stage) {
  let rate = 0, counted = 0, isPaused = false, aspect = 0, playing = null, first = null, controls = [], wanted = sharing.read(location.hash);
  const act = (request) => {
    message.answered();
    sample.send(request);
  };
  const panel = new SamplePanel(get('sample'), {
    slide: (name, value) => act({ slider: { name, value } }),
    press: (text) => act({ press: text }),
  });
  const pause = () => act({ paused: !isPaused }), home = () => act({ home: true });
  const degrees = (radians) => 180 / Math.PI * radians;
  const shown = () => ({ scene: playing, camera: stage.state.camera, set: sharing.changes(first, controls) });
  // A link is heeded once its scene plays: the panel first, then the camera, from where it is by then.
  const heed = () => {
    if (wanted?.scene !== playing || !first || !stage.state)
      return;
    for (const change of wanted.set) {
      const [, name, value] = change.match(/^([^=]*)=(.*)$/) ?? [];
      if (name !== undefined)
        act({ slider: { name, value: Number(value) } });
      else if (!sharing.changes(first, controls).includes(change))
        act({ press: change });
    }
    if (wanted.look)
      stage.look.turn(sharing.turnTo(wanted.look, stage.state.camera));
    wanted = null;
  };
  get('share').onclick = async () => {
    if (!first || !stage.state)
      return;
    const isCopied = await copy(sharing.write(shown()));
    say(isCopied ? 'A link to this scene, its panel and the camera is copied.' : 'The address of this page has all of it now: copy it.', 'note');
  };
  get('film').onclick = async () => {
    if (!first || !stage.state)
      return;
    const command = sharing.command(shown());
    try {
      await navigator.clipboard.writeText(command);
      say('The command that films this is copied.', 'note');
    } catch {
      say(command, 'note');
    }
  };
  addEventListener('hashchange', () => {
    wanted = sharing.read(location.hash);
    if (wanted && wanted.scene !== playing)
      sample.send({ scene: wanted.scene });
  });
  keys.listen(get('canvas'), {
    turn: (aside, above) => stage.look.turn({ yaw: -degrees(aside), pitch: degrees(above) }),
    approach: (factor) => stage.look.turn({ zoom: factor }),
    home,
  }, pause);
  message.listen();
  get('pause').onclick = pause;
  get('home').onclick = home;
  get('theme').onclick = toggle;
  get('fold').onclick = () => get('fold').setAttribute('aria-expanded', get('fold').getAttribute('aria-expanded') !== 'true');
  get('scene').onchange = (event) => {
    wanted = null;
    say('The scene is made …');
    sample.send({ scene: event.target.value });
  };

  const alate = window.alate = { stage, get state() { return stage.state; }, get rate() { return rate; }, status: 'connecting', sample };
  sample.listen({
    hello: ({ scene, scenes }) => {
      const { title } = scenes.find(({ name }) => name === scene);
      document.title = `${title} – Alate`;
      get('title').textContent = title;
      get('canvas').setAttribute('aria-label', `The scene ${title}`);
      get('scene').replaceChildren(...scenes.map((other) => new Option(other.title, other.name, false, other.name === scene)));
      stage.clear();
      [playing, first, aspect] = [scene, null, 0];
      say(null);
      if (wanted && wanted.scene !== scene) {
        if (scenes.some(({ name }) => name === wanted.scene)) {
          sample.send({ scene: wanted.scene });
        } else {
          say(`The link is of a scene that is not here: ${wanted.scene}.`, 'note bad');
          wanted = null;
        }
      }
    },
    panel: ({ paused, controls: told }) => {
      isPaused = paused;
      get('pause').textContent = paused ? 'Go on' : 'Pause';
      controls = told;
      first ??= told;
      panel.show(told);
    },
    state: (state) => {
      counted++;
      stage.setState(state);
      heed();
      // It sends no more than this page can take.
      sample.send({ seen: state.number });
    },
    error: ({ message: text }) => say(text, 'note bad'),
    status: (status, reason) => {
      alate.status = status;
      get('status').textContent = { live: 'live', away: 'not connected' }[status];
      say(status === 'away' ? reason || 'The scene has stopped. This page goes on when it is started again.' : null, status === 'away' ? 'bad' : '');
    },
  });

  setInterval(() => {
    rate = counted;
    counted = 0;
    if (alate.status === 'live')
      get('status').textContent = `live, ${rate} states/s`;
  }, 1000);
  const draw = () => {
    stage.render();
    const look = stage.look.told(), { clientWidth: width, clientHeight: height } = get('canvas');
    if (look)
      sample.send({ look });
    if (height > 0 && stage.state && aspect !== width / height) {
      aspect = width / height;
      sample.send({ aspect });
    }
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
}
