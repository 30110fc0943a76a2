import { INSTANCE } from './scene-format.js';
import { Look, eyeOf } from './scene-look.js';
import { LAMPS, materials } from './scene-shader.js';
import { Sun } from './scene-sun.js';

const ATTRIBUTES = ['rowX', 'rowY', 'rowZ', 'tint', 'extra', 'next'];

// A scene as its states tell it: every draw is one call, of as many instances as it has.
export class SceneStage {
  constructor(THREE, canvas) {
    this.three = THREE;
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: false });
    // By the distance of the first instance: all draws begin at the same place.
    this.renderer.setTransparentSort((a, b) => b.object.userData.far - a.object.userData.far || a.id - b.id);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(60, 1, 0.05, 1000);
    this.look = new Look();
    this.sun = new Sun(THREE);
    const value = (start) => ({ value: start });
    this.shared = {
      eye: value(new THREE.Vector3()), sky: value([0, 0, 0]), equator: value([0, 0, 0]), ground: value([0, 0, 0]), sunFrom: value([0, 1, 0]), sun: value([0, 0, 0]),
      lamps: value(new Float32Array(4 * LAMPS)), lampLights: value(new Float32Array(3 * LAMPS)), ...this.sun.uniforms,
    };
    this.clear();
  }

  clear() {
    for (const { object } of this.draws?.values() ?? [])
      this.drop(object);
    for (const map of this.maps?.values() ?? [])
      map.dispose();
    for (const made of this.looks?.values() ?? [])
      [made.shown, made.shadow].forEach((material) => material.dispose());
    Object.assign(this, { meshes: new Map(), maps: new Map(), draws: new Map(), looks: new Map(), state: null, isOld: true });
    this.look.clear();
  }

  setState(state) {
    state.meshes.forEach((mesh) => this.setMesh(mesh));
    state.maps.forEach((map) => this.setMap(map));
    const unused = new Map(this.draws), eye = eyeOf(state.camera);
    for (const draw of state.draws) {
      const key = `${draw.mesh}/${draw.part}/${lookOf(draw)}`;
      unused.delete(key);
      this.setDraw(this.draws.get(key) ?? this.makeDraw(key, draw), draw, eye);
    }
    for (const [key, { object }] of unused) {
      this.drop(object);
      this.draws.delete(key);
    }
    state.goneMeshes.forEach((number) => this.meshes.delete(number));
    state.goneMaps.forEach((number) => {
      this.maps.get(number)?.dispose();
      this.maps.delete(number);
    });
    this.light(state.light, state.camera.target);
    this.state = state;
    this.look.answered(state.camera.look);
    this.isOld = this.isLit = true;
  }

  setMesh(mesh) {
    const { three: THREE } = this;
    if (mesh.isWhole) {
      const attributes = { position: new THREE.BufferAttribute(mesh.places, 3), normal: new THREE.BufferAttribute(mesh.normals, 4, true) };
      for (const [name, values, size] of [['uv', mesh.coordinates, 2], ['colour', mesh.colours, 4], ['baked', mesh.baked, 2], ['joints', mesh.joints, 4]]) {
        if (values)
          attributes[name] = new THREE.BufferAttribute(values, size);
      }
      this.meshes.set(mesh.number, { attributes, parts: mesh.parts.map((indices) => new THREE.BufferAttribute(indices, 1)) });
      for (const [key, draw] of this.draws) {
        if (draw.mesh === mesh.number) {
          this.drop(draw.object);
          this.draws.delete(key);
        }
      }
      return;
    }
    const { position, normal } = this.meshes.get(mesh.number).attributes;
    position.array = mesh.places;
    normal.array = mesh.normals;
    position.needsUpdate = normal.needsUpdate = true;
  }

  setMap({ number, isNumbers, width, height, texels }) {
    const { three: THREE } = this, known = this.maps.get(number);
    if (known && known.image.width === width && known.image.height === height) {
      known.image.data = texels;
      known.needsUpdate = true;
      return;
    }
    const map = new THREE.DataTexture(texels, width, height, THREE.RGBAFormat, isNumbers ? THREE.FloatType : THREE.UnsignedByteType);
    if (!isNumbers)
      Object.assign(map, { colorSpace: THREE.SRGBColorSpace, generateMipmaps: true, magFilter: THREE.LinearFilter, minFilter: THREE.LinearMipmapLinearFilter, anisotropy: Math.min(8, this.renderer.capabilities.getMaxAnisotropy()) });
    map.needsUpdate = true;
    known?.dispose();
    this.maps.set(number, map);
    for (const made of this.looks.values()) {
      if (made.map === number)
        made.shown.uniforms.map.value = made.shadow.uniforms.map.value = map;
    }
  }

  makeDraw(key, draw) {
    const { three: THREE } = this, { attributes, parts } = this.meshes.get(draw.mesh), geometry = new THREE.InstancedBufferGeometry();
    for (const [name, attribute] of Object.entries(attributes))
      geometry.setAttribute(name, attribute);
    geometry.setIndex(parts[draw.part]);
    const object = new THREE.Mesh(geometry, null);
    object.frustumCulled = false;
    object.matrixAutoUpdate = false;
    this.scene.add(object);
    const made = { object, geometry, mesh: draw.mesh, room: 0 };
    this.draws.set(key, made);
    return made;
  }

  setDraw(made, draw, eye) {
    const { three: THREE } = this, { object, geometry } = made;
    if (draw.count > made.room) {
      made.room = draw.count > 1 ? Math.ceil(1.5 * draw.count) : 1;
      made.instances = new THREE.InstancedInterleavedBuffer(new Float32Array(INSTANCE * made.room), INSTANCE);
      made.instances.setUsage(THREE.DynamicDrawUsage);
      ATTRIBUTES.forEach((name, k) => geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(made.instances, 4, 4 * k)));
    }
    made.instances.array.set(draw.instances);
    made.instances.clearUpdateRanges();
    made.instances.addUpdateRange(0, draw.instances.length);
    made.instances.needsUpdate = true;
    geometry.instanceCount = draw.count;
    const look = this.lookOf(draw), first = draw.instances;
    object.material = look.shown;
    object.userData.shadow = look.shadow;
    object.userData.far = Math.hypot(first[3] - eye[0], first[7] - eye[1], first[11] - eye[2]);
  }

  lookOf(draw) {
    const key = lookOf(draw);
    if (!this.looks.has(key))
      this.looks.set(key, { map: draw.map, ...materials(this.three, draw, this.maps.get(draw.picture) ?? null, this.maps.get(draw.map) ?? null, this.shared) });
    return this.looks.get(key);
  }

  // The lamps that are brightest at the point that the camera looks at.
  light(light, [x, y, z]) {
    const { shared } = this, strength = ({ place, light: sent }) => Math.max(...sent) / Math.max((place[0] - x) ** 2 + (place[1] - y) ** 2 + (place[2] - z) ** 2, 1e-3);
    for (const name of ['sky', 'equator', 'ground', 'sunFrom', 'sun'])
      shared[name].value = light[name];
    const lamps = [...light.lamps].sort((a, b) => strength(b) - strength(a)).slice(0, LAMPS);
    shared.lamps.value.fill(0);
    shared.lampLights.value.fill(0);
    lamps.forEach(({ place, light: sent, range }, k) => {
      shared.lamps.value.set([...place, range], 4 * k);
      shared.lampLights.value.set(sent, 3 * k);
    });
  }

  // Draws what has changed, or all of it again.
  render(again = false) {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight, { state, camera, renderer } = this;
    if (width === 0 || height === 0 || !state)
      return;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    if (this.width !== width || this.height !== height || this.ratio !== ratio) {
      Object.assign(this, { width, height, ratio, isOld: true });
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    }
    if (!this.isOld && !this.look.isMoved && !again)
      return;
    this.isOld = this.look.isMoved = false;
    const view = this.look.from(state.camera), eye = eyeOf(view);
    // Unity's Z is turned round, as what shades does at its end.
    camera.position.set(eye[0], eye[1], -eye[2]);
    camera.lookAt(view.target[0], view.target[1], -view.target[2]);
    Object.assign(camera, { fov: view.opening, aspect: width / height, near: view.nearest });
    camera.updateProjectionMatrix();
    this.shared.eye.value.set(...eye);
    if (this.isLit)
      this.sun.cast(renderer, this.scene, state.light, view);
    this.isLit = false;
    renderer.setClearColor(new this.three.Color(...state.behind), 1);
    renderer.render(this.scene, camera);
  }

  drop(object) {
    this.scene.remove(object);
    object.geometry.dispose();
  }
}

const lookOf = ({ picture, map, flags, through, gloss, shine }) => [picture, map, flags, through, gloss, shine].join('/');

