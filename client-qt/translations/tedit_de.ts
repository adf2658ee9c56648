<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>about</name>
    <message>
        <source>this window</source>
        <translation>dieses Fenster</translation>
    </message>
    <message>
        <source>the picture of the part</source>
        <translation>das Bild des Bauteils</translation>
    </message>
    <message>
        <source>messages between window and server</source>
        <translation>Nachrichten zwischen Fenster und Server</translation>
    </message>
    <message>
        <source>the connection</source>
        <translation>die Verbindung</translation>
    </message>
    <message>
        <source>the server&apos;s processes</source>
        <translation>die Prozesse des Servers</translation>
    </message>
    <message>
        <source>exact geometry</source>
        <translation>exakte Geometrie</translation>
    </message>
    <message>
        <source>filling with tets, a program of its own</source>
        <translation>Füllen mit Tetraedern, ein eigenes Programm</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>lineare Algebra</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>gemeinfrei</translation>
    </message>
    <message>
        <source>documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>ids of versions</source>
        <translation>Kennungen der Versionen</translation>
    </message>
    <message>
        <source>checksums of files and tokens</source>
        <translation>Prüfsummen von Dateien und Token</translation>
    </message>
    <message>
        <source>the solver on GPUs</source>
        <translation>der Löser auf Grafikkarten</translation>
    </message>
    <message>
        <source>the server&apos;s log</source>
        <translation>das Protokoll des Servers</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>die Befehlszeile</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>command_groups</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The surface of version %1 was not seen since the document was opened.</source>
        <translation>Die Oberfläche von Version %1 wurde seit dem Öffnen des Dokuments nicht angezeigt.</translation>
    </message>
    <message>
        <source>Version %1 has no field of this load case here yet.</source>
        <translation>Version %1 hat hier noch kein Feld dieses Lastfalls.</translation>
    </message>
    <message>
        <source>Version %1 was seen without this quantity: %2.</source>
        <translation>Version %1 wurde ohne diese Größe angezeigt: %2.</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max. %1</translation>
    </message>
    <message>
        <source>mass %1</source>
        <translation>Masse %1</translation>
    </message>
</context>
<context>
    <name>cube</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Fields for ParaView</source>
        <translation>Felder für ParaView</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Boundary with surfaces</source>
        <translation>Oberfläche mit Flächennummern</translation>
    </message>
</context>
<context>
    <name>head_questions</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
</context>
<context>
    <name>jobs</name>
    <message>
        <source>nearly done</source>
        <translation>fast fertig</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>cancelling</source>
        <translation>wird abgebrochen</translation>
    </message>
</context>
<context>
    <name>legend</name>
    <message>
        <source>No field</source>
        <translation>Kein Feld</translation>
    </message>
    <message>
        <source>The bare part.</source>
        <translation>Nur das Bauteil.</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>A colour for each surface: what a pick can mean.</source>
        <translation>Eine Farbe für jede Fläche: was ein Klick auswählen kann.</translation>
    </message>
    <message>
        <source>von Mises stress</source>
        <translation>Vergleichsspannung</translation>
    </message>
    <message>
        <source>One number for how near a ductile material is to yielding. It has no sign: tension and compression look alike.</source>
        <translation>Nach von Mises: eine Zahl dafür, wie nahe ein zäher Werkstoff am Fließen ist. Sie hat kein Vorzeichen: Zug und Druck sehen gleich aus.</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>How far each point moves.</source>
        <translation>Wie weit sich jeder Punkt bewegt.</translation>
    </message>
    <message>
        <source>Displacement x</source>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>How far each point moves along x.</source>
        <translation>Wie weit sich jeder Punkt in x-Richtung bewegt.</translation>
    </message>
    <message>
        <source>Displacement y</source>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>How far each point moves along y.</source>
        <translation>Wie weit sich jeder Punkt in y-Richtung bewegt.</translation>
    </message>
    <message>
        <source>Displacement z</source>
        <translation>Verschiebung z</translation>
    </message>
    <message>
        <source>How far each point moves along z.</source>
        <translation>Wie weit sich jeder Punkt in z-Richtung bewegt.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Sicherheitsfaktor</translation>
    </message>
    <message>
        <source>Yield strength over von Mises stress. Red, below 1: it yields. Grey: the material has no yield strength.</source>
        <translation>Streckgrenze durch Vergleichsspannung. Rot, unter 1: der Werkstoff fließt. Grau: der Werkstoff hat keine Streckgrenze.</translation>
    </message>
    <message>
        <source>Principal stress 1</source>
        <translation>Hauptspannung 1</translation>
    </message>
    <message>
        <source>The largest tension at each point: it opens cracks.</source>
        <translation>Der größte Zug in jedem Punkt: er öffnet Risse.</translation>
    </message>
    <message>
        <source>Principal stress 2</source>
        <translation>Hauptspannung 2</translation>
    </message>
    <message>
        <source>The middle one of the principal stresses.</source>
        <translation>Die mittlere der Hauptspannungen.</translation>
    </message>
    <message>
        <source>Principal stress 3</source>
        <translation>Hauptspannung 3</translation>
    </message>
    <message>
        <source>The largest compression at each point, negative.</source>
        <translation>Der größte Druck in jedem Punkt, negativ.</translation>
    </message>
    <message>
        <source>Largest shear</source>
        <translation>Größte Schubspannung</translation>
    </message>
    <message>
        <source>Half the difference of principal stress 1 and 3 (Tresca).</source>
        <translation>Die halbe Differenz der Hauptspannungen 1 und 3 (Tresca).</translation>
    </message>
    <message>
        <source>Stress xx</source>
        <translation>Spannung xx</translation>
    </message>
    <message>
        <source>Along x; tension is positive.</source>
        <translation>In x-Richtung; Zug ist positiv.</translation>
    </message>
    <message>
        <source>Stress yy</source>
        <translation>Spannung yy</translation>
    </message>
    <message>
        <source>Along y; tension is positive.</source>
        <translation>In y-Richtung; Zug ist positiv.</translation>
    </message>
    <message>
        <source>Stress zz</source>
        <translation>Spannung zz</translation>
    </message>
    <message>
        <source>Along z; tension is positive.</source>
        <translation>In z-Richtung; Zug ist positiv.</translation>
    </message>
    <message>
        <source>Shear stress xy</source>
        <translation>Schubspannung xy</translation>
    </message>
    <message>
        <source>In the plane of x and y.</source>
        <translation>In der xy-Ebene.</translation>
    </message>
    <message>
        <source>Shear stress yz</source>
        <translation>Schubspannung yz</translation>
    </message>
    <message>
        <source>In the plane of y and z.</source>
        <translation>In der yz-Ebene.</translation>
    </message>
    <message>
        <source>Shear stress zx</source>
        <translation>Schubspannung zx</translation>
    </message>
    <message>
        <source>In the plane of z and x.</source>
        <translation>In der zx-Ebene.</translation>
    </message>
    <message>
        <source>Estimated error</source>
        <translation>Geschätzter Fehler</translation>
    </message>
    <message>
        <source>How far the stress may be off for want of a finer mesh, in per cent of the part&apos;s mean stress. An indicator, not a bound.</source>
        <translation>Wie weit die Spannung danebenliegen kann, weil das Netz nicht feiner ist, in Prozent der mittleren Spannung des Bauteils. Ein Anhaltspunkt, keine Schranke.</translation>
    </message>
    <message>
        <source>over 1000</source>
        <translation>über 1000</translation>
    </message>
    <message>
        <source>Largest principal strain</source>
        <translation>Größte Hauptdehnung</translation>
    </message>
    <message>
        <source>The largest stretch at each point, in whatever direction it is: what a strain gauge could read there. 1000 µm/m are 0.1 %.</source>
        <translation>Die größte Dehnung an jedem Punkt, gleich in welcher Richtung: was ein Dehnungsmessstreifen dort anzeigen könnte. 1000 µm/m sind 0,1 %.</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
</context>
<context>
    <name>load_editing</name>
    <message>
        <source>Give at least one component that is not 0</source>
        <translation>Komponente ungleich 0 eingeben</translation>
    </message>
    <message>
        <source>Give the material a name</source>
        <translation>Dem Werkstoff einen Namen geben</translation>
    </message>
    <message>
        <source>Must be a number above 0</source>
        <translation>Muss eine Zahl größer als 0 sein</translation>
    </message>
    <message>
        <source>Must be a number between −1 and 0.5</source>
        <translation>Muss eine Zahl zwischen −1 und 0,5 sein</translation>
    </message>
    <message>
        <source>Must be a number, not negative</source>
        <translation>Muss eine Zahl sein, nicht negativ</translation>
    </message>
    <message>
        <source>Must be a number, not negative; 0 when it is not known</source>
        <translation>Muss eine Zahl sein, nicht negativ; 0, wenn sie nicht bekannt ist</translation>
    </message>
    <message>
        <source>Pick surfaces and use the selection</source>
        <translation>Flächen auswählen und die Auswahl übernehmen</translation>
    </message>
    <message>
        <source>Tick at least one component</source>
        <translation>Mindestens eine Komponente ankreuzen</translation>
    </message>
    <message>
        <source>Give a number where it is ticked</source>
        <translation>Wo ein Haken ist, eine Zahl eingeben</translation>
    </message>
    <message>
        <source>Must be a number other than 0</source>
        <translation>Muss eine Zahl ungleich 0 sein</translation>
    </message>
    <message>
        <source>a material</source>
        <translation>ein Werkstoff</translation>
    </message>
    <message>
        <source>a support</source>
        <translation>ein Lager</translation>
    </message>
    <message>
        <source>a load</source>
        <translation>eine Last</translation>
    </message>
    <message>
        <source>Give three numbers, alone or with a unit of their kind</source>
        <translation>Drei Zahlen, allein oder mit einer passenden Einheit</translation>
    </message>
