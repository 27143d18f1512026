// SPDX-License-Identifier: GPL-3.0-or-later
// A picture fills the window when it is clicked, and goes back by another click or Escape.
for (const image of document.querySelectorAll('figure img')) {
  const figure = image.parentElement;
  figure.querySelector('figcaption').append(' ', make('a', {href: image.src, download: `${figure.previousElementSibling?.id || 'picture'}.svg`}, 'Save picture'));
  const enlarge = make('button', {type: 'button', class: 'enlarge', title: 'Enlarge', 'aria-expanded': 'false'});
  image.replaceWith(enlarge);
  enlarge.append(image);
  enlarge.addEventListener('click', () =>
    enlarge.setAttribute('aria-expanded', String(figure.classList.toggle('large'))));
}
document.addEventListener('keydown', event => {
  if (event.key !== 'Escape') return;
  for (const figure of document.querySelectorAll('figure.large')) figure.querySelector('.enlarge').click();
});
