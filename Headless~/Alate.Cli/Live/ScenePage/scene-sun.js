// Shadows of the sun: the scene as it sees it, about the point that the camera looks at.
const CELLS = 2048, LEAST = 6, MOST = 40, FAR = 200, BIAS = 3;

export class Sun {
  constructor(THREE) {
    this.three = THREE;
    this.target = new THREE.WebGLRenderTarget(CELLS, CELLS, { depthTexture: new THREE.DepthTexture(CELLS, CELLS), minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, FAR);
    this.uniforms = { shadow: { value: this.target.depthTexture }, toShadow: { value: new THREE.Matrix4() }, shadowCell: { value: 0 } };
  }

  cast(renderer, scene, light, view) {
    const { camera, uniforms } = this, half = Math.min(Math.max(LEAST, 1.5 * view.distance), MOST), [x, y, z] = view.target, [a, b, c] = light.sunFrom;
    uniforms.shadowCell.value = light.hasShadows ? BIAS * 2 * half / CELLS / FAR : 0;
    if (!light.hasShadows)
      return;
    Object.assign(camera, { left: -half, right: half, top: half, bottom: -half });
    camera.position.set(x + 0.5 * FAR * a, y + 0.5 * FAR * b, -(z + 0.5 * FAR * c));
    camera.lookAt(x, y, -z);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    uniforms.toShadow.value.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).multiply(new this.three.Matrix4().makeScale(1, 1, -1));
    const shown = scene.children.map((object) => object.material);
    scene.children.forEach((object) => { object.material = object.userData.shadow; });
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    scene.children.forEach((object, k) => { object.material = shown[k]; });
  }
}
