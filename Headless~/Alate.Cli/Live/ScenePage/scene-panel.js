// The panel of the sample, in the elements of a page. It shows what the sample says; nothing is kept here.
export class SamplePanel {
  constructor(root, actions) {
    Object.assign(this, { root, actions, controls: [], shape: '' });
  }

  show(controls) {
    const shape = controls.map(({ kind, name, row, min, max }) => [kind, name, row, min, max].join()).join(';');
    if (shape !== this.shape) {
      this.shape = shape;
      this.controls = controls.map((control) => this.make(control));
      const lines = [];
      this.controls.forEach(({ element }, k) => {
        if (controls[k].row !== controls[k - 1]?.row)
          lines.push(document.createElement('div'));
        lines.at(-1).append(element);
      });
      this.root.replaceChildren(...lines);
    }
    controls.forEach((control, k) => this.controls[k].set(control));
  }

  make(control) {
    if (control.kind === 'slider')
      return this.slider(control);
    if (control.kind === 'label') {
      const element = document.createElement('p');
      return { element, set: ({ text }) => { element.textContent = text; } };
    }
    const element = document.createElement('button');
    element.onclick = () => this.actions.press(element.textContent);
    return {
      element,
      set: ({ text, on }) => {
        element.textContent = text;
        if (on !== undefined)
          element.setAttribute('aria-pressed', on);
      },
    };
  }

  slider({ name, min, max }) {
    const element = document.createElement('div'), label = document.createElement('label'), input = document.createElement('input');
    element.className = 'slider';
    label.htmlFor = input.id = `slider-${name.toLowerCase().replace(/[^a-z]+/g, '-')}`;
    Object.assign(input, { type: 'range', min, max, step: 'any' });
    let sent = 0;
    input.oninput = () => {
      // A hand moves it more often than the sample has frames; the last place is always told.
      clearTimeout(this.later);
      const tell = () => {
        sent = performance.now();
        this.actions.slide(name, Number(input.value));
      };
      if (performance.now() - sent > 60)
        tell();
      else
        this.later = setTimeout(tell, 60);
    };
    element.append(label, input);
    return {
      element,
      set: ({ text, value }) => {
        label.textContent = text;
        input.setAttribute('aria-valuetext', text);
        if (document.activeElement !== input)
          input.value = value;
      },
    };
  }
}
