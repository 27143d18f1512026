// SPDX-License-Identifier: GPL-3.0-or-later
const DOUBLE_CLICK = 250;  // [ms]
const SLOWEST_DOUBLE_CLICK = 1000;  // [ms] of any system's setting
const FLAT = 12;  // [px]
const KEY_STEPS = 100;  // of an axis

// A drawing with two axes, in SVG: it fills its host's width, tells the values under the pointer above it, zooms by dragging
// a box or by its buttons, and passes clicks on. The arrow keys move a cross whose values it tells. A flat box, and the buttons of
// a chart over speed, zoom along x alone. Colours come from the style sheet.
//
// options: name; x, y: {label, range: [low, high], ticks: [[place, words], ...] if not even}; height [px];
//   paint(chart): appends what is drawn; read(x, y): the words under the pointer; pick(x, y): a click, returns what takes it back;
//   step(-1 or 1): an arrow key; even: the same length on both axes; rows(): what "CSV" saves, its heads first;
//   look: a class of its own; right [px]: the margin there, for names beside it; shared: the selection whose window of speeds x shows.
class Chart {
  static margin = {left: 58, right: 14, top: 8, bottom: 42};

  constructor(host, options) {
    this.options = options;
    this.range = {x: [...options.x.range], y: [...options.y.range]};
    this.readout = make('output', {class: 'readout'});
    this.svg = makeSvg('svg', {class: `chart ${options.look ?? ''}`, role: 'img', tabindex: 0, 'aria-label': `${options.name}; the arrow keys tell values`});
    this.tools = make('div', {class: 'tools'});
    const zoom = factor => () => this.zoomBy(factor);
    this.buttons = make('span', {class: 'zoom'}, button('+', `${options.name}: zoom in`, zoom(0.5)),
      button('\u2212', `${options.name}: zoom out`, zoom(2)),
      button('Whole', `${options.name}: show all of it`, () => this.reset()), button('SVG', `${options.name}: save this view`, () => this.saveView()),
      ...(options.rows ? [button('CSV', `${options.name}: save its numbers`, () => download([csvOf(options.rows())], 'text/csv', `${this.fileName}.csv`))] : []));
    this.tools.append(this.readout, this.buttons);
    host.append(this.tools, this.svg);
    this.listen();
    options.shared?.onWindow(range => { this.range.x = range ?? [...options.x.range]; this.draw(); });
    options.shared?.onHover((rpm, chart) => { if (chart !== this) this.cross(rpm, null); });
    new ResizeObserver(() => this.draw()).observe(this.svg);
  }

  px(x) { return this.left + (x - this.range.x[0]) / (this.range.x[1] - this.range.x[0]) * this.width; }
  py(y) { return this.top + (this.range.y[1] - y) / (this.range.y[1] - this.range.y[0]) * this.height; }

  // Where an event is, in the numbers of the axes.
  place(event) {
    const box = this.svg.getBoundingClientRect();
    const share = (at, first, size) => Math.min(1, Math.max(0, (at - first) / size));
    const across = share(event.clientX - box.left, this.left, this.width);
    const up = 1 - share(event.clientY - box.top, this.top, this.height);
    const between = ([low, high], part) => low + part * (high - low);
    return [between(this.range.x, across), between(this.range.y, up)];
  }

  get fileName() { return this.options.name.replace(/\W+/g, '_'); }

