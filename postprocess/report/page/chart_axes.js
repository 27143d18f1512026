// SPDX-License-Identifier: GPL-3.0-or-later
// Round numbers along the axes of a chart, and their lines.
function roundStep(span, most) {
  const rough = span / most, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find(factor => factor * power >= rough);
}

function ticksOf([low, high], most) {
  const step = roundStep(high - low || 1, most), decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push([k * step, (k * step).toFixed(decimals)]);
  return ticks;
}

function drawAxes(chart) {
  const {axes, left, top, width, height, range, options} = chart, bottom = top + height;
  const inside = ([place], [low, high]) => place >= low && place <= high;
  for (const [place, words] of options.x.ticks ?? ticksOf(range.x, Math.max(2, width / 90))) {
    if (!inside([place], range.x)) continue;
    const x = chart.px(place);
    axes.append(makeSvg('line', {x1: x, x2: x, y1: top, y2: bottom}), makeSvg('text', {x, y: bottom + 15, 'text-anchor': 'middle'}, words));
  }
  for (const [place, words] of options.y.ticks ?? ticksOf(range.y, Math.max(2, height / 45))) {
    if (!inside([place], range.y)) continue;
    const y = chart.py(place);
    axes.append(makeSvg('line', {x1: left, x2: left + width, y1: y, y2: y}), makeSvg('text', {x: left - 6, y: y + 4, 'text-anchor': 'end'}, words));
  }
  axes.append(makeSvg('text', {x: left + width / 2, y: bottom + 34, 'text-anchor': 'middle', class: 'axis-name'}, options.x.label),
    makeSvg('text', {x: 13, y: top + height / 2, 'text-anchor': 'middle', class: 'axis-name',
      transform: `rotate(-90 13 ${top + height / 2})`}, options.y.label));
}
