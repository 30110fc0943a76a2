import { blob, colours, floats, wholes } from './format.js';
import { Arrows, Sheet, heat, ramps } from './overlays.js';
import { Perch } from './perch.js';

const HOME = [0.68, 0.5, 4.1], HALF = Math.tan(Math.PI / 180 * 14);

// The insect in three dimensions: one for each column, seen by one camera.
export class Stage {
  constructor(THREE, OrbitControls, canvas) {
    this.three = THREE;
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.renderer.setScissorTest(true);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.05, 50);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.enableDamping = true;
    this.controls.minDistance = 1.2;
    this.controls.maxDistance = 12;
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xb9ad98, 1.7));
    const key = new THREE.DirectionalLight(0xfff4e4, 2.0);
    key.position.set(-1.2, 2.2, 1.6);
    // From behind, it parts a dark body from a dark ground.
    this.rim = new THREE.DirectionalLight(0xdfe8ff, 0);
    this.rim.position.set(1.6, 1.4, -2.4);
    this.camera.add(key, this.rim);
    this.scene.add(this.camera);
    this.columns = [];
    this.shown = { field: null, skeleton: false, loads: false, forces: false };
    this.controls.addEventListener('change', () => { this.isOld = true; });
    this.home();
  }

  home() {
    this.view = HOME;
  }

  // Of the camera: angles aside and above, radians, and distance.
  get view() {
    const at = new this.three.Spherical().setFromVector3(this.camera.position);
    return [at.theta, Math.PI / 2 - at.phi, at.radius];
  }

  set view([aside, above, far]) {
    const distance = Math.min(Math.max(far, this.controls.minDistance), this.controls.maxDistance);
    this.camera.position.set(distance * Math.cos(above) * Math.sin(aside), distance * Math.sin(above), distance * Math.cos(above) * Math.cos(aside));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
  }

  // Turns the camera about the insect, radians.
  turn(aside, above) {
    const { three: THREE, camera } = this, at = new THREE.Spherical().setFromVector3(camera.position);
    at.theta += aside;
    at.phi = Math.min(Math.max(at.phi - above, 0.02), Math.PI - 0.02);
    camera.position.setFromSpherical(at);
    this.controls.update();
  }

  // Changes the camera's distance by a factor.
  approach(factor) {
    const { minDistance, maxDistance } = this.controls;
    this.camera.position.setLength(Math.min(Math.max(this.camera.position.length() * factor, minDistance), maxDistance));
    this.controls.update();
  }

  // Light and outlines for a light ground or a dark one.
  dress(isDark) {
    this.outline = isDark ? 0xf4f1ea : 0x2c2a26;
    this.rim.intensity = isDark ? 2.5 : 0;
    this.columns.forEach((column) => column.wings.forEach((wing) => wing.rim.material.color.set(this.outline)));
    this.isOld = true;
  }

  // Says whether it shows it: not where another one has come while its pictures were read.
  async setScene(scene) {
    const { three: THREE } = this;
    const ticket = this.ticket = {};
    const textures = await Promise.all(scene.textures.map((text) => text && this.texture(text)));
    if (ticket !== this.ticket)
      return false;
    this.clear();
    this.textures = textures.filter(Boolean);
    for (const column of scene.columns) {
      const group = new THREE.Group();
      group.scale.setScalar(1 / scene.reach);
      group.add(this.body(scene.body));
      const abdomen = scene.abdomen ? this.body(scene.abdomen) : null;
      if (abdomen) {
        abdomen.position.fromArray(scene.abdomen.hinge);
        group.add(abdomen);
      }
      const wings = scene.wings.map((wing) => this.wing(wing, textures[wing.texture], Boolean(scene.own)));
      const skeleton = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0xe4572e, depthTest: false, transparent: true }));
      skeleton.renderOrder = 5;
      skeleton.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(scene.wings.reduce((sum, wing) => sum + 6 * bones(wing), 0)), 3));
      const loads = new Arrows(THREE, scene.wings.reduce((sum, wing) => sum + wing.chains * wing.joints, 0), 0x7a3fd0, 0.014 * scene.reach);
      const forces = [new Arrows(THREE, 1, 0x0b7fc2, 0.03 * scene.reach), new Arrows(THREE, 1, 0xd9480f, 0.03 * scene.reach)];
      group.add(...wings.flatMap((wing) => [wing.mesh, wing.rim]), skeleton, loads.object, ...forces.map((arrow) => arrow.object));
      group.traverse((part) => { part.frustumCulled = false; });
      const perch = scene.settings.landing ? new Perch(THREE) : null;
      this.scene.add(group);
      if (perch)
        this.scene.add(perch.object);
      this.columns.push({ group, perch, abdomen, wings, skeleton, loads, forces, sheets: [], title: column.title });
    }
    this.reach = scene.reach;
    return true;
  }

  async texture(text) {
    const { three: THREE } = this;
    const image = await createImageBitmap(blob(text, 'image/png'), { imageOrientation: 'none', premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    const texture = new THREE.Texture(image);
    texture.flipY = false;
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.anisotropy = this.renderer.capabilities.getMaxAnisotropy();
    texture.needsUpdate = true;
    return texture;
  }

  body(body) {
    const { three: THREE } = this, geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(floats(body.positions), 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(floats(body.normals), 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colours(body.colours), 4));
    geometry.setIndex(new THREE.BufferAttribute(wholes(body.triangles), 1));
    return new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.62, transparent: true }));
  }

  wing(wing, texture, isOwn) {
    const { three: THREE } = this, geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(wholes(wing.triangles), 1));
    if (wing.uvs)
      geometry.setAttribute('uv', new THREE.BufferAttribute(floats(wing.uvs), 2));
    const painted = wing.colours ? colours(wing.colours) : null;
    const material = new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, roughness: 0.7, transparent: wing.glass, depthWrite: !wing.glass, alphaTest: wing.cut ? 0.5 : 0, alphaToCoverage: !!wing.cut });
    // Light from behind shines through a wing.
    if (texture)
      Object.assign(material, { map: texture, emissiveMap: texture, emissive: new THREE.Color(0.22, 0.2, 0.17) });
    else if (painted)
      material.vertexColors = true;
    else
      Object.assign(material, { color: new THREE.Color(0.50, 0.27, 0.07), emissive: new THREE.Color(0.07, 0.04, 0.01) });
    if (wing.underside)
      material.onBeforeCompile = (shader) => paleBelow(shader, wing.underside);
    const plain = new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, roughness: 0.8, vertexColors: true });
    const rim = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: this.outline }));
    rim.geometry.setIndex(new THREE.BufferAttribute(rimOf(wholes(wing.triangles)), 1));
    return { ...wing, geometry, mesh: new THREE.Mesh(geometry, material), rim, isOwn, material, plain, painted, count: 0 };
  }

  setState(state) {
    this.state = state;
    this.isOld = true;
    this.columns.forEach((column, c) => {
      const from = state.columns[c];
      if (from && from.wings.length === column.wings.length)
        this.pose(column, from);
    });
  }

  pose(column, from) {
    const { three: THREE, shown } = this, lines = column.skeleton.geometry.getAttribute('position');
    let at = 0, arrow = 0;
    if (column.abdomen)
      column.abdomen.rotation.x = from.abdomen;
    column.loads.object.visible = shown.loads;
    column.skeleton.visible = shown.skeleton;
    column.wings.forEach((wing, w) => {
      const state = from.wings[w], { geometry } = wing;
      if (wing.count !== state.vertices) {
        wing.count = state.vertices;
        geometry.setAttribute('position', new THREE.BufferAttribute(new Int16Array(4 * state.vertices), 4, true));
        geometry.setAttribute('normal', new THREE.BufferAttribute(new Int8Array(4 * state.vertices), 4, true));
        geometry.setAttribute('color', new THREE.BufferAttribute(wing.painted ?? new Float32Array(4 * state.vertices).fill(1), 4));
      }
      wing.mesh.scale.setScalar(state.reach);
      wing.rim.scale.setScalar(state.reach);
      wing.rim.geometry.setAttribute('position', geometry.getAttribute('position'));
      wing.rim.visible = wing.isOwn || Boolean(shown.field);
      geometry.getAttribute('position').array.set(state.places);
      geometry.getAttribute('position').needsUpdate = true;
      geometry.getAttribute('normal').array.set(state.normals);
      geometry.getAttribute('normal').needsUpdate = true;
      this.colour(wing, state);
      if (shown.skeleton) {
        for (let chain = 0; chain < wing.chains; chain++) {
          for (let joint = 0; joint + 1 < wing.joints; joint++) {
            const first = 3 * (chain * wing.joints + joint);
            lines.array.set(state.joints.subarray(first, first + 6), at);
            at += 6;
          }
        }
      }
      if (shown.loads) {
        for (let k = 0; k < state.joints.length; k += 3)
          column.loads.set(arrow++, state.joints[k], state.joints[k + 1], state.joints[k + 2], state.loads[k], state.loads[k + 1], state.loads[k + 2], 3 * this.reach);
      }
    });
    if (column.perch && from.place)
      column.perch.place(column.group, from.place, this.reach);
    lines.needsUpdate = true;
    column.loads.update();
    this.shed(column, from.sheets);
    const length = 0.35 * this.reach;
    column.forces[0].set(0, 0, 0, 0, 0, from.lift, 0, length);
    column.forces[1].set(0, 0, 0, 0, 0, 0, -from.drag, length);
    column.forces.forEach((force) => {
      force.object.visible = shown.forces;
      force.update();
    });
  }

  // The rings behind the wings, where a state has some.
  shed(column, sheets = []) {
    while (column.sheets.length < sheets.length) {
      column.sheets.push(new Sheet(this.three));
      column.group.add(column.sheets.at(-1).object);
    }
    column.sheets.forEach((sheet, k) => {
      sheet.object.visible = k < sheets.length;
      if (k < sheets.length)
        sheet.set(sheets[k]);
    });
  }

  // The painting, or a field of numbers.
  colour(wing, state) {
    const field = this.shown.field && ramps[this.shown.field];
    if (!field) {
      wing.mesh.material = wing.material;
      if (wing.painted && wing.dirty)
        wing.geometry.setAttribute('color', new this.three.BufferAttribute(wing.painted, 4));
      wing.dirty = false;
      return;
    }
    if (!wing.dirty)
      wing.geometry.setAttribute('color', new this.three.BufferAttribute(new Float32Array(4 * state.vertices).fill(1), 4));
    wing.dirty = true;
    wing.mesh.material = wing.plain;
    const attribute = wing.geometry.getAttribute('color');
    for (let k = 0; k < state.vertices; k++)
      heat(field, field.of(state.places[4 * k + 3]), attribute.array, 4 * k);
    attribute.needsUpdate = true;
  }

  // Rows and columns of the panels, as large as they can be.
  grid(width, height) {
    const count = Math.max(this.columns.length, 1), down = (across) => Math.ceil(count / across), size = (across) => Math.min(width / across, height / down(across));
    const across = Array.from({ length: count }, (_, k) => k + 1).reduce((best, other) => size(other) > size(best) ? other : best);
    return { across, down: down(across) };
  }

  // Draws what has changed, or all of it again.
  render(again = false) {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (width === 0 || height === 0)
      return;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    if (this.width !== width || this.height !== height || this.ratio !== ratio) {
      Object.assign(this, { width, height, ratio });
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.isOld = true;
    }
    this.controls.update();
    if (!this.isOld && !again)
      return;
    this.isOld = false;
    // Between what is written above and below. One insect alone may reach beyond.
    const { top = 0, bottom = 0 } = this.inset ?? {}, free = Math.max(height - top - bottom, height / 4), { across, down } = this.grid(width, free);
    const isAlone = this.columns.length < 2, w = width / across, cell = free / down;
    // Below the names of the columns, which take at most half.
    const h = isAlone ? height : cell - Math.min(this.room ?? 0, cell / 2), least = isAlone ? free : h;
    this.camera.aspect = w / h;
    this.camera.fov = 360 / Math.PI * Math.atan(HALF * Math.max(1, 1.15 * least / w) * h / least);
    this.camera.setViewOffset(w, h, 0, isAlone ? (bottom - top) / 2 : 0, w, h);
    this.camera.updateProjectionMatrix();
    this.columns.forEach((column, k) => {
      this.columns.forEach((other) => { other.group.visible = other === column; });
      const left = k % across * w, low = isAlone ? 0 : height - top - (Math.floor(k / across) + 1) * cell;
      this.renderer.setViewport(left, low, w, h);
      this.renderer.setScissor(left, low, w, h);
      this.renderer.render(this.scene, this.camera);
    });
  }

  clear() {
    for (const column of this.columns) {
      for (const object of [column.group, column.perch?.object].filter(Boolean)) {
        this.scene.remove(object);
        object.traverse((part) => {
          part.geometry?.dispose();
          part.material?.dispose();
        });
      }
      column.wings.forEach((wing) => {
        wing.material.dispose();
        wing.plain.dispose();
      });
    }
    this.textures?.forEach((texture) => {
      texture.image.close?.();
      texture.dispose();
    });
    this.columns = [];
  }
}

// Edges of one triangle alone, in pairs of vertices: the outline, where the mesh is not cut along a seam.
export function rimOf(triangles) {
  const edges = new Map();
  for (let k = 0; k < triangles.length; k++) {
    const a = triangles[k], b = triangles[k % 3 === 2 ? k - 2 : k + 1], key = Math.min(a, b) * 4294967296 + Math.max(a, b);
    edges.set(key, edges.has(key) ? null : [a, b]);
  }
  return Uint32Array.from([...edges.values()].filter(Boolean).flat());
}

// The lower side, as the package's own shader has it: paler by a colour where it is bright.
function paleBelow(shader, underside) {
  shader.uniforms.underside = { value: underside };
  shader.fragmentShader = 'uniform vec4 underside;\n' + shader.fragmentShader.replace('#include <color_fragment>', `#include <color_fragment>
  if (!gl_FrontFacing)
    diffuseColor.rgb = mix(diffuseColor.rgb, underside.rgb, underside.a * max(diffuseColor.r, max(diffuseColor.g, diffuseColor.b)));`);
}

function bones(wing) {
  return wing.chains * (wing.joints - 1);
}
