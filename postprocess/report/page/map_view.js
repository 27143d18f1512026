// SPDX-License-Identifier: GPL-3.0-or-later
// Amplitude over speed and frequency of one edge, in total or of one nodal diameter: the interaction map.
const VIRIDIS = colourTable('viridis');
const MOST_ORDERS = 60;
const WIDEST_HALF_LINE = 0.1;  // of an engine order, as the pictures have it

// What a map is drawn from: speeds with their lines, and a line's amplitude [mm] of a nodal diameter `part`, both directions
// added, or of all ('total'). This report's own, or another one's.
function ownMap(data, edge) {
  return {speeds: data.speeds, failed: data.failed, amplitude: (index, line, part) => {
    const {lines} = data.speeds[index], spectrum = data.array(`${index}/${edge}/spectrum`), count = data.sectors;
    const at = n => spectrum[line + lines * n];
    if (part === 'total') {
      let sum = 0;
      for (let n = 0; n < count; ++n) sum += at(n);
      return sum;
    }
    const n = Number(part), mirror = (count - n) % count;
    return mirror === n ? at(n) : at(n) + at(mirror);
  }};
}

function otherMap(data, k, edge) {
  const speeds = data.others[k][edge];
  return {speeds, failed: [], amplitude: (index, line, part) => {
    const name = `other/${k}/${edge}/${part}`;
    return name in data.arrays ? data.array(name)[speeds[index].first + line] : 0;
  }};
}

// The line of a speed's spectrum at an engine order, or -1 between lines.
function lineAt(speed, order) {
  const line = Math.round(order * speed.revolutions), half = Math.min(0.5 / speed.revolutions, WIDEST_HALF_LINE);
  return line > 0 && line < speed.lines && Math.abs(order - line / speed.revolutions) <= half ? line : -1;
}

