// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel's surface, moved: sector j by R_j Re(sum over the waves of u e^{i (k phi + n j alpha)}), phi the rotor's angle
// or, of a mode, the phase of its period.
class WheelMotion {
  constructor(data) {
    this.data = data;
    this.nodes = data.array('nodes');
    this.count = this.nodes.length / 3;
    this.triangles = data.array('triangles');
  }

  // `place` names the packed waves ('motion/0/0', ...), `waves` their engine orders and nodal diameters.
  choose(place, waves) {
    this.waves = waves.map((wave, i) => ({order: wave.order, diameter: wave.nodal_diameter,
      re: this.data.array(`${place(i)}/re`), im: this.data.array(`${place(i)}/im`)}));
    this.moved = new Float32Array(3 * this.count);
  }

  // [m] of sector j's nodes, in the x, y, z of sector 0.
  displacementOf(j, angle) {
    const {moved, data} = this;
    moved.fill(0);
    for (const {order, diameter, re, im} of this.waves) {
      const phase = order * angle + diameter * j * 2 * Math.PI / data.sectors, c = Math.cos(phase), s = Math.sin(phase);
      for (let i = 0; i < moved.length; ++i) moved[i] += c * re[i] - s * im[i];
    }
    return moved;
  }

  // [m] how far some nodes move at most, of the instants of a revolution, in any sector.
  largestOf(nodes) {
    const instants = 36, largest = nodes.map(() => 0);
    for (let j = 0; j < this.data.sectors; ++j)
      for (let k = 0; k < instants; ++k) {
        const u = this.displacementOf(j, 2 * Math.PI * k / instants);
        nodes.forEach((node, i) => { largest[i] = Math.max(largest[i], Math.hypot(u[3 * node], u[3 * node + 1], u[3 * node + 2])); });
      }
    return largest;
  }

  // Positions of the whole wheel, `size` times the displacement added; `paint(vertex, length)` hears each node's displacement [m].
  positions(angle, size, into, paint) {
    const {nodes, count, data} = this;
    for (let j = 0; j < data.sectors; ++j) {
      const u = this.displacementOf(j, angle), turn = j * 2 * Math.PI / data.sectors, c = Math.cos(turn), s = Math.sin(turn);
      for (let i = 0, at = 3 * j * count; i < 3 * count; i += 3, at += 3) {
        const x = nodes[i] + size * u[i], y = nodes[i + 1] + size * u[i + 1];
        into[at] = c * x - s * y;
        into[at + 1] = s * x + c * y;
        into[at + 2] = nodes[i + 2] + size * u[i + 2];
        paint?.(at / 3, Math.hypot(u[i], u[i + 1], u[i + 2]));
      }
    }
  }
}
