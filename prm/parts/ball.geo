// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of a ball at the end of a stud: radius 10 mm, its centre in the origin; the stud has a radius of 8 mm. A core
// of cells about the axis and two rings of them are columns from the ball to the plane end of the stud.
// gmsh -3 ball.geo -o ball.msh
Mesh.MshFileVersion = 4.1;
r = 10; zc = 0; end = 10;
a[] = {0.24, 0.56, Asin(0.8)}; // polar angles of core and rings on the ball
Point(1) = {0, 0, zc};
Point(10) = {0, 0, zc - r}; Point(50) = {0, 0, end};
For i In {0 : 2}
  d = r * Sin(a[i]); z = zc - r * Cos(a[i]);
  Point(2 + i) = {0, 0, z};
  For j In {0 : 2} // on y = 0, on the diagonal, on x = 0
    x = j == 2 ? 0 : d * Cos(j * Pi / 4); y = d * Sin(j * Pi / 4);
    Point(11 + 3 * i + j) = {x, y, z}; Point(51 + 3 * i + j) = {x, y, end};
  EndFor
EndFor
// Lines of the disc between its points 0 to 9: the core's sides, rays, arcs.
first[] = {0, 1, 2, 3, 1, 2, 3, 4, 5, 4, 5, 6, 7, 8};
last[] = {1, 2, 3, 0, 4, 5, 6, 5, 6, 7, 8, 9, 8, 9};
cells[] = {6, 6, 6, 6, 5, 5, 5, 6, 6, 3, 3, 3, 6, 6};
For e In {0 : 13}
  below = 10 + first[e]; above = 50 + first[e];
  If (e == 7 || e == 8)
    Circle(10 + e) = {below, 3, 10 + last[e]};
  ElseIf (e > 11)
    Circle(10 + e) = {below, 4, 10 + last[e]};
  Else
    Circle(10 + e) = {below, 1, 10 + last[e]};
  EndIf
  If (e == 7 || e == 8 || e > 11)
    Circle(50 + e) = {above, 50, 50 + last[e]};
  Else
    Line(50 + e) = {above, 50 + last[e]};
  EndIf
  Transfinite Curve{10 + e, 50 + e} = cells[e] + 1;
EndFor
For p In {0 : 9}
  Line(100 + p) = {10 + p, 50 + p};
  Transfinite Curve{100 + p} = 10 Using Progression 1.25;
EndFor
For e In {0 : 13}
  Curve Loop(100 + e) = {10 + e, 100 + last[e], -(50 + e), -(100 + first[e])}; Surface(100 + e) = {100 + e};
EndFor
// Blocks by their four lines, of which the last two run backwards.
one[] = {0, 4, 5, 9, 10}; two[] = {1, 7, 8, 12, 13}; three[] = {2, 5, 6, 10, 11}; four[] = {3, 1, 2, 7, 8};
For b In {0 : 4}
  s = b ? -1 : 1;
  Curve Loop(10 + b) = {10 + one[b], 10 + two[b], s * (10 + three[b]), s * (10 + four[b])};
  Surface(10 + b) = {10 + b} In Sphere {1};
  Curve Loop(50 + b) = {50 + one[b], 50 + two[b], s * (50 + three[b]), s * (50 + four[b])};
  Plane Surface(50 + b) = {50 + b};
  Surface Loop(b + 1) = {10 + b, 50 + b, 100 + one[b], 100 + two[b], 100 + three[b], 100 + four[b]}; Volume(b + 1) = {b + 1};
EndFor
Transfinite Surface "*"; Recombine Surface "*"; Transfinite Volume "*";
Physical Surface("cap") = {10 : 12};
Physical Surface("shoulder") = {13, 14};
Physical Surface("shank") = {112, 113};
Physical Surface("end") = {50 : 54};
Physical Surface("x0") = {103, 106, 111};
Physical Surface("y0") = {100, 104, 109};
Physical Volume("ball") = {1 : 5};
