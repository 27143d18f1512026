// SPDX-License-Identifier: GPL-3.0-or-later
// What happens at the shown speed: motion and force of all sectors, their travelling waves, where the casing is rubbed, and the
// path of the tip.

// Of the motion one period is drawn, or all that is recorded.
function shownSamples(speed) {
  return speed.samples * Math.min(speed.period || speed.revolutions, speed.revolutions);
}

// [deg] of the rotor from the start of the recording, at the sample of the cursor.
function angleOf({sample, speed}) { return 360 * sample / speed.samples; }

// [deg] of the casing that the tip of sector 0 passes then.
function casingAngle(selection) { return (angleOf(selection) + selection.data.tip_angle[selection.edge]) % 360; }

// The rotor's angle at which motion, force, contact, path and wheel have their cursor, and what sector 0 does there.
function timeView(host, selection) {
  const {data} = selection, slider = make('input', {type: 'range', min: 0, step: 1, 'aria-label': 'Rotor angle'});
  const told = make('output', {class: 'readout', id: 'at-instant'});
  slider.addEventListener('input', () => selection.setSample(Number(slider.value)));
  host.append(make('div', {class: 'tools time'}, make('label', {class: 'choice'}, 'Rotor angle ', slider), told));
  selection.onSample(() => {
    const {speed, sample, edge} = selection, at = what => digits(selection.array(edge, what)[sample], 3);
    Object.assign(slider, {max: shownSamples(speed) - 1, value: sample});
    const angle = `${angleOf(selection).toFixed(0)} deg`;
    slider.setAttribute('aria-valuetext', angle);
    told.textContent = `${angle}: sector 0 at the ${edge} edge ${at(data.component)} mm ${data.component}, force ${at('force')} N, ` +
      `over the casing at ${((casingAngle(selection) + 360) % 360).toFixed(0)} deg`;
  });
  selection.onChange(() => selection.setSample(selection.sample));
}

function half(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) { low = Math.min(low, value); high = Math.max(high, value); }
  return [low, high];
}

// One sector above the other; sector j moves as sector j mod the held ones.
function sectorsView(host, selection, what, unit) {
  const {data} = selection, title = {motion: `Motion of all sectors, ${data.component}`, force: 'Contact force on all sectors'}[what];
  const name = what === 'motion' ? data.component : 'force';
  const spacing = () => {
    let most = 0;
    for (const edge of ['leading', 'trailing']) {
      const [low, high] = half(selection.array(edge, name));
      most = Math.max(most, high - low);
    }
    return most > 0 ? 1.1 * most : 1;
  };
  const values = j => selection.array(selection.edge, name).subarray((j % data.held) * selection.speed.samples * selection.speed.revolutions)
    .subarray(0, shownSamples(selection.speed));
  const chart = new Chart(host, {
    name: title, height: 360, x: {label: 'rotor angle [deg]', range: [0, 360]},
    y: {label: `sector (${unit} between)`, range: [-1, data.sectors], ticks: Array.from({length: data.sectors}, (_, j) => [j, `${j}`])},
    paint: drawn => {
      const gap = spacing(), angles = Float32Array.from({length: shownSamples(selection.speed)}, (_, s) => 360 * s / selection.speed.samples);
      for (let j = 0; j < data.sectors; ++j) {
        const [low, high] = half(values(j)), middle = what === 'force' ? 0 : (low + high) / 2;
        drawn.line(angles, values(j).map(value => j + (value - middle) / gap), j % 2 ? 'sector odd' : 'sector even');
      }
    },
    read: (x, y) => {
      const j = Math.min(data.sectors - 1, Math.max(0, Math.round(y))), {samples} = selection.speed;
      const s = Math.min(shownSamples(selection.speed) - 1, Math.max(0, Math.round(x / 360 * samples)));
      return `sector ${j}, ${(360 * s / samples).toFixed(1)} deg: ${digits(values(j)[s])} ${unit}`;
    },
    pick: x => {
      const before = selection.sample;
      selection.setSample(Math.min(shownSamples(selection.speed) - 1, Math.round(x / 360 * selection.speed.samples)));
      return () => selection.setSample(before);
    },
    rows: () => {
      const all = Array.from({length: data.sectors}, (_, j) => values(j));
      return [['rotor angle [deg]', ...all.map((_, j) => `sector ${j} [${unit}]`)],
        ...Array.from(all[0], (_, s) => [360 * s / selection.speed.samples, ...all.map(values => values[s])])];
    },
  });
  selection.onChange(() => {
    chart.options.y.label = `sector (a step is ${digits(spacing(), 2)} ${unit})`;
    chart.setRanges([0, 360 * shownSamples(selection.speed) / selection.speed.samples], [-1, data.sectors]);
  });
  selection.onSample(() => chart.setNow(angleOf(selection)));
}

// Signed nodal diameter of a column of the spectrum.
function signedDiameter(column, sectors) { return 2 * column > sectors ? column - sectors : column; }

