// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel in 3-D: which motion, which colours, how fast; play and pause. Drawn while it is in the window.
const COLOURINGS = {
  displacement: {words: 'displacement now', palette: 'blues', unit: 'mm'},
  vibration: {words: 'stress of the vibration, largest over the cycle', palette: 'magma', unit: 'MPa, von Mises'},
  both: {words: 'stress with spin, largest over the cycle', palette: 'magma', unit: 'MPa, von Mises'},
};
const SECONDS = [4, 8, 16, 32];

class WheelView {
  constructor(host, data, selection) {
    Object.assign(this, {host, data, selection, colouring: 'displacement', seconds: 8, angle: 0, casing: true, forces: true});
    this.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.canvas = make('canvas', {class: 'wheel', tabindex: 0, role: 'img', 'aria-label': 'The wheel in motion; arrow keys turn it, plus and minus zoom'});
    this.scene = new WheelScene(this.canvas, data);
    this.told = make('output', {class: 'readout'});
    this.bar = make('div');
    host.append(this.controls(), this.canvas, make('div', {class: 'tools'}, this.bar, this.told));
    this.entries = [...data.motions.map((_, k) => `motion/${k}`), ...data.modes.map((_, k) => `mode/${k}`)];
    this.listen();
    this.choose(this.atSelection() ?? this.entries[0]);
  }

  nameOf(entry) {
    const [kind, k] = entry.split('/'), what = this.data[`${kind}s`][k];
    if (kind === 'mode') return `mode: nodal diameter ${what.nodal_diameter}, family ${what.family}, ${what.hz.toFixed(0)} Hz`;
    const peak = this.selection.data.critical.find(found => found.index === what.index);
    return `motion at ${what.rpm.toFixed(0)} rpm${peak ? `, ${peak.wave}` : ''}`;
  }

  // The motion of the speed that the other views show, if there is one.
  atSelection() {
    const k = this.data.motions.findIndex(motion => motion.index === this.selection.index);
    return k < 0 ? null : `motion/${k}`;
  }

  controls() {
    const {data} = this, tick = (words, name) => {
      const box = make('input', {type: 'checkbox', checked: ''});
      box.addEventListener('change', () => { this[name] = box.checked; this.update(); });
      return make('label', {class: 'choice'}, box, ` ${words}`);
    };
    this.which = choice('Shown', [...data.motions.map((_, k) => `motion/${k}`), ...data.modes.map((_, k) => `mode/${k}`)]
      .map(entry => [entry, this.nameOf(entry)]), '', entry => this.choose(entry));
    this.colours = choice('Colours', Object.entries(COLOURINGS).map(([name, {words}]) => [name, words]), this.colouring,
      name => { this.colouring = name; this.update(); });
    this.pause = button(this.playing ? 'Pause' : 'Play', 'Play or pause the motion', () => {
      this.playing = !this.playing;
      this.pause.textContent = this.playing ? 'Pause' : 'Play';
    });
    return make('div', {class: 'tools'}, this.which, this.colours, this.pause,
      choice('A revolution takes', SECONDS.map(s => [String(s), `${s} s`]), String(this.seconds), s => { this.seconds = Number(s); }),
      tick('casing', 'casing'), tick('contact forces', 'forces'), button('View from the inlet', 'Back to the first view', () => this.scene.home()));
  }

  listen() {
    this.selection.onChange(() => { if (this.atSelection()) this.choose(this.atSelection()); });
    this.canvas.addEventListener('keydown', event => {
      const turn = {ArrowLeft: [-0.15, 0, 1], ArrowRight: [0.15, 0, 1], ArrowUp: [0, -0.12, 1], ArrowDown: [0, 0.12, 1], '+': [0, 0, 0.9], '-': [0, 0, 1.11]}[event.key];
      if (!turn) return;
      event.preventDefault();
      this.scene.turn(...turn);
    });
    new IntersectionObserver(([entry]) => {
      const was = this.inView;
      this.inView = entry.isIntersecting;
      if (this.inView && !was) requestAnimationFrame(now => this.frame(now));
    }).observe(this.canvas);
  }

