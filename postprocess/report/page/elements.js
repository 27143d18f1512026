// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of the page, made in a line.
function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes))
    if (value !== null && value !== undefined) element.setAttribute(name, value);
  return element;
}

function make(tag, attributes = {}, ...children) {
  const element = set(document.createElement(tag), attributes);
  element.append(...children);
  return element;
}

function makeSvg(tag, attributes = {}, text = '') {
  const element = set(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes);
  element.textContent = text;
  return element;
}

// A choice with its label; `entries` are pairs of value and words.
function choice(label, entries, chosen, onChange) {
  const select = make('select', {'aria-label': label},
    ...entries.map(([value, words]) => make('option', {value}, words)));
  select.value = chosen;
  select.addEventListener('change', () => onChange(select.value));
  return make('label', {class: 'choice'}, label + ' ', select);
}

// What a button says to the eye is a part of what it says to the ear.
function button(words, label, onClick) {
  const named = /\p{L}/u.test(words) ? `${words}: ${label}` : label;
  const element = make('button', {type: 'button', 'aria-label': named, title: label}, words);
  element.addEventListener('click', onClick);
  return element;
}

function download(parts, type, name) {
  const url = URL.createObjectURL(new Blob(parts, {type}));
  make('a', {href: url, download: name}).click();
  URL.revokeObjectURL(url);
}

function copied(text) {
  const area = make('textarea');
  area.value = text;
  document.body.append(area);
  area.select();
  const done = document.execCommand('copy');
  area.remove();
  return done;
}

// Rows of cells as the text of a CSV file.
function csvOf(rows) {
  const quoted = cell => /[",\n]/.test(cell) ? `"${String(cell).replaceAll('"', '""')}"` : cell;
  return rows.map(row => row.map(quoted).join(',')).join('\n') + '\n';
}

// So many digits as count.
function digits(value, count = 4) {
  if (!Number.isFinite(value)) return 'none';
  return value === 0 ? '0' : String(Number(value.toPrecision(count)));
}
