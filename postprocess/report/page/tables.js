// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons above every table copy it, its columns parted by tabs, and save it as CSV.
const cellsOf = table => [...table.rows].map(row => [...row.cells].map(cell => cell.textContent));

for (const table of document.querySelectorAll('table')) {
  const copy = button('Copy table', 'its columns parted by tabs', () => {
    copy.textContent = copied(cellsOf(table).map(row => row.join('\t')).join('\n')) ? 'Copied' : 'Select the table and copy it by hand';
    copy.setAttribute('aria-label', copy.textContent);
  });
  copy.className = 'copy';
  const heading = table.closest('section')?.querySelector('h2')?.id ?? 'table';
  const save = button('Save CSV', `${heading}.csv`, () => download([csvOf(cellsOf(table))], 'text/csv', `${heading}.csv`));
  save.className = 'copy';
  table.parentElement.before(copy, ' ', save);
}

// Under the pointer, by a click or with the keyboard a column's head tells what it means.
function columnHelp() {
  const note = make('div', {role: 'tooltip', id: 'column-help', hidden: ''});
  document.body.append(note);
  const hide = () => { note.hidden = true; };
  const show = head => {
    note.textContent = head.dataset.help;
    note.hidden = false;
    const box = head.getBoundingClientRect();
    note.style.left = `${Math.max(8, Math.min(box.left, innerWidth - note.offsetWidth - 8))}px`;
    note.style.top = `${box.bottom + note.offsetHeight < innerHeight ? box.bottom : Math.max(0, box.top - note.offsetHeight)}px`;
  };
  for (const head of document.querySelectorAll('th[title]')) {
    head.dataset.help = head.title;
    head.removeAttribute('title');
    const ask = make('button', {type: 'button', class: 'help', 'aria-describedby': note.id}, head.textContent);
    head.replaceChildren(ask);
    ask.addEventListener('focus', () => show(head));
    ask.addEventListener('click', () => show(head));
    ask.addEventListener('blur', hide);
    head.addEventListener('pointerenter', () => show(head));
    head.addEventListener('pointerleave', () => { if (document.activeElement !== ask) hide(); });
  }
  document.addEventListener('keydown', event => { if (event.key === 'Escape') hide(); });
  document.addEventListener('scroll', hide, {capture: true, passive: true});
}
columnHelp();
