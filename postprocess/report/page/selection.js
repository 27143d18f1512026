// SPDX-License-Identifier: GPL-3.0-or-later
// Index of the speed that is nearest to one [rpm].
function nearestIn(speeds, rpm) {
  let best = 0;
  for (let i = 1; i < speeds.length; ++i)
    if (Math.abs(speeds[i].rpm - rpm) < Math.abs(speeds[best].rpm - rpm)) best = i;
  return best;
}

// The speed and the edge that all views show: one place, and whoever wants to know when it changes.
class Selection {
  constructor(data) {
    this.data = data;
    this.index = data.shown;
    this.edge = data.edge;
    this.listeners = [];
  }

  get speed() { return this.data.speeds[this.index]; }
  get name() {
    const critical = this.data.critical.find(peak => peak.index === this.index);
    return `${this.speed.rpm.toFixed(0)} rpm${critical ? `, critical: ${critical.wave}` : ''}`;
  }
  array(edge, what) { return this.data.array(`${this.index}/${edge}/${what}`); }

  onChange(listener) { this.listeners.push(listener); }
  tell() { for (const listener of this.listeners) listener(); }

  choose(index) {
    this.index = Math.min(Math.max(index, 0), this.data.speeds.length - 1);
    this.tell();
  }
  chooseEdge(edge) {
    this.edge = edge;
    this.tell();
  }
  step(by) { this.choose(this.index + by); }

  nearest(rpm) { return nearestIn(this.data.speeds, rpm); }

  // A critical speed that is near enough to be meant (`reach` [rpm]), or else the nearest speed.
  pick(rpm, reach) {
    const {critical, speeds} = this.data;
    const near = critical.map(peak => peak.index).filter(index => Math.abs(speeds[index].rpm - rpm) <= reach)
      .sort((a, b) => Math.abs(speeds[a].rpm - rpm) - Math.abs(speeds[b].rpm - rpm));
    this.choose(near.length ? near[0] : this.nearest(rpm));
  }
}

// Choices by keyboard: critical speeds, neighbours, any speed, the edge. Says aloud what is shown.
function selectionBar(selection) {
  const {data} = selection, none = '';
  const critical = choice('Critical speed', [[none, 'none'], ...data.critical.map(peak =>
    [String(peak.index), `${data.speeds[peak.index].rpm.toFixed(0)} rpm, ${peak.wave}`])], none,
    value => value !== none && selection.choose(Number(value)));
  const slider = make('input', {type: 'range', min: 0, max: data.speeds.length - 1, step: 1, 'aria-label': 'Speed'});
  slider.addEventListener('input', () => selection.choose(Number(slider.value)));
  const shown = make('output', {class: 'shown', 'aria-live': 'polite', id: 'shown-speed'});
  const edge = choice('Edge', [['leading', 'leading'], ['trailing', 'trailing']], selection.edge,
    value => selection.chooseEdge(value));
  selection.onChange(() => {
    slider.value = selection.index;
    slider.setAttribute('aria-valuetext', selection.name);
    shown.textContent = `${selection.name}; ${selection.speed.motion}`;
    critical.lastChild.value = data.critical.some(peak => peak.index === selection.index) ? String(selection.index) : none;
  });
  return make('div', {class: 'selection'}, shown, critical, button('\u2039', 'The speed before', () => selection.step(-1)),
    slider, button('\u203a', 'The next speed', () => selection.step(1)), edge);
}
