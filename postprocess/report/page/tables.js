// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons above every table copy it, its columns parted by tabs, and save it as CSV.
function asCsv(table) {
  const quoted = text => /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  return [...table.rows].map(row => [...row.cells].map(cell => quoted(cell.textContent)).join(',')).join('\n') + '\n';
}

for (const table of document.querySelectorAll('table')) {
  const copy = button('Copy table', 'Copy this table', () => {
    const rows = [...table.rows].map(row => [...row.cells].map(cell => cell.textContent).join('\t')).join('\n');
    const area = make('textarea');
    area.value = rows;
    document.body.append(area);
    area.select();
    copy.textContent = document.execCommand('copy') ? 'Copied' : 'Select the table and copy it by hand';
    area.remove();
  });
  copy.className = 'copy';
  const save = button('Save CSV', 'Save this table', () => {
    const url = URL.createObjectURL(new Blob([asCsv(table)], {type: 'text/csv'}));
    make('a', {href: url, download: 'table.csv'}).click();
    URL.revokeObjectURL(url);
  });
  save.className = 'copy';
  table.parentElement.before(copy, ' ', save);
}
