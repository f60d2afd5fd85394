// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of a block with a socket of radius 10.1 mm for the ball of ball.geo; its lowest point is that of the ball. A
// core of cells about the axis and three rings of them are columns from the plane foot to the socket and its brim.
// gmsh -3 socket.geo -o socket.msh
Mesh.MshFileVersion = 4.1;
r = 10.1; zc = r - 10; end = -18;
a[] = {0.24, 0.56, Pi / 4}; // polar angles of core and rings in the socket
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
For j In {0 : 2} // the outside, 16 mm from the axis
  x = j == 2 ? 0 : 16 * Cos(j * Pi / 4); y = 16 * Sin(j * Pi / 4);
  Point(20 + j) = {x, y, z}; Point(60 + j) = {x, y, end};
EndFor
// Lines of the disc between its points 0 to 12: the core's sides, rays, arcs.
first[] = {0, 1, 2, 3, 1, 2, 3, 4, 5, 4, 5, 6, 7, 8, 7, 8, 9, 10, 11};
last[] = {1, 2, 3, 0, 4, 5, 6, 5, 6, 7, 8, 9, 8, 9, 10, 11, 12, 11, 12};
cells[] = {5, 5, 5, 5, 4, 4, 4, 5, 5, 3, 3, 3, 5, 5, 4, 4, 4, 5, 5};
For e In {0 : 18}
  below = 10 + first[e]; above = 50 + first[e];
  If (e == 7 || e == 8)
    Circle(10 + e) = {below, 3, 10 + last[e]};
  ElseIf (e == 12 || e == 13 || e > 16)
    Circle(10 + e) = {below, 4, 10 + last[e]};
  ElseIf (e > 13)
    Line(10 + e) = {below, 10 + last[e]};
  Else
    Circle(10 + e) = {below, 1, 10 + last[e]};
  EndIf
  If (e == 7 || e == 8 || e == 12 || e == 13 || e > 16)
    Circle(50 + e) = {above, 50, 50 + last[e]};
  Else
    Line(50 + e) = {above, 50 + last[e]};
  EndIf
  Transfinite Curve{10 + e, 50 + e} = cells[e] + 1;
EndFor
For p In {0 : 12}
  Line(100 + p) = {10 + p, 50 + p};
  Transfinite Curve{100 + p} = 9 Using Progression 1.25;
EndFor
For e In {0 : 18}
  Curve Loop(100 + e) = {10 + e, 100 + last[e], -(50 + e), -(100 + first[e])}; Surface(100 + e) = {100 + e};
EndFor
// Blocks by their four lines, of which the last two run backwards.
one[] = {0, 4, 5, 9, 10, 14, 15}; two[] = {1, 7, 8, 12, 13, 17, 18}; three[] = {2, 5, 6, 10, 11, 15, 16};
four[] = {3, 1, 2, 7, 8, 12, 13};
For b In {0 : 6}
  s = b ? -1 : 1;
  Curve Loop(10 + b) = {10 + one[b], 10 + two[b], s * (10 + three[b]), s * (10 + four[b])};
  If (b < 5)
    Surface(10 + b) = {10 + b} In Sphere {1};
  Else
    Plane Surface(10 + b) = {10 + b};
  EndIf
  Curve Loop(50 + b) = {50 + one[b], 50 + two[b], s * (50 + three[b]), s * (50 + four[b])};
  Plane Surface(50 + b) = {50 + b};
  Surface Loop(b + 1) = {10 + b, 50 + b, 100 + one[b], 100 + two[b], 100 + three[b], 100 + four[b]}; Volume(b + 1) = {b + 1};
EndFor
Transfinite Surface "*"; Recombine Surface "*"; Transfinite Volume "*";
Physical Surface("socket") = {10 : 14};
Physical Surface("outside") = {117, 118};
Physical Surface("foot") = {50 : 56};
Physical Surface("x0") = {103, 106, 111, 116};
Physical Surface("y0") = {100, 104, 109, 114};
Physical Volume("block") = {1 : 7};
