// The line over the picture. It stays until it is answered: by what comes next, its button or the Escape key.
const get = (id) => document.getElementById(id);

export function say(text, kind = '', commands = []) {
  get('line').hidden = !text;
  get('said').replaceChildren(text ?? '', ...commands.map((command) => {
    const code = document.createElement('code');
    code.textContent = command;
    return code;
  }));
  get('line').className = kind;
  get('dismiss').hidden = !kind.includes('note');
}

// What was wrong is no more, or what was said was read.
export function answered() {
  if (get('line').className.includes('note'))
    say(null);
}

export function listen() {
  get('dismiss').onclick = () => {
    answered();
    get('canvas').focus();
  };
  addEventListener('keydown', (event) => event.key === 'Escape' && answered());
}
