// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Section of a shaft, radius 10 mm, whose axis is 15 mm above z = 0. A core of radius 3 mm holds and turns it.
// gmsh -2 shaft.geo -o shaft.msh
Mesh.MshFileVersion = 2.2;
r[] = {3, 10};
Point(1) = {0, 0, 15};
For i In {0 : 7}
  For j In {0 : 1}
    Point(10 + 10 * j + i) = {r[j] * Cos(i * Pi / 4), 0, 15 + r[j] * Sin(i * Pi / 4)};
  EndFor
EndFor
For i In {0 : 7}
  k = (i + 1) % 8;
  Circle(10 + i) = {10 + i, 1, 10 + k}; Circle(20 + i) = {20 + i, 1, 20 + k};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0 : 7}
  k = (i + 1) % 8;
  Curve Loop(i + 1) = {30 + i, 20 + i, -(30 + k), -(10 + i)}; Plane Surface(i + 1) = {i + 1};
EndFor
Transfinite Curve{10 : 17, 20 : 27} = 14;
Transfinite Curve{30 : 37} = 11 Using Progression 0.92;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("core") = {10 : 17};
Physical Curve("side") = {20 : 27};
Physical Surface("shaft") = {1 : 8};