  choose(entry) {
    this.entry = entry;
    this.which.lastChild.value = entry;
    const [kind, k] = entry.split('/');
    this.mode = kind === 'mode' ? this.data.modes[k] : null;
    this.shown = kind === 'motion' ? this.data.motions[k] : null;
    const waves = this.mode ? [{order: 1, nodal_diameter: this.mode.nodal_diameter}] : this.shown.waves;
    this.scene.motion.choose(i => this.mode ? entry : `${entry}/${i}`, waves);
    this.largest = this.mode ? 1 : this.shown.largest;
    this.size = DRAWN_SHARE * this.data.radius / this.largest;
    if (this.mode && this.colouring !== 'displacement') this.colouring = this.colours.lastChild.value = 'displacement';
    this.colours.lastChild.disabled = Boolean(this.mode);
    this.update();
  }

  update() {
    const {palette, unit} = COLOURINGS[this.colouring], moving = this.colouring === 'displacement';
    const most = moving ? (this.mode ? 1 : 1000 * this.largest) : this.shown.stress_limit;
    this.bar.replaceChildren(colourBar(palette, [0, most / 2, most].map(value => digits(value, 3)), this.mode ? 'of the largest component' : unit));
    this.table = colourTable(palette).map(rgb => rgb.map(value => value / 255));
    const stress = moving ? null : this.data.array(`${this.entry}/${this.colouring}`), limit = moving ? this.largest : most;
    const colours = this.scene.colours.array;
    this.paint = (vertex, length) => {
      const value = stress ? stress[vertex % this.scene.motion.count] : length;
      const rgb = this.table[Math.min(255, Math.round(255 * value / limit))];
      colours.set(rgb, 3 * vertex);
    };
    this.scene.setCasing(this.shown && this.casing ? this.data.array(`${this.entry}/clearance`) : null);
    if (this.shown) this.mostForce = half(this.data.array(`${this.entry}/force`))[1];
    this.place();
  }

  // Everything at the present angle.
  place() {
    const {scene} = this;
    scene.motion.positions(this.angle, this.size, scene.positions.array, this.paint);
    scene.positions.needsUpdate = scene.colours.needsUpdate = true;
    if (scene.casing) scene.casing.rotation.z = -this.angle;
    scene.setForces(this.shown && this.forces ? this.forceNow() : null, this.mostForce || 1);
    scene.draw();
    const turns = this.angle / (2 * Math.PI);
    this.told.textContent = this.mode ? `${(360 * (turns % 1)).toFixed(0)} deg of the period; displacement drawn as ${100 * DRAWN_SHARE} % of the radius`
      : `rotor at ${(360 * turns).toFixed(0)} deg; displacement ${digits(this.size, 2)} times as large, casing's shape and clearance ${digits(this.scene.casingSize, 2)} times; ${digits(100 * this.shown.left_out, 2)} % of the mean square of the motion is in smaller waves and left out`;
  }

  forceNow() {
    const {samples, samples_per_revolution: per, first_sample: first} = this.shown, {held, contacts} = this.data;
    const force = this.data.array(`${this.entry}/force`);
    const sample = ((Math.floor(this.angle / (2 * Math.PI) * per) - first) % samples + samples) % samples;
    return (sector, node) => force[((sector % held) * contacts + node) * samples + sample];
  }

  frame(now) {
    if (!this.inView) { this.before = null; return; }
    if (this.playing && this.before) {
      const period = this.mode ? 2 * Math.PI : 2 * Math.PI * this.shown.samples / this.shown.samples_per_revolution;
      const pace = this.mode ? 4 / this.seconds : 1 / this.seconds;
      this.angle = (this.angle + 2 * Math.PI * pace * Math.min(0.1, (now - this.before) / 1000)) % period;
    }
    this.before = now;
    this.place();
    requestAnimationFrame(next => this.frame(next));
  }
}

function hasWebGL() {
  const context = make('canvas').getContext('webgl');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

function pictureInstead(host) {
  host.append(make('p', {}, 'This browser has no WebGL to draw the wheel with; this picture shows it.'));
  const picture = document.querySelector('h2#contact_displacement ~ figure img, h2#mode_shapes ~ figure img');
  if (picture) host.append(make('figure', {}, picture.cloneNode()));
}

// The library is unpacked when the reader comes near. Without WebGL a picture stands there.
function wheelView(host, selection) {
  if (!hasWebGL()) return pictureInstead(host);
  const start = async () => {
    const library = make('script');
    library.textContent = new TextDecoder().decode(await inflated('three-library'));
    document.head.append(library);
    new WheelView(host, await unpacked('wheel-data'), selection);
  };
  const watcher = new IntersectionObserver(entries => {
    if (!entries.some(entry => entry.isIntersecting)) return;
    watcher.disconnect();
    start();
  }, {rootMargin: '400px'});
  watcher.observe(host);
}
