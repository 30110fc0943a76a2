import { blend, decode } from './format.js';

const RATE = 30;

// Beats that were flown when this site was made: files beside the page, played in a loop.
export class Baked {
  constructor(listener, wanted) {
    this.listener = listener;
    this.wanted = wanted;
    this.set_ = { species: null, variant: 'standard', compare: false, paused: false, values: { slow: 0.1 } };
    this.received = 0;
    this.time = 0;
    this.start();
  }

  async start() {
    const index = await this.json('insects/index.json');
    this.listener.status('baked');
    this.listener.hello(index);
    await this.set({ species: index.species[0].name });
    if (this.wanted)
      await this.set(this.wanted);
    let before = performance.now();
    const next = (now) => {
      if (now - before > 900 / RATE) {
        this.play(Math.min((now - before) / 1000, 0.1));
        before = now;
      }
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  }

  async json(path) {
    const answer = await fetch(path);
    if (!answer.ok)
      throw new Error(`${path}: ${answer.status}`);
    return answer.json();
  }

  async set(change) {
    const wanted = { ...this.set_, ...change, values: { slow: change.values?.slow ?? this.set_.values.slow } };
    if ((change.species && !change.variant) || wanted.compare)
      wanted.variant = 'standard';
    const name = `${wanted.species}-${wanted.variant}${wanted.compare ? '-parts' : ''}`;
    if (name !== this.name) {
      this.name = name;
      try {
        const [scene, frames] = await Promise.all([this.scene(`insects/${name}.json`), this.frames(`insects/${name}.bin`)]);
        if (!change.values?.slow)
          wanted.values.slow = scene.settings.values.slow;
        this.frames_ = frames;
        this.hertz = frames[0].columns[0].hertz;
        this.set_ = wanted;
        this.listener.scene({ ...scene, settings: { ...scene.settings, ...wanted } });
      } catch (problem) {
        this.listener.error({ message: `This site has no such flight (${problem.message}).` });
      }
      return;
    }
    this.set_ = wanted;
    this.listener.settings(wanted);
  }

  // Meshes and paintings stand in a file that variants have in common.
  async scene(path) {
    const scene = await this.json(path);
    if (scene.look !== this.lookPath)
      [this.look, this.lookPath] = [await this.json(scene.look), scene.look];
    return { ...scene, ...this.look };
  }

  // Packed by gzip, unless the server has unpacked it.
  async bytes(path) {
    const answer = await fetch(path);
    if (!answer.ok)
      throw new Error(`${path}: ${answer.status}`);
    const all = await answer.arrayBuffer(), [first, second] = new Uint8Array(all, 0, 2);
    return first === 0x1f && second === 0x8b ? new Response(new Blob([all]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer() : all;
  }

  async frames(path) {
    const all = await this.bytes(path), view = new DataView(all), frames = [];
    for (let at = 0; at < all.byteLength;) {
      const length = view.getUint32(at, true);
      frames.push(decode(all.slice(at + 4, at + 4 + length)));
      at += 4 + length;
    }
    return frames;
  }

  play(seconds) {
    if (!this.frames_)
      return;
    this.time += this.set_.paused ? 0 : seconds * this.set_.values.slow;
    const at = this.time * this.hertz, share = (at - Math.floor(at)) * this.frames_.length, k = Math.floor(share) % this.frames_.length;
    const state = blend(this.frames_[k], this.frames_[(k + 1) % this.frames_.length], share - Math.floor(share));
    state.time = this.time;
    state.number = this.received++;
    state.columns.forEach((column) => {
      column.beats = Math.floor(at);
      column.phase = 2 * Math.PI * (at - Math.floor(at));
    });
    this.listener.state(state);
  }
}
