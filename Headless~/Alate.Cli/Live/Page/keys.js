// The insect by keyboard: what dragging, scrolling and the buttons do.
const TURN = Math.PI / 24, NEARER = 0.9;

export function listen(canvas, stage, pause) {
  const moves = {
    ArrowLeft: () => stage.turn(-TURN, 0), ArrowRight: () => stage.turn(TURN, 0), ArrowUp: () => stage.turn(0, TURN), ArrowDown: () => stage.turn(0, -TURN),
    '+': () => stage.approach(NEARER), '=': () => stage.approach(NEARER), '-': () => stage.approach(1 / NEARER), '_': () => stage.approach(1 / NEARER),
    PageUp: () => stage.approach(NEARER ** 3), PageDown: () => stage.approach(NEARER ** -3), Home: () => stage.home(), ' ': pause,
  };
  const used = () => document.getElementById('hint')?.remove();
  canvas.addEventListener('pointerdown', used, { once: true });
  canvas.addEventListener('keydown', (event) => {
    if (!moves[event.key] || event.ctrlKey || event.metaKey || event.altKey)
      return;
    event.preventDefault();
    moves[event.key]();
  });
}