  // The view with the looks that the style sheet gives it.
  saveView() {
    const looks = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'font-size', 'font-family'];
    const copy = this.svg.cloneNode(true), from = this.svg.querySelectorAll('*');
    copy.querySelectorAll('*').forEach((element, i) => {
      const style = getComputedStyle(from[i]);
      for (const look of looks) element.style.setProperty(look, style.getPropertyValue(look));
    });
    copy.querySelector('.cross')?.remove();
    set(copy, {xmlns: 'http://www.w3.org/2000/svg', width: this.svg.clientWidth, style: `background:${getComputedStyle(document.body).backgroundColor}`});
    download([new XMLSerializer().serializeToString(copy)], 'image/svg+xml', `${this.fileName}.svg`);
  }

  // Lines through a place; y null: the upright one alone.
  cross(x, y) {
    this.crossed?.remove();
    if (x === null || !this.width) return;
    const {left, top, width, height} = this, at = this.px(x);
    this.crossed = makeSvg('g', {class: 'cross'});
    if (at >= left && at <= left + width) this.crossed.append(makeSvg('line', {x1: at, x2: at, y1: top, y2: top + height}));
    if (y !== null) this.crossed.append(makeSvg('line', {x1: left, x2: left + width, y1: this.py(y), y2: this.py(y)}));
    this.svg.append(this.crossed);
  }

  // A line at x, or a dot at a place, which moves while the rest stays.
  setNow(x, y = null) {
    this.now = [x, y];
    this.drawNow();
  }

  drawNow() {
    this.nowMark?.remove();
    if (!this.now || !this.width) return;
    const [x, y] = this.now, {left, top, width, height} = this, at = this.px(x);
    if (!(at >= left && at <= left + width)) return;
    this.nowMark = y === null ? makeSvg('line', {class: 'now', x1: at, x2: at, y1: top, y2: top + height})
      : makeSvg('circle', {class: 'now', cx: at, cy: this.py(y), r: 5});
    this.svg.append(this.nowMark);
  }

  point(x, y) {
    this.cursor = [x, y];
    this.readout.textContent = this.options.read?.(x, y) ?? '';
    this.cross(x, y);
    this.options.shared?.hover(x, this);
  }

  leave() {
    this.readout.textContent = '';
    this.cross(null);
    this.options.shared?.hover(null, this);
  }

  // An arrow key: along a chart over speed to the next one, else the cross.
  move(across, up) {
    const {x, y} = this.range, {step, middle} = this.options;
    const inside = (value, [low, high]) => Math.min(high, Math.max(low, value));
    let [atX, atY] = this.cursor ?? [middle?.() ?? (x[0] + x[1]) / 2, (y[0] + y[1]) / 2];
    if (step && across) step(across);
    atX = step ? middle() : inside(atX + across * (x[1] - x[0]) / KEY_STEPS, x);
    this.point(atX, inside(atY + up * (y[1] - y[0]) / KEY_STEPS, y));
  }

  listen() {
    let from = null;
    let picking = 0, picked = null;
    this.svg.addEventListener('pointerdown', event => {
      this.svg.setPointerCapture?.(event.pointerId);  // a box may be released outside
      from = {place: this.place(event), x: event.clientX, y: event.clientY};
    });
    this.svg.addEventListener('pointermove', event => {
      this.point(...this.place(event));
      if (from && event.buttons) this.drawBox(from.place, this.place(event));
    });
    this.svg.addEventListener('pointerleave', () => this.leave());
    this.svg.addEventListener('blur', () => this.leave());
    this.svg.addEventListener('pointerup', event => {
      if (!from) return;
      const moved = Math.hypot(event.clientX - from.x, event.clientY - from.y), start = from.place;
      this.box?.remove();
      if (moved > 8) this.zoomTo(start, this.place(event), Math.abs(event.clientY - from.y) < FLAT);
      else if (this.options.pick) {  // once it is clear that no second click follows
        const at = this.place(event);
        clearTimeout(picking);
        picking = setTimeout(() => { picked = {back: this.options.pick(...at), when: performance.now()}; }, DOUBLE_CLICK);
      }
      from = null;
    });
    this.svg.addEventListener('pointercancel', () => { from = null; this.box?.remove(); });
    this.svg.addEventListener('dblclick', () => {
      clearTimeout(picking);
      if (picked && performance.now() - picked.when < SLOWEST_DOUBLE_CLICK) picked.back();
      picked = null;
      this.reset();
    });
    this.svg.addEventListener('keydown', event => {
      const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (!move) return;
      event.preventDefault();
      this.move(...move);
    });
  }

  drawBox(a, b) {
    this.box?.remove();
    const [left, right] = [this.px(a[0]), this.px(b[0])].sort((p, q) => p - q);
    const [top, bottom] = [this.py(a[1]), this.py(b[1])].sort((p, q) => p - q);
    this.box = makeSvg('rect', {x: left, y: top, width: right - left, height: bottom - top, class: 'zoom-box'});
    this.svg.append(this.box);
  }

  // All charts over speed show the same speeds.
  show(x, y) {
    this.range.y = y;
    if (this.options.shared) return this.options.shared.showWindow(x);
    this.range.x = x ?? [...this.options.x.range];
    this.draw();
  }

  zoomTo(a, b, flat) {
    this.show([Math.min(a[0], b[0]), Math.max(a[0], b[0])], flat ? this.range.y : [Math.min(a[1], b[1]), Math.max(a[1], b[1])]);
  }

  // About the chosen place, or the middle; never beyond the whole.
  zoomBy(factor) {
    const zoomed = axis => {
      const [low, high] = this.range[axis], [first, last] = this.options[axis].range;
      const middle = axis === 'x' && this.options.middle ? this.options.middle() : (low + high) / 2;
      const half = Math.min(factor * (high - low), last - first) / 2;
      const start = Math.min(Math.max(middle - half, first), last - 2 * half);
      return [start, start + 2 * half];
    };
    this.show(zoomed('x'), this.options.shared ? this.range.y : zoomed('y'));
  }

  reset() { this.show(null, [...this.options.y.range]); }

  // Other numbers on the axes from now on.
  setRanges(x, y) {
    this.options.x.range = x;
    this.options.y.range = y;
    this.reset();
  }

  draw() {
    const full = this.svg.clientWidth;
    if (!full) return;
    const {left, top, bottom} = Chart.margin, {height, right = Chart.margin.right} = this.options;
    Object.assign(this, {left, top, width: Math.max(60, full - left - right), height: height - top - bottom});
    if (this.options.even) this.makeEven();
    this.svg.replaceChildren();
    set(this.svg, {viewBox: `0 0 ${full} ${height}`, height});
    this.clip = `clip-${Chart.count = (Chart.count ?? 0) + 1}`;
    const clip = makeSvg('clipPath', {id: this.clip});
    clip.append(makeSvg('rect', {x: left, y: top, width: this.width, height: this.height}));
    this.axes = makeSvg('g', {class: 'axes'});
    this.content = makeSvg('g', {'clip-path': `url(#${this.clip})`});
    this.svg.append(clip, makeSvg('rect', {x: left, y: top, width: this.width, height: this.height, class: 'ground'}),
      this.axes, this.content);
    drawAxes(this);
    this.options.paint(this);
    this.svg.append(makeSvg('rect', {x: left, y: top, width: this.width, height: this.height, class: 'frame'}));
    this.drawNow();
  }

  makeEven() {
    const [[x0, x1], [y0, y1]] = [this.range.x, this.range.y];
    const scale = Math.max((x1 - x0) / this.width, (y1 - y0) / this.height);
    const about = (low, high, size) => [(low + high - scale * size) / 2, (low + high + scale * size) / 2];
    this.range = {x: about(x0, x1, this.width), y: about(y0, y1, this.height)};
  }

  line(xs, ys, look, colour = null) {
    let path = '', pen = 'M';
    for (let i = 0; i < xs.length; ++i) {
      if (!Number.isFinite(ys[i])) { pen = 'M'; continue; }
      path += `${pen}${this.px(xs[i]).toFixed(1)} ${this.py(ys[i]).toFixed(1)}`;
      pen = 'L';
    }
    this.content.append(makeSvg('path', {d: path, class: look, style: colour && `stroke:${colour}`}));
  }

  dot(x, y, radius, look) { this.content.append(makeSvg('circle', {cx: this.px(x), cy: this.py(y), r: radius, class: look})); }

  // At the foot of the chart.
  triangle(x, filled) {
    const at = this.px(x), foot = this.top + this.height;
    this.content.append(makeSvg('path', {d: `M${at - 5} ${foot - 2}h10l-5 -9z`, class: filled ? 'equation-2' : 'aliased'}));
  }

  upright(x, look) { this.line([x, x], this.range.y, look); }

  text(x, y, words, attributes = {}) {
    this.content.append(makeSvg('text', {x: this.px(x), y: this.py(y), ...attributes}, words));
  }
}
