// SPDX-License-Identifier: GPL-3.0-or-later
// Index of the speed that is nearest to one [rpm].
function nearestIn(speeds, rpm) {
  let best = 0;
  for (let i = 1; i < speeds.length; ++i)
    if (Math.abs(speeds[i].rpm - rpm) < Math.abs(speeds[best].rpm - rpm)) best = i;
  return best;
}

// What all views show: the speed, the edge, the nodal diameter of the maps, and the window of speeds; whoever wants to know when it
// changes; and the same in the page's address, so that a link leads to a view, and "back" to the one before.
class Selection {
  constructor(data) {
    Object.assign(this, {data, listeners: [], windows: [], hovers: [], instants: [], sample: 0});
    this.begin();
    this.readAddress();
    addEventListener('popstate', () => {
      if (location.hash === '') this.begin();
      else if (!this.readAddress()) return;
      this.tell();
      this.tellWindow();
    });
  }

  // The view of an address that names none.
  begin() { Object.assign(this, {index: this.data.shown, edge: this.data.edge, part: 'total', asked: null, window: null}); }

  // Whether the address names a view; one that names an element of the page does not.
  readAddress() {
    const found = new URLSearchParams(location.hash.slice(1)), number = name => Number.parseFloat(found.get(name));
    if (!Number.isFinite(number('rpm'))) return false;
    this.index = this.nearest(number('rpm'));
    this.asked = null;
    if (['leading', 'trailing'].includes(found.get('edge'))) this.edge = found.get('edge');
    this.part = /^\d+$/.test(found.get('nd') ?? '') && Number(found.get('nd')) <= this.data.sectors / 2 ? found.get('nd') : 'total';
    this.window = number('from') < number('to') ? [number('from'), number('to')] : null;
    return true;
  }

  get address() {
    return `#rpm=${this.speed.rpm.toFixed(1)}&edge=${this.edge}${this.part === 'total' ? '' : `&nd=${this.part}`}${
      this.window ? `&from=${this.window[0].toFixed(0)}&to=${this.window[1].toFixed(0)}` : ''}`;
  }

  // Steps of a series make one entry of the history.
  writeAddress(series) {
    history[series && this.inSeries ? 'replaceState' : 'pushState'](null, '', this.address);
    this.inSeries = series;
  }

  get speed() { return this.data.speeds[this.index]; }
  get name() {
    return `${this.speed.rpm.toFixed(0)} rpm${this.critical ? `, critical: ${this.critical.wave}` : ''}`;
  }
  array(edge, what) { return this.data.array(`${this.index}/${edge}/${what}`); }

  onChange(listener) { this.listeners.push(listener); }
  tell() { for (const listener of this.listeners) listener(); }

  // `asked` [rpm]: what was typed, which need not have been simulated.
  choose(index, {series = false, asked = null} = {}) {
    this.index = Math.min(Math.max(index, 0), this.data.speeds.length - 1);
    this.asked = asked;
    this.writeAddress(series);
    this.tell();
  }
  chooseEdge(edge) {
    this.edge = edge;
    this.writeAddress(false);
    this.tell();
  }
  choosePart(part) {
    this.part = part;
    this.writeAddress(false);
    this.tell();
  }
  step(by) { this.choose(this.index + by, {series: true}); }
  ask(rpm) { this.choose(this.nearest(rpm), {asked: rpm}); }

  // [rpm] that the charts over speed show; null: all.
  onWindow(listener) { this.windows.push(listener); }
  tellWindow() { for (const listener of this.windows) listener(this.window); }
  showWindow(range) {
    this.window = range;
    this.writeAddress(true);
    this.tellWindow();
  }
  onHover(listener) { this.hovers.push(listener); }
  hover(rpm, chart) { for (const listener of this.hovers) listener(rpm, chart); }

  // The recorded sample at which motion, force, contact and wheel have their cursor; `teller`: who need not hear of it.
  onSample(listener) { this.instants.push(listener); }
  setSample(sample, teller = null) {
    this.sample = sample % shownSamples(this.speed);
    for (const listener of this.instants) listener(teller);
  }

  get critical() { return this.data.critical.find(peak => peak.index === this.index); }

  // On the straight line between the simulated speeds.
  between(rpm, what) {
    const {speeds} = this.data, above = speeds.findIndex(speed => speed.rpm >= rpm);
    if (above <= 0) return null;
    const [a, b] = [speeds[above - 1], speeds[above]], share = (rpm - a.rpm) / (b.rpm - a.rpm);
    return {low: a.rpm, high: b.rpm, value: a[what] + share * (b[what] - a[what])};
  }

