// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel in 3-D: which motion, which colours, how fast; play and pause. Drawn while it is in the window.
const COLOURINGS = {
  displacement: {words: 'displacement now', palette: 'blues', unit: 'mm'},
  vibration: {words: 'stress of the vibration, largest over the cycle', palette: 'magma', unit: 'MPa, von Mises'},
  spin: {words: 'stress of the spin alone', palette: 'magma', unit: 'MPa, von Mises'},
  both: {words: 'stress with spin, largest over the cycle', palette: 'magma', unit: 'MPa, von Mises'},
};
const SECONDS = [4, 8, 16, 32];
const METAL = [0.78, 0.8, 0.83];
const DISC_ABOVE = 0.02;  // of the disc's nodes, above its colours: single ones beside the blades' roots stand far above

class WheelView {
  constructor(host, data, selection) {
    Object.assign(this, {host, data, selection, colouring: 'displacement', seconds: 8, angle: 0, casing: true, forces: true, discOnly: false,
      halved: false, alike: false, worst: true, probing: null});
    this.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.canvas = make('canvas', {class: 'wheel', tabindex: 0, role: 'img', 'aria-label': 'The wheel in motion; arrow keys turn it, plus and minus zoom, a click tells the values at a node'});
    this.scene = new WheelScene(this.canvas, data);
    this.told = make('output', {class: 'readout'});
    this.bar = make('div');
    this.blank = make('p', {class: 'blank', hidden: ''});
    this.probed = make('output', {class: 'readout', id: 'probed'});
    host.append(this.controls(), this.blank, this.canvas, this.timeBar(), make('div', {class: 'tools'}, this.bar, this.told),
      make('div', {class: 'tools'}, this.probed));
    this.onDisc = new Set(data.array('disc'));
    host.parentElement.classList.add('drawn');
    this.listen();
    this.choose(this.atSelection());
  }

  get entries() {
    return ['none', ...this.data.motions.map((_, k) => `motion/${k}`), ...this.data.modes.map((_, k) => `mode/${k}`), 'rest'];
  }

  nameOf(entry) {
    if (entry === 'none') return 'nothing: no motion of the wheel at the shown speed';
    if (entry === 'rest') return 'at rest: sector 0, its mesh and node sets';
    const [kind, k] = entry.split('/'), what = this.data[`${kind}s`][k];
    if (kind === 'mode') return `mode: nodal diameter ${what.nodal_diameter}, family ${what.family}, ${what.hz.toFixed(0)} Hz`;
    const peak = this.selection.data.critical.find(found => found.index === what.index);
    return `motion at ${what.rpm.toFixed(0)} rpm${peak ? `, ${peak.wave}` : ''}`;
  }

  // The motion of the speed that the other views show, or nothing; another speed's would mislead.
  atSelection() {
    const k = this.data.motions.findIndex(motion => motion.index === this.selection.index);
    return k < 0 ? 'none' : `motion/${k}`;
  }

  controls() {
    const {data} = this, tick = (words, name) => {
      const box = make('input', {type: 'checkbox', checked: this[name] ? '' : null});
      box.addEventListener('change', () => { this[name] = box.checked; this.update(); });
      return make('label', {class: 'choice'}, box, ` ${words}`);
    };
    this.which = choice('Shown', this.entries.map(entry => [entry, this.nameOf(entry)]), '', entry => this.choose(entry));
    this.colours = choice('Colours', Object.entries(COLOURINGS).map(([name, {words}]) => [name, words]), this.colouring,
      name => { this.colouring = name; this.update(); });
    this.pause = button('', 'Play or pause the motion', () => this.play(!this.playing));
    this.instant = button('Hardest contact', 'Pause where the casing pushes most', () => this.showInstant());
    this.play(this.playing);
    return make('div', {class: 'tools'}, this.which, this.colours, this.pause, this.instant,
      choice('A revolution takes', SECONDS.map(s => [String(s), `${s} s`]), String(this.seconds), s => { this.seconds = Number(s); }),
      tick('casing', 'casing'), tick('enlarged as the blades are', 'alike'), tick('contact forces', 'forces'), tick('cut in half', 'halved'),
      ...(data.motions.length ? [tick('largest stress', 'worst')] : []),
      ...(data.has_disc ? [tick('disc only', 'discOnly')] : []), button('View from the inlet', 'Back to the first view', () => this.scene.home()),
      button('Save picture', 'Save this view as a PNG file', () => this.save()));
  }

  // The instant within the period.
  timeBar() {
    this.slider = make('input', {type: 'range', min: 0, max: 999, step: 1, 'aria-label': 'Instant of the period'});
    this.slider.addEventListener('input', () => {
      this.play(false);
      this.angle = this.period * Number(this.slider.value) / 1000;
      this.place();
    });
    return make('div', {class: 'tools time'}, make('label', {class: 'choice'}, 'Instant ', this.slider));
  }

