// SPDX-License-Identifier: GPL-3.0-or-later
// What C++ packed into the page (explore/packed_arrays.h): the directory's length, the directory, the numbers.
async function inflated(id) {
  const element = document.getElementById(id);
  const bytes = Uint8Array.from(atob(element.textContent.trim()), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

async function unpacked(id) {
  const buffer = await inflated(id), length = new DataView(buffer).getUint32(0, true), start = 4 + length;
  const about = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const types = {f32: Float32Array, i16: Int16Array, u32: Uint32Array};
  const found = new Map();
  about.array = name => {
    if (!found.has(name)) {
      const [type, offset, count, scale] = about.arrays[name];
      const numbers = new types[type](buffer, start + offset, count);
      found.set(name, type === 'i16' ? Float32Array.from(numbers, number => number * scale) : numbers);
    }
    return found.get(name);
  };
  return about;
}
