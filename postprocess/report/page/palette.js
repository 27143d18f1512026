// SPDX-License-Identifier: GPL-3.0-or-later
// Perceptually ordered, and told apart by colour-blind eyes: viridis for amplitudes over a map; blues (displacement) and magma
// (stress) for surfaces, from light (small) to dark.
const PALETTES = {
  viridis: ['440154', '482878', '3e4989', '31688e', '26828e', '1f9e89', '35b779', '6ece58', 'b5de2b', 'fde725'],
  blues: ['e6eaee', 'c7e9b4', '7fcdbb', '41b6c4', '1d91c0', '225ea8', '253494', '081d58'],
  magma: ['fcfdd0', 'feca8d', 'fd9668', 'f1605d', 'cd4071', '9e2f7f', '721f81', '440f76', '180f3d'],
};

// Red, green, blue (0 .. 255) at 256 even places of a palette.
function colourTable(name) {
  const stops = PALETTES[name].map(text => [0, 2, 4].map(at => parseInt(text.slice(at, at + 2), 16)));
  return Array.from({length: 256}, (_, i) => {
    const place = i / 255 * (stops.length - 1), below = Math.min(Math.floor(place), stops.length - 2);
    return stops[below].map((value, k) => Math.round(value + (place - below) * (stops[below + 1][k] - value)));
  });
}

function gradientOf(name) {
  return `linear-gradient(to right, ${PALETTES[name].map(stop => '#' + stop).join(', ')})`;
}

// A scale for people: the colours from left to right, numbers at its ends and between.
function colourBar(name, labels, what) {
  const bar = make('div', {class: 'colour-bar', role: 'img', 'aria-label': `Colours: ${labels.join(', ')} ${what}`});
  bar.append(make('span', {class: 'ramp', style: `background:${gradientOf(name)}`}));
  bar.append(make('span', {class: 'numbers'}, ...labels.map(label => make('span', {}, label))));
  bar.append(make('span', {class: 'unit'}, what));
  return bar;
}
