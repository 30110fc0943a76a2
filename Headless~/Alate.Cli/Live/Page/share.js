// All that a page shows, as the end of its address: #species=monarch&variant=standard&speed=2&view=0.68,0.5,4.1&show=chart,wake
const SET = ['compare', 'wake', 'landing'], NO_SLIDERS = ['species', 'variant', 'show', 'view', 'theme'];

// Settings of the simulation, angles (radians) and distance of the camera, names of what is shown, and light or dark where it was chosen.
export function write({ settings, view, shown, theme }) {
  const parts = new URLSearchParams({ species: settings.species, variant: settings.variant });
  for (const [name, number] of Object.entries(settings.values))
    parts.set(name, Number(number.toPrecision(6)));
  const all = [...shown, ...SET.filter((name) => settings[name])];
  if (all.length > 0)
    parts.set('show', all.join());
  parts.set('view', view.map((number) => Number(number.toFixed(3))).join());
  if (theme)
    parts.set('theme', theme);
  return `#${decodeURIComponent(parts)}`;
}

// Null for an address that says nothing.
export function read(hash) {
  const parts = new URLSearchParams(hash.replace(/^#/, '')), shown = (parts.get('show') ?? '').split(',').filter(Boolean);
  if (!parts.get('species'))
    return null;
  const numbers = [...parts].filter(([name, text]) => !NO_SLIDERS.includes(name) && text !== '' && Number.isFinite(Number(text)));
  const view = (parts.get('view') ?? '').split(',').map(Number), theme = parts.get('theme');
  return {
    wanted: {
      species: parts.get('species'), ...parts.get('variant') && { variant: parts.get('variant') }, ...Object.fromEntries(SET.map((name) => [name, shown.includes(name)])),
      values: Object.fromEntries(numbers.map(([name, text]) => [name, Number(text)])),
    },
    view: view.length === 3 && view.every(Number.isFinite) ? view : null,
    shown: shown.filter((name) => !SET.includes(name)),
    theme: theme === 'light' || theme === 'dark' ? theme : null,
  };
}

// Into the address line and the clipboard; false where only the address line has it.
export async function copy(link) {
  history.replaceState(null, '', link);
  try {
    await navigator.clipboard.writeText(location.href);
    return true;
  } catch {
    return false;
  }
}
