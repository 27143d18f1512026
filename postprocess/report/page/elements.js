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

function button(words, label, onClick) {
  const element = make('button', {type: 'button', 'aria-label': label, title: label}, words);
  element.addEventListener('click', onClick);
  return element;
}

// So many digits as count.
function digits(value, count = 4) {
  if (!Number.isFinite(value)) return 'none';
  return value === 0 ? '0' : String(Number(value.toPrecision(count)));
}
