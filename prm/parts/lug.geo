// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Half of a lug, x >= 0: an eye of radius 10 mm in a round end of radius 18 mm, and a shank up to z = 60 mm.
// gmsh -2 lug.geo -o lug.msh
Mesh.MshFileVersion = 2.2;
r = 10; R = 18;
x[] = {0, R / Sqrt(2), R, R, 0};
z[] = {0, R - R / Sqrt(2), R, 2 * R, 2 * R};
cells[] = {30, 30, 16, 12};
Point(1) = {0, 0, R};
For i In {0 : 4}
  angle = i * Pi / 4;
  Point(10 + i) = {i < 4 ? r * Sin(angle) : 0, 0, R - r * Cos(angle)}; Point(20 + i) = {x[i], 0, z[i]};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0 : 3}
  Circle(10 + i) = {10 + i, 1, 11 + i};
  If (i < 2)
    Circle(20 + i) = {20 + i, 1, 21 + i};
  Else
    Line(20 + i) = {20 + i, 21 + i};
  EndIf
  Curve Loop(i + 1) = {-(30 + i), 10 + i, 31 + i, -(20 + i)}; Plane Surface(i + 1) = {i + 1};
  Transfinite Curve{10 + i, 20 + i} = cells[i] + 1;
EndFor
Point(30) = {R, 0, 60}; Point(31) = {0, 0, 60};
Line(40) = {23, 30}; Line(41) = {30, 31}; Line(42) = {31, 24};
Curve Loop(5) = {40, 41, 42, -23}; Plane Surface(5) = {5};
Transfinite Curve{40, 42} = 11; Transfinite Curve{41} = cells[3] + 1;
Transfinite Curve{30 : 34} = 11 Using Progression 1.2;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("eye") = {10 : 13};
Physical Curve("end") = {20, 21};
Physical Curve("shank") = {41};
Physical Curve("x0") = {30, 34, 42};
Physical Surface("lug") = {1 : 5};
