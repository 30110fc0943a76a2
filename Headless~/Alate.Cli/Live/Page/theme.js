// Light or dark: as the system says, until a person chooses.
const root = document.documentElement, system = matchMedia('(prefers-color-scheme: dark)');

export const isDark = () => root.dataset.theme ? root.dataset.theme === 'dark' : system.matches;

export const chosen = () => root.dataset.theme ?? null;

export function choose(theme) {
  root.dataset.theme = theme;
  dispatchEvent(new Event('theme'));
}

export const toggle = () => choose(isDark() ? 'light' : 'dark');

system.addEventListener('change', () => dispatchEvent(new Event('theme')));
