// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Section of a disc's slot for the dovetail root of dovetail.geo: lip, flank, and a bottom with corners of radius 2 mm.
// gmsh -2 slot.geo -o slot.msh
Mesh.MshFileVersion = 2.2;
x[] = {5, 4.8, 8.8, 8.8, 6.8, 0}; // from the rim of the disc to the middle of the slot's bottom
z[] = {0, -2.8, -6.8, -8, -10, -10};
X[] = {16, 16, 16, 16, 16, 0}; // outer ends of the blocks
Z[] = {0, -2.8, -7.5, -10, -18, -18};
along[] = {10, 27, 6, 9, 13}; // nodes
For i In {0 : 5}
  Point(10 + i) = {x[i], 0, z[i]}; Point(20 + i) = {X[i], 0, Z[i]};
  Line(10 + i) = {10 + i, 20 + i};
  If (i < 5)
    Point(30 + i) = {-x[i], 0, z[i]}; Point(40 + i) = {-X[i], 0, Z[i]};
    Line(20 + i) = {30 + i, 40 + i};
  EndIf
EndFor
Point(50) = {6.8, 0, -8}; Point(51) = {-6.8, 0, -8};
For i In {0 : 4}
  If (i < 4)
    left = 31 + i; Left = 41 + i; end = 21 + i;
  Else
    left = 15; Left = 25; end = 15;
  EndIf
  If (i == 3)
    Circle(33) = {13, 50, 14}; Circle(53) = {33, 51, 34};
  Else
    Line(30 + i) = {10 + i, 11 + i}; Line(50 + i) = {30 + i, left};
  EndIf
  Line(40 + i) = {20 + i, 21 + i}; Line(60 + i) = {40 + i, Left};
  Curve Loop(10 + i) = {30 + i, 11 + i, -(40 + i), -(10 + i)}; Plane Surface(10 + i) = {10 + i};
  Curve Loop(20 + i) = {20 + i, 60 + i, -end, -(50 + i)}; Plane Surface(20 + i) = {20 + i};
  Transfinite Curve{30 + i, 40 + i, 50 + i, 60 + i} = along[i];
EndFor
Transfinite Curve{10 : 15, 20 : 24} = 13 Using Progression 1.25;
Transfinite Surface "*"; Recombine Surface "*";
Physical Curve("right_flank") = {31};
Physical Curve("left_flank") = {51};
Physical Curve("right_corner") = {33};
Physical Curve("left_corner") = {53};
Physical Curve("disc") = {44, 64};
Physical Surface("slot") = {10 : 14, 20 : 24};
