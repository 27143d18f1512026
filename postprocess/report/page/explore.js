// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the linked views into their places, once the data is unpacked. Until then, and without scripts, the pictures stand there.
function panel(host, title, fill) {
  const section = make('section', {class: 'panel'}, make('h3', {}, title));
  host.append(section);
  fill(section);
}

async function explore() {
  const data = await unpacked('speed-data'), selection = new Selection(data);
  document.documentElement.classList.add('live');
  responseView(document.getElementById('live-response'), selection);
  const host = document.getElementById('live-views');
  host.append(...selectionBar(selection));
  linkRows(selection);
  mapsView(host, selection);
  const grid = make('div', {class: 'grid'});
  timeView(host, selection);
  host.append(grid);
  panel(grid, `Motion of all sectors, ${data.component}`, section => sectorsView(section, selection, 'motion', 'mm'));
  panel(grid, 'Contact force on all sectors', section => sectorsView(section, selection, 'force', 'N'));
  panel(grid, 'Two-way spectrum', section => spectrumView(section, selection));
  panel(grid, 'Where sector 0 rubs the casing', section => contactView(section, selection));
  panel(grid, 'Path of the tip, sector 0 and faint the others', section => orbitView(section, selection));
  panel(grid, 'Campbell diagram', section => campbellView(section, selection));
  selection.tell();
  selection.tellWindow();
  const wheel = document.getElementById('live-wheel');
  if (wheel) wheelView(wheel, selection);
  return selection;
}
explore();