  // The same of the amplitude at what was typed; null where that speed was simulated, or lies outside the simulated ones.
  get askedBetween() {
    return this.asked === null || Math.abs(this.asked - this.speed.rpm) < 0.5 ? null : this.between(this.asked, 'largest');
  }

  // The largest waves at the chosen edge: engine order, signed nodal diameter, amplitude [mm].
  largestWaves(count) {
    const {lines, revolutions} = this.speed, {sectors} = this.data, spectrum = this.array(this.edge, 'spectrum'), waves = [];
    for (let column = 0; column < sectors; ++column)
      for (let line = 1; line < lines; ++line)
        waves.push([line / revolutions, 2 * column > sectors ? column - sectors : column, spectrum[line + lines * column]]);
    return waves.sort((a, b) => b[2] - a[2]).slice(0, count);
  }

  nearest(rpm) { return nearestIn(this.data.speeds, rpm); }

  // A critical speed that is near enough to be meant (`reach` [rpm]), or else the nearest speed.
  pick(rpm, reach) {
    const {critical, speeds} = this.data, before = this.index;
    const near = critical.map(peak => peak.index).filter(index => Math.abs(speeds[index].rpm - rpm) <= reach)
      .sort((a, b) => Math.abs(speeds[a].rpm - rpm) - Math.abs(speeds[b].rpm - rpm));
    this.choose(near.length ? near[0] : this.nearest(rpm));
    return () => this.choose(before);
  }
}

const mmOf = length => `${digits(length, 3)} mm`;

// Where a speed [rpm] lies among the speeds to avoid.
function placeAmong(bands, rpm) {
  const named = band => `${band.low.toFixed(0)} to ${band.high.toFixed(0)} rpm (${band.reason})`;
  const inside = bands.find(({low, high}) => low <= rpm && rpm <= high);
  if (inside) return `To be avoided: inside ${named(inside)}`;
  if (!bands.length) return 'No band of speeds to avoid is known';
  const distance = ({low, high}) => Math.max(low - rpm, rpm - high);
  const nearest = bands.reduce((a, b) => distance(a) <= distance(b) ? a : b), away = distance(nearest);
  return `Outside the speeds to avoid: ${digits(away, 3)} rpm (${digits(100 * away / rpm, 2)} %) from ${named(nearest)}`;
}

// Stress and Goodman's utilisation as far as they are known; `stress` [MPa], `goodman` [1]: estimates, or null.
function loadOf(critical, stress, goodman) {
  if (critical && critical.vibration !== null)
    return `${critical.over_cycle ? '' : 'at least '}${digits(critical.vibration, 3)} MPa${critical.goodman === null ? '' : `, Goodman's utilisation ${critical.goodman.toFixed(2)}`}`;
  if (stress === null) return 'stress not known';
  return `about ${digits(stress, 2)} MPa${goodman === null ? '' : `, Goodman's utilisation about ${goodman.toFixed(2)}`}`;
}

// How sure the numbers of a simulated speed are.
function certaintyOf(speed, critical) {
  const percent = share => `${digits(100 * share, 2)} %`, steps = speed.step_error > 0 ? `, the time step changes it by ${percent(speed.step_error)}` : '';
  if (!critical) return `${speed.motion}${speed.settled ? '' : ', not settled'}${steps}`;
  return `${speed.motion}${speed.settled ? '' : ', not settled'}, amplitude within ${percent(critical.slack)}, peak between ${
    critical.between.map(rpm => rpm.toFixed(0)).join(' and ')} rpm; ${critical.open === null ? 'no error budget'
    : `the error budget leaves open ${critical.open.map(([what, share]) => `${percent(share)} of ${what === '|u|' ? what : `the ${what}`}`).join(', ')}`}`;
}

// In a few words, of any speed: whether to run there, what moves, what it bears, and how sure that is.
function verdictAt(selection) {
  const {data, speed, critical, asked} = selection, between = selection.askedBetween;
  if (asked !== null && !between && Math.abs(asked - speed.rpm) >= 0.5) return 'Not known: outside the simulated speeds.';
  const [excursion, stress, goodman] = ['excursion', 'stress', 'goodman'].map(
    what => between && speed[what] !== null ? selection.between(asked, what).value : speed[what]);
  const sure = between ? `on the line between ${between.low.toFixed(0)} and ${between.high.toFixed(0)} rpm, where a peak may be missed`
    : certaintyOf(speed, critical);
  return `${placeAmong(data.avoid, between ? asked : speed.rpm)}. |u| ${mmOf(excursion)}, ${
    loadOf(between ? null : critical, stress, goodman)}. How sure: ${sure}${data.caveat}.`;
}

