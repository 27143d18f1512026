// SPDX-License-Identifier: GPL-3.0-or-later
// One sector of a bladed disc in gmsh's CAD kernel. Millimetres; z is the axis of rotation. A STEP file of a sector takes the
// place of all that stands above "Groups": Merge "sector.step";
SetFactory("OpenCASCADE");

blades = 12;
bore = 30; rim = 80; tip = 125;  // radii
chord = 28; thickness = 2.4;     // of a profile; edges are blunt
pitch = 2 * Pi / blades;

// The disc: a section in the plane y = 0, turned about z by one pitch.
r[] = {bore, bore, 40, 68, 74, rim, rim, 74, 68, 40};
z[] = {-15, 15, 5, 5, 15, 15, -15, -15, -5, -5};
For k In {0 : 9}
  Point(1 + k) = {r[k], 0, z[k]};
EndFor
For k In {0 : 9}
  Line(1 + k) = {1 + k, 1 + (k + 1) % 10};
EndFor
Curve Loop(1) = {1 : 10};
Plane Surface(1) = {1};
disc[] = Extrude {{0, 0, 1}, {0, 0, 0}, pitch} { Surface{1}; };

// The blade in the middle: profiles at three heights, two sides closed by straight edges.
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
ThruSections(11) = wires[];
Rotate {{0, 0, 1}, {0, 0, 0}, pitch / 2} { Volume{11}; }
Cylinder(12) = {0, 0, -50, 0, 0, 100, tip};
BooleanIntersection(13) = { Volume{11}; Delete; }{ Volume{12}; Delete; };
BooleanDifference(14) = { Volume{13}; Delete; }{ Volume{disc[1]}; };
parts[] = BooleanFragments{ Volume{disc[1]}; Delete; }{ Volume{14}; Delete; };
Recursive Delete { Curve{:}; }  // what the sections leave

// Groups, by where the faces are. The cuts must pair: one is meshed as the other, turned.
e = 0.01;
low[] = Surface In BoundingBox {bore - e, -e, -15 - e, rim + e, e, 15 + e};
c = Cos(pitch); s = Sin(pitch);
high[] = Surface In BoundingBox {bore * c - e, bore * s - e, -15 - e, rim * c + e, rim * s + e, 15 + e};
held[] = Surface In BoundingBox {bore * c - e, -e, -15 - e, bore + e, bore * s + e, 15 + e};
faces[] = Boundary { Volume{parts[1]}; };
For k In {0 : #faces[] - 1}
  box[] = BoundingBox Surface{faces[k]};
  If (box[0] > 0.5 * (rim + tip))
    top[] += faces[k];
  EndIf
EndFor
Periodic Surface{high[]} = {low[]} Rotate {{0, 0, 1}, {0, 0, 0}, pitch};
Physical Volume("disc") = {parts[0]};
Physical Volume("main_blade") = {parts[1]};
Physical Surface("cyclic_low") = {low[]};
Physical Surface("cyclic_high") = {high[]};
Physical Surface("clamped") = {held[]};
Physical Surface("blade_tip") = {top[]};

Mesh.MeshSizeMax = 8;
MeshSize{ PointsOf{ Volume{parts[1]}; } } = 4;
Mesh.ElementOrder = 2;