function spectrumView(host, selection) {
  const {data} = selection, half = Math.floor(data.sectors / 2), lowest = half - data.sectors + 1;
  const amplitude = (line, column) => selection.array(selection.edge, 'spectrum')[line + selection.speed.lines * column];
  const columnOf = n => (n + data.sectors) % data.sectors;
  const chart = new Chart(host, {
    name: 'Two-way spectrum', height: 330, x: {label: 'engine order', range: [0, data.axes.engine_orders + 0.5]},
    y: {label: 'nodal diameter (+ backward)', range: [lowest - 0.6, half + 0.6],
      ticks: Array.from({length: data.sectors}, (_, k) => [lowest + k, `${lowest + k}`])},
    paint: drawn => {
      const {lines, revolutions} = selection.speed, top = Math.log10(data.axes.map), {decades} = data.axes;
      const width = Math.max(2, drawn.px(Math.min(0.5 / revolutions, 0.2)) - drawn.px(-Math.min(0.5 / revolutions, 0.2)));
      for (let column = 0; column < data.sectors; ++column)
        for (let line = 1; line < lines; ++line) {
          const level = (Math.log10(amplitude(line, column)) - top) / decades + 1;
          if (!(level > 0)) continue;
          const tall = (drawn.py(0) - drawn.py(0.86)) * Math.min(1, level), n = signedDiameter(column, data.sectors);
          const [r, g, b] = VIRIDIS[Math.round(255 * Math.min(1, level))];
          drawn.content.append(makeSvg('rect', {x: drawn.px(line / revolutions) - width / 2, y: drawn.py(n) - tall / 2, width, height: tall,
            fill: `rgb(${r},${g},${b})`, class: 'wave-bar'}));
        }
    },
    read: (x, y) => {
      const {lines, revolutions} = selection.speed, line = Math.min(lines - 1, Math.max(0, Math.round(x * revolutions)));
      const n = Math.min(half, Math.max(lowest, Math.round(y)));
      return `EO ${digits(line / revolutions)}, ND ${n > 0 ? '+' : ''}${n}: ${digits(amplitude(line, columnOf(n)))} mm`;
    },
    rows: () => [['engine order', 'signed nodal diameter', 'amplitude [mm]'], ...selection.largestWaves(Infinity)],
  });
  selection.onChange(() => chart.draw());
}

function contactView(host, selection) {
  host.append(legend(['leading', 'leading edge'], ['trailing', 'trailing edge']));
  const share = edge => selection.array(edge, 'contact');
  const chart = new Chart(host, {
    name: 'Where sector 0 rubs', height: 260, x: {label: 'angle on the casing [deg]', range: [0, 360], ticks: [0, 60, 120, 180, 240, 300, 360].map(a => [a, `${a}`])},
    y: {label: 'share of the steps [1]', range: [0, 1.05]},
    paint: drawn => {
      for (const edge of ['leading', 'trailing']) {
        const areas = share(edge).length;
        drawn.line(Float32Array.from({length: areas}, (_, a) => 360 * (a + 0.5) / areas), share(edge), edge);
      }
    },
    read: x => {
      const areas = share('leading').length, area = Math.min(areas - 1, Math.floor(x / 360 * areas));
      return `area ${area}, ${(360 * area / areas).toFixed(1)} deg: leading edge ${digits(share('leading')[area], 3)}, trailing edge ${digits(share('trailing')[area], 3)}`;
    },
    rows: () => [['angle [deg]', 'leading edge [1]', 'trailing edge [1]'],
      ...Array.from(share('leading'), (value, area) => [360 * (area + 0.5) / share('leading').length, value, share('trailing')[area]])],
  });
  selection.onChange(() => chart.draw());
  selection.onSample(() => chart.setNow((casingAngle(selection) + 360) % 360));
}

// Along the normal (towards the casing) against the tangential; sector 0 strong, the others faint.
function orbitView(host, selection) {
  const {data} = selection;
  host.append(legend(['leading', 'leading edge'], ['trailing', 'trailing edge']));
  const path = (edge, what, j) => {
    const all = selection.speed.samples * selection.speed.revolutions;
    return selection.array(edge, what).subarray(j * all, j * all + shownSamples(selection.speed));
  };
  const chart = new Chart(host, {
    name: 'Path of the tip', height: 330, even: true, x: {label: 'tangential, with the rotation [mm]', range: [-1, 1]},
    y: {label: 'along the normal [mm]', range: [-1, 1]},
    paint: drawn => {
      for (const edge of ['leading', 'trailing'])
        for (let j = data.held - 1; j >= 0; --j)
          drawn.line(path(edge, 'tangential', j), path(edge, 'normal', j), `${edge} ${j ? 'faint' : ''}`);
    },
    read: (x, y) => `${digits(x, 3)} mm tangential, ${digits(y, 3)} mm along the normal`,
    rows: () => [['tangential, leading edge [mm]', 'along the normal, leading edge [mm]', 'tangential, trailing edge [mm]', 'along the normal, trailing edge [mm]'],
      ...Array.from(path('leading', 'normal', 0), (normal, s) => [path('leading', 'tangential', 0)[s], normal, path('trailing', 'tangential', 0)[s],
        path('trailing', 'normal', 0)[s]])],
  });
  selection.onChange(() => {
    const around = what => {
      const ends = ['leading', 'trailing'].map(edge => half(selection.array(edge, what)));
      const low = Math.min(...ends.map(end => end[0])), high = Math.max(...ends.map(end => end[1]));
      const room = 0.05 * (high - low) || 1e-6;
      return [low - room, high + room];
    };
    chart.setRanges(around('tangential'), around('normal'));
  });
  selection.onSample(() => chart.setNow(...['tangential', 'normal'].map(what => path(selection.edge, what, 0)[selection.sample])));
}
