// SPDX-License-Identifier: GPL-3.0-or-later
// Amplitude over speed; a click chooses a speed, a critical one if it is near.
const NEAR_PIXELS = 14;

function legend(...entries) {
  return make('ul', {class: 'legend'}, ...entries.map(([look, words]) => make('li', {},
    make('span', {class: `swatch ${look}`}), words)));
}

function speedRange(data) { return {label: 'speed [rpm]', range: [...data.axes.speed]}; }

// A speed whose motion leaves what its model can say, at the upper edge.
function markOutside(chart, rpm) {
  const x = chart.px(rpm);
  if (x >= chart.left && x <= chart.left + chart.width)
    chart.content.append(makeSvg('rect', {class: 'outside-mark', x: x - 2, y: chart.top, width: 4, height: 5}));
}

// Where the critical speeds are, and the one that is shown.
function markSpeeds(chart, selection) {
  const {data} = selection;
  for (const peak of data.critical) {
    const x = data.speeds[peak.index].rpm;
    chart.upright(x, 'critical-mark');
  }
  chart.upright(selection.speed.rpm, 'chosen-mark');
}

function pickSpeed(chart, selection, x) {
  return selection.pick(x, NEAR_PIXELS * (chart.range.x[1] - chart.range.x[0]) / chart.width);
}

// A range of speeds, as high as the chart.
function drawBand(chart, low, high, look) {
  const [left, right] = [low, high].map(x => Math.min(chart.left + chart.width, Math.max(chart.left, chart.px(x))));
  if (right > left) chart.content.append(makeSvg('rect', {class: look, x: left, y: chart.top, width: right - left, height: chart.height}));
}

// Speeds and an amplitude of each, with a gap at those that failed.
function curveOf({speeds, failed}, name) {
  const points = [...speeds.map(speed => [speed.rpm, speed[name]]), ...failed.map(rpm => [rpm, NaN])].sort(([a], [b]) => a - b);
  return [0, 1].map(k => points.map(point => point[k]));
}

function drawResponse(chart, selection) {
  const {data} = selection, {speeds} = data;
  if (data.operating[1] > 0) drawBand(chart, ...data.operating, 'operating');
  for (const band of data.avoid) drawBand(chart, band.low, band.high, `avoid grade-${band.grade}`);
  markSpeeds(chart, selection);
  for (const name of ['largest', 'leading', 'trailing']) chart.line(...curveOf(data, name), name);
  for (const x of data.failed) chart.text(x, 0, '\u00d7', {class: 'failed', dy: -4});
  data.others.forEach((_, k) => chart.line(data.array(`other/${k}/speed`), data.array(`other/${k}/largest`), `other other-${k % 6}`));
  for (const speed of speeds) {
    chart.dot(speed.rpm, speed.largest, 2.2, 'largest-dot');
    if (speed.outside) markOutside(chart, speed.rpm);
    if (!/\bperiodic\b/.test(speed.motion)) chart.dot(speed.rpm, speed.largest, 5.5, 'unsteady');
  }
  let free = -Infinity;  // right of the name before
  for (const peak of data.critical) {
    const {rpm: x, largest} = speeds[peak.index], at = chart.px(x), aside = Math.max(0, free - at);
    free = at + aside + 12;
    chart.text(x, largest, peak.wave.split(':')[0], {class: 'wave-name', transform: `rotate(-90 ${at} ${chart.py(largest)})`, dx: 9, dy: aside - 4});
  }
  for (const [rule, rpms] of Object.entries(data.predicted))
    for (const x of rpms) chart.triangle(x, rule === 'equation_2');
  chart.dot(selection.speed.rpm, selection.speed.largest, 6, 'chosen-dot');
}

