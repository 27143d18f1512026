// SPDX-License-Identifier: GPL-3.0-or-later
// What three.js draws: the wheel, the casing around it, balls where it pushes. The axis of rotation is upright, the inlet on top.
const DRAWN_SHARE = 0.07;  // of the outer radius: how far the largest displacement is drawn
const MARKED = {sector: '#ed8c24', clamped: '#d91a1f', contact: '#0d4dd9'};
const DRAWN_CASING = 0.06;  // of it: how far the casing's shape is drawn at most
const POINTED = {worst: '#e3008c', probed: '#0b5fff'};
const SLOW_FRAME = 90;  // [ms]
const COARSEST = 0.5;  // pixels drawn for each of the screen's, along a line

class WheelScene {
  constructor(canvas, data) {
    this.data = data;
    this.motion = new WheelMotion(data);
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.05 * data.radius, 20 * data.radius);
    this.camera.up.set(0, 0, -1);
    this.middle = this.middleOf(this.motion.nodes);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.target.set(0, 0, this.middle);
    this.controls.enableKeys = false;
    this.controls.enablePan = false;
    this.casingSize = DRAWN_CASING * data.radius / Math.max(1e-9, ...data.array('casing/distortion').map(Math.abs));
    this.pixels = Math.min(2, window.devicePixelRatio);
    this.addLights();
    this.addWheel();
  }

  middleOf(nodes) {
    let low = Infinity, high = -Infinity;
    for (let i = 2; i < nodes.length; i += 3) { low = Math.min(low, nodes[i]); high = Math.max(high, nodes[i]); }
    return (low + high) / 2;
  }

  home() {
    const {clientWidth, clientHeight} = this.renderer.domElement, narrow = Math.max(1, 1.2 * clientHeight / (clientWidth || 1));
    const far = 4.1 * this.data.radius * narrow, tilt = 0.8;
    this.camera.position.set(0, -far * Math.sin(tilt), this.middle - far * Math.cos(tilt));
    this.controls.update();
  }

  // By keys: about the axis, up or down, nearer or farther.
  turn(around, over, nearer) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(new THREE.Vector3(0, 0, 1), around);
    const side = new THREE.Vector3().crossVectors(offset, this.camera.up).normalize();
    const tilted = offset.clone().applyAxisAngle(side, over);
    const upright = Math.abs(tilted.clone().normalize().z);
    this.camera.position.copy(this.controls.target).add((upright < 0.995 ? tilted : offset).multiplyScalar(nearer));
    this.controls.update();
  }

  addLights() {
    const lamp = new THREE.DirectionalLight(0xffffff, 0.65);
    lamp.position.set(-0.6, 0.8, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0x8f9aa8, 0.6));
  }

  addWheel() {
    const {motion, data} = this, {count, triangles} = motion, total = data.sectors * count;
    const geometry = new THREE.BufferGeometry(), index = new Uint32Array(data.sectors * triangles.length);
    for (let j = 0; j < data.sectors; ++j)
      for (let i = 0; i < triangles.length; ++i) index[j * triangles.length + i] = j * count + triangles[i];
    const changing = () => new THREE.BufferAttribute(new Float32Array(3 * total), 3).setUsage(THREE.DynamicDrawUsage);
    this.positions = changing();
    this.colours = changing();
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    geometry.setAttribute('position', this.positions);
    geometry.setAttribute('color', this.colours);
    motion.waves = [];
    motion.moved = new Float32Array(3 * count);
    motion.positions(0, 0, this.positions.array);
    geometry.computeVertexNormals();
    const mesh = new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({vertexColors: THREE.VertexColors, side: THREE.DoubleSide, flatShading: true,
      specular: 0, shininess: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}));
    mesh.frustumCulled = false;
    geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(0, 0, this.middle), 3 * data.radius);
    this.wheel = mesh;
    this.scene.add(mesh);
    this.addMarks();
    this.addPoints();
  }

  // The mesh of sector 0, its clamped and its contact nodes.
  addMarks() {
    const {data} = this, geometryOf = index => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', this.positions);
      geometry.setIndex(Array.from(index));
      return geometry;
    };
    const points = (index, colour, size) => new THREE.Points(geometryOf(index), new THREE.PointsMaterial({color: colour, size, sizeAttenuation: false}));
    this.marks = new THREE.Group();
    this.marks.add(new THREE.LineSegments(geometryOf(data.array('edges')), new THREE.LineBasicMaterial({color: 0x3b4048})),
      points(data.array('clamped'), MARKED.clamped, 4), points(data.array('contact/node'), MARKED.contact, 8));
    for (const mark of this.marks.children) mark.frustumCulled = false;
    this.scene.add(this.marks);
  }

  // Nodes that stand out, each by its name; null: none.
  addPoints() {
    this.points = {};
    for (const [name, colour] of Object.entries(POINTED)) {
      const ball = new THREE.Mesh(new THREE.SphereBufferGeometry(0.016 * this.data.radius, 16, 12),
        new THREE.MeshBasicMaterial({color: colour, depthTest: false, transparent: true, opacity: 0.85}));
      ball.renderOrder = 2;
      this.points[name] = ball;
      this.scene.add(ball);
    }
  }

  mark(name, vertex) {
    const ball = this.points[name];
    ball.visible = vertex !== null && vertex !== undefined;
    if (ball.visible) ball.position.fromArray(this.positions.array, 3 * vertex);
  }

  // The vertex of the wheel that is drawn at a place of the canvas, -1 .. 1 across and up; null: none.
  vertexAt(across, up) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(across, up), this.camera);
    const hit = ray.intersectObject(this.wheel).find(({point}) => !this.halved || point.x <= 0);
    if (!hit) return null;
    const place = new THREE.Vector3(), far = vertex => place.fromArray(this.positions.array, 3 * vertex).distanceTo(hit.point);
    return [hit.face.a, hit.face.b, hit.face.c].sort((a, b) => far(a) - far(b))[0];
  }

  // Only the half with x <= 0 is drawn.
  halve(halved) {
    this.halved = halved;
    this.renderer.clippingPlanes = halved ? [new THREE.Plane(new THREE.Vector3(-1, 0, 0), 0)] : [];
  }

  // Fewer pixels where frames take long, as without a graphics card; `lasted` [ms].
  keepPace(lasted) {
    this.lasting = 0.8 * (this.lasting ?? lasted) + 0.2 * lasted;
    if (this.lasting < SLOW_FRAME || this.pixels <= COARSEST) return;
    this.pixels = Math.max(COARSEST, this.pixels / 1.5);
    this.lasting = this.width = 0;
  }

  // The casing of a motion at its running clearance, both as many times as large as they are as `size` says, or else so that
  // they are seen; it turns against the rotor.
  setCasing(clearance, size) {
    this.scene.remove(this.casing);
    this.casing = null;
    if (!clearance) return;
    const {data} = this, angle = data.array('casing/angle'), distortion = data.array('casing/distortion');
    const position = data.array('contact/position'), normal = data.array('contact/normal'), nodes = data.contacts;
    const places = [], index = [];
    for (let a = 0; a < angle.length; ++a)
      for (let k = 0; k < nodes; ++k) {
        const open = (size ?? this.casingSize) * (clearance[k] - distortion[a]), r = position[3 * k] + open * normal[3 * k];
        places.push(r * Math.cos(angle[a]), r * Math.sin(angle[a]), position[3 * k + 2] + open * normal[3 * k + 2]);
        const here = a * nodes + k;
        if (a + 1 < angle.length && k + 1 < nodes) index.push(here, here + 1, here + nodes, here + 1, here + nodes + 1, here + nodes);
      }
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(index);
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
    geometry.computeVertexNormals();
    this.casing = new THREE.Group();
    this.casing.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: 0x7f8c99, transparent: true, opacity: 0.16,
      side: THREE.DoubleSide, depthWrite: false})));
    for (const k of [0, nodes - 1]) {
      const rim = Array.from(angle, (_, a) => new THREE.Vector3(...places.slice(3 * (a * nodes + k), 3 * (a * nodes + k) + 3)));
      this.casing.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints(rim), new THREE.LineBasicMaterial({color: 0x5a6875})));
    }
    this.scene.add(this.casing);
  }

  // [N] by sector and contact node at this instant, the largest of all instants beside it; null: none.
  setForces(force, most) {
    if (!this.balls) {
      const shape = new THREE.SphereBufferGeometry(0.028 * this.data.radius, 16, 12), look = new THREE.MeshLambertMaterial({color: 0xd55e00});
      this.balls = Array.from({length: this.data.sectors * this.data.contacts}, () => new THREE.Mesh(shape, look));
      this.scene.add(...this.balls);
    }
    const at = this.data.array('contact/node'), {contacts} = this.data, places = this.positions.array;
    this.balls.forEach((ball, i) => {
      const share = force ? force(Math.floor(i / contacts), i % contacts) / most : 0, vertex = 3 * (Math.floor(i / contacts) * this.motion.count + at[i % contacts]);
      ball.visible = share > 0.005;
      ball.position.set(places[vertex], places[vertex + 1], places[vertex + 2]);
      ball.scale.setScalar(Math.sqrt(Math.max(share, 0.02)));
    });
  }

  draw() {
    const {clientWidth: width, clientHeight: height} = this.renderer.domElement;
    if (!width) return;
    if (!this.seen) this.home();
    this.seen = true;
    if (this.width !== width || this.height !== height) {
      Object.assign(this, {width, height});
      this.renderer.setPixelRatio(this.pixels);
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
    this.renderer.render(this.scene, this.camera);
  }
}
