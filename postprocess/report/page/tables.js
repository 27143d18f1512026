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
