// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Section of a hub, radii 9.99 mm and 15 mm, whose axis is 15 mm above z = 0. Four keys, 1.5 degrees wide, hold its rim.
// gmsh -2 hub.geo -o hub.msh
Mesh.MshFileVersion = 2.2;
r[] = {9.99, 15};
Point(1) = {0, 0, 15};
For i In {0 : 3}
  For j In {0 : 1} // both ends of a key
    angle = i * Pi / 2 + (2 * j - 1) * Pi / 240;
    Point(10 + 2 * i + j) = {r[0] * Cos(angle), 0, 15 + r[0] * Sin(angle)};
    Point(20 + 2 * i + j) = {r[1] * Cos(angle), 0, 15 + r[1] * Sin(angle)};
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
For i In {0 : 3} // cells of 3 degrees between the keys
  Transfinite Curve{10 + 2 * i, 20 + 2 * i} = 2;
  Transfinite Curve{11 + 2 * i, 21 + 2 * i} = 31;
EndFor
Transfinite Curve{30 : 37} = 9;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("bore") = {10 : 17};
Physical Curve("right_key") = {20};
Physical Curve("top_key") = {22};
Physical Curve("left_key") = {24};
Physical Curve("bottom_key") = {26};
Physical Curve("rim") = {21, 23, 25, 27}; // between the keys
Physical Surface("hub") = {1 : 8};
