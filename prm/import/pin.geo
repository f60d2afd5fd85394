// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of a pin, radius 3 mm and height 6 mm, whose lower end is a cap of a sphere of radius 10 mm. Gmsh's tetrahedra
// are divided into hexahedra.
// gmsh -3 pin.geo -o pin.msh
SetFactory("OpenCASCADE");
r = 3; h = 6; sphere = 10;
Mesh.MshFileVersion = 4.1;
Mesh.SubdivisionAlgorithm = 2;
Mesh.MeshSizeMin = 0.3; Mesh.MeshSizeMax = 2;
Cylinder(1) = {0, 0, 0, 0, 0, h, r, Pi/2};
Sphere(2) = {0, 0, sphere, sphere};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
eps = 1e-3;
x0[] = Surface In BoundingBox {-eps, -eps, -eps, eps, r + eps, h + eps};
y0[] = Surface In BoundingBox {-eps, -eps, -eps, r + eps, eps, h + eps};
top[] = Surface In BoundingBox {-eps, -eps, h - eps, r + eps, r + eps, h + eps};
cap[] = Surface In BoundingBox {-eps, -eps, -eps, r + eps, r + eps, 1};
Physical Surface("cap") = {cap[]};
Physical Surface("top") = {top[]};
Physical Surface("x0") = {x0[]};
Physical Surface("y0") = {y0[]};
Physical Volume("pin") = {3};
MeshSize{ PointsOf{ Volume{3}; } } = 1.6;
MeshSize{ PointsOf{ Surface{cap[]}; } } = 1.2;
MeshSize{ Point In BoundingBox {-eps, -eps, -eps, eps, eps, eps} } = 0.3; // where it touches
