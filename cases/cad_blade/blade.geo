// SPDX-License-Identifier: GPL-3.0-or-later
// A compressor blade with its foot, as a CAD system would draw it: `gmsh blade.geo -parse_and_exit` writes blade.step.
// Millimetres; z is the axis of rotation, the blade stands along x, and the casing is a cylinder about z.
SetFactory("OpenCASCADE");

rim = 80; tip = 125;        // radii
chord = 28; thickness = 2.4; // of a profile; edges are blunt
foot_width = 26; foot_length = 30; foot_height = 10;

// Profiles at three heights: two sides, closed by straight edges. Chord along z, turned about x by the stagger.
heights[] = {rim - 2, 0.5 * (rim + tip), tip + 3};
staggers[] = {20, 35, 50};
For k In {0 : 2}
  h = heights[k];
  t = thickness * (1 - 0.2 * k);
  c = chord / 2;
  p = newp;
  Point(p) = {h, -0.25 * t, -c};
  Point(p + 1) = {h, -0.5 * t, 0};
  Point(p + 2) = {h, -0.25 * t, c};
  Point(p + 3) = {h, 0.25 * t, c};
  Point(p + 4) = {h, 0.5 * t, 0};
  Point(p + 5) = {h, 0.25 * t, -c};
  l = newl;
  Spline(l) = {p, p + 1, p + 2};
  Line(l + 1) = {p + 2, p + 3};
  Spline(l + 2) = {p + 3, p + 4, p + 5};
  Line(l + 3) = {p + 5, p};
  Rotate {{1, 0, 0}, {h, 0, 0}, staggers[k] * Pi / 180} { Curve{l, l + 1, l + 2, l + 3}; }
  w = newll;
  Wire(w) = {l, l + 1, l + 2, l + 3};
  wires[] += w;
EndFor
ThruSections(1) = wires[];
Cylinder(2) = {0, 0, -50, 0, 0, 100, tip};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Box(4) = {rim - foot_height, -foot_width / 2, -foot_length / 2, foot_height, foot_width, foot_length};
BooleanUnion(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Recursive Delete { Curve{:}; }  // what the sections leave
Save "blade.step";
