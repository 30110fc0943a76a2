import { toggle } from './theme.js';

// The controls beside the picture. They show what the simulation says it does; nothing is kept here.
// Units as they are read aloud.
const spoken = { '×': 'times the insect\'s own', '× time': 'times your time', 'm/s': 'metres a second' };
const get = (id) => document.getElementById(id);

export class Panel {
  constructor(actions) {
    this.actions = actions;
    this.sliders = new Map();
    get('species').onchange = (event) => actions.set({ species: event.target.value });
    get('variant').onchange = (event) => actions.set({ species: get('species').value, variant: event.target.value });
    get('pause').onclick = () => actions.set({ paused: !this.settings?.paused });
    get('landing').onclick = () => actions.set({ landing: !this.settings?.landing });
    get('share').onclick = () => actions.share();
    get('home').onclick = () => actions.home();
    get('reset').onclick = () => actions.set({ species: this.settings.species, variant: this.settings.variant });
    get('save').onclick = () => actions.save();
    get('catalogue').onclick = () => actions.set({ catalogue: true });
    get('file').onchange = (event) => {
      actions.files([...event.target.files]);
      event.target.value = '';
    };
    get('fold').onclick = () => get('fold').setAttribute('aria-expanded', get('fold').getAttribute('aria-expanded') !== 'true');
    get('theme').onclick = toggle;
    for (const button of get('overlays').children)
      button.onclick = () => actions.show(button.dataset.show, button.getAttribute('aria-pressed') !== 'true');
    this.takeDrops();
  }

  takeDrops() {
    const over = (event, on) => {
      event.preventDefault();
      document.body.classList.toggle('over', on);
    };
    addEventListener('dragover', (event) => over(event, true));
    addEventListener('dragleave', (event) => over(event, false));
    addEventListener('drop', (event) => {
      over(event, false);
      this.actions.drop(event.dataTransfer);
    });
  }

  hello({ species, sliders }) {
    this.species = species;
    get('species').replaceChildren(...species.map(({ name, title }) => new Option(title, name)));
    get('sliders').replaceChildren(...sliders.map((slider) => this.slider(slider)));
  }

  slider(slider) {
    const row = document.createElement('div'), label = document.createElement('label'), output = document.createElement('output'), input = document.createElement('input');
    row.className = 'slider';
    label.htmlFor = input.id = `slider-${slider.name}`;
    label.textContent = slider.title;
    Object.assign(input, { type: 'range', min: 0, max: 1, step: 'any' });
    const { min, max } = slider, ratio = max / min;
    const value = (share) => slider.logarithmic ? min * ratio ** share : min + share * (max - min);
    const share = (number) => slider.logarithmic ? Math.log(number / min) / Math.log(ratio) : (number - min) / (max - min);
    const show = (number) => {
      output.textContent = `${text(number, slider.whole)} ${slider.unit}`.trim();
      input.setAttribute('aria-valuetext', `${text(number, slider.whole)} ${spoken[slider.unit] ?? slider.unit}`.trim());
    };
    input.oninput = () => {
      const number = slider.whole ? Math.round(value(Number(input.value))) : Number(value(Number(input.value)).toPrecision(3));
      show(number);
      this.actions.set({ values: { [slider.name]: Math.min(Math.max(number, min), max) } });
    };
    this.sliders.set(slider.name, {
      row,
      set: (number) => {
        show(number);
        if (document.activeElement !== input)
          input.value = Math.min(Math.max(share(number), 0), 1);
      },
    });
    row.append(label, output, input);
    return row;
  }

  show(settings) {
    this.settings = settings;
    get('species').value = settings.species;
    const variants = this.species?.find(({ name }) => name === settings.species)?.variants ?? [];
    if (get('variant').dataset.of !== settings.species) {
      get('variant').dataset.of = settings.species;
      get('variant').replaceChildren(...variants.map((name) => new Option(name, name)));
    }
    get('variant').value = settings.variant;
    get('pause').textContent = settings.paused ? 'Fly on' : 'Pause';
    this.press('compare', settings.compare);
    this.press('wake', Boolean(settings.wake));
    this.land(settings);
    for (const [name, number] of Object.entries(settings.values))
      this.sliders.get(name)?.set(number);
  }

  // What lands flies by its own wings: nothing but time is set, and the air's loads on its wings are not told.
  land({ species, landing }) {
    get('landing').setAttribute('aria-pressed', Boolean(landing));
    get('landing').disabled = !landing && !this.species?.find(({ name }) => name === species)?.lands;
    get('reset').hidden = Boolean(landing);
    for (const [name, { row }] of this.sliders)
      row.hidden = Boolean(landing) && name !== 'slow';
    for (const name of ['compare', 'loads', 'attack', 'strain', 'wake'])
      document.querySelector(`[data-show=${name}]`).hidden = Boolean(landing);
  }

  press(name, on) {
    document.querySelector(`[data-show=${name}]`).setAttribute('aria-pressed', on);
  }
}

function text(number, whole) {
  return whole ? String(Math.round(number)) : String(Number(number.toPrecision(3))).replace('-', '−');
}
