// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// One side of a dovetail root with a flank at 45 degrees, 6 mm thick, of which the half y >= 0 is meshed. The root is
// turned so that its flank lies on z = 0 with its middle at x = 0; the blade's pull is then along (1, 0, -1).
// gmsh -3 dovetail.geo -o dovetail.msh
size = 0.8;
Mesh.MshFileVersion = 4.1;
Mesh.MeshSizeMin = size; Mesh.MeshSizeMax = size;
Mesh.RecombinationAlgorithm = 2; // quadrilaterals alone
// Across and along the blade, as it stands: foot, flank, neck.
u[] = {0, 8, 8, 4, 4, 0};
v[] = {0, 0, 2, 6, 12, 12};
c = Cos(-3 * Pi / 4); s = Sin(-3 * Pi / 4);
For i In {0 : 5}
  Point(i + 1) = {c * (u[i] - 6) - s * (v[i] - 4), 0, s * (u[i] - 6) + c * (v[i] - 4)};
EndFor
For i In {1 : 6}
  Line(i) = {i, i % 6 + 1};
EndFor
Curve Loop(1) = {1 : 6}; Plane Surface(1) = {1};
Recombine Surface{1};
made[] = Extrude {0, 3, 0} { Surface{1}; Layers{3}; Recombine; };
Physical Surface("middle") = {1};
Physical Surface("flank") = {made[4]};
Physical Surface("neck") = {made[6]};
Physical Volume("root") = {made[1]};
