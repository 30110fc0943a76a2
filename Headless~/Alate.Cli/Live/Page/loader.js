import { say } from './message.js';

// Makes the stage with what it needs of three.js; null where that, or WebGL 2, is missing, which the page says.
export async function load(make, command) {
  try {
    return await make();
  } catch (problem) {
    if (problem instanceof TypeError || problem instanceof SyntaxError)
      tellHowToGetThree(command);
    else
      say(`WebGL 2 is not available in this browser (${problem.message}).`, 'bad');
    document.getElementById('status').textContent = 'not loaded';
    return null;
  }
}

function tellHowToGetThree(command) {
  const why = document.querySelector('[type=importmap]').textContent.includes('https:') ? 'there is no network here' : 'its files are gone';
  say(`three.js could not be loaded: ${why}. Two commands bring it:`, 'bad', ['npm ci --prefix Headless~/Web', `dotnet run -c Release --project Headless~/Alate.Cli -- ${command}`]);
}
