// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of the paper's cylinder, radius 10 mm and height 10 mm: quadrilaterals, extruded into layers.
// gmsh -3 cylinder.geo -setnumber size 2.5 -setnumber layers 4 -o cylinder.msh
// gmsh -3 cylinder.geo -setnumber size 5 -setnumber layers 2 -o cylinder_coarse.msh
// gmsh -3 cylinder.geo -setnumber size 1.25 -setnumber layers 8 -o cylinder_fine.msh
DefineConstant[ size = 2.5, layers = 4 ];
r = 10; h = 10;
Mesh.MshFileVersion = 4.1;
Mesh.MeshSizeMin = size; Mesh.MeshSizeMax = size;
Mesh.RecombinationAlgorithm = 2; // quadrilaterals alone
Point(1) = {0, 0, 0}; Point(2) = {r, 0, 0}; Point(3) = {0, r, 0};
Line(1) = {1, 2}; Circle(2) = {2, 1, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Recombine Surface{1};
made[] = Extrude {0, 0, h} { Surface{1}; Layers{layers}; Recombine; };
Physical Surface("base") = {1};
Physical Surface("top") = {made[0]};
Physical Surface("y0") = {made[2]};
Physical Surface("x0") = {made[4]};
Physical Volume("body") = {made[1]};
