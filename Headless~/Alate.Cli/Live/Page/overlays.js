// Fields that are shown as colours, with their ends. Of the packed number of a vertex: stretch in tenths of a per cent, angle of attack in degrees.
export const ramps = {
  strain: { title: 'stretch of the membrane', low: 0, high: 8, isOpen: true, unit: ' %', of: (packed) => (packed & 255) / 10, stops: ['#c4d6e4', '#f2c14e', '#e4572e', '#7b1e3a', '#230a2b'] },
  attack: { title: 'angle of attack', low: 0, high: 90, unit: '°', of: (packed) => (packed >> 8) & 255, stops: ['#0b3c5d', '#328cc1', '#dfe9e4', '#f0a04b', '#a6341b'] },
};

for (const ramp of Object.values(ramps))
  ramp.light = ramp.stops.map(linear);

// Linear light of an sRGB colour.
function linear(stop) {
  return [1, 3, 5].map((at) => {
    const encoded = parseInt(stop.slice(at, at + 2), 16) / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
  });
}

export function heat(ramp, value, colours, at) {
  const share = Math.min(Math.max((value - ramp.low) / (ramp.high - ramp.low), 0), 1) * (ramp.light.length - 1);
  const k = Math.min(Math.floor(share), ramp.light.length - 2), part = share - k, a = ramp.light[k], b = ramp.light[k + 1];
  for (let c = 0; c < 3; c++)
    colours[at + c] = a[c] + part * (b[c] - a[c]);
}

// The two ways in which vortex rings turn; the stronger, the denser. The oldest rings fade away.
export const wake = { title: 'circulation of the wake', stops: ['#1f5fa8', '#b3261e'], faintest: 0.05, densest: 0.7 };

wake.light = wake.stops.map(linear);

// Rings of one wing, as a sheet between rows of points.
export class Sheet {
  constructor(THREE) {
    this.three = THREE;
    this.geometry = new THREE.BufferGeometry();
    this.room = 0;
    const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, vertexColors: true, transparent: true, depthWrite: false });
    this.object = new THREE.Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
  }

  set({ rows, width, reach, places }) {
    if (rows * width > this.room || width !== this.width)
      this.lay(2 * rows, width);
    this.object.scale.setScalar(reach);
    this.geometry.getAttribute('position').array.set(places);
    this.geometry.getAttribute('position').needsUpdate = true;
    const colours = this.geometry.getAttribute('color');
    for (let k = 0; k < rows * width; k++)
      shade(places[4 * k + 3] / 32767, 1 - Math.floor(k / width) / Math.max(rows - 1, 1), colours.array, 4 * k);
    colours.needsUpdate = true;
    this.geometry.setDrawRange(0, 6 * (rows - 1) * (width - 1));
  }

  lay(rows, width) {
    const { three: THREE, geometry } = this, triangles = [];
    Object.assign(this, { room: rows * width, width });
    for (let row = 0; row + 1 < rows; row++) {
      for (let k = row * width; k + 1 < (row + 1) * width; k++)
        triangles.push(k, k + 1, k + width, k + 1, k + width + 1, k + width);
    }
    geometry.dispose();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Int16Array(4 * this.room), 4, true));
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(4 * this.room), 4));
    geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(triangles), 1));
  }
}

// Colour of a share of the strongest circulation, -1 to 1, in the old part of the wake less of it.
export function shade(share, fresh, colours, at) {
  colours.set(wake.light[share < 0 ? 0 : 1], at);
  colours[at + 3] = fresh * (wake.faintest + (wake.densest - wake.faintest) * Math.min(Math.abs(share), 1));
}

// Many arrows in two draw calls: shafts and heads.
export class Arrows {
  constructor(THREE, count, colour, size) {
    this.three = THREE;
    this.size = size;
    this.object = new THREE.Group();
    const material = new THREE.MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
    this.shafts = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.22, 0.22, 1, 6).translate(0, 0.5, 0), material, count);
    this.heads = new THREE.InstancedMesh(new THREE.ConeGeometry(0.6, 1.6, 10).translate(0, 0.8, 0), material, count);
    this.object.renderOrder = 6;
    this.object.add(this.shafts, this.heads);
    [this.from, this.along, this.scale, this.turn, this.matrix, this.up] =
      [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3(), new THREE.Quaternion(), new THREE.Matrix4(), new THREE.Vector3(0, 1, 0)];
  }

  set(k, x, y, z, dx, dy, dz, factor) {
    const length = factor * Math.hypot(dx, dy, dz);
    this.from.set(x, y, z);
    this.along.set(dx, dy, dz).normalize();
    this.turn.setFromUnitVectors(this.up, length > 0 ? this.along : this.up);
    const head = Math.min(this.size, 0.4 * length);
    this.shafts.setMatrixAt(k, this.matrix.compose(this.from, this.turn, this.scale.set(this.size, Math.max(length - head, 1e-9), this.size)));
    this.from.addScaledVector(this.along, Math.max(length - 1.6 * head, 0));
    this.heads.setMatrixAt(k, this.matrix.compose(this.from, this.turn, this.scale.setScalar(Math.max(head, 1e-9))));
  }

  update() {
    this.shafts.instanceMatrix.needsUpdate = true;
    this.heads.instanceMatrix.needsUpdate = true;
  }
}
