// SPDX-License-Identifier: GPL-3.0-or-later
// A button above every table copies it, its columns parted by tabs.
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
  table.parentElement.before(copy);
}