// What happens at the shown speed, in words.
function answersAt(selection) {
  const {data, speed, critical, asked, edge} = selection, side = edge === 'leading' ? 0 : 1, between = selection.askedBetween;
  return [
    ['Asked', between ? `${digits(asked, 6)} rpm was not simulated, the nearest speed is shown. On the line between ${between.low.toFixed(0)} and ${
      between.high.toFixed(0)} rpm the tip moves by ${mmOf(between.value)}.` : asked !== null && Math.abs(asked - speed.rpm) >= 0.5
        ? `${digits(asked, 6)} rpm is outside the simulated speeds, the nearest one is shown.` : null],
    ['Verdict', verdictAt(selection)],
    ['Motion', `${mmOf(speed.largest)} on the tip line, leading edge ${mmOf(speed.leading)}, trailing edge ${mmOf(speed.trailing)}; in all directions |u| ${
      mmOf(speed.excursion)}; ${speed.motion}; running clearance at the ${edge} edge ${mmOf(speed.clearance[side])}`],
    ['Waves', `at the ${edge} edge ${selection.largestWaves(3).map(([order, n, amplitude]) =>
      `EO ${digits(order)} ND ${n > 0 ? '+' : ''}${n} ${mmOf(amplitude)}`).join(', ')}`],
    ['Stress', critical?.stress ?? (speed.stress === null ? 'recovered at critical speeds only'
      : `about ${digits(speed.stress, 2)} MPa of the vibration, estimated from the waves of the tip; it is recovered at critical speeds`)],
    ['Outside validity', speed.outside],
  ].filter(([, words]) => words);
}

// Tables whose first column is a speed: each row leads to that speed.
function linkRows(selection) {
  for (const table of document.querySelectorAll('main table')) {
    if (!/^(critical )?speed \[rpm\]$/.test(table.tHead?.rows[0].cells[0].textContent ?? '')) continue;
    for (const row of table.tBodies[0].rows) {
      const cell = row.cells[0], rpm = Number(cell.textContent);
      if (!Number.isFinite(rpm) || !cell.textContent) continue;
      const link = button(cell.textContent, `${cell.textContent} rpm: show this speed`, () => {
        selection.ask(rpm);
        selection.asked = null;
        selection.tell();
        document.getElementById('explore').scrollIntoView();
      });
      link.classList.add('row-speed');
      link.setAttribute('aria-label', link.title);
      cell.replaceChildren(link);
    }
  }
}

// Choices by keyboard: critical speeds, neighbours, any speed, the edge. Says aloud what is shown.
function selectionBar(selection) {
  const {data} = selection, none = '';
  const answers = make('dl', {class: 'answers', id: 'shown-answers'});
  const critical = choice('Critical speed', [[none, 'none'], ...data.critical.map(peak =>
    [String(peak.index), `${data.speeds[peak.index].rpm.toFixed(0)} rpm, ${peak.wave}`])], none,
    value => value !== none && selection.choose(Number(value)));
  const slider = make('input', {type: 'range', min: 0, max: data.speeds.length - 1, step: 1, 'aria-label': 'Speed'});
  slider.addEventListener('input', () => selection.choose(Number(slider.value), {series: true}));
  const typed = make('input', {type: 'number', min: 0, step: 'any', 'aria-label': 'Speed in rpm', class: 'typed'});
  typed.addEventListener('change', () => { if (typed.value) selection.ask(Number(typed.value)); });
  const link = button('Copy link', 'to this speed and view', () => {
    link.textContent = copied(new URL(selection.address, location.href).href) ? 'Link copied' : 'Copy the address by hand';
  });
  link.removeAttribute('aria-label');
  const shown = make('output', {class: 'shown', 'aria-live': 'polite', id: 'shown-speed'});
  const edge = choice('Edge', [['leading', 'leading'], ['trailing', 'trailing']], selection.edge,
    value => selection.chooseEdge(value));
  selection.onChange(() => {
    slider.value = selection.index;
    slider.setAttribute('aria-valuetext', selection.name);
    shown.textContent = `${selection.name}; ${selection.speed.motion}`;
    typed.value = digits(selection.asked ?? selection.speed.rpm, 6);
    edge.lastChild.value = selection.edge;
    link.textContent = 'Copy link';
    answers.replaceChildren(...answersAt(selection).flatMap(([question, words]) => [make('dt', {}, question), make('dd', {}, words)]));
    critical.lastChild.value = data.critical.some(peak => peak.index === selection.index) ? String(selection.index) : none;
  });
  const bar = make('div', {class: 'selection'}, shown, critical, make('label', {class: 'choice'}, 'rpm ', typed),
    button('\u2039', 'The speed before', () => selection.step(-1)), slider, button('\u203a', 'The next speed', () => selection.step(1)), edge, link);
  return [bar, answers];
}