  // [rad] of the rotor, or of a mode's phase, after which the motion repeats, or ends.
  get period() { return 2 * Math.PI * (this.shown ? this.shown.samples / this.shown.samples_per_revolution : 1); }

  // The recorded sample that is shown.
  get sample() {
    const {samples, samples_per_revolution: per, first_sample: first} = this.shown;
    return first + ((Math.floor(this.angle / (2 * Math.PI) * per) - first) % samples + samples) % samples;
  }

  play(playing) {
    this.playing = playing;
    this.pause.textContent = playing ? 'Pause' : 'Play';
  }

  // The recorded sample of the cycle with the largest sum of forces.
  showInstant() {
    const {samples, samples_per_revolution: per, first_sample: first} = this.shown, {held, contacts} = this.data;
    const force = this.data.array(`${this.entry}/force`), sums = new Float64Array(samples);
    for (let row = 0; row < held * contacts; ++row)
      for (let s = 0; s < samples; ++s) sums[s] += force[row * samples + s];
    this.angle = 2 * Math.PI * ((first + sums.indexOf(Math.max(...sums))) % samples + 1e-6) / per;
    this.play(false);
  }

  save() {
    make('a', {href: this.canvas.toDataURL(), download: `wheel_${this.which.lastChild.selectedOptions[0].textContent.replace(/\W+/g, '_')}.png`}).click();
  }

