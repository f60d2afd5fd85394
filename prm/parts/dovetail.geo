// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Section of a blade's root with two flanks at 45 degrees and fillets of radius 1.5 mm between flanks and neck. Points are
// those of the right half, from the top along the surface to the foot, beside places on the middle line.
// gmsh -2 dovetail.geo -o dovetail.msh
Mesh.MshFileVersion = 2.2;
r = 1.5; zc = 2 - (4 + r) + r * Sqrt(2); // the fillet's radius and the height of its centre: it touches x = 4 and x + z = 2
x[] = {4, 4, 4 + r - r / Sqrt(2), 4 + r - r / Sqrt(2) + 0.5, 8.44, 8.44};
z[] = {6, zc, zc - r / Sqrt(2), zc - r / Sqrt(2) - 0.5, 2 - 8.44, -9.5};
middle[] = {6, -2.2, -3.4, -4, -8.2, -9.5};
along[] = {14, 11, 4, 26, 8}; // nodes
For i In {0 : 5}
  Point(i) = {0, 0, middle[i]};
  Point(10 + i) = {x[i], 0, z[i]}; Point(20 + i) = {-x[i], 0, z[i]};
  Line(10 + i) = {i, 10 + i}; Line(20 + i) = {i, 20 + i};
EndFor
Point(30) = {4 + r, 0, zc}; Point(31) = {-4 - r, 0, zc};
For i In {0 : 4}
  Line(30 + i) = {i, i + 1};
  If (i == 1)
    Circle(41) = {11, 30, 12}; Circle(51) = {21, 31, 22};
  Else
    Line(40 + i) = {10 + i, 11 + i}; Line(50 + i) = {20 + i, 21 + i};
  EndIf
  Curve Loop(10 + i) = {11 + i, -(40 + i), -(10 + i), 30 + i}; Plane Surface(10 + i) = {10 + i};
  Curve Loop(20 + i) = {20 + i, 50 + i, -(21 + i), -(30 + i)}; Plane Surface(20 + i) = {20 + i};
  Transfinite Curve{30 + i, 40 + i, 50 + i} = along[i];
EndFor
Transfinite Curve{10 : 15, 20 : 25} = 13 Using Progression 0.84;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("right") = {43};
Physical Curve("left") = {53};
Physical Curve("right_fillet") = {41};
Physical Curve("left_fillet") = {51};
Physical Curve("neck") = {10, 20};
Physical Surface("root") = {10 : 14, 20 : 24};