</context>
<context>
    <name>load_words</name>
    <message>
        <source>along </source>
        <translation>in Richtung </translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest eingespannt</translation>
    </message>
    <message>
        <source>Roller: slides, does not lift</source>
        <translation>Gleitlager: gleitet, hebt nicht ab</translation>
    </message>
    <message>
        <source>Displaced by </source>
        <translation>Verschoben um </translation>
    </message>
    <message>
        <source>Force </source>
        <translation>Kraft </translation>
    </message>
    <message>
        <source>Traction </source>
        <translation>Flächenlast </translation>
    </message>
    <message>
        <source>Pressure </source>
        <translation>Druck </translation>
    </message>
    <message>
        <source>Gravity </source>
        <translation>Schwerkraft </translation>
    </message>
    <message>
        <source>grows by %1 %2</source>
        <translation>wächst um %1 %2</translation>
    </message>
    <message>
        <source>along the normal</source>
        <translation>längs der Normalen</translation>
    </message>
    <message>
        <source>Moment </source>
        <translation>Moment </translation>
    </message>
    <message>
        <source>at (%1, %2, %3) mm</source>
        <translation>bei (%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>Bearing force </source>
        <translation>Lagerkraft </translation>
    </message>
</context>
<context>
    <name>moment</name>
    <message>
        <source>today, %1</source>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gestern, %1</translation>
    </message>
</context>
<context>
    <name>operation_form</name>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>At least %1</source>
        <translation>Mindestens %1</translation>
    </message>
    <message>
        <source>At most %1</source>
        <translation>Höchstens %1</translation>
    </message>
    <message>
        <source>Usually %1</source>
        <translation>Üblich %1</translation>
    </message>
</context>
<context>
    <name>operations</name>
    <message>
        <source>Fillet inner corners</source>
        <translation>Innenecken ausrunden</translation>
    </message>
    <message>
        <source>Rounds inner corners with a radius: fills what a ball outside the material cannot reach.</source>
        <translation>Rundet Innenecken mit einem Radius aus: füllt, was eine Kugel außerhalb des Werkstoffs nicht erreicht.</translation>
    </message>
    <message>
        <source>Two or more walls that meet: the concave edges between them; one wall alone: all its concave edges.</source>
        <translation>Zwei oder mehr Wände, die zusammenstoßen: die hohlen Kanten dazwischen; eine Wand allein: alle ihre hohlen Kanten.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the ball that rolls along both walls.</source>
        <translation>Radius der Kugel, die an beiden Wänden entlangrollt.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Facets over an arc of 90 degrees, at least; where the mesh is finer there are more.</source>
        <translation>Facetten über einen Bogen von 90 Grad, mindestens; wo das Netz feiner ist, sind es mehr.</translation>
    </message>
    <message>
        <source>Erode</source>
        <translation>Abtragen</translation>
    </message>
    <message>
        <source>Takes material off below surfaces: a given depth, or layers of tets.</source>
        <translation>Trägt unter Flächen Werkstoff ab: eine gegebene Tiefe oder Schichten von Tetraedern.</translation>
    </message>
    <message>
        <source>The surfaces to take material off; for a fin its sides, tip and fillets.</source>
        <translation>Die Flächen, an denen abgetragen wird; bei einer Rippe ihre Seiten, die Spitze und die Ausrundungen.</translation>
    </message>
    <message>
        <source>Layers of tets</source>
        <translation>Tetraederschichten</translation>
    </message>
    <message>
        <source>How many layers of tets to take off where the depth is 0. A layer is no length.</source>
        <translation>Wie viele Schichten von Tetraedern abgetragen werden, wo die Tiefe 0 ist. Eine Schicht ist keine Länge.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>How much material to take off. 0 takes off layers of tets instead.</source>
        <translation>Wie viel Werkstoff abgetragen wird. 0 trägt stattdessen Schichten von Tetraedern ab.</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>What becomes of a part that falls apart: refuse, keep_largest (of each body) or allow.</source>
        <translation>Was aus einem Bauteil wird, das zerfällt: refuse (ablehnen), keep_largest (das größte Stück jedes Körpers behalten) oder allow (erlauben).</translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation>Loch schließen</translation>
    </message>
    <message>
        <source>Closes holes: through, blind, stepped, in curved walls or closed inside the part.</source>
        <translation>Schließt Bohrungen: durchgehend, Sackloch, abgesetzt, in gekrümmten Wänden oder im Inneren des Bauteils.</translation>
    </message>
    <message>
        <source>The wall surfaces of one or more holes; bottoms are found by themselves.</source>
        <translation>Die Wandflächen einer oder mehrerer Bohrungen; Böden werden von selbst gefunden.</translation>
    </message>
    <message>
        <source>Exactly the selected surfaces</source>
        <translation>Genau die ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Do not complete the selection by bottoms and inner parts of the hole.</source>
        <translation>Die Auswahl nicht um Böden und innere Teile der Bohrung ergänzen.</translation>
    </message>
    <message>
        <source>Include the entry</source>
        <translation>Senkung einbeziehen</translation>
    </message>
    <message>
        <source>Also fill the countersink or counterbore around the hole.</source>
        <translation>Auch die Senkung um die Bohrung füllen.</translation>
    </message>
    <message>
        <source>Improve mesh</source>
        <translation>Netz verbessern</translation>
    </message>
    <message>
        <source>Gives the tets a better shape: the worst first, then all of them.</source>
        <translation>Gibt den Tetraedern eine bessere Form: erst den schlechtesten, dann allen.</translation>
    </message>
    <message>
        <source>Surfaces whose surroundings are improved; none: the whole mesh.</source>
        <translation>Flächen, deren Umgebung verbessert wird; keine: das ganze Netz.</translation>
    </message>
    <message>
        <source>Surface tolerance</source>
        <translation>Flächentoleranz</translation>
    </message>
    <message>
        <source>How far the boundary may move, to mend tets on thin boundary triangles. 0 keeps it as it is.</source>
        <translation>Wie weit sich die Oberfläche bewegen darf, um Tetraeder auf schmalen Randdreiecken zu verbessern. 0 lässt sie, wie sie ist.</translation>
    </message>
    <message>
        <source>Smooth the whole mesh</source>
        <translation>Ganzes Netz glätten</translation>
    </message>
    <message>
        <source>Also lower the harmonic energy, which evens out all tets; without, only bad ones change.</source>
        <translation>Auch die harmonische Energie senken, was alle Tetraeder angleicht; ohne ändern sich nur schlechte.</translation>
    </message>
    <message>
        <source>Target quality</source>
        <translation>Zielgüte</translation>
    </message>
    <message>
        <source>Tets with a radius ratio (3 r_in / R_circ) below this are lifted, worst first.</source>
        <translation>Tetraeder mit einem Radienverhältnis (3 r_in / R_circ) darunter werden verbessert, die schlechtesten zuerst.</translation>
    </message>
    <message>
        <source>Round edges</source>
        <translation>Kanten abrunden</translation>
    </message>
    <message>
        <source>Rounds outer edges with a radius: takes off what a ball inside the material cannot reach.</source>
        <translation>Rundet Außenkanten mit einem Radius ab: nimmt weg, was eine Kugel im Werkstoff nicht erreicht.</translation>
    </message>
    <message>
        <source>Two or more walls that meet: the convex edges between them; one wall alone: all its convex edges.</source>
        <translation>Zwei oder mehr Wände, die zusammenstoßen: die vorspringenden Kanten dazwischen; eine Wand allein: alle ihre vorspringenden Kanten.</translation>
    </message>
    <message>
        <source>Remove boss, rib or fin</source>
        <translation>Auge, Rippe entfernen</translation>
    </message>
    <message>
        <source>Takes off what stands on the part and continues the surface under it.</source>
        <translation>Nimmt weg, was auf dem Bauteil steht, und setzt die Fläche darunter fort.</translation>
    </message>
    <message>
        <source>A surface of the boss, rib or fin; its other sides are found by themselves.</source>
        <translation>Eine Fläche des Auges oder der Rippe; die anderen Seiten werden von selbst gefunden.</translation>
    </message>
    <message>
        <source>Do not complete the selection by the other sides, the top and the fillets.</source>
        <translation>Die Auswahl nicht um die anderen Seiten, die Oberseite und die Ausrundungen ergänzen.</translation>
    </message>
    <message>
        <source>Thicken</source>
        <translation>Aufdicken</translation>
    </message>
    <message>
        <source>Puts material of a given thickness on flat and round surfaces.</source>
        <translation>Bringt auf ebenen und runden Flächen Werkstoff gegebener Dicke auf.</translation>
    </message>
    <message>
        <source>The flat, cylindrical and conical surfaces to put material on; both halves of a bore.</source>
        <translation>Die ebenen, zylindrischen und kegeligen Flächen, auf die Werkstoff kommt; bei einer Bohrung beide Hälften.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>How much material to put on.</source>
        <translation>Wie viel Werkstoff aufgebracht wird.</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>keep largest</source>
        <translation>größtes behalten</translation>
    </message>
    <message>
        <source>allow</source>
        <translation>erlauben</translation>
    </message>
    <message>
        <source>Use it where two walls meet in a sharp inner corner: the stress there grows with every finer mesh, in a fillet it does not. Pick the walls on both sides. A fillet needs room: where a wall is narrower than it, the edit is refused with the largest radius that works.</source>
        <translation>Wo zwei Wände in einer scharfen Innenecke zusammenstoßen: Dort wächst die Spannung mit jedem feineren Netz, in einer Ausrundung nicht. Die Wände auf beiden Seiten anklicken. Eine Ausrundung braucht Platz: Wo eine Wand schmaler ist als sie, wird die Änderung mit dem größten Radius abgelehnt, der geht.</translation>
    </message>
    <message>
        <source>Flat, cylindrical and conical surfaces move by exactly the depth and keep their names, so loads on them stay. Layers of tets come off any surface, but a layer is no length. A cut that would split the part is refused unless &quot;Pieces&quot; allows it.</source>
        <translation>Ebene, zylindrische und kegelige Flächen gehen um genau die Tiefe zurück und behalten ihre Namen, Lasten darauf bleiben also. Lagen von Tetraedern lassen sich von jeder Fläche nehmen, eine Lage ist aber keine Länge. Ein Schnitt, der das Teil zerlegen würde, wird abgelehnt, wenn „Stücke“ ihn nicht erlaubt.</translation>
    </message>
    <message>
        <source>Pick one wall of the hole: what belongs to it is found. A countersink is filled only with &quot;Include the entry&quot;. The closed place becomes part of the surface around it where it continues that one, and is a surface of its own elsewhere.</source>
        <translation>Eine Wand des Lochs anklicken: Was dazugehört, wird gefunden. Eine Senkung wird nur mit „Senkung einbeziehen“ gefüllt. Wo die geschlossene Stelle die Fläche um sie fortsetzt, gehört sie zu dieser, sonst ist sie eine eigene.</translation>
    </message>
    <message>
        <source>Edits improve what they touch by themselves: use this for a mesh that came with bad tets. Without a selection all of it is improved, which takes some seconds. The part keeps its shape, unless a tolerance is given.</source>
        <translation>Änderungen verbessern, was sie berühren, von selbst: Dies ist für ein Netz, das mit schlechten Tetraedern kam. Ohne Auswahl wird das ganze verbessert, was einige Sekunden dauert. Das Teil behält seine Form, wenn keine Toleranz angegeben ist.</translation>
    </message>
    <message>
        <source>Use it on sharp outer edges. Pick the walls on both sides of an edge, or one wall for all its edges. It takes material off; loads and supports on the walls stay.</source>
        <translation>Für scharfe Außenkanten. Die Wände auf beiden Seiten einer Kante anklicken, oder eine Wand für alle ihre Kanten. Es nimmt Material ab; Lasten und Lager auf den Wänden bleiben.</translation>
    </message>
    <message>
        <source>Pick any one side: the other sides, the top and the fillets that belong to it are found, and the surface under it runs on. Loads and supports on what is taken off go with it, unless the form says otherwise.</source>
        <translation>Irgendeine Seite anklicken: Die anderen Seiten, das Ende und die Ausrundungen, die dazugehören, werden gefunden, und die Fläche darunter läuft weiter. Lasten und Lager auf dem, was abgenommen wird, gehen mit, wenn das Formular nichts anderes sagt.</translation>
    </message>
    <message>
        <source>The surfaces keep their names, so loads and supports on them stay. Pick both halves of a bore together. Where something is in the way, the edit is refused with the greatest thickness that works.</source>
        <translation>Die Flächen behalten ihre Namen, Lasten und Lager darauf bleiben also. Beide Hälften einer Bohrung zusammen auswählen. Wo etwas im Weg ist, wird die Änderung mit der größten Dicke abgelehnt, die geht.</translation>
    </message>
    <message>
        <source>thickness taken off</source>
        <translation>abgetragene Dicke</translation>
    </message>
    <message>
        <source>taken off at the least exact place</source>
        <translation>abgetragen an der ungenauesten Stelle</translation>
    </message>
    <message>
        <source>pieces, of 1 body</source>
        <translation>Stücke, aus 1 Körper</translation>
    </message>
    <message>
        <source>pieces, of %1 bodies</source>
        <translation>Stücke, aus %1 Körpern</translation>
    </message>
    <message>
        <source>hinges repaired</source>
        <translation>ausgebesserte Scharnierkanten</translation>
    </message>
    <message>
        <source>crumbs dropped</source>
        <translation>entfernte Krümel</translation>
    </message>
    <message>
        <source>of the part&apos;s volume</source>
        <translation>des Volumens des Teils</translation>
    </message>
    <message>
        <source>runs of edges rounded</source>
        <translation>gerundete Kantenzüge</translation>
    </message>
    <message>
        <source>facets over each arc</source>
        <translation>Facetten über jeden Bogen</translation>
    </message>
    <message>
        <source>put on at the least exact place</source>
        <translation>aufgetragen an der ungenauesten Stelle</translation>
    </message>
    <message>
        <source>change of the radius, fitted</source>
        <translation>Änderung des Radius, angepasst</translation>
    </message>
    <message>
        <source>thickness put on</source>
        <translation>aufgetragene Dicke</translation>
    </message>
</context>
<context>
    <name>operations_manual</name>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Anklicken</translation>
    </message>
</context>
<context>
    <name>overlay</name>
    <message>
        <source>99 % of the area</source>
        <translation>99 % der Fläche</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
</context>
<context>
    <name>places</name>
    <message>
        <source>inside, %1 from %2</source>
        <translation>innen, %1 von %2</translation>
    </message>
    <message>
        <source>where %1 surfaces meet, %2 among them</source>
        <translation>wo %1 Flächen zusammenstoßen, darunter %2</translation>
    </message>
    <message>
        <source>where %1 and %2 meet</source>
        <translation>wo %1 und %2 zusammenstoßen</translation>
    </message>
</context>
<context>
    <name>preview</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Tets</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>%1 (%2 new, %3 gone)</source>
        <translation>%1 (%2 neu, %3 weg)</translation>
    </message>
    <message>
        <source>Worst tet here</source>
        <translation>Schlechteste Form</translation>
    </message>
    <message>
        <source>%1 before, %2 then</source>
        <translation>vorher %1, dann %2</translation>
    </message>
    <message>
        <source>All loads and supports stay as they are.</source>
        <translation>Alle Lasten und Lager bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Loads and supports that change: %1</source>
        <translation>Lasten und Lager, die sich ändern: %1</translation>
    </message>
</context>
<context>
    <name>quantities</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>reactions</name>
    <message>
        <source>%1 and %2 more surfaces</source>
        <translation>%1 und %2 weitere Flächen</translation>
    </message>
    <message>
        <source>Sum of the reactions</source>
        <translation>Summe der Reaktionen</translation>
    </message>
    <message>
        <source>The loads are %1, %2: %3 are not balanced. Do not trust this solve.</source>
        <translation>Die Lasten sind %1, %2: %3 sind nicht im Gleichgewicht. Dieser Lösung ist nicht zu trauen.</translation>
    </message>
    <message>
        <source>balances the loads</source>
        <translation>im Gleichgewicht mit den Lasten</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>entlang %1</translation>
    </message>
    <message>
        <source>Reaction of a support</source>
        <translation>Reaktion eines Lagers</translation>
    </message>
    <message>
        <source>Reaction: %1</source>
        <translation>Reaktion: %1</translation>
    </message>
</context>
<context>
    <name>receipt</name>
    <message>
        <source>Surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>new, %1</source>
        <translation>neu, %1</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>entfallen</translation>
    </message>
    <message>
        <source>merged into surface %1</source>
        <translation>in Fläche %1 aufgegangen</translation>
    </message>
    <message>
        <source>split from surface %1</source>
        <translation>von Fläche %1 abgetrennt</translation>
    </message>
    <message>
        <source>area %1</source>
        <translation>Inhalt %1</translation>
    </message>
    <message>
        <source>There are no loads yet.</source>
        <translation>Es gibt noch keine Lasten.</translation>
    </message>
    <message>
        <source>All loads and supports are as before.</source>
        <translation>Alle Lasten und Lager sind wie zuvor.</translation>
    </message>
    <message>
        <source>Loads and supports that changed: %1</source>
        <translation>Lasten und Lager, die sich geändert haben: %1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Tets</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>%1 new, %2 gone</source>
        <translation>%1 neu, %2 entfallen</translation>
    </message>
    <message>
        <source>Worst tet here</source>
        <translation>Schlechtestes Tetraeder hier</translation>
    </message>
    <message>
        <source>%1 before, %2 now</source>
        <translation>vorher %1, jetzt %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1, made by the preview (operation %2, mesh %3, checks %4)</source>
        <translation>%1, von der Vorschau gerechnet (Operation %2, Netz %3, Prüfungen %4)</translation>
    </message>
    <message>
        <source>%1 (operation %2, mesh %3, checks %4)</source>
        <translation>%1 (Operation %2, Netz %3, Prüfungen %4)</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
</context>
<context>
    <name>receipt_words</name>
    <message>
        <source>Fixed</source>
        <translation>Fest eingespannt</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Roller</source>
        <translation>Rollenlager</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Traction</source>
        <translation>Flächenlast</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Remote force</source>
        <translation>Entfernte Kraft</translation>
    </message>
    <message>
        <source>Bearing force</source>
        <translation>Lagerkraft</translation>
    </message>
    <message>
        <source>%1 (load %2)</source>
        <translation>%1 (Last %2)</translation>
    </message>
    <message>
        <source>%1 (support %2)</source>
        <translation>%1 (Lager %2)</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>surfaces %1</source>
        <translation>Flächen %1</translation>
    </message>
    <message>
        <source>%1 in all, as before</source>
        <translation>%1 insgesamt, wie zuvor</translation>
    </message>
    <message>
        <source>%1 in all instead of %2</source>
        <translation>%1 insgesamt statt %2</translation>
    </message>
    <message>
        <source>%1 is as before</source>
        <translation>%1 ist wie zuvor</translation>
    </message>
    <message>
        <source>%1: its surfaces have %2 now</source>
        <translation>%1: Ihre Flächen haben jetzt %2</translation>
    </message>
    <message>
        <source>%1 lost %2 and acts on %3 now</source>
        <translation>%1 hat %2 verloren und wirkt jetzt auf %3</translation>
    </message>
    <message>
        <source>%1 no longer acts: it lost %2</source>
        <translation>%1 wirkt nicht mehr: verloren ist %2</translation>
    </message>
    <message>
        <source>%1 lost %2, its share moved to %3</source>
        <translation>%1 hat %2 verloren, der Anteil ging an %3</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>%1 (%2 tets; %3)</source>
        <translation>%1 (%2 Tetraeder; %3)</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erstellt mit</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>the whole part</source>
        <translation>das ganze Teil</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Yield strength</source>
        <translation>Streckgrenze</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Linear tets: a preview. They are too stiff in bending, so displacements and stresses come out too small.</source>
        <translation>Lineare Tetraeder: eine Vorschau. Sie sind zu biegesteif, Verschiebungen und Spannungen fallen zu klein aus.</translation>
    </message>
    <message>
        <source>Quadratic tets, but a preview: the solver had not converged to its usual tolerance.</source>
        <translation>Quadratische Tetraeder, aber eine Vorschau: Der Löser war noch nicht bis zu seiner üblichen Toleranz konvergiert.</translation>
    </message>
    <message>
        <source>Quadratic tets, converged: final for this mesh.</source>
        <translation>Quadratische Tetraeder, konvergiert: endgültig für dieses Netz.</translation>
    </message>
    <message>
        <source>Places where the stress grows with every refinement of the mesh, so that it is no measure of strength (rims of clamps, sharp inner edges): %1.</source>
        <translation>Stellen, an denen die Spannung mit jeder Verfeinerung des Netzes wächst, so dass sie kein Maß der Festigkeit ist (Ränder von Einspannungen, scharfe Innenkanten): %1.</translation>
    </message>
    <message>
        <source>rim of a clamp</source>
        <translation>Rand einer Einspannung</translation>
    </message>
    <message>
        <source>sharp inner edge</source>
        <translation>scharfe Innenkante</translation>
    </message>
    <message>
        <source>Estimated error of the stresses in the energy norm: %1; %2.</source>
        <translation>Geschätzter Fehler der Spannungen in der Energienorm: %1; %2.</translation>
    </message>
    <message>
        <source>Residual of the equations: %1; unknowns: %2; computed on %3.</source>
        <translation>Residuum der Gleichungen: %1; Unbekannte: %2; gerechnet auf %3.</translation>
    </message>
    <message>
        <source>Load cases</source>
        <translation>Lastfälle</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Volume change</source>
        <translation>Volumenänderung</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Largest stress</source>
        <translation>Größte Spannung</translation>
    </message>
    <message>
        <source>What to trust</source>
        <translation>Was davon zu halten ist</translation>
    </message>
    <message>
        <source>Linear elasticity: small displacements, no yielding, no contact, no fatigue. A safety factor compares with the yield strength only.</source>
        <translation>Lineare Elastizität: kleine Verschiebungen, kein Fließen, kein Kontakt, keine Ermüdung. Ein Sicherheitsfaktor vergleicht nur mit der Streckgrenze.</translation>
    </message>
    <message>
        <source>Version %1: %2</source>
        <translation>Version %1: %2</translation>
    </message>
    <message>
        <source>What the edits said</source>
        <translation>Was die Änderungen meldeten</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
</context>
<context>
    <name>results</name>
    <message>
        <source>At the rim of a clamp: </source>
        <translation>Am Rand einer Einspannung: </translation>
    </message>
    <message>
        <source>At a sharp inner edge: </source>
        <translation>An einer scharfen Innenkante: </translation>
    </message>
    <message>
        <source>the value grows with every refinement of the mesh; it is no measure of strength.</source>
        <translation>Der Wert wächst mit jeder Verfeinerung des Netzes; er ist kein Maß der Festigkeit.</translation>
    </message>
    <message>
        <source>the value falls with every refinement of the mesh; it says nothing.</source>
        <translation>Der Wert fällt mit jeder Verfeinerung des Netzes; er sagt nichts aus.</translation>
    </message>
    <message>
        <source>There is no stress: the supports take the loads whole.</source>
        <translation>Es gibt keine Spannung: Die Lager nehmen die Lasten ganz auf.</translation>
    </message>
    <message>
        <source>Largest von Mises stress</source>
        <translation>Größte Vergleichsspannung (von Mises)</translation>
    </message>
    <message>
        <source>Largest apart from such places</source>
        <translation>Größte abseits solcher Stellen</translation>
    </message>
    <message>
        <source>on the surface; right beside such a place it still leans on the mesh</source>
        <translation>auf der Oberfläche; gleich neben einer solchen Stelle hängt sie noch vom Netz ab</translation>
    </message>
    <message>
        <source>Largest displacement</source>
        <translation>Größte Verschiebung</translation>
    </message>
    <message>
        <source>Least safety factor</source>
        <translation>Kleinster Sicherheitsfaktor</translation>
    </message>
    <message>
        <source>Below 1: the material yields there.</source>
        <translation>Unter 1: Der Werkstoff fließt dort.</translation>
    </message>
    <message>
        <source>No safety factor: no yield strength is known. Give the material one in &quot;Loads and supports&quot;.</source>
        <translation>Kein Sicherheitsfaktor: Keine Streckgrenze ist bekannt. Geben Sie dem Werkstoff eine in „Lasten und Lager“.</translation>
    </message>
    <message>
        <source>The safety factor is that of materials with a yield strength; others have none yet.</source>
        <translation>Der Sicherheitsfaktor gilt für Werkstoffe mit Streckgrenze; andere haben noch keine.</translation>
    </message>
    <message>
        <source>No mass: a density is missing. Give the material one in &quot;Loads and supports&quot;.</source>
        <translation>Keine Masse: Eine Dichte fehlt. Geben Sie dem Werkstoff eine in „Lasten und Lager“.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Estimated error of the stresses</source>
        <translation>Geschätzter Fehler der Spannungen</translation>
    </message>
    <message>
        <source>Worst of %1 load cases</source>
        <translation>Schlimmstes aus %1 Lastfällen</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>Version %1: </source>
        <translation>Version %1: </translation>
    </message>
    <message>
        <source>preview, the solver still converges</source>
        <translation>Vorschau, der Löser konvergiert noch</translation>
    </message>
    <message>
        <source>preview: linear tets are too stiff in bending</source>
        <translation>Vorschau: Lineare Tetraeder sind zu biegesteif</translation>
    </message>
    <message>
        <source>preview: stopped at a coarse tolerance</source>
        <translation>Vorschau: bei grober Toleranz beendet</translation>
    </message>
    <message>
        <source>final</source>
        <translation>endgültig</translation>
    </message>
    <message>
        <source>Open a part: its figures stand here once it is solved.</source>
        <translation>Öffnen Sie ein Teil: Seine Kennwerte stehen hier, sobald es gelöst ist.</translation>
    </message>
    <message>
        <source>The solve failed. </source>
        <translation>Die Lösung ist gescheitert. </translation>
    </message>
    <message>
        <source>Change the loads or supports, or solve again (F5).</source>
        <translation>Ändern Sie Lasten oder Lager, oder lösen Sie noch einmal (F5).</translation>
    </message>
    <message>
        <source>The solver was stopped. Solve again (F5).</source>
        <translation>Der Löser wurde angehalten. Lösen Sie noch einmal (F5).</translation>
    </message>
    <message>
        <source>There are no loads yet. Add supports and loads in &quot;Loads and supports&quot;.</source>
        <translation>Es gibt noch keine Lasten. Fügen Sie Lager und Lasten in „Lasten und Lager“ hinzu.</translation>
    </message>
    <message>
        <source>The part is not solved yet. Solve it (F5).</source>
        <translation>Das Teil ist noch nicht gelöst. Lösen Sie es (F5).</translation>
    </message>
    <message>
        <source>The solver runs; first figures come as a preview.</source>
        <translation>Der Löser läuft; erste Kennwerte kommen als Vorschau.</translation>
    </message>
    <message>
        <source>good: on average stresses are within about %1 %</source>
        <translation>gut: Im Mittel stimmen die Spannungen auf etwa %1 %</translation>
    </message>
    <message>
        <source>fair: good enough to compare variants; peaks may be off by more</source>
        <translation>mäßig: gut genug, um Varianten zu vergleichen; Spitzen können weiter daneben liegen</translation>
    </message>
    <message>
        <source>rough: trust displacements, not single stresses</source>
        <translation>grob: Verschiebungen sind brauchbar, einzelne Spannungen nicht</translation>
    </message>
    <message>
        <source>poor: the mesh is too coarse for these stresses</source>
        <translation>schlecht: Das Netz ist zu grob für diese Spannungen</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
</context>
<context>
    <name>results_table</name>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Load case</source>
        <translation>Lastfall</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::about_dialog</name>
    <message>
        <source>About TEdit</source>
        <translation>Über TEdit</translation>
    </message>
    <message>
        <source>Edits tetrahedral meshes of parts and shows the new stress at once.

TEdit is free software under the GNU Affero General Public License, version 3 or (at your option) any later version. It comes without any warranty. Whoever lets others use a changed TEdit over a network must offer them its source.</source>
        <translation>Ändert Tetraedernetze von Bauteilen und zeigt sofort die neue Spannung.

TEdit ist freie Software unter der GNU Affero General Public License, Version 3 oder (nach Ihrer Wahl) jeder späteren Version. Es gibt keinerlei Gewährleistung. Wer andere ein geändertes TEdit über ein Netzwerk benutzen lässt, muss ihnen dessen Quelltext anbieten.</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>Verwendete Bibliotheken</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Wofür</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::banner</name>
    <message>
        <source>Where: %1</source>
        <translation>Wo: %1</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 did not work</source>
        <translation>%1 ist nicht gelungen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::command_palette</name>
    <message>
        <source>Search commands and operations</source>
        <translation>Befehle und Operationen suchen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::compare_tool</name>
    <message>
        <source>Compare with the version before</source>
        <translation>Mit der Version davor vergleichen</translation>
    </message>
    <message>
        <source>Side by side with linked cameras, or their difference</source>
        <translation>Nebeneinander mit gekoppelter Ansicht oder als Differenz</translation>
    </message>
    <message>
        <source>Comparison: difference or side by side</source>
        <translation>Vergleich: Differenz oder nebeneinander</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::compare_view</name>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translation>Zurück (Esc)</translation>
    </message>
    <message>
        <source>Go to version %1</source>
        <translation>Zu Version %1 gehen</translation>
    </message>
    <message>
        <source>v%1 minus v%2, on the surface of v%1; dark grey: not in both</source>
        <translation>v%1 minus v%2, auf der Oberfläche von v%1; dunkelgrau: nicht in beiden</translation>
    </message>
    <message>
        <source>  (preview)</source>
        <translation>  (Vorschau)</translation>
    </message>
    <message>
        <source> (no difference)</source>
        <translation> (kein Unterschied)</translation>
    </message>
    <message>
        <source>  (not solved here)</source>
        <translation>  (hier nicht gelöst)</translation>
    </message>
    <message>
        <source>Version %1 is being fetched.</source>
        <translation>Version %1 wird geholt.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::connection_tool</name>
    <message>
        <source>Start the server</source>
        <translation>Server starten</translation>
    </message>
    <message>
        <source>connected to %1</source>
        <translation>verbunden mit %1</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>The connection to the server is lost. It is taken up again by itself; nothing that was done is lost.</source>
        <translation>Die Verbindung zum Server ist unterbrochen. Sie wird von selbst wieder aufgenommen; nichts von dem, was getan wurde, geht verloren.</translation>
    </message>
    <message>
        <source>The connection is slow: the server has not answered for %1. What was asked for goes on when it does, and can be cancelled.</source>
        <translation>Die Verbindung ist langsam: der Server antwortet seit %1 nicht. Was angefordert wurde, geht weiter, sobald er antwortet, und kann abgebrochen werden.</translation>
    </message>
    <message>
        <source>Connect to a server</source>
        <translation>Mit einem Server verbinden</translation>
    </message>
    <message>
        <source>Address and token, as &quot;tedit serve&quot; prints them: ws://HOST:PORT/v1 TOKEN</source>
        <translation>Adresse und Token, wie „tedit serve“ sie ausgibt: ws://HOST:PORT/v1 TOKEN</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::context_panel</name>
    <message>
        <source>+ smooth</source>
        <translation>+ glatte</translation>
    </message>
    <message>
        <source>Add all surfaces that continue these without an edge</source>
        <translation>Alle Flächen dazunehmen, die diese ohne Kante fortsetzen</translation>
    </message>
    <message>
        <source>+ tangent neighbours</source>
        <translation>+ tangentiale Nachbarn</translation>
    </message>
    <message>
        <source>Add the surfaces next to these</source>
        <translation>Die Nachbarflächen dazunehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Click a surface of the part: a bore, a rib or a wall is picked whole. Click again for the single surface; Shift adds. Ctrl+drag draws a box.</source>
        <translation>Auf eine Fläche des Bauteils klicken: Bohrung, Rippe oder Wand wird als Ganzes ausgewählt. Ein zweiter Klick nimmt die einzelne Fläche, Umschalt nimmt dazu. Strg+Ziehen spannt ein Rechteck auf.</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> und %1 weitere</translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation>Flächen: %1</translation>
    </message>
    <message>
        <source>
Area %1</source>
        <translation>
Inhalt %1</translation>
    </message>
    <message>
        <source>The server does not offer this operation any more.</source>
        <translation>Der Server bietet diese Operation nicht mehr an.</translation>
    </message>
    <message>
        <source>Select: %1</source>
        <translation>Auswählen: %1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>This takes %1 % of the part&apos;s volume away.</source>
        <translation>Das nimmt %1 % des Teilevolumens weg.</translation>
    </message>
    <message>
        <source>Applied as soon as it is clear what it takes away.</source>
        <translation>Wird angewandt, sobald klar ist, was es wegnimmt.</translation>
    </message>
    <message>
        <source>Take %1 % of the part off</source>
        <translation>%1 % des Teils abtragen</translation>
    </message>
    <message>
        <source>Apply after this</source>
        <translation>Danach anwenden</translation>
    </message>
    <message>
        <source>Empty the queue</source>
        <translation>Warteschlange leeren</translation>
    </message>
    <message>
        <source>What runs goes on, what waits behind it is not made</source>
        <translation>Was läuft, geht weiter; was dahinter wartet, entfällt</translation>
    </message>
    <message>
        <source>Then: %1</source>
        <translation>Danach: %1</translation>
    </message>
    <message>
        <source>Enter in a field, or Ctrl+Enter</source>
        <translation>Eingabe in einem Feld, oder Strg+Eingabe</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::deformation_row</name>
    <message>
        <source>not deformed</source>
        <translation>unverformt</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>So large that the deformation is seen, for each load case</source>
        <translation>So groß, dass die Verformung zu sehen ist, für jeden Lastfall</translation>
    </message>
    <message>
        <source>Swings between the part without load and the deformed one</source>
        <translation>Schwingt zwischen dem Teil ohne Last und dem verformten</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Automatic deformation</source>
        <translation>Automatische Verformung</translation>
    </message>
    <message>
        <source>Animate the deformation</source>
        <translation>Verformung bewegen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::document</name>
    <message>
        <source>Surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>The list of operations did not come: %1</source>
        <translation>Die Liste der Operationen kam nicht an: %1</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::document_keeping</name>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Nothing to do: each step is kept when it is made. Says where.</source>
        <translation>Nichts zu tun: Jeder Schritt ist gesichert, sobald er getan ist. Sagt, wo.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Kopie sichern</translation>
    </message>
    <message>
        <source>All versions and loads in one file, to mail or to put aside</source>
        <translation>Alle Versionen und Lasten in einer Datei, zum Verschicken oder Weglegen</translation>
    </message>
    <message>
        <source>Show where the document is</source>
        <translation>Zeigen, wo das Dokument liegt</translation>
    </message>
    <message>
        <source>Opens its folder</source>
        <translation>Öffnet seinen Ordner</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>Everything is safe already: each step is kept when it is made. This is version %1 of %2.</source>
        <translation>Alles ist schon gesichert: Jeder Schritt wird gesichert, sobald er getan ist. Dies ist Version %1 von %2.</translation>
    </message>
    <message>
        <source>Save a copy of the document</source>
        <translation>Kopie des Dokuments sichern</translation>
    </message>
    <message>
        <source>TEdit documents (*.tedit)</source>
        <translation>TEdit-Dokumente (*.tedit)</translation>
    </message>
    <message>
        <source>Rename the document</source>
        <translation>Dokument umbenennen</translation>
    </message>
    <message>
        <source>For all who have it open; its versions, probes and pictures go with it</source>
        <translation>Für alle, die es geöffnet haben; Versionen, Messpunkte und Bilder gehen mit</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::documents_tool</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>A mesh with its load cases, a document, or a recipe, which is run</source>
        <translation>Ein Netz mit seinen Lastfällen, ein Dokument oder ein Rezept, das ausgeführt wird</translation>
    </message>
    <message>
        <source>Connect to a server</source>
        <translation>Mit einem Server verbinden</translation>
    </message>
    <message>
        <source>Close the part</source>
        <translation>Bauteil schließen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation>öffne %1</translation>
    </message>
    <message>
        <source>the last session was not closed; opening %1 again</source>
        <translation>die letzte Sitzung wurde nicht beendet; %1 wird wieder geöffnet</translation>
    </message>
    <message>
        <source>Open a mesh and its load cases, a document or a recipe</source>
        <translation>Netz mit Lastfällen, Dokument oder Rezept öffnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Writes the part as a file for other programs: the mesh, its boundary or its fields</source>
        <translation>Schreibt das Teil als Datei für andere Programme: das Netz, seine Oberfläche oder seine Felder</translation>
    </message>
    <message>
        <source>Meshes, load cases, recipes, documents (%1)</source>
        <translation>Netze, Lastfälle, Rezepte, Dokumente (%1)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::edit_requests</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Go to version %1</source>
        <translation>Zu Version %1 gehen</translation>
    </message>
    <message>
        <source>Name the version</source>
        <translation>Version benennen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::field_panel</name>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation>Kalt bis warm</translation>
    </message>
    <message>
        <source>Safety steps</source>
        <translation>Sicherheitsstufen</translation>
    </message>
    <message>
        <source>Colours that flow, or steps of one colour each</source>
        <translation>Fließende Farben oder Stufen von je einer Farbe</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Fließend</translation>
    </message>
    <message>
        <source>%1 bands</source>
        <translation>%1 Stufen</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Isolinien</translation>
    </message>
    <message>
        <source>Lines of equal value on the surface, at the edges of the bands</source>
        <translation>Linien gleichen Werts auf der Oberfläche, an den Grenzen der Stufen</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Wie eingegeben</translation>
    </message>
    <message>
        <source>Locked across versions</source>
        <translation>Fest für alle Versionen</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Load case</source>
        <translation>Lastfall</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>No yield strength is known: give the material one in &quot;Loads and supports&quot;.</source>
        <translation>Es ist keine Streckgrenze bekannt: dem Werkstoff unter „Lasten und Lager“ eine geben.</translation>
    </message>
    <message>
        <source>Envelope of all</source>
        <translation>Einhüllende aller</translation>
    </message>
    <message>
        <source>Loading: the server was asked for it.</source>
        <translation>Wird geladen: der Server wurde danach gefragt.</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>wird geladen</translation>
    </message>
    <message>
        <source>99 % of the area</source>
        <translation>99 % der Fläche</translation>
    </message>
    <message>
        <source>Full range</source>
        <translation>Ganzer Bereich</translation>
    </message>
    <message>
        <source>The hundredth of the surface with the largest values has the colour of the upper end: one hot corner leaves colours for the rest</source>
        <translation>Das Hundertstel der Oberfläche mit den größten Werten hat die Farbe des oberen Endes: Eine heiße Ecke lässt Farben für den Rest übrig</translation>
    </message>
    <message>
        <source>No result is shown: choose one above as the field</source>
        <translation>Gezeigt wird kein Ergebnis: oben eines als Feld wählen</translation>
    </message>
    <message>
        <source>The safety steps have the same colours everywhere</source>
        <translation>Die Sicherheitsstufen haben überall dieselben Farben</translation>
    </message>
    <message>
        <source>Values with a sign have no logarithm</source>
        <translation>Werte mit Vorzeichen haben keinen Logarithmus</translation>
    </message>
    <message>
        <source>Choose the range &quot;As typed&quot; to type it</source>
        <translation>Zum Eintippen den Bereich „Wie eingegeben“ wählen</translation>
    </message>
    <message>
        <source>The envelope of all load cases has no deformation: choose one of them</source>
        <translation>Die Einhüllende aller Lastfälle hat keine Verformung: einen davon wählen</translation>
    </message>
    <message>
        <source>For the safety factor only</source>
        <translation>Nur für den Sicherheitsfaktor</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::file_requests</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>Set the load cases</source>
        <translation>Lastfälle setzen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::finder_popup</name>
    <message>
        <source>What fits</source>
        <translation>Was passt</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::foreground_work</name>
    <message>
        <source>cancelling</source>
        <translation>wird abgebrochen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::help_panel</name>
    <message>
        <source>Search the help</source>
        <translation>In der Hilfe suchen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>This window</source>
        <translation>Dieses Fenster</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Improving a mesh</source>
        <translation>Netz verbessern</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>In the browser</source>
        <translation>Im Browser</translation>
    </message>
    <message>
        <source>The same page, with its pictures</source>
        <translation>Dieselbe Seite, mit ihren Bildern</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::help_tool</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>The manual: the page for what is being done, with a search</source>
        <translation>Das Handbuch: die Seite zu dem, was gerade getan wird, mit Suche</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>All commands with their keys, to look up and to change</source>
        <translation>Alle Befehle mit ihren Tasten, zum Nachsehen und Ändern</translation>
    </message>
    <message>
        <source>About TEdit</source>
        <translation>Über TEdit</translation>
    </message>
    <message>
        <source>Version, licence, libraries</source>
        <translation>Version, Lizenz, Bibliotheken</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::history_strip</name>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>%1 tets</source>
        <translation>%1 Tetraeder</translation>
    </message>
    <message>
        <source>mass %1</source>
        <translation>Masse %1</translation>
    </message>
    <message>
        <source>volume %1</source>
        <translation>Volumen %1</translation>
    </message>
    <message>
        <source>worst tet where it changed: %1 before, %2 now</source>
        <translation>schlechtestes Tetraeder im geänderten Bereich: vorher %1, jetzt %2</translation>
    </message>
    <message>
        <source>Go to this version (Enter)</source>
        <translation>Zu dieser Version gehen (Eingabe)</translation>
    </message>
    <message>
        <source>Name and note ... (F2)</source>
        <translation>Name und Notiz … (F2)</translation>
    </message>
    <message>
        <source>Compare with version %1</source>
        <translation>Mit Version %1 vergleichen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::history_tool</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Name and note of a version</source>
        <translation>Name und Notiz einer Version</translation>
    </message>
    <message>
        <source>Of the one that is chosen in the history</source>
        <translation>Von der, die im Verlauf gewählt ist</translation>
    </message>
    <message>
        <source>The last edit, or the last change of loads</source>
        <translation>Die letzte Änderung am Teil oder an den Lasten</translation>
    </message>
    <message>
        <source>What was undone last</source>
        <translation>Was zuletzt rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Go to version %1</source>
        <translation>Gehe zu Version %1</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::jobs_button</name>
    <message>
        <source>What runs, and how the server is</source>
        <translation>Was läuft und wie es dem Server geht</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>  (%1 run)</source>
        <translation>  (%1 laufen)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::jobs_panel</name>
    <message>
        <source>Nothing runs.</source>
        <translation>Nichts läuft.</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>just begun</source>
        <translation>gerade begonnen</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>, running and waiting: %1</source>
        <translation>, laufend und wartend: %1</translation>
    </message>
    <message>
        <source>, started again: %1</source>
        <translation>, neu gestartet: %1</translation>
    </message>
    <message>
        <source>open documents: %1, connections: %2</source>
        <translation>offene Dokumente: %1, Verbindungen: %2</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Bearbeitungen</translation>
    </message>
    <message>
        <source>Mesh improvement</source>
        <translation>Netzverbesserung</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>startet</translation>
    </message>
    <message>
        <source>out of order</source>
        <translation>außer Betrieb</translation>
    </message>
    <message>
        <source>Nothing of yours runs.</source>
        <translation>Von Ihnen läuft nichts.</translation>
    </message>
    <message>
        <source>The server still solves %1, which was open here before.</source>
        <translation>Der Server rechnet noch an %1, das hier vorher offen war.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::jobs_tool</name>
    <message>
        <source>What runs</source>
        <translation>Was läuft</translation>
    </message>
    <message>
        <source>Jobs with their progress, and the server&apos;s workers</source>
        <translation>Aufträge mit ihrem Fortschritt und die Arbeitsprozesse des Servers</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::legend_strip</name>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::load_editor</name>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>New load</source>
        <translation>Neue Last</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Typical values; take those of your data sheet for a real design</source>
        <translation>Übliche Werte; für eine echte Auslegung die des Datenblatts nehmen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Name des Werkstoffs</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Yield</source>
        <translation>Streckgr.</translation>
    </message>
    <message>
        <source>Regions of the mesh</source>
        <translation>Bereiche des Netzes</translation>
    </message>
    <message>
        <source>all that no other material names</source>
        <translation>alle, die kein anderer Werkstoff nennt</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest eingespannt</translation>
    </message>
    <message>
        <source>Displaced by ...</source>
        <translation>Verschoben um …</translation>
    </message>
    <message>
        <source>Roller: slides, no lifting</source>
        <translation>Gleitlager: gleitet, hebt nicht ab</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Not ticked: free to move this way</source>
        <translation>Ohne Haken: in dieser Richtung frei</translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation>Flächen: %1</translation>
    </message>
    <message>
        <source>Give numbers of regions, with commas between</source>
        <translation>Nummern von Bereichen eingeben, mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>No surfaces yet: click them, Shift adds</source>
        <translation>Noch keine Flächen: anklicken, Umschalt fügt hinzu</translation>
    </message>
    <message>
        <source>Click surfaces of the part; Shift adds. %1</source>
        <translation>Flächen des Teils anklicken; Umschalt fügt hinzu. %1</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>Yield strength</source>
        <translation>Streckgrenze</translation>
    </message>
    <message>
        <source>Displacement %1</source>
        <translation>Verschiebung %1</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::load_form</name>
    <message>
        <source>Force, spread over the surfaces</source>
        <translation>Kraft, über die Flächen verteilt</translation>
    </message>
    <message>
        <source>Force along the normal</source>
        <translation>Kraft längs der Normalen</translation>
    </message>
    <message>
        <source>Positive pushes on the part, negative pulls</source>
        <translation>Positiv drückt auf das Bauteil, negativ zieht</translation>
    </message>
    <message>
        <source>Pressure, along the normal</source>
        <translation>Druck, längs der Normalen</translation>
    </message>
    <message>
        <source>Bearing: a pin presses on its bore</source>
        <translation>Lager: Ein Bolzen drückt auf seine Bohrung</translation>
    </message>
    <message>
        <source>The force of the pin, across the bore; only the half that it faces carries</source>
        <translation>Die Kraft des Bolzens quer zur Bohrung; nur die Hälfte, auf die er drückt, trägt</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Turns about this direction, right-handed</source>
        <translation>Dreht um diese Richtung, rechtshändig</translation>
    </message>
    <message>
        <source>Remote force, at a place apart</source>
        <translation>Kraft an einem fernen Ort</translation>
    </message>
    <message>
        <source>As if a rigid lever led from the place to the surfaces</source>
        <translation>Als führte ein starrer Hebel von dem Ort zu den Flächen</translation>
    </message>
    <message>
        <source>Traction, per area</source>
        <translation>Flächenlast, je Flächeneinheit</translation>
    </message>
    <message>
        <source>Gravity, on all mass</source>
        <translation>Schwerkraft, auf alle Massen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Component %1</source>
        <translation>Komponente %1</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Changes by place, as under a liquid</source>
        <translation>Ändert sich mit dem Ort, wie unter einer Flüssigkeit</translation>
    </message>
    <message>
        <source>Grows by</source>
        <translation>Wächst um</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Ort %1</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Ort</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::load_requests</name>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>Set the load cases</source>
        <translation>Lastfälle setzen</translation>
    </message>
    <message>
        <source>Remove the load case</source>
        <translation>Lastfall entfernen</translation>
    </message>
    <message>
        <source>Rename the load case</source>
        <translation>Lastfall umbenennen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::loads_panel</name>
    <message>
        <source>Load cases</source>
        <translation>Lastfälle</translation>
    </message>
    <message>
        <source>+ Support</source>
        <translation>+ Lager</translation>
    </message>
    <message>
        <source>Hold the surfaces that are picked</source>
        <translation>Die ausgewählten Flächen festhalten</translation>
    </message>
    <message>
        <source>+ Load</source>
        <translation>+ Last</translation>
    </message>
    <message>
        <source>Load the surfaces that are picked</source>
        <translation>Die ausgewählten Flächen belasten</translation>
    </message>
    <message>
        <source>+ Material</source>
        <translation>+ Werkstoff</translation>
    </message>
    <message>
        <source>What the part is made of</source>
        <translation>Woraus das Bauteil besteht</translation>
    </message>
    <message>
        <source>+ Load case</source>
        <translation>+ Lastfall</translation>
    </message>
    <message>
        <source>Another set of materials, supports and loads</source>
        <translation>Ein weiterer Satz aus Werkstoffen, Lagern und Lasten</translation>
    </message>
    <message>
        <source>%1 has changes that the server has not taken yet.</source>
        <translation>%1 hat Änderungen, die der Server noch nicht übernommen hat.</translation>
    </message>
    <message>
        <source>%1 is not solved yet; it still needs %2.</source>
        <translation>%1 ist noch nicht gerechnet; es fehlt noch: %2.</translation>
    </message>
    <message>
        <source>%1 is solved too. It was set before this window opened the document, so its items are not known here.</source>
        <translation>%1 wird auch gerechnet. Der Lastfall wurde gesetzt, bevor dieses Fenster das Dokument öffnete; seine Einträge sind hier nicht bekannt.</translation>
    </message>
    <message>
        <source>No loads yet. Pick surfaces of the part, then add a support and a load.</source>
        <translation>Noch keine Lasten. Flächen des Bauteils auswählen, dann ein Lager und eine Last anlegen.</translation>
    </message>
    <message>
        <source>  · reduced</source>
        <translation>  · verkleinert</translation>
    </message>
    <message>
        <source>  · area changed</source>
        <translation>  · Flächeninhalt geändert</translation>
    </message>
    <message>
        <source>Surfaces: %1</source>
        <translation>Flächen: %1</translation>
    </message>
    <message>
        <source>Double-click to change it</source>
        <translation>Doppelklick zum Ändern</translation>
    </message>
    <message>
        <source>Support dropped</source>
        <translation>Lager entfallen</translation>
    </message>
    <message>
        <source>Load dropped</source>
        <translation>Last entfallen</translation>
    </message>
    <message>
        <source>Change ...</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Add a support</source>
        <translation>Lager anlegen</translation>
    </message>
    <message>
        <source>Add a load</source>
        <translation>Last anlegen</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Werkstoff anlegen</translation>
    </message>
    <message>
        <source>Rename ...</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Discard what is not solved yet</source>
        <translation>Noch nicht Gerechnetes verwerfen</translation>
    </message>
    <message>
        <source>Remove the load case</source>
        <translation>Lastfall entfernen</translation>
    </message>
    <message>
        <source>Load case</source>
        <translation>Lastfall</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>Neuer Werkstoff</translation>
    </message>
    <message>
        <source>New support</source>
        <translation>Neues Lager</translation>
    </message>
    <message>
        <source>New load</source>
        <translation>Neue Last</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source> copy</source>
        <translation> (Kopie)</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::loads_tool</name>
    <message>
        <source>Loads and supports</source>
        <translation>Lasten und Lager</translation>
    </message>
    <message>
        <source>Show or hide loads and supports</source>
        <translation>Lasten und Lager ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Arrows and support marks of the load case that is shown</source>
        <translation>Pfeile und Lagersymbole des gezeigten Lastfalls</translation>
    </message>
    <message>
        <source>Add a support</source>
        <translation>Lager anlegen</translation>
    </message>
    <message>
        <source>Add a load</source>
        <translation>Last anlegen</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Werkstoff anlegen</translation>
    </message>
    <message>
        <source>New load case</source>
        <translation>Neuer Lastfall</translation>
    </message>
    <message>
        <source>Remove the chosen load, support or load case</source>
        <translation>Gewählte Last, gewähltes Lager oder gewählten Lastfall entfernen</translation>
    </message>
    <message>
        <source>What is chosen in &quot;Loads and supports&quot;</source>
        <translation>Was unter „Lasten und Lager“ gewählt ist</translation>
    </message>
    <message>
        <source>Choose one in &quot;Loads and supports&quot; first.</source>
        <translation>Wählen Sie erst etwas unter „Lasten und Lager“.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::local_server</name>
    <message>
        <source>it printed nothing</source>
        <translation>er hat nichts ausgegeben</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::log_panel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::main_window</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Hauptleiste</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Document %1</source>
        <translation>Dokument %1</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Cancel what runs</source>
        <translation>Abbrechen, was läuft</translation>
    </message>
    <message>
        <source>Search everything</source>
        <translation>Alles durchsuchen</translation>
    </message>
    <message>
        <source>All commands and operations</source>
        <translation>Alle Befehle und Operationen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::name_form</name>
    <message>
        <source>Name of the document</source>
        <translation>Name des Dokuments</translation>
    </message>
    <message>
        <source>Enter renames it, Esc leaves it</source>
        <translation>Eingabe benennt um, Esc verwirft</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::operations_tool</name>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Apply the operation</source>
        <translation>Operation anwenden</translation>
    </message>
    <message>
        <source>Waited behind it, so not made: %1</source>
        <translation>Wartete dahinter, also nicht ausgeführt: %1</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::overlay</name>
    <message>
        <source>min %1</source>
        <translation>min. %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max. %1</translation>
    </message>
    <message>
        <source>max %1, above the scale</source>
        <translation>max. %1, über der Skala</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::pictures_tool</name>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>The view with its legend as a PNG</source>
        <translation>Die Ansicht mit ihrer Legende als PNG</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::plot_panel</name>
    <message>
        <source>Shown field by area</source>
        <translation>Gezeigtes Feld über dem Flächeninhalt</translation>
    </message>
    <message>
        <source>Shown field between two probes</source>
        <translation>Gezeigtes Feld zwischen zwei Messpunkten</translation>
    </message>
    <message>
        <source>Tets that the edit touched, by quality</source>
        <translation>Tetraeder, die die Änderung berührt hat, nach Güte</translation>
    </message>
    <message>
        <source>No field is shown.</source>
        <translation>Es wird kein Feld gezeigt.</translation>
    </message>
    <message>
        <source>%1, v%2</source>
        <translation>%1, v%2</translation>
    </message>
    <message>
        <source>% of area</source>
        <translation>% des Flächeninhalts</translation>
    </message>
    <message>
        <source>Set two probes (P, then click the part).</source>
        <translation>Zwei Messpunkte setzen (P, dann auf das Bauteil klicken).</translation>
    </message>
    <message>
        <source>There is no field on this line.</source>
        <translation>Auf dieser Linie gibt es kein Feld.</translation>
    </message>
    <message>
        <source>Set the deformation to 0: the line runs through the part as it is.</source>
        <translation>Die Verformung auf 0 stellen: die Linie läuft durch das unverformte Bauteil.</translation>
    </message>
    <message>
        <source>%1 from probe %2 to %3</source>
        <translation>%1 von Messpunkt %2 bis %3</translation>
    </message>
    <message>
        <source>No edit has been made yet.</source>
        <translation>Es wurde noch nichts geändert.</translation>
    </message>
    <message>
        <source>This edit made and changed no tet.</source>
        <translation>Diese Bearbeitung hat kein Tetraeder neu gemacht oder geändert.</translation>
    </message>
    <message>
        <source>Worst tet: %1 before, %2 now; median now %3.
How many have which quality is counted by a thorough improvement only (&quot;Improve mesh&quot;).</source>
        <translation>Schlechtestes Tetraeder: vorher %1, jetzt %2; Median jetzt %3.
Wie viele welche Güte haben, zählt nur eine gründliche Verbesserung („Netz verbessern“).</translation>
    </message>
    <message>
        <source>Radius ratio of the tets, v%1; the outline: before</source>
        <translation>Radienverhältnis der Tetraeder, v%1; die Umrisslinie: vorher</translation>
    </message>
    <message>
        <source>radius ratio, 1 is best</source>
        <translation>Radienverhältnis, 1 ist das beste</translation>
    </message>
    <message>
        <source>% of tets</source>
        <translation>% der Tetraeder</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::policy_row</name>
    <message>
        <source>Loads and supports whose surface goes</source>
        <translation>Lasten und Lager, deren Fläche verschwindet</translation>
    </message>
    <message>
        <source>go with it</source>
        <translation>verschwinden mit ihr</translation>
    </message>
    <message>
        <source>move to what takes its place</source>
        <translation>gehen auf das über, was an ihre Stelle tritt</translation>
    </message>
    <message>
        <source>forbid the edit</source>
        <translation>verbieten die Änderung</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::preview_box</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Shows what the edit would make while its values move</source>
        <translation>Zeigt, was die Änderung ergäbe, während ihre Werte verstellt werden</translation>
    </message>
    <message>
        <source>Preview now</source>
        <translation>Jetzt Vorschau</translation>
    </message>
    <message>
        <source>Shows what these values would make</source>
        <translation>Zeigt, was diese Werte ergäben</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Making the preview</source>
        <translation>Vorschau wird gerechnet</translation>
    </message>
    <message>
        <source>Making the preview: %1</source>
        <translation>Vorschau wird gerechnet: %1</translation>
    </message>
    <message>
        <source>Not applied. Orange: new. Blue: taken away. Made in %1.</source>
        <translation>Nicht angewandt. Orange: neu. Blau: entfernt. Gerechnet in %1.</translation>
    </message>
    <message>
        <source>The part stays as it is.</source>
        <translation>Das Bauteil bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>The last preview took longer than %1: ask for it.</source>
        <translation>Die letzte Vorschau dauerte länger als %1: sie kommt nur auf Wunsch.</translation>
    </message>
    <message>
        <source>Find the most that works</source>
        <translation>Das Größte suchen, das geht</translation>
    </message>
    <message>
        <source>Looks for the largest value that the part takes, for up to 3 s</source>
        <translation>Sucht den größten Wert, der am Bauteil möglich ist, bis zu 3 s lang</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::probe_panel</name>
    <message>
        <source>Probes</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>surface gone</source>
        <translation>Fläche entfallen</translation>
    </message>
    <message>
        <source>At the nearest point of the same surface: its triangle was changed</source>
        <translation>Am nächsten Punkt derselben Fläche: sein Dreieck wurde geändert</translation>
    </message>
    <message>
        <source>P, then click places of the part. Two of them give a distance.</source>
        <translation>P, dann Stellen des Bauteils anklicken. Zwei davon ergeben einen Abstand.</translation>
    </message>
    <message>
        <source>A second probe gives the distance.</source>
        <translation>Ein zweiter Messpunkt ergibt den Abstand.</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>Abstand %1 bis %2: %3</translation>
    </message>
    <message>
        <source>The surface of one of them is gone.</source>
        <translation>Die Fläche von einem der beiden ist entfallen.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::probes_tool</name>
    <message>
        <source>Probes and plots</source>
        <translation>Messpunkte und Diagramme</translation>
    </message>
    <message>
        <source>Probe: values at places that are clicked</source>
        <translation>Messen: Werte an angeklickten Stellen</translation>
    </message>
    <message>
        <source>Numbered pins that stay over edits; two give a distance and a line</source>
        <translation>Nummerierte Punkte, die Änderungen überdauern; zwei ergeben einen Abstand und eine Linie</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Alle Messpunkte entfernen</translation>
    </message>
    <message>
        <source>The field by area, along a line, and the quality of tets</source>
        <translation>Das Feld über dem Flächeninhalt, längs einer Linie, und die Güte der Tetraeder</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::quantity_field</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>In %1, or typed with %2</source>
        <translation>In %1, oder eingegeben mit %2</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::receipt_panel</name>
    <message>
        <source>What this edit did</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>No edit has been made yet.</source>
        <translation>Es wurde noch nichts geändert.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::receipt_tool</name>
    <message>
        <source>What this edit did</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>%1: version %2 in %3</source>
        <translation>%1: Version %2 in %3</translation>
    </message>
    <message>
        <source>Loads and supports that this edit reduced or dropped: %1. See &quot;What this edit did&quot;.</source>
        <translation>Lasten und Lager, die diese Änderung verkleinert oder entfernt hat: %1. Siehe „Was sich geändert hat“.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::recent_documents</name>
    <message>
        <source>Go on with</source>
        <translation>Weiter mit</translation>
    </message>
    <message>
        <source>Documents that were open before</source>
        <translation>Dokumente, die früher offen waren</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1 was taken from the list; the document itself stays.</source>
        <translation>%1 wurde aus der Liste genommen; das Dokument selbst bleibt.</translation>
    </message>
    <message>
        <source>Open (Enter)</source>
        <translation>Öffnen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Take from this list (Del)</source>
        <translation>Aus der Liste nehmen (Entf)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::recipes_tool</name>
    <message>
        <source>Run the recipe %1</source>
        <translation>Rezept %1 ausführen</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: fertig</translation>
    </message>
    <message>
        <source>%1: stopped at %2</source>
        <translation>%1: angehalten bei %2</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>%1: done. Steps that write files (%2) were left out: export by hand, or use &quot;tedit run&quot;.</source>
        <translation>%1: fertig. Schritte, die Dateien schreiben (%2), wurden ausgelassen: von Hand exportieren, oder „tedit run“ verwenden.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::recording_tool</name>
    <message>
        <source>Record steps</source>
        <translation>Schritte aufzeichnen</translation>
    </message>
    <message>
        <source>recording, steps: %1</source>
        <translation>Aufzeichnung, Schritte: %1</translation>
    </message>
    <message>
        <source>Save the recorded steps</source>
        <translation>Aufgezeichnete Schritte speichern</translation>
    </message>
    <message>
        <source>Writes down what is done as a recipe, which the window and &quot;tedit run&quot; carry out; again: ends and saves</source>
        <translation>Zeichnet als Rezept auf, was getan wird; Fenster und „tedit run“ führen es aus; noch einmal: beendet und speichert</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Rezepte (*.json)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::report_pictures</name>
    <message>
        <source>%1, worst of all load cases</source>
        <translation>%1, Schlimmstes aller Lastfälle</translation>
    </message>
    <message>
        <source>%1, load case %2</source>
        <translation>%1, Lastfall %2</translation>
    </message>
    <message>
        <source>Supports and loads, load case %1</source>
        <translation>Lager und Lasten, Lastfall %1</translation>
    </message>
    <message>
        <source>The part</source>
        <translation>Das Teil</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::results_summary_panel</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>Als Tabelle kopieren</translation>
    </message>
    <message>
        <source>For a spreadsheet or a text (Ctrl+C)</source>
        <translation>Für eine Tabellenkalkulation oder einen Text (Strg+C)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Pictures, loads, figures and what to trust, as PDF or HTML</source>
        <translation>Bilder, Lasten, Kennwerte und was davon zu halten ist, als PDF oder HTML</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Not known: that version was not solved with these loads since the document was opened</source>
        <translation>Nicht bekannt: Jene Version wurde seit dem Öffnen des Dokuments nicht mit diesen Lasten gelöst</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::results_summary_tool</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>How strong the part is: largest stress, safety, reactions</source>
        <translation>Wie fest das Teil ist: größte Spannung, Sicherheit, Reaktionen</translation>
    </message>
    <message>
        <source>Copy the results as a table</source>
        <translation>Die Ergebnisse als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Pictures, loads, figures and what to trust, as PDF or HTML</source>
        <translation>Bilder, Lasten, Kennwerte und was davon zu halten ist, als PDF oder HTML</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>picture %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::results_tool</name>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Solve again</source>
        <translation>Neu rechnen</translation>
    </message>
    <message>
        <source>Stop the solver</source>
        <translation>Löser anhalten</translation>
    </message>
    <message>
        <source>Mark smallest and largest value</source>
        <translation>Kleinsten und größten Wert markieren</translation>
    </message>
    <message>
        <source>Show or hide isolines</source>
        <translation>Isolinien ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Lines of equal value on the surface and on a section</source>
        <translation>Linien gleichen Werts auf der Oberfläche und auf einem Schnitt</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
    <message>
        <source>Animate the deformation</source>
        <translation>Verformung bewegen</translation>
    </message>
    <message>
        <source>Swings between the part without load and the deformed one</source>
        <translation>Schwingt zwischen dem Teil ohne Last und dem verformten</translation>
    </message>
    <message>
        <source>stress before the edit that is previewed</source>
        <translation>Spannung vor der gezeigten Bearbeitung</translation>
    </message>
    <message>
        <source>No solve of this part runs.</source>
        <translation>Für dieses Teil läuft keine Rechnung.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::section_bar</name>
    <message>
        <source>Section across x</source>
        <translation>Schnitt quer zu x</translation>
    </message>
    <message>
        <source>Section across y</source>
        <translation>Schnitt quer zu y</translation>
    </message>
    <message>
        <source>Section across z</source>
        <translation>Schnitt quer zu z</translation>
    </message>
    <message>
        <source>Parallel to the picked surface</source>
        <translation>Parallel zur ausgewählten Fläche</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::section_tool</name>
    <message>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>Cuts the part and shows the field inside</source>
        <translation>Schneidet das Bauteil und zeigt das Feld im Inneren</translation>
    </message>
    <message>
        <source>Section parallel to the last click</source>
        <translation>Schnitt parallel zum letzten Klick</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::selection</name>
    <message>
        <source>Nothing selected</source>
        <translation>Nichts ausgewählt</translation>
    </message>
    <message>
        <source>Bore, Ø %1</source>
        <translation>Bohrung, Ø %1</translation>
    </message>
    <message>
        <source>Hole or pocket</source>
        <translation>Loch oder Tasche</translation>
    </message>
    <message>
        <source>Rib or boss</source>
        <translation>Rippe oder Auge</translation>
    </message>
    <message>
        <source>%1 surfaces</source>
        <translation>%1 Flächen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::selection_tool</name>
    <message>
        <source>Hide the selection</source>
        <translation>Auswahl ausblenden</translation>
    </message>
    <message>
        <source>Isolate the selection</source>
        <translation>Nur die Auswahl zeigen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Select with a box</source>
        <translation>Mit einem Rechteck auswählen</translation>
    </message>
    <message>
        <source>Ctrl+drag in the view does the same</source>
        <translation>Strg+Ziehen in der Ansicht tut dasselbe</translation>
    </message>
    <message>
        <source>Select all that can be seen</source>
        <translation>Alles Sichtbare auswählen</translation>
    </message>
    <message>
        <source>Draw a box. To the right: what lies in it altogether; to the left: all that it touches. Shift adds, Esc ends. Ctrl+drag does it at any time.</source>
        <translation>Ein Rechteck aufziehen. Nach rechts: was ganz darin liegt; nach links: alles, was es berührt. Umschalt nimmt dazu, Esc beendet. Strg+Ziehen geht jederzeit.</translation>
    </message>
    <message>
        <source>area %1</source>
        <translation>Inhalt %1</translation>
    </message>
    <message>
        <source>Find surfaces</source>
        <translation>Flächen suchen</translation>
    </message>
    <message>
        <source>By a name, &quot;bores 8 to 12 mm&quot;, equal ones, smooth neighbours</source>
        <translation>Nach Namen, „Bohrungen 8 bis 12 mm“, gleiche, glatte Nachbarn</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::settings_dialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>In den Einstellungen suchen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Nur Fehler</translation>
    </message>
    <message>
        <source>Errors and news</source>
        <translation>Fehler und Neues</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Farben des Fensters</translation>
    </message>
    <message>
        <source>Light, dark, or as the system has it when the program starts</source>
        <translation>Hell, dunkel oder wie das System beim Start des Programms</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>The log shows</source>
        <translation>Das Protokoll zeigt</translation>
    </message>
    <message>
        <source>What is written to the log panel</source>
        <translation>Was in das Protokoll geschrieben wird</translation>
    </message>
    <message>
        <source>No setting has these letters.</source>
        <translation>Keine Einstellung enthält diese Buchstaben.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Holds from the next start of the program</source>
        <translation>Gilt ab dem nächsten Start des Programms</translation>
    </message>
    <message>
        <source>The server&apos;s choice</source>
        <translation>Wahl des Servers</translation>
    </message>
    <message>
        <source>Linear tets: a quick look</source>
        <translation>Lineare Tetraeder: ein schneller Blick</translation>
    </message>
    <message>
        <source>Quadratic tets: accurate</source>
        <translation>Quadratische Tetraeder: genau</translation>
    </message>
    <message>
        <source>solve to the end</source>
        <translation>bis zum Ende rechnen</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Where the stress is computed: auto, cpu, or a part of a device&apos;s name</source>
        <translation>Wo die Spannung gerechnet wird: auto, cpu oder ein Teil eines Gerätenamens</translation>
    </message>
    <message>
        <source>Element order</source>
        <translation>Elementordnung</translation>
    </message>
    <message>
        <source>Linear tets are several times faster, but too stiff in bending: their stress is too low</source>
        <translation>Lineare Tetraeder sind mehrfach schneller, aber zu steif bei Biegung: ihre Spannung ist zu klein</translation>
    </message>
    <message>
        <source>Stop as a preview at</source>
        <translation>Als Vorschau anhalten bei</translation>
    </message>
    <message>
        <source>Stops at this estimated error in energy: less exact and faster</source>
        <translation>Hält bei diesem geschätzten Fehler der Energie an: ungenauer und schneller</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation>Kalt bis warm</translation>
    </message>
    <message>
        <source>Automatic, anew with each field</source>
        <translation>Automatisch, neu für jedes Feld</translation>
    </message>
    <message>
        <source>Locked to that of the first field</source>
        <translation>Fest auf den des ersten Felds</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>The scale that a field is drawn with</source>
        <translation>Die Skala, mit der ein Feld gezeichnet wird</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>From where to where the colours go; locked, versions can be compared by colour</source>
        <translation>Von wo bis wo die Farben reichen; mit festem Bereich lassen sich Versionen nach der Farbe vergleichen</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Equal factors get equal room on the scale</source>
        <translation>Gleiche Faktoren bekommen gleich viel Platz auf der Skala</translation>
    </message>
    <message>
        <source>As a turntable: upright</source>
        <translation>Wie ein Drehteller: aufrecht</translation>
    </message>
    <message>
        <source>As a ball: any way</source>
        <translation>Wie eine Kugel: beliebig</translation>
    </message>
    <message>
        <source>A drag turns the part</source>
        <translation>Ziehen dreht das Teil</translation>
    </message>
    <message>
        <source>Upright the z axis never tilts; any way the part can also be turned head over heels</source>
        <translation>Aufrecht kippt die z-Achse nie; beliebig lässt sich das Teil auch über Kopf drehen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::settings_tool</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Colours, solver, legend, log</source>
        <translation>Farben, Löser, Legende, Protokoll</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::shortcuts_dialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>Befehle und Tasten suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Neue Tasten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>The command has no keys any more</source>
        <translation>Der Befehl hat keine Tasten mehr</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>The keys that the command came with</source>
        <translation>Die Tasten, die der Befehl von Anfang an hatte</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot; already. Give that one other keys first.</source>
        <translation>%1 gehört schon zu „%2“. Diesem zuerst andere Tasten geben.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::solve_requests</name>
    <message>
        <source>Solve</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Stop the solver</source>
        <translation>Löser anhalten</translation>
    </message>
    <message>
        <source>Fields on demand</source>
        <translation>Felder auf Abruf</translation>
    </message>
    <message>
        <source>iteration %1, residual %2</source>
        <translation>Iteration %1, Residuum %2</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::surface_finder</name>
    <message>
        <source>Up and down show what a row is, Enter selects it</source>
        <translation>Auf und ab zeigen, was eine Zeile ist, Eingabe wählt sie aus</translation>
    </message>
    <message>
        <source>No surface has &quot;%1&quot; in its name</source>
        <translation>Keine Fläche hat „%1“ im Namen</translation>
    </message>
    <message>
        <source>All %1 surfaces</source>
        <translation>Alle %1 Flächen</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Select a surface first</source>
        <translation>Erst eine Fläche auswählen</translation>
    </message>
    <message>
        <source>There is no such bore</source>
        <translation>Eine solche Bohrung gibt es nicht</translation>
    </message>
    <message>
        <source>All %1 bores</source>
        <translation>Alle %1 Bohrungen</translation>
    </message>
    <message>
        <source>at (%1, %2, %3) mm</source>
        <translation>bei (%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>All %1 of the same area</source>
        <translation>Alle %1 mit derselben Fläche</translation>
    </message>
    <message>
        <source>A name, &quot;bores 8 to 12 mm&quot;, &quot;equal&quot;, &quot;smooth&quot;</source>
        <translation>Name, „Bohrungen 8 bis 12 mm“, „gleiche“, „glatt“</translation>
    </message>
    <message>
        <source>Ø %1</source>
        <translation>Ø %1</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::tour_card</name>
    <message>
        <source>Show me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::tour_tool</name>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Two minutes on a shipped part: close a bore and see its stress</source>
        <translation>Zwei Minuten an einem mitgelieferten Teil: eine Bohrung schließen und die Spannung sehen</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Das Teil drehen</translation>
    </message>
    <message>
        <source>Drag with the left mouse button. The wheel zooms to the pointer, F puts the whole part back into the view.</source>
        <translation>Mit der linken Maustaste ziehen. Das Rad vergrößert zum Zeiger hin, F holt das ganze Teil wieder ins Bild.</translation>
    </message>
    <message>
        <source>Pick a bore</source>
        <translation>Eine Bohrung wählen</translation>
    </message>
    <message>
        <source>Click into one of the holes: all of its wall is selected. At the right stands what it is, and what can be done with it.</source>
        <translation>In eine der Bohrungen klicken: Ihre ganze Wand ist gewählt. Rechts steht, was sie ist und was sich damit tun lässt.</translation>
    </message>
    <message>
        <source>Close it</source>
        <translation>Sie schließen</translation>
    </message>
    <message>
        <source>Choose Fill hole. The preview shows what comes (orange) before anything is changed; where the part stays as it is, its stress stays in sight.</source>
        <translation>„Loch schließen“ wählen. Die Vorschau zeigt, was dazukommt (orange), bevor etwas geändert ist; wo das Teil bleibt, wie es ist, bleibt seine Spannung zu sehen.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Press Apply, or Ctrl+Enter. Loads and supports stay where they are, and the stress is solved anew by itself.</source>
        <translation>Anwenden drücken, oder Strg+Eingabe. Lasten und Lager bleiben, wo sie sind, und die Spannung wird von selbst neu gelöst.</translation>
    </message>
    <message>
        <source>Read the result</source>
        <translation>Das Ergebnis lesen</translation>
    </message>
    <message>
        <source>The line at the bottom says &quot;preview&quot; until the stress is final. Press R: the largest stress, before and after.</source>
        <translation>Die Zeile unten sagt „Vorschau“, bis die Spannung endgültig ist. R drücken: die größte Spannung, vorher und nachher.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Es zurücknehmen</translation>
    </message>
    <message>
        <source>Ctrl+Z undoes, Ctrl+Y brings it back. Every version stays in the history below, and nothing has to be saved.</source>
        <translation>Strg+Z nimmt zurück, Strg+Y holt wieder. Jede Version bleibt unten im Verlauf, und nichts muss gesichert werden.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>Das ist alles</translation>
    </message>
    <message>
        <source>Ctrl+K finds every command by its name, F1 is the manual. Drop a mesh of your own on the window to go on.</source>
        <translation>Strg+K findet jeden Befehl nach seinem Namen, F1 ist das Handbuch. Weiter geht es mit einem eigenen Netz, das auf das Fenster gezogen wird.</translation>
    </message>
    <message>
        <source>The shipped parts are not there: the tour needs the plate.</source>
        <translation>Die mitgelieferten Teile sind nicht da: Der Rundgang braucht die Platte.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::truth_line</name>
    <message>
        <source>no part</source>
        <translation>kein Bauteil</translation>
    </message>
    <message>
        <source>preview of an edit, not applied</source>
        <translation>Vorschau einer Änderung, nicht angewandt</translation>
    </message>
    <message>
        <source>waiting for the solver</source>
        <translation>wartet auf den Löser</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>wird gerechnet</translation>
    </message>
    <message>
        <source>preview, converging</source>
        <translation>Vorschau, konvergiert</translation>
    </message>
    <message>
        <source>not solved</source>
        <translation>nicht gerechnet</translation>
    </message>
    <message>
        <source>no field</source>
        <translation>kein Feld</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>final</source>
        <translation>endgültig</translation>
    </message>
    <message>
        <source>check the loads</source>
        <translation>Lasten prüfen</translation>
    </message>
    <message>
        <source>residual %1</source>
        <translation>Residuum %1</translation>
    </message>
    <message>
        <source>error est. %1 %</source>
        <translation>geschätzter Fehler %1 %</translation>
    </message>
    <message>
        <source>%1 unknowns</source>
        <translation>%1 Unbekannte</translation>
    </message>
    <message>
        <source>solved in %1 on %2</source>
        <translation>gerechnet in %1 auf %2</translation>
    </message>
    <message>
        <source>%1 load cases</source>
        <translation>%1 Lastfälle</translation>
    </message>
    <message>
        <source>iteration %1</source>
        <translation>Iteration %1</translation>
    </message>
    <message>
        <source>%1 tets</source>
        <translation>%1 Tetraeder</translation>
    </message>
    <message>
        <source>edit %1</source>
        <translation>Änderung %1</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbinde</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>keine Antwort seit %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 warten</translation>
    </message>
    <message>
        <source>solver stopped</source>
        <translation>Löser angehalten</translation>
    </message>
    <message>
        <source>preview, solver stopped</source>
        <translation>Vorschau, Löser angehalten</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Solves the part as it is now (F5)</source>
        <translation>Löst das Teil, wie es jetzt ist (F5)</translation>
    </message>
    <message>
        <source>Stops the solver; the next edit is solved again</source>
        <translation>Hält den Löser an; nach der nächsten Änderung wird wieder gelöst</translation>
    </message>
    <message>
        <source>the stress shown is that before it; it is solved when it is applied</source>
        <translation>gezeigt ist die Spannung davor; gelöst wird, wenn sie angewendet ist</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::unit_question</name>
    <message>
        <source>The part is %1 large, read as %2. Its file says no unit: was it written in</source>
        <translation>Das Teil ist %1 groß, gelesen als %2. Seine Datei nennt keine Einheit: Geschrieben wurde sie in</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::vector_field</name>
    <message>
        <source>%1 %2 in all</source>
        <translation>%1 %2 insgesamt</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::version_editor</name>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Enter keeps, Esc drops</source>
        <translation>Eingabe behält, Esc verwirft</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::view_cube</name>
    <message>
        <source>Standard views</source>
        <translation>Standardansichten</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::viewing_tool</name>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>The selection, or the whole part</source>
        <translation>Die Auswahl oder das ganze Bauteil</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>View from: %1</source>
        <translation>Ansicht von: %1</translation>
    </message>
    <message>
        <source>Parallel or perspective</source>
        <translation>Parallel oder perspektivisch</translation>
    </message>
    <message>
        <source>Show or hide the mesh</source>
        <translation>Netz ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Show or hide the edges</source>
        <translation>Kanten ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Dark or light</source>
        <translation>Dunkel oder hell</translation>
    </message>
    <message>
        <source>Show or hide axes and scale</source>
        <translation>Achsen und Maßstab zeigen oder verbergen</translation>
    </message>
    <message>
        <source>At the lower right, also in pictures</source>
        <translation>Unten rechts, auch in Bildern</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::viewport</name>
    <message>
        <source>The part</source>
        <translation>Das Bauteil</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::welcome_page</name>
    <message>
        <source>Change a part, see its stress at once</source>
        <translation>Ein Bauteil ändern und sofort seine Spannung sehen</translation>
    </message>
    <message>
        <source>Open a tetrahedral mesh with surface ids (Gmsh .msh) by dropping it here, or start with a shipped part:</source>
        <translation>Ein Tetraedernetz mit Flächennummern (Gmsh .msh) hierher ziehen oder mit einem mitgelieferten Bauteil beginnen:</translation>
    </message>
    <message>
        <source>Open ...</source>
        <translation>Öffnen ...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Two minutes on a shipped part: close a bore and see its stress</source>
        <translation>Zwei Minuten an einem mitgelieferten Teil: eine Bohrung schließen und die Spannung sehen</translation>
    </message>
    <message>
        <source>Work on another computer ...</source>
        <translation>Auf einem anderen Rechner arbeiten ...</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::window_player</name>
    <message>
        <source>Run the recipe</source>
        <translation>Rezept ausführen</translation>
    </message>
    <message>
        <source>before the first step</source>
        <translation>vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>step %1 of %2 (%3)</source>
        <translation>Schritt %1 von %2 (%3)</translation>
    </message>
</context>
<context>
    <name>unit_question</name>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
</context>
</TS>