  listen() {
    this.selection.onChange(() => { if (this.atSelection() !== 'none' || this.shown) this.choose(this.atSelection()); });
    this.selection.onSample(teller => {
      if (teller === this || this.shown?.index !== this.selection.index) return;
      this.play(false);
      this.angle = (2 * Math.PI * (this.selection.sample + 1e-6) / this.shown.samples_per_revolution) % this.period;
      this.place();
    });
    this.canvas.addEventListener('pointerdown', event => { this.pressed = [event.clientX, event.clientY]; });
    this.canvas.addEventListener('pointerup', event => {
      if (this.pressed && Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) < 5) this.probe(event);
    });
    // Without a key the wheel of the mouse moves the page.
    this.host.addEventListener('wheel', event => { if (!event.ctrlKey && !event.metaKey) event.stopPropagation(); }, {capture: true});
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
    const [kind, k] = entry.split('/'), none = kind === 'none';
    this.blank.hidden = !none;
    this.canvas.hidden = none;
    this.blank.textContent = none ? `No motion of the whole wheel was recovered at ${this.selection.speed.rpm.toFixed(0)} rpm, only at the critical speeds; ` +
      'choose one of them, a mode or the wheel at rest above.' : '';
    this.rest = none || kind === 'rest';
    this.mode = kind === 'mode' ? this.data.modes[k] : null;
    this.shown = kind === 'motion' ? this.data.motions[k] : null;
    const waves = this.mode ? [{order: 1, nodal_diameter: this.mode.nodal_diameter}] : this.shown?.waves ?? [];
    this.scene.motion.choose(i => this.mode ? entry : `${entry}/${i}`, waves);
    this.largest = this.shown ? this.shown.largest : 1;
    this.size = DRAWN_SHARE * this.data.radius / this.largest;
    this.scene.marks.visible = this.rest;
    if (!this.shown && this.colouring !== 'displacement') this.colouring = this.colours.lastChild.value = 'displacement';
    this.colours.lastChild.disabled = this.instant.disabled = !this.shown;
    this.update();
  }

  // A click on the wheel marks the nearest node and tells what it does.
  probe(event) {
    const box = this.canvas.getBoundingClientRect();
    this.probing = this.scene.vertexAt(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    this.place();
  }

  // Values at a node of the whole wheel, now and over the cycle.
  wordsAt(vertex) {
    const {count, nodes} = this.scene.motion, node = vertex % count, sector = Math.floor(vertex / count), [x, y, z] = nodes.subarray(3 * node, 3 * node + 3);
    const [moved, unit] = [this.lengths?.[vertex] ?? 0, this.mode ? 'of the largest component' : 'mm'];
    const stress = name => `${digits(this.data.array(`${this.entry}/${name}`)[node], 3)} MPa`;
    return `Node marked blue: sector ${sector}, radius ${(1000 * Math.hypot(x, y)).toFixed(1)} mm, axial ${(1000 * z).toFixed(1)} mm; ` + (this.rest ? '' :
      `moves ${digits(moved * (this.mode ? 1 : 1000), 3)} ${unit} now${this.shown ? `; over the cycle and all sectors ${stress('vibration')} of the vibration, ${
        stress('spin')} of the spin, ${stress('both')} of both` : ''}`);
  }

  // The node with the largest stress of the vibration, outside the zones where stress grows with the mesh.
  wordsOfWorst() {
    const {worst} = this.shown;
    return `Marked pink: the largest stress of the vibration, ${digits(worst.mpa, 3)} MPa, ${worst.where || 'in the sector'}, sector ${worst.sector}, rotor at ${
      (360 * worst.sample / this.shown.samples_per_revolution % 360).toFixed(0)} deg. `;
  }

  // What the colours end at, in their own unit: of the disc alone what all but a few of its nodes stay below.
  limitOf(stress) {
    if (!this.discOnly) return stress ? this.shown.stress_limit : this.largest;
    const all = stress ? [...this.onDisc].map(node => stress[node]) : this.scene.motion.largestOf([...this.onDisc]);
    return Math.max(all.sort((a, b) => a - b)[Math.floor((1 - DISC_ABOVE) * (all.length - 1))], 1e-12);
  }

  // Colours by what moves or is stressed; returns the bar that tells them.
  paintField() {
    const {palette, unit} = COLOURINGS[this.colouring], {count} = this.scene.motion, colours = this.scene.colours.array;
    const stress = this.colouring === 'displacement' ? null : this.data.array(`${this.entry}/${this.colouring}`);
    const limit = this.limitOf(stress), most = limit * (stress || this.mode ? 1 : 1000);
    const table = colourTable(palette).map(rgb => rgb.map(value => value / 255));
    this.lengths = new Float32Array(this.data.sectors * count);
    this.paint = (vertex, length) => {
      this.lengths[vertex] = length;
      const value = stress ? stress[vertex % count] : length, shown = !this.discOnly || this.onDisc.has(vertex % count);
      colours.set(shown ? table[Math.min(255, Math.round(255 * value / limit))] : METAL, 3 * vertex);
    };
    return colourBar(palette, [0, most / 2, most].map(value => digits(value, 3)), this.mode ? 'of the largest component' : unit);
  }

  // Sector 0 stands out; its node sets have their names.
  paintSector() {
    const {count} = this.scene.motion, colours = this.scene.colours.array, chosen = new THREE.Color(MARKED.sector).toArray();
    this.paint = vertex => colours.set(vertex < count ? chosen : METAL, 3 * vertex);
    return make('span', {}, ...Object.entries({sector: 'sector 0', clamped: 'clamped nodes', contact: 'contact nodes'}).flatMap(
      ([name, words]) => [make('span', {style: `color:${MARKED[name]}`, 'aria-hidden': 'true'}, '\u25CF '), `${words}  `]));
  }

  update() {
    this.bar.replaceChildren(this.rest ? this.paintSector() : this.paintField());
    this.scene.setCasing(this.shown && this.casing ? this.data.array(`${this.entry}/clearance`) : null, this.alike ? this.size : null);
    this.scene.halve(this.halved);
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
    const {count} = scene.motion, worst = this.shown?.worst;
    scene.mark('worst', worst && this.worst ? worst.sector * count + worst.node : null);
    scene.mark('probed', this.probing);
    scene.draw();
    this.probed.textContent = (worst && this.worst ? this.wordsOfWorst() : '') + (this.probing === null ? 'A click on the wheel tells the values at a node.'
      : this.wordsAt(this.probing));
    this.slider.value = Math.round(1000 * this.angle / this.period);
    if (this.shown?.index === this.selection.index) this.selection.setSample(this.sample, this);
    const turns = this.angle / (2 * Math.PI);
    this.told.textContent = this.rest ? '' : this.mode ? `${(360 * (turns % 1)).toFixed(0)} deg of the period; displacement drawn as ${digits(100 * DRAWN_SHARE)} % of the radius`
      : `rotor at ${(360 * turns).toFixed(0)} deg; displacement ${digits(this.size, 2)} times as large, casing's shape and clearance ${digits(this.alike ? this.size : this.scene.casingSize, 2)} times; ${digits(100 * this.shown.left_out, 2)} % of the mean square of the motion is in smaller waves and left out`;
  }

  forceNow() {
    const {samples, first_sample: first} = this.shown, {held, contacts} = this.data;
    const force = this.data.array(`${this.entry}/force`), sample = this.sample - first;
    return (sector, node) => force[((sector % held) * contacts + node) * samples + sample];
  }

  frame(now) {
    if (!this.inView) { this.before = null; return; }
    if (this.playing && this.before && !this.rest) {
      const pace = this.mode ? 4 / this.seconds : 1 / this.seconds;
      this.angle = (this.angle + 2 * Math.PI * pace * Math.min(0.1, (now - this.before) / 1000)) % this.period;
    }
    if (this.playing && this.before) this.scene.keepPace(now - this.before);
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
  const picture = document.querySelector('h2#meridional_section ~ figure img');
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
