// The picture shows the insect as it is: not what a link asks for.
if (location.hash)
  document.getElementById('first')?.remove();

// For a page that was opened as a file, from where browsers load no modules: says how to open it.
if (location.protocol === 'file:') {
  const folder = decodeURIComponent(location.pathname).replace(/[^/]*$/, '').replace(/^\/([A-Za-z]:)/, '$1'), code = document.createElement('code');
  code.textContent = `python3 -m http.server -d "${folder}"`;
  document.getElementById('title').textContent = 'Insects in flight';
  document.getElementById('panel').remove();
  document.getElementById('said').replaceChildren('Browsers open this page only from a web server. Run this, then open http://localhost:8000', code);
  document.getElementById('dismiss').hidden = true;
  document.getElementById('line').hidden = false;
}
