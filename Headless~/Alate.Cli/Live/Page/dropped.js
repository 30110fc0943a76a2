// Files that were dropped, as the simulation takes them: pairs of name and content.
const LARGEST = 16 * 1024 * 1024, TOGETHER = 2 * LARGEST, MOST = 16, SIDE = 2048;

// The files of a drop, and those within its folders; of many only the first beyond what is taken. Reads the drop before it waits: it is empty afterwards.
export async function filesOf(transfer) {
  const files = [...transfer.files], entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter((entry) => entry);
  if (!entries.some((entry) => entry.isDirectory))
    return files;
  const found = [];
  for (const entry of entries)
    await gather(entry, found);
  return found;
}

// Hidden files are of the system.
async function gather(entry, found) {
  if (found.length > MOST || entry.name.startsWith('.'))
    return;
  if (entry.isFile) {
    found.push(await new Promise((done, fail) => { entry.file(done, fail); }));
    return;
  }
  // A reader gives its entries in parts, the last of which is empty.
  for (const reader = entry.createReader(); found.length <= MOST;) {
    const part = await new Promise((done, fail) => { reader.readEntries(done, fail); });
    if (part.length === 0)
      return;
    for (const inner of part)
      await gather(inner, found);
  }
}

export async function read(files) {
  if (files.length > MOST)
    throw new Error(`These are more than ${MOST} files; drop those of one insect.`);
  const all = [];
  for (const file of files) {
    const isAlone = files.length === 1, taken = isAlone && isPhotograph(file) ? await toPng(file) : file;
    if (taken.size > LARGEST)
      throw new Error(`${file.name}: it is larger than 16 MB.`);
    all.push([file.name, await taken.arrayBuffer()]);
  }
  if (all.reduce((sum, [, content]) => sum + content.byteLength, 0) > TOGETHER)
    throw new Error('These files are larger than 32 MB together.');
  return all;
}

// Of a camera, or of the web.
function isPhotograph(file) {
  return /\.(jpe?g|webp|avif|heic|heif|bmp|gif)$/i.test(file.name) || (file.type.startsWith('image/') && file.type !== 'image/png');
}

// Turned as the camera was held, and no larger than a wing needs.
async function toPng(file) {
  let image;
  try {
    image = await createImageBitmap(file, { imageOrientation: 'from-image' });
  } catch {
    throw new Error(`${file.name}: this browser cannot read that picture. PNG and JPEG are taken.`);
  }
  const factor = Math.min(1, SIDE / Math.max(image.width, image.height)), canvas = document.createElement('canvas');
  Object.assign(canvas, { width: Math.max(Math.round(image.width * factor), 1), height: Math.max(Math.round(image.height * factor), 1) });
  const pen = canvas.getContext('2d');
  pen.imageSmoothingQuality = 'high';
  pen.drawImage(image, 0, 0, canvas.width, canvas.height);
  image.close();
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}
