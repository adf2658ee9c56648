<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_GB" sourcelanguage="en_GB">
<context>
    <name>about</name>
    <message>
        <source>this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture of the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>messages between window and server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the server&apos;s processes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filling with tets, a program of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>public domain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>documents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ids of versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checksums of files and tokens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solver on GPUs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the server&apos;s log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>errors</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The surface of version %1 was not seen since the document was opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version %1 has no field of this load case here yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version %1 was seen without this quantity: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mass %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cube</name>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>jobs</name>
    <message>
        <source>nearly done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelling</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>legend</name>
    <message>
        <source>No field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bare part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour for each surface: what a pick can mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>von Mises stress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number for how near a ductile material is to yielding. It has no sign: tension and compression look alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far each point moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far each point moves along x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far each point moves along y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far each point moves along z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yield strength over von Mises stress. Red, below 1: it yields. Grey: the material has no yield strength.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Principal stress 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest tension at each point: it opens cracks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Principal stress 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle one of the principal stresses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Principal stress 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest compression at each point, negative.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest shear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the difference of principal stress 1 and 3 (Tresca).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stress xx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along x; tension is positive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stress yy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along y; tension is positive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stress zz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along z; tension is positive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear stress xy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the plane of x and y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear stress yz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the plane of y and z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear stress zx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the plane of z and x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimated error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the stress may be off for want of a finer mesh, in per cent of the part&apos;s mean stress. An indicator, not a bound.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over 1000</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>load_editing</name>
    <message>
        <source>Give three numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give at least one component that is not 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the material a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be a number above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be a number between −1 and 0.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be a number, not negative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be a number, not negative; 0 when it is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick surfaces and use the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick at least one component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a number where it is ticked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be a number other than 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a load</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>load_words</name>
    <message>
        <source>along </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roller: slides, does not lift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displaced by </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Traction </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>moment</name>
    <message>
        <source>today, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>operation_form</name>
    <message>
        <source>From %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usually %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>operations</name>
    <message>
        <source>Fillet inner corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounds inner corners with a radius: fills what a ball outside the material cannot reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two or more walls that meet: the concave edges between them; one wall alone: all its concave edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the ball that rolls along both walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facets over an arc of 90 degrees, at least; where the mesh is finer there are more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes material off below surfaces: layers of tets, or a given depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surfaces to take material off; for a fin its sides, tip and fillets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers of tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many layers of tets to take off. A layer is no length: for one, give a depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the surfaces by this length instead; 0 takes off layers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of a part that falls apart: refuse, keep_largest (of each body) or allow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes holes: through, blind, stepped, in curved walls or closed inside the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wall surfaces of one or more holes; bottoms are found by themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exactly the selected surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not complete the selection by bottoms and inner parts of the hole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Include the entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also fill the countersink or counterbore around the hole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Improve mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the tets a better shape: the worst first, then all of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces whose surroundings are improved; none: the whole mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the boundary may move, to mend tets on thin boundary triangles. 0 keeps it as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth the whole mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also lower the harmonic energy, which evens out all tets; without, only bad ones change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tets with a radius ratio (3 r_in / R_circ) below this are lifted, worst first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounds outer edges with a radius: takes off what a ball inside the material cannot reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two or more walls that meet: the convex edges between them; one wall alone: all its convex edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove boss, rib or fin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes off what stands on the part and continues the surface under it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A surface of the boss, rib or fin; its other sides are found by themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not complete the selection by the other sides, the top and the fillets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thicken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts material of a given thickness on flat and round surfaces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flat, cylindrical and conical surfaces to put material on; both halves of a bore.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much material to put on.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>overlay</name>
    <message>
        <source> · locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · log</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>preview</name>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 new, %3 gone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst tet here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 before, %2 then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All loads and supports stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads and supports that change: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>quantities</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>receipt</name>
    <message>
        <source>Surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>merged into surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>split from surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no loads yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All loads and supports are as before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads and supports that changed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new, %2 gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst tet here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 before, %2 now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, made by the preview (operation %2, mesh %3, checks %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (operation %2, mesh %3, checks %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::about_dialog</name>
    <message>
        <source>About TEdit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits tetrahedral meshes of parts and shows the new stress at once.

TEdit is free software under the GNU Affero General Public License, version 3 or (at your option) any later version. It comes without any warranty. Whoever lets others use a changed TEdit over a network must offer them its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::banner</name>
    <message>
        <source>Where: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not work</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::command_palette</name>
    <message>
        <source>Search commands and operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::compare_view</name>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v%1 minus v%2, on the surface of v%1; dark grey: not in both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  (preview)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (no difference)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::context_panel</name>
    <message>
        <source>+ smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add all surfaces that continue these without an edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ tangent neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the surfaces next to these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a surface of the part: a bore, a rib or a wall is picked whole. Click again for the single surface; Shift adds. Ctrl+drag draws a box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server does not offer this operation any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::document</name>
    <message>
        <source>Surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the load cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list of operations did not come: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iteration %1, residual %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name the version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields on demand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the solver</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::field_panel</name>
    <message>
        <source>Viridis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours that flow, or steps of one colour each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of equal value on the surface, at the edges of the bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked across versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not deformed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No yield strength is known: give the material one in &quot;Loads and supports&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Envelope of all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading: the server was asked for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loading</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::help_panel</name>
    <message>
        <source>Search the help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Improving a mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the browser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same page, with its pictures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::history_strip</name>
    <message>
        <source>Versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mass %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volume %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst tet where it changed: %1 before, %2 now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this version (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name and note ... (F2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::jobs_button</name>
    <message>
        <source>What runs, and how the server is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  (%1 run)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::jobs_panel</name>
    <message>
        <source>Nothing runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>just begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, running and waiting: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, started again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open documents: %1, connections: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::legend_strip</name>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::load_editor</name>
    <message>
        <source>Use the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typical values; take those of your data sheet for a real design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young&apos;s modulus in MPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density in kg/m³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yield strength in MPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yield</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regions of the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all that no other material names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displaced by ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roller: slides, no lifting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not ticked: free to move this way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement %1 in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force, spread over the surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Traction, per area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure, along the normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity, on all mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Component %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure in MPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positive pushes on the part, negative pulls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No surfaces yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click surfaces of the part first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces picked: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give numbers of regions, with commas between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 in all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::loads_panel</name>
    <message>
        <source>Load cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the surfaces that are picked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load the surfaces that are picked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the part is made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another set of materials, supports and loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has changes that the server has not taken yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not solved yet; it still needs %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is solved too. It was set before this window opened the document, so its items are not known here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No loads yet. Pick surfaces of the part, then add a support and a load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  · reduced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  · area changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click to change it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard what is not solved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::local_server</name>
    <message>
        <source>it printed nothing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::main_window</name>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads and supports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this edit did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last session was not closed; opening %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to the server is lost. It is taken up again by itself; nothing that was done is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection is slow: the server has not answered for %1. What was asked for goes on when it does, and can be cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the mesh (.msh), its boundary (.stl) or its fields (.vtu)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view with its legend as a PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply the operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel what runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the solver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All commands and operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selection, or the whole part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts the part and shows the field inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section parallel to the last click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolate the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel or perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark smallest and largest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark or light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address and token, as &quot;tedit serve&quot; prints them: ws://HOST:PORT/v1 TOKEN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh (*.msh)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields for ParaView (*.vtu)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundary (*.stl)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jobs with their progress, and the server&apos;s workers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a box. To the right: what lies in it altogether; to the left: all that it touches. Shift adds, Esc ends. Ctrl+drag does it at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select with a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+drag in the view does the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all that can be seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide isolines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name and note of a version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the one that is chosen in the history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording, steps: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes down what is done, for &quot;tedit-qt --script&quot;; again: ends and saves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the recorded steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide loads and supports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows and support marks of the load case that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen load, support or load case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is chosen in &quot;Loads and supports&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with the version before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side with linked cameras, or their difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison: difference or side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours, solver, legend, log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All commands with their keys, to look up and to change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About TEdit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version, licence, libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probes and plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe: values at places that are clicked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered pins that stay over edits; two give a distance and a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field by area, along a line, and the quality of tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: version %2 in %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads and supports that this edit reduced or dropped: %1. See &quot;What this edit did&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The manual: the page for what is being done, with a search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mesh with its load cases, a document, or a recipe, which is run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a mesh and its load cases, a document or a recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes, load cases, recipes, documents (*.msh *.json *.tedit)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of equal value on the surface and on a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the recipe %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: done. Its exports (%2) were left out: export by hand, or use &quot;tedit run&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: stopped at %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::overlay</name>
    <message>
        <source>min %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::plot_panel</name>
    <message>
        <source>Shown field by area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown field between two probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tets that the edit touched, by quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No field is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, v%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set two probes (P, then click the part).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no field on this line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the deformation to 0: the line runs through the part as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from probe %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No edit has been made yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst tet: %1 before, %2 now; median now %3.
How many have which quality is counted by a thorough improvement only (&quot;Improve mesh&quot;).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius ratio of the tets, v%1; the outline: before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius ratio, 1 is best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of tets</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::preview_box</name>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what the edit would make while its values move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what these values would make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the preview: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not applied. Orange: new. Blue: taken away. Made in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last preview took longer than %1: ask for it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::probe_panel</name>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the nearest point of the same surface: its triangle was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, then click places of the part. Two of them give a distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A second probe gives the distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface of one of them is gone.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::receipt_panel</name>
    <message>
        <source>What this edit did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No edit has been made yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::recent_documents</name>
    <message>
        <source>Go on with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Documents that were open before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was taken from the list; the document itself stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take from this list (Del)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::recipe_player</name>
    <message>
        <source>Recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before the first step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2 (%3)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::section_bar</name>
    <message>
        <source>Section across x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section across y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section across z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel to the picked surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::selection</name>
    <message>
        <source>Nothing selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bore, Ø %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole or pocket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rib or boss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 surfaces</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::settings_dialog</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors and news</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light, dark, or as the system has it when the program starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The log shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is written to the log panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No setting has these letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds from the next start of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear tets: a quick look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quadratic tets: accurate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solve to the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the stress is computed: auto, cpu, or a part of a device&apos;s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Element order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear tets are several times faster, but too stiff in bending: their stress is too low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop as a preview at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops at this estimated error in energy: less exact and faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic, anew with each field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked to that of the first field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale that a field is drawn with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where to where the colours go; locked, versions can be compared by colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal factors get equal room on the scale</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::shortcuts_dialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command has no keys any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys that the command came with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot; already. Give that one other keys first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::truth_line</name>
    <message>
        <source>no part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview of an edit, not applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the solver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview, converging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>final</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stresses follow when it is applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error est. %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 unknowns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solved in %1 on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 load cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iteration %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connecting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solver stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview, solver stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solves the part as it is now (F5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the solver; the next edit is solved again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::version_editor</name>
    <message>
        <source>Version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter keeps, Esc drops</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::view_cube</name>
    <message>
        <source>Standard views</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::viewport</name>
    <message>
        <source>The part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tedit::desktop::welcome_page</name>
    <message>
        <source>Change a part, see its stress at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a tetrahedral mesh with surface ids (Gmsh .msh) by dropping it here, or start with a shipped part:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a server ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