function responseView(host, selection) {
  const {data} = selection;
  host.append(legend(['largest', 'largest on the tip line'], ['leading', 'leading edge'], ['trailing', 'trailing edge'],
    ...[3, 2, 1, 0].flatMap(grade => data.avoid.filter(band => band.grade === grade).slice(0, 1).map(band => [`avoid grade-${grade}`, band.concern])),
    ...(data.operating[1] > 0 ? [['operating', 'operating range']] : []), ['unsteady', 'not periodic'], ...(data.failed.length ? [['failed', 'failed']] : []), ...(data.speeds.some(speed => speed.outside) ? [['outside', 'outside validity']] : []), ['chosen', 'shown speed'],
    ...(data.predicted.aliased.length ? [['aliased', 'rule with aliasing']] : []),
    ...(data.predicted.equation_2.length ? [['equation-2', 'eq. 2']] : []), ...data.others.map(({name}, k) => [`other other-${k % 6}`, name])));
  const chart = new Chart(host, {
    name: 'Tip amplitude over speed', height: 380, x: speedRange(data),
    y: {label: 'amplitude [mm]', range: [0, 1.32 * (Math.max(data.axes.amplitude, ...data.others.flatMap((_, k) => [...data.array(`other/${k}/largest`)])) || 1)]},
    shared: selection, rows: () => [['speed [rpm]', 'largest [mm]', 'leading edge [mm]', 'trailing edge [mm]', 'motion'],
      ...data.speeds.map(speed => [speed.rpm, speed.largest, speed.leading, speed.trailing, speed.motion]),
      ...data.failed.map(rpm => [rpm, '', '', '', 'failed'])],
    paint: drawn => drawResponse(drawn, selection),
    pick: x => pickSpeed(chart, selection, x), step: by => selection.step(by), middle: () => selection.speed.rpm,
    read: x => {
      const speed = data.speeds[selection.nearest(x)];
      return `${speed.rpm.toFixed(0)} rpm: ${digits(speed.largest)} mm; leading edge ${digits(speed.leading)}, trailing edge ${digits(speed.trailing)} mm; ${speed.motion}${
        speed.outside ? `; outside validity: ${speed.outside}` : ''}`;
    },
  });
  selection.onChange(() => chart.draw());
  if (data.speeds.some(speed => speed.stress !== null)) stressView(host, selection);
}

// What the stress is held against: the class of a line, MPa, words.
function limitsOf({strength}) {
  if (!strength) return [];
  return [['goodman', strength.allowed, `Goodman's rule allows ${strength.allowed.toFixed(0)} MPa (mean ${strength.mean.toFixed(0)} MPa)`],
    ...(strength.yield === null ? [] : [['yield', strength.yield, `yield strength ${strength.yield.toFixed(0)} MPa, of vibration and spin together`]])];
}

// The stress of the vibration at every speed by the waves of the tip, and at the critical speeds as the cycle, or one
// instant, has it.
function stressView(host, selection) {
  const {data} = selection, {speeds} = data, recovered = data.critical.filter(peak => peak.vibration !== null);
  const limits = limitsOf(data);
  const high = Math.max(...speeds.map(speed => speed.stress), ...recovered.map(peak => peak.vibration), ...limits.map(([, stress]) => stress)) || 1;
  const kinds = [['recovered', 'recovered over a cycle', peak => peak.over_cycle], ['at-least', 'at least: recovered at one instant', peak => !peak.over_cycle]]
    .filter(([, , holds]) => recovered.some(holds));
  host.append(make('h3', {}, 'Stress of the vibration over speed'), legend(['stress', 'estimated from the waves of the tip'], ...kinds.map(([look, words]) => [look, words]),
    ...limits.map(([look, , words]) => [look, words]), ['chosen', 'shown speed']));
  const chart = new Chart(host, {
    name: 'Stress over speed', look: 'stress', height: 210, x: speedRange(data), y: {label: 'von Mises [MPa]', range: [0, 1.08 * high]}, shared: selection,
    paint: drawn => {
      for (const band of data.avoid) drawBand(drawn, band.low, band.high, `avoid grade-${band.grade}`);
      markSpeeds(drawn, selection);
      for (const [look, stress] of limits) drawn.line(drawn.range.x, [stress, stress], `limit ${look}`);
      drawn.line(speeds.map(speed => speed.rpm), speeds.map(speed => speed.stress), 'stress');
      for (const [look, , holds] of kinds)
        for (const peak of recovered.filter(holds)) drawn.dot(speeds[peak.index].rpm, peak.vibration, 4.5, look);
    },
    pick: x => pickSpeed(chart, selection, x), step: by => selection.step(by), middle: () => selection.speed.rpm,
    read: x => {
      const index = selection.nearest(x), peak = recovered.find(found => found.index === index);
      return `${speeds[index].rpm.toFixed(0)} rpm: ${digits(speeds[index].stress, 3)} MPa estimated${peak ? `, ${peak.over_cycle ? '' : 'at least '}${digits(peak.vibration, 3)} MPa recovered` : ''}`;
    },
    rows: () => [['speed [rpm]', 'estimated [MPa]', 'recovered [MPa]'],
      ...speeds.map((speed, index) => [speed.rpm, speed.stress, recovered.find(peak => peak.index === index)?.vibration ?? ''])],
  });
  selection.onChange(() => chart.draw());
}
