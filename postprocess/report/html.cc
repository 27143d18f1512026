// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/html.h"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace tiprub::html {

namespace {

std::string shown(const Cell& cell) {
  constexpr int digits = 4;
  constexpr double large = 1e3, huge = 1e9;  // whole numbers read better between them
  if (const auto* value = std::get_if<double>(&cell)) {
    if (!std::isfinite(*value)) return "";
    if (std::abs(*value) >= large && std::abs(*value) < huge) return fixed(*value, 0);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, *value);
    return buffer;
  }
  if (const auto* whole = std::get_if<int>(&cell)) return std::to_string(*whole);
  return escaped(std::get<std::string>(cell));
}

bool looks_numeric(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-/ e") == std::string::npos;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::string table(const Table& table) {
  std::string text = "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& name : table.header) text += "<th>" + escaped(name) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const Cell& cell : row) {
      const std::string value = shown(cell);
      text += (looks_numeric(value) ? "<td class=\"n\">" : "<td>") + value + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

const char* style() {
  return R"(
:root{color-scheme:light}
body{font:16px/1.55 system-ui,"DejaVu Sans",Verdana,sans-serif;color:#1c2733;background:#fff;margin:0}
main{max-width:72rem;margin:0 auto;padding:2rem 1.25rem 4rem}
h1{font-size:1.7rem;line-height:1.25;margin:.2rem 0 .3rem}
h2{font-size:1.25rem;margin:2.6rem 0 .6rem;border-bottom:1px solid #d5dce3;padding-bottom:.25rem}
p{max-width:50rem}
.lead{font-size:1.08rem;background:#eef3f8;border-left:4px solid #0072b2;padding:.8rem 1rem;max-width:none}
.lead p{margin:.35rem 0;max-width:none}
.sub{color:#5a6875;margin:0 0 1.2rem}
.scroll{overflow-x:auto}
button{font:inherit;font-size:.78rem;color:#0b5fa5;background:#fff;border:1px solid #c5d3df;border-radius:3px;cursor:pointer;margin:.2rem 0}
table{border-collapse:collapse;font-size:.86rem;font-variant-numeric:tabular-nums;margin:.4rem 0}
th{text-align:left;font-weight:600;border-bottom:2px solid #9fb0bf;padding:.3rem .45rem;vertical-align:bottom}
td{border-bottom:1px solid #e3e8ed;padding:.25rem .45rem;white-space:nowrap}
td.n{text-align:right}
tbody tr:hover{background:#f6f9fb}
figure{margin:1.2rem 0 2rem}
figure img{max-width:100%;height:auto;display:block;cursor:zoom-in;border:1px solid #e3e8ed;background:#fff}
figure.large{position:fixed;inset:0;margin:0;z-index:9;background:#fff;overflow:auto;padding:1rem}
figure.large img{width:100%;cursor:zoom-out}
figcaption{font-size:.9rem;color:#3b4856;max-width:58rem;margin-top:.5rem}
a{color:#0b5fa5}
pre{background:#f5f7f9;border:1px solid #e3e8ed;padding:.8rem 1rem;overflow-x:auto;font-size:.82rem;line-height:1.4}
details{margin:.5rem 0}
summary{cursor:pointer;color:#0b5fa5}
nav{font-size:.9rem;color:#5a6875}
@media print{button{display:none}figure{break-inside:avoid}details{display:none}}
)";
}

const char* script() {
  return R"(
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
)";
}

}  // namespace tiprub::html
