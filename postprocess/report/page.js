// SPDX-License-Identifier: GPL-3.0-or-later
for (const image of document.querySelectorAll('figure img'))
  image.addEventListener('click', () => image.parentElement.classList.toggle('large'));
for (const table of document.querySelectorAll('table')) {
  const button = document.createElement('button');
  button.textContent = 'Copy table';
  button.addEventListener('click', async () => {
    const rows = [...table.rows].map(row => [...row.cells].map(cell => cell.textContent).join('\t')).join('\n');
    const area = document.createElement('textarea');
    area.value = rows;
    document.body.append(area);
    area.select();
    button.textContent = document.execCommand('copy') ? 'Copied' : 'Select the table and copy it by hand';
    area.remove();
  });
  table.parentElement.before(button);
}
document.addEventListener('keydown', event => {
  if (event.key === 'Escape')
    for (const figure of document.querySelectorAll('figure.large')) figure.classList.remove('large');
});
