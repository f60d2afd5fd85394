// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Half of a shaft, y >= 0, radius 10 mm, from z = 0 to 60 mm. Its seat reaches 2 mm beyond both ends of the wheel.
// gmsh -3 bent_shaft.geo -o bent_shaft.msh
Mesh.MshFileVersion = 4.1;
r = 10; c = 5;
Point(1) = {0, 0, 0};
For i In {0 : 4}
  Point(10 + i) = {r * Cos(i * Pi / 4), i < 4 ? r * Sin(i * Pi / 4) : 0, 0};
EndFor
Point(20) = {c, 0, 0}; Point(21) = {0.8 * c, 0.8 * c, 0}; Point(22) = {0, c, 0}; Point(23) = {-0.8 * c, 0.8 * c, 0};
Point(24) = {-c, 0, 0};
For i In {0 : 4}
  Line(30 + i) = {20 + i, 10 + i};
EndFor
For i In {0 : 3}
  Circle(10 + i) = {10 + i, 1, 11 + i}; Line(20 + i) = {20 + i, 21 + i};
  Curve Loop(i + 1) = {30 + i, 10 + i, -(31 + i), -(20 + i)}; Plane Surface(i + 1) = {i + 1};
EndFor
Line(40) = {1, 20}; Line(41) = {1, 22}; Line(42) = {1, 24};
Curve Loop(5) = {40, 20, 21, -41}; Plane Surface(5) = {5};
Curve Loop(6) = {41, 22, 23, -42}; Plane Surface(6) = {6};
Transfinite Curve{10 : 13, 20 : 23, 40 : 42} = 4;
Transfinite Curve{30 : 34} = 4 Using Progression 0.7;
Transfinite Surface "*"; Recombine Surface "*";
y0[] = {}; free[] = {}; seat[] = {}; held[] = {}; volumes[] = {};
For i In {1 : 6}
  s = i;
  For part In {0 : 2}
    If (part == 0)
      out[] = Extrude {0, 0, 3} { Surface{s}; Layers{1}; Recombine; };
    ElseIf (part == 1)
      out[] = Extrude {0, 0, 24} { Surface{s}; Recombine;
        Layers{ {1, 2, 3, 4, 4, 2}, {2 / 24, 9 / 24, 15 / 24, 19 / 24, 22 / 24, 1} }; };
    Else
      out[] = Extrude {0, 0, 33} { Surface{s}; Layers{ {2, 5}, {4 / 33, 1} }; Recombine; };
    EndIf
    s = out[0]; volumes[] += out[1];
    If (i == 1)
      y0[] += out[2];
    EndIf
    If (i == 4)
      y0[] += out[4];
    EndIf
    If (i == 5)
      y0[] += out[2];
    EndIf
    If (i == 6)
      y0[] += out[5];
    EndIf
    If (i <= 4)
      If (part == 1)
        seat[] += out[3];
      Else
        free[] += out[3];
      EndIf
    EndIf
  EndFor
  held[] += s;
EndFor
Physical Surface("seat") = {seat[]};
Physical Surface("side") = {free[]};
Physical Surface("bearing") = {held[]};
Physical Surface("y0") = {y0[]};
Physical Volume("shaft") = {volumes[]};
