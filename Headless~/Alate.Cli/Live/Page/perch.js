// The flower on which an insect lands, and where both are in the picture.
const REACH = 0.9, STEM = 6, PETALS = 11;

export class Perch {
  // In units of the insect's reach; the insect's feet are at the origin.
  constructor(THREE) {
    const part = (geometry, colour) => new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color: colour, roughness: 0.85 }));
    this.object = new THREE.Group();
    this.object.add(part(new THREE.CylinderGeometry(0.26, 0.2, 0.08, 32).translate(0, -0.04, 0), 0xd99a1c), part(new THREE.CylinderGeometry(0.035, 0.05, STEM, 10).translate(0, -0.08 - STEM / 2, 0), 0x55723a));
    for (let k = 0; k < PETALS; k++) {
      const petal = new THREE.SphereGeometry(1, 20, 10).scale(0.3, 0.018, 0.11).translate(0.48, 0, 0).rotateZ(0.12).rotateY(2 * Math.PI * k / PETALS).translate(0, -0.075, 0);
      this.object.add(part(petal, 0xc9a7d8));
    }
  }

  // Puts insect and flower into the picture: farther away from it the farther they are apart.
  place(group, { at, turn }, reach) {
    const far = Math.hypot(...at) / reach, scale = 1 / Math.max(1, 0.5 * far / REACH);
    group.quaternion.set(...turn);
    group.scale.setScalar(scale / reach);
    group.position.set(...at.map((value) => 0.5 * scale * value / reach));
    this.object.scale.setScalar(scale);
    this.object.position.set(...at.map((value) => -0.5 * scale * value / reach));
  }
}
