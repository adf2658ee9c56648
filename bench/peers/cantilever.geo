// A beam of 5 x 1 x 1 m, in mm. Surface 1 (x = 0) is held, surface 2 (x = 5 m) is loaded: cantilever.json.
// gmsh cantilever.geo -3 -setnumber h SIZE -o cantilever.msh; sizes in mm: 81.5 gives 44 k tets, 50.5 176 k, 28.8 942 k.
SetFactory("Built-in");
If (!Exists(h))
  h = 81.5;
EndIf
Point(1) = {0, 0, 0, h}; Point(2) = {0, 1000, 0, h}; Point(3) = {0, 1000, 1000, h}; Point(4) = {0, 0, 1000, h};
Point(5) = {5000, 0, 0, h}; Point(6) = {5000, 1000, 0, h}; Point(7) = {5000, 1000, 1000, h}; Point(8) = {5000, 0, 1000, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {1, 5}; Line(10) = {2, 6}; Line(11) = {3, 7}; Line(12) = {4, 8};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Curve Loop(3) = {1, 10, -5, -9}; Plane Surface(3) = {3};
Curve Loop(4) = {2, 11, -6, -10}; Plane Surface(4) = {4};
Curve Loop(5) = {3, 12, -7, -11}; Plane Surface(5) = {5};
Curve Loop(6) = {4, 9, -8, -12}; Plane Surface(6) = {6};
Surface Loop(1) = {1, 2, 3, 4, 5, 6}; Volume(1) = {1};
Mesh.Algorithm3D = 1; Mesh.SaveAll = 1; Mesh.Binary = 1; Mesh.MshFileVersion = 4.1;
