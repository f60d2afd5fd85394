// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Half of a wheel's hub, y >= 0, radii 9.99 mm and 24 mm, from z = 5 to 25 mm. Layers are thin where the shaft leaves it.
// The web is the outer ring, from 20 mm on, of its end z = 5.
// gmsh -3 wheel.geo -o wheel.msh
Mesh.MshFileVersion = 4.1;
r[] = {9.99, 14, 20, 24};
Point(1) = {0, 0, 5};
For j In {0 : 3}
  For i In {0 : 2}
    Point(10 + 10 * j + i) = {r[j] * Cos(i * Pi / 2), i == 1 ? r[j] : 0, 5};
  EndFor
  Circle(10 + 10 * j) = {10 + 10 * j, 1, 11 + 10 * j}; Circle(11 + 10 * j) = {11 + 10 * j, 1, 12 + 10 * j};
EndFor
Transfinite Curve{10, 11, 20, 21, 30, 31, 40, 41} = 7;
For j In {0 : 2}
  For i In {0 : 2}
    Line(60 + 10 * j + i) = {10 + 10 * j + i, 20 + 10 * j + i};
  EndFor
  For i In {0 : 1}
    s = 1 + 2 * j + i;
    Curve Loop(s) = {60 + 10 * j + i, 20 + 10 * j + i, -(61 + 10 * j + i), -(10 + 10 * j + i)}; Plane Surface(s) = {s};
  EndFor
EndFor
Transfinite Curve{60 : 62} = 4 Using Progression 1.3; Transfinite Curve{70 : 72} = 3; Transfinite Curve{80 : 82} = 2;
Transfinite Surface "*"; Recombine Surface "*";
For s In {1 : 6}
  made[] = Extrude {0, 0, 20} { Surface{s}; Recombine; Layers{ {1, 2, 3, 3, 3}, {1.5 / 20, 8 / 20, 14 / 20, 18 / 20, 1} }; };
  volumes[] += made[1]; outer[] += made[3]; inner[] += made[5]; y0[] += s % 2 == 1 ? made[2] : made[4];
EndFor
Physical Surface("bore") = {inner[0], inner[1]};
Physical Surface("rim") = {outer[4], outer[5]};
Physical Surface("web") = {5, 6};
Physical Surface("y0") = {y0[]};
Physical Volume("wheel") = {volumes[]};