// Pixels of the map over the chart's ranges; grey where a failed speed is nearest.
function mapImage(chart, {axes}, map, part) {
  const width = Math.round(chart.width), height = Math.round(chart.height);
  const canvas = make('canvas', {width, height}), context = canvas.getContext('2d');
  const image = context.createImageData(width, height), pixels = new Uint32Array(image.data.buffer);
  const colours = VIRIDIS.map(([r, g, b]) => (255 << 24 | b << 16 | g << 8 | r) >>> 0), missing = 0xffd9d9d9;
  const top = Math.log10(axes.map), {decades} = axes, known = new Map();
  const colourOf = (index, line) => {
    const key = index * 65536 + line;
    if (!known.has(key)) {
      const level = (Math.log10(map.amplitude(index, line, part)) - top) / decades + 1;
      known.set(key, colours[Math.round(255 * Math.min(1, Math.max(0, level)))]);
    }
    return known.get(key);
  };
  for (let x = 0; x < width; ++x) {
    const rpm = chart.range.x[0] + (x + 0.5) / width * (chart.range.x[1] - chart.range.x[0]);
    const index = nearestIn(map.speeds, rpm), off = Math.abs(map.speeds[index].rpm - rpm);
    const none = map.failed.some(failed => Math.abs(failed - rpm) < off);
    for (let y = 0; y < height; ++y) {
      const frequency = chart.range.y[1] - (y + 0.5) / height * (chart.range.y[1] - chart.range.y[0]);
      const line = lineAt(map.speeds[index], frequency * 60 / rpm);
      pixels[y * width + x] = none ? missing : line < 0 ? colours[0] : colourOf(index, line);
    }
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

// Names of the engine orders where their lines leave the chart: beside it, or inside below its top; none runs into another.
function nameOrders(chart, count, look) {
  const {left, top, width, height} = chart, [low, high] = chart.range.y, right = chart.range.x[1], tall = 12, wide = 36;
  let below = Infinity, before = Infinity;
  for (let k = 1; k <= count; ++k) {
    const atRight = chart.py(k * right / 60), atTop = chart.px(60 * high / k), words = `EO ${k}`;
    if (k * right / 60 < low) continue;
    if (atRight >= top) {
      if (below - atRight < tall) continue;
      below = atRight;
      chart.svg.append(makeSvg('text', {x: left + width + 4, y: Math.min(atRight, top + height) + 4, class: 'order-name'}, words));
    } else if (atTop > left + wide && atTop < left + width && before - atTop > wide) {
      before = atTop;
      chart.content.append(makeSvg('text', {x: atTop - 3, y: top + 11, 'text-anchor': 'end', class: `order-name ${look}`}, words));
    }
  }
}

// Names of the families where their curves begin; curves that are closer than a name is high share one.
function nameFamilies(chart, curves, first) {
  const names = [], places = curves.map(curve => [chart.py(curve.hertz[first]), curve.family]).sort(([a], [b]) => b - a);
  for (const [y, family] of places) {
    if (!names.length || names.at(-1).y - y > 13) names.push({y, families: []});
    names.at(-1).families.push(family);
  }
  for (const {y, families} of names) {
    const least = Math.min(...families), most = Math.max(...families);
    chart.content.append(makeSvg('text', {x: chart.left + 5, y: y - 3, class: 'family-name'},
      least === most ? `family ${least}` : `families ${least}-${most}`));
  }
}

function drawMap(chart, selection, map, part) {
  const {data} = selection, rpm = data.speeds.map(speed => speed.rpm);
  chart.content.append(makeSvg('image', {href: mapImage(chart, data, map, part), x: chart.left, y: chart.top,
    width: chart.width, height: chart.height, preserveAspectRatio: 'none'}));
  for (let k = 1; k <= data.axes.engine_orders; ++k) {
    chart.line(chart.range.x, chart.range.x.map(x => k * x / 60), 'map-order');
  }
  nameOrders(chart, data.axes.engine_orders, 'map-order-name');
  data.modes.forEach((mode, k) => {
    if (part === 'total' || Number(part) === mode.nodal_diameter) chart.line(rpm, data.array(`mode/${k}`), 'map-mode');
  });
  for (const speed of data.speeds) if (speed.outside) markOutside(chart, speed.rpm);
  markSpeeds(chart, selection);
}

function readMap(map, part, rpm, frequency) {
  const index = nearestIn(map.speeds, rpm), speed = map.speeds[index];
  const line = Math.min(speed.lines - 1, Math.max(1, Math.round(frequency * 60 / speed.rpm * speed.revolutions)));
  const order = line / speed.revolutions;
  return `${speed.rpm.toFixed(0)} rpm, ${(order * speed.rpm / 60).toFixed(0)} Hz (EO ${digits(order)}): ${
    digits(map.amplitude(index, line, part))} mm`;
}

// The numbers of what a map shows.
function mapRows(map, part, {x, y}) {
  const rows = [['speed [rpm]', 'frequency [Hz]', 'engine order', part === 'total' ? 'total [mm]' : `nodal diameter ${part} [mm]`]];
  map.speeds.forEach((speed, index) => {
    if (speed.rpm < x[0] || speed.rpm > x[1]) return;
    for (let line = 1; line < speed.lines; ++line) {
      const order = line / speed.revolutions, frequency = order * speed.rpm / 60;
      if (frequency >= y[0] && frequency <= y[1]) rows.push([speed.rpm, frequency, order, map.amplitude(index, line, part)]);
    }
  });
  return rows;
}

function mapView(host, selection, edge) {
  const {data} = selection, maps = {here: ownMap(data, edge), ...data.others.map((_, k) => otherMap(data, k, edge))};
  const shown = {whose: 'here'};
  const chart = new Chart(host, {
    name: `Interaction map, ${edge} edge`, height: 380, right: 42, x: speedRange(data),
    y: {label: 'frequency [Hz]', range: [0, data.axes.frequency]},
    paint: drawn => drawMap(drawn, selection, maps[shown.whose], selection.part), shared: selection,
    rows: () => mapRows(maps[shown.whose], selection.part, chart.range), step: by => selection.step(by),
    pick: x => pickSpeed(chart, selection, x), middle: () => selection.speed.rpm,
    read: (x, y) => readMap(maps[shown.whose], selection.part, x, y),
  });
  selection.onChange(() => chart.draw());
  return {show(what) { Object.assign(shown, what); chart.draw(); }};
}

// Natural frequencies over speed by nodal diameter, engine orders, and the critical speeds at the frequencies of their waves.
function campbellView(host, selection) {
  const {data} = selection, rpm = data.speeds.map(speed => speed.rpm), marched = marchedDiameters(data);
  const colourOf = n => `var(--series-${n % 8})`, curves = data.modes.map((mode, k) => ({...mode, hertz: data.array(`mode/${k}`)}));
  const shown = curves.filter(curve => marched.includes(curve.nodal_diameter)), high = Math.max(...shown.flatMap(curve => [...curve.hertz]), 1);
  host.append(legend(...marched.map(n => [`series-${n % 8}`, `ND ${n}`]), ['map-order', 'engine orders'], ['met', 'critical speeds'], ['chosen', 'shown speed']));
  const chart = new Chart(host, {
    name: 'Campbell diagram', height: 380, right: 42, x: speedRange(data), y: {label: 'frequency [Hz]', range: [0, 1.05 * high]}, shared: selection,
    pick: x => pickSpeed(chart, selection, x), step: by => selection.step(by), middle: () => selection.speed.rpm,
    paint: drawn => {
      for (let k = 1; k <= MOST_ORDERS && k * rpm[0] / 60 < 1.05 * high; ++k) drawn.line(drawn.range.x, drawn.range.x.map(x => k * x / 60), 'order');
      for (const curve of shown) drawn.line(rpm, curve.hertz, 'mode', colourOf(curve.nodal_diameter));
      nameOrders(drawn, MOST_ORDERS, '');
      nameFamilies(drawn, shown, selection.nearest(drawn.range.x[0]));
      drawn.upright(selection.speed.rpm, 'chosen-mark');
      for (const peak of data.critical) {
        const x = data.speeds[peak.index].rpm;
        drawn.dot(x, Math.min(1.05 * high, peak.order * x / 60), 5, 'met');
      }
    },
    read: (x, y) => {
      const i = selection.nearest(x), near = [...shown].sort((a, b) => Math.abs(a.hertz[i] - y) - Math.abs(b.hertz[i] - y))[0];
      return `${rpm[i].toFixed(0)} rpm, ${y.toFixed(0)} Hz, EO ${digits(y * 60 / rpm[i], 3)}${
        near ? `; next mode: ND ${near.nodal_diameter}, family ${near.family}, ${near.hertz[i].toFixed(0)} Hz` : ''}`;
    },
    rows: () => [['speed [rpm]', ...shown.map(curve => `ND ${curve.nodal_diameter} family ${curve.family} [Hz]`)],
      ...rpm.map((speed, i) => [speed, ...shown.map(curve => curve.hertz[i])])],
  });
  selection.onChange(() => chart.draw());
}

// Nodal diameters of the modes that the march could move.
function marchedDiameters({modes, sectors, held}) {
  return [...new Set(modes.map(mode => mode.nodal_diameter))].filter(n => n % (sectors / held) === 0);
}

// Nodal diameters that move at all: an empty map tells nothing.
function movingParts(data) {
  const moving = new Set();
  data.speeds.forEach((speed, index) => {
    for (const edge of ['leading', 'trailing']) {
      const spectrum = data.array(`${index}/${edge}/spectrum`);
      for (let n = 0; n < data.sectors; ++n)
        for (let line = 1; line < speed.lines; ++line)
          if (spectrum[line + speed.lines * n] > data.axes.map * 10 ** -data.axes.decades)
            moving.add(Math.min(n, data.sectors - n));
    }
  });
  return [...moving].sort((a, b) => a - b);
}

function mapsView(host, selection) {
  const {data} = selection, {map, decades} = data.axes;
  const pair = make('div', {class: 'pair'}), maps = ['leading', 'trailing'].map(edge => {
    const side = make('div', {}, make('h3', {}, `Interaction map, ${edge} edge`));
    pair.append(side);
    return mapView(side, selection, edge);
  });
  const labels = Array.from({length: 3}, (_, i) => digits(map * 10 ** (decades * (i / 2 - 1)), 2));
  const parts = choice('Nodal diameters', [['total', 'all, their sum'], ...movingParts(data).map(n => [String(n), `${n} alone`])],
    selection.part, part => selection.choosePart(part));
  selection.onChange(() => { parts.lastChild.value = selection.part; });
  host.append(make('div', {class: 'tools'}, parts,
    ...(data.others.length ? [choice('Maps of', [['here', 'this report'], ...data.others.map(({name}, k) => [String(k), name])], 'here',
      whose => maps.forEach(view => view.show({whose})))] : []),
    colourBar('viridis', labels, 'mm, logarithmic')),
    legend(['map-order', 'engine orders'], ['map-mode', 'natural frequencies'], ['critical on-map', 'critical speeds'], ['chosen on-map', 'shown speed'],
    ...(data.speeds.some(speed => speed.outside) ? [['outside', 'outside validity']] : [])), pair);
}
