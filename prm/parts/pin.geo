// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Half of a pin, x >= 0, radius 9.95 mm, which rests on the lower side of the eye of lug.geo and is held by a bolt of radius
// 4 mm in its middle.
// gmsh -2 pin.geo -o pin.msh
Mesh.MshFileVersion = 2.2;
r[] = {4, 9.95};
cells[] = {25, 25, 13, 10};
Point(1) = {0, 0, 8 + r[1]};
For i In {0 : 4}
  angle = i * Pi / 4;
  For j In {0 : 1}
    Point(10 + 10 * j + i) = {i < 4 ? r[j] * Sin(angle) : 0, 0, 8 + r[1] - r[j] * Cos(angle)};
  EndFor
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0 : 3}
  Circle(10 + i) = {10 + i, 1, 11 + i}; Circle(20 + i) = {20 + i, 1, 21 + i};
  Curve Loop(i + 1) = {30 + i, 20 + i, -(31 + i), -(10 + i)}; Plane Surface(i + 1) = {i + 1};
  Transfinite Curve{10 + i, 20 + i} = cells[i] + 1;
EndFor
Transfinite Curve{30 : 34} = 11 Using Progression 0.83;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("bolt") = {10 : 13};
Physical Curve("side") = {20 : 23};
Physical Curve("x0") = {30, 34};
Physical Surface("pin") = {1 : 4};
