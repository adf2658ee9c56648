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
    <name>cad</name>
    <message>
        <source>Being made on the CAD model</source>
        <translation>Wird am CAD-Modell ausgeführt</translation>
    </message>
    <message>
        <source>The part as the CAD model has it</source>
        <translation>Das Teil, wie es das CAD-Modell hat</translation>
    </message>
    <message>
        <source>On the CAD model, new vertices within %1</source>
        <translation>Auch am CAD-Modell, neue Knoten höchstens %1 daneben</translation>
    </message>
    <message>
        <source>In the mesh only: %1</source>
        <translation>Nur im Netz: %1</translation>
    </message>
    <message>
        <source>Not tried on the CAD model: %1</source>
        <translation>Am CAD-Modell nicht versucht: %1</translation>
    </message>
    <message>
        <source>CAD ...</source>
        <comment>on a small picture: being made on the model</comment>
        <translation>CAD ...</translation>
    </message>
    <message>
        <source>CAD</source>
        <comment>on a small picture: the model has it</comment>
        <translation>CAD</translation>
    </message>
    <message>
        <source>mesh only</source>
        <comment>on a small picture: the CAD model has it not</comment>
        <translation>nur Netz</translation>
    </message>
    <message>
        <source>CAD ?</source>
        <comment>on a small picture: not tried on the model</comment>
        <translation>CAD ?</translation>
    </message>
    <message>
        <source>Version %1. %2</source>
        <translation>Version %1. %2</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>slab</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>plug</source>
        <translation>Stopfen</translation>
    </message>
    <message>
        <source>fillet</source>
        <translation>Ausrundung</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
</context>
<context>
    <name>cad_import</name>
    <message>
        <source>meshing the CAD file</source>
        <translation>CAD-Datei vernetzen</translation>
    </message>
    <message>
        <source>editing the CAD model</source>
        <translation>CAD-Modell bearbeiten</translation>
    </message>
    <message>
        <source>meshing the surface</source>
        <translation>die Oberfläche wird vernetzt</translation>
    </message>
</context>
<context>
    <name>certification</name>
    <message>
        <source>CalculiX solves</source>
        <translation>CalculiX rechnet</translation>
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
    <message>
        <source>Mesh, Gmsh 2.2</source>
        <translation>Netz, Gmsh 2.2</translation>
    </message>
    <message>
        <source>Deck of CalculiX or Abaqus</source>
        <translation>Eingabedatei von CalculiX oder Abaqus</translation>
    </message>
    <message>
        <source>Deck of Nastran</source>
        <translation>Eingabedatei von Nastran</translation>
    </message>
    <message>
        <source>Universal file of I-DEAS</source>
        <translation>Universaldatei von I-DEAS</translation>
    </message>
    <message>
        <source>Part for 3D printing</source>
        <translation>Bauteil für den 3D-Druck</translation>
    </message>
    <message>
        <source>Boundary with colours</source>
        <translation>Oberfläche mit Farben</translation>
    </message>
    <message>
        <source>Boundary for viewers (glTF)</source>
        <translation>Oberfläche für Betrachter (glTF)</translation>
    </message>
    <message>
        <source>MED of Salome and code_aster</source>
        <translation>MED von Salome und code_aster</translation>
    </message>
</context>
<context>
    <name>handles</name>
    <message>
        <source>along %1</source>
        <translation>entlang %1</translation>
    </message>
    <message>
        <source>across the wall</source>
        <translation>quer zur Wand</translation>
    </message>
</context>
<context>
    <name>head_questions</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Check for printing</source>
        <translation>Auf Druckbarkeit prüfen</translation>
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
    <message>
        <source>Pick at least one surface of the part</source>
        <translation>Mindestens eine Fläche des Bauteils anklicken</translation>
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
    <message>
        <source>x; y; z, or empty: by the wall</source>
        <translation>x; y; z, oder leer: nach der Fläche</translation>
    </message>
    <message>
        <source>click the part, or x; y; z in %1</source>
        <translation>das Teil anklicken oder x; y; z in %1</translation>
    </message>
    <message>
        <source>x; y; z in %1</source>
        <translation>x; y; z in %1</translation>
    </message>
    <message>
        <source>numbers, between semicolons</source>
        <translation>Zahlen, mit Strichpunkten dazwischen</translation>
    </message>
    <message>
        <source>in %1, between semicolons</source>
        <translation>in %1, mit Strichpunkten dazwischen</translation>
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
    <message>
        <source>What becomes of a part that falls apart: the cut is refused, the largest piece of each body is kept, or all pieces stay.</source>
        <translation>Was aus einem Bauteil wird, das zerfällt: Der Schnitt wird abgelehnt, das größte Stück jedes Körpers bleibt, oder alle Stücke bleiben.</translation>
    </message>
    <message>
        <source>Boss</source>
        <translation>Auge</translation>
    </message>
    <message>
        <source>Adds a round, rectangular, slotted or polygonal boss to a wall.</source>
        <translation>Setzt ein rundes, rechteckiges, langrundes oder vieleckiges Auge auf eine Fläche.</translation>
    </message>
    <message>
        <source>The wall to put it on, or none where a place is given.</source>
        <translation>Die Fläche, auf die es kommt; keine, wenn ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>How far it stands out over the place.</source>
        <translation>Wie weit es über den Ort hinausragt.</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>Nach außen</translation>
    </message>
    <message>
        <source>The direction that it grows in. Empty: across the wall.</source>
        <translation>Die Richtung, in die es wächst. Leer: quer zur Fläche.</translation>
    </message>
    <message>
        <source>Select the wall and give the place, or take its middle. On curved walls the boss goes down to the wall all around. Its top and sides are surfaces of their own.</source>
        <translation>Wählen Sie die Fläche und geben Sie den Ort an, oder nehmen Sie ihre Mitte. Auf gewölbten Flächen reicht das Auge rundum bis zur Fläche hinab. Oberseite und Seiten werden eigene Flächen.</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Drills a hole: blind or through, with counterbore, countersink or for a thread.</source>
        <translation>Bohrt ein Loch: als Sackloch oder durchgehend, mit Flach- oder Kegelsenkung oder für ein Gewinde.</translation>
    </message>
    <message>
        <source>The wall to drill into, or none where a place is given.</source>
        <translation>Die Fläche, in die gebohrt wird; keine, wenn ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The hole&apos;s axis, either way round: it is drilled into the material. Empty: across the wall.</source>
        <translation>Die Achse des Lochs, gleich in welchem Sinn: gebohrt wird ins Material. Leer: quer zur Fläche.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Of the hole.</source>
        <translation>Des Lochs.</translation>
    </message>
    <message>
        <source>Of its cylinder; 0 goes through all there is.</source>
        <translation>Des Zylinders; 0 geht durch alles hindurch.</translation>
    </message>
    <message>
        <source>For a thread</source>
        <translation>Für ein Gewinde</translation>
    </message>
    <message>
        <source>Takes the core diameter of this metric thread instead.</source>
        <translation>Nimmt stattdessen den Kerndurchmesser dieses metrischen Gewindes.</translation>
    </message>
    <message>
        <source>Tip angle</source>
        <translation>Spitzenwinkel</translation>
    </message>
    <message>
        <source>Of a blind hole&apos;s tip; 0 is flat, 118 degrees is usual.</source>
        <translation>Der Spitze eines Sacklochs; 0 ist flach, üblich sind 118 Grad.</translation>
    </message>
    <message>
        <source>Counterbore</source>
        <translation>Flachsenkung</translation>
    </message>
    <message>
        <source>Its diameter; 0: none.</source>
        <translation>Ihr Durchmesser; 0: keine.</translation>
    </message>
    <message>
        <source>Counterbore depth</source>
        <translation>Tiefe der Flachsenkung</translation>
    </message>
    <message>
        <source>From the wall on.</source>
        <translation>Von der Fläche an.</translation>
    </message>
    <message>
        <source>Countersink</source>
        <translation>Kegelsenkung</translation>
    </message>
    <message>
        <source>Its diameter at the wall; 0: none.</source>
        <translation>Ihr Durchmesser an der Fläche; 0: keine.</translation>
    </message>
    <message>
        <source>Countersink angle</source>
        <translation>Winkel der Kegelsenkung</translation>
    </message>
    <message>
        <source>Of the whole cone.</source>
        <translation>Des ganzen Kegels.</translation>
    </message>
    <message>
        <source>sans</source>
        <translation>serifenlos</translation>
    </message>
    <message>
        <source>bold</source>
        <translation>fett</translation>
    </message>
    <message>
        <source>serif</source>
        <translation>mit Serifen</translation>
    </message>
    <message>
        <source>mono</source>
        <translation>feste Breite</translation>
    </message>
    <message>
        <source>The wall to write on, or none where a place is given.</source>
        <translation>Die Fläche, auf die geschrieben wird; keine, wenn ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>One line.</source>
        <translation>Eine Zeile.</translation>
    </message>
    <message>
        <source>TEdit</source>
        <translation>TEdit</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Schrifthöhe</translation>
    </message>
    <message>
        <source>How far it stands out of the wall; negative is sunk.</source>
        <translation>Wie weit er aus der Fläche ragt; negativ ist eingesenkt.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Of the letters.</source>
        <translation>Der Buchstaben.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Which way the letters stand. Empty: by the part&apos;s axes.</source>
        <translation>Wohin die Buchstaben stehen. Leer: nach den Achsen des Teils.</translation>
    </message>
    <message>
        <source>The direction that the text looks in. Empty: across the wall.</source>
        <translation>Die Richtung, in die der Text blickt. Leer: quer zur Fläche.</translation>
    </message>
    <message>
        <source>For names and numbers on flat walls. Letters that are small beside the part&apos;s tets make many small ones: a raised height of about a tenth of the letters does well.</source>
        <translation>Für Namen und Nummern auf ebenen Flächen. Buchstaben, die klein gegen die Tets des Teils sind, ergeben viele kleine Tets: gut ist eine Höhe von etwa einem Zehntel der Schrifthöhe.</translation>
    </message>
    <message>
        <source>below</source>
        <translation>darunter</translation>
    </message>
    <message>
        <source>above</source>
        <translation>darüber</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Mit einer Ebene schneiden</translation>
    </message>
    <message>
        <source>A flat wall to cut along, or none where the plane is given.</source>
        <translation>Eine ebene Fläche, entlang der geschnitten wird; keine, wenn die Ebene angegeben ist.</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Which way the plane looks. Empty: as the wall does.</source>
        <translation>Wohin die Ebene blickt. Leer: wie die Fläche.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>How far the plane is moved against its normal.</source>
        <translation>Wie weit die Ebene gegen ihre Normale verschoben wird.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>Cuts a round, rectangular, slotted or polygonal pocket into a wall.</source>
        <translation>Schneidet eine runde, rechteckige, langrunde oder vieleckige Tasche in eine Fläche.</translation>
    </message>
    <message>
        <source>The wall to cut into, or none where a place is given.</source>
        <translation>Die Fläche, in die geschnitten wird; keine, wenn ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>How deep it goes; 0 goes through all there is.</source>
        <translation>Wie tief sie geht; 0 geht durch alles hindurch.</translation>
    </message>
    <message>
        <source>The direction that it is cut against. Empty: across the wall.</source>
        <translation>Die Richtung, gegen die geschnitten wird. Leer: quer zur Fläche.</translation>
    </message>
    <message>
        <source>Select the wall and give the place, or take its middle. The floor and the walls of the pocket are surfaces of their own.</source>
        <translation>Wählen Sie die Fläche und geben Sie den Ort an, oder nehmen Sie ihre Mitte. Boden und Wände der Tasche werden eigene Flächen.</translation>
    </message>
    <message>
        <source>furthest off what was asked for</source>
        <translation>größte Abweichung vom Verlangten</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>The middle of the profile, on the wall. Empty: the middle of the selected wall.</source>
        <translation>Die Mitte des Profils, auf der Fläche. Leer: die Mitte der gewählten Fläche.</translation>
    </message>
    <message>
        <source>Where the hole&apos;s axis enters the wall. Empty: the middle of the selected wall.</source>
        <translation>Wo die Achse des Lochs in die Fläche eintritt. Leer: die Mitte der gewählten Fläche.</translation>
    </message>
    <message>
        <source>The middle of the text, on the wall. Empty: the middle of the selected wall.</source>
        <translation>Die Mitte des Texts, auf der Fläche. Leer: die Mitte der gewählten Fläche.</translation>
    </message>
    <message>
        <source>A point of the plane. Empty: the middle of the selected wall.</source>
        <translation>Ein Punkt der Ebene. Leer: die Mitte der gewählten Fläche.</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>slot</source>
        <translation>Langloch</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>What it looks like from above.</source>
        <translation>Wie es von oben aussieht.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The circle&apos;s and the polygon&apos;s diameter, the rectangle&apos;s and the slot&apos;s length.</source>
        <translation>Durchmesser von Kreis und Vieleck, Länge von Rechteck und Langloch.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Across the length of a rectangle or a slot; 0: a square, half the slot.</source>
        <translation>Quer zur Länge von Rechteck oder Langloch; 0: ein Quadrat, beim Langloch die halbe Länge.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Of a polygon.</source>
        <translation>Eines Vielecks.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Which way the length goes. Empty: by the part&apos;s axes.</source>
        <translation>Wohin die Länge zeigt. Leer: nach den Achsen des Teils.</translation>
    </message>
    <message>
        <source>Surfaces of any form move by exactly the depth and keep their names, so loads on them stay. Beside a neighbour that runs on smoothly a step is left: select it, too, to move both. A cut that would split the part is refused unless &quot;Pieces&quot; allows it.</source>
        <translation>Flächen jeder Form rücken um genau die Tiefe und behalten ihre Namen, also bleiben Lasten auf ihnen. Neben einer Nachbarfläche, die glatt weiterläuft, bleibt eine Stufe: auch sie auswählen, um beide zu bewegen. Ein Schnitt, der das Teil teilen würde, wird abgelehnt, außer „Stücke“ erlaubt ihn.</translation>
    </message>
    <message>
        <source>tets without volume meshed anew</source>
        <translation>Tetraeder ohne Volumen neu vernetzt</translation>
    </message>
    <message>
        <source>Coarsen mesh</source>
        <translation>Vergröbern</translation>
    </message>
    <message>
        <source>Makes the mesh coarser at surfaces or around a point; the part keeps its shape.</source>
        <translation>Macht das Netz an Flächen oder um einen Punkt gröber; das Teil behält seine Form.</translation>
    </message>
    <message>
        <source>The surfaces at which the mesh is to be coarser, or none where a place is given.</source>
        <translation>Die Flächen, an denen das Netz gröber werden soll, oder keine, wo ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Shorter edges go; 0: twice what they are now.</source>
        <translation>Kürzere Kanten fallen weg; 0: das Doppelte von jetzt.</translation>
    </message>
    <message>
        <source>Coarsens around this place instead of at surfaces.</source>
        <translation>Vergröbert um diesen Ort statt an Flächen.</translation>
    </message>
    <message>
        <source>How far from there vertices may go; 0: three times the size.</source>
        <translation>Wie weit von dort Knoten wegfallen dürfen; 0: das Dreifache der Größe.</translation>
    </message>
    <message>
        <source>How far the boundary may be from where it was; 0: a fiftieth of the size.</source>
        <translation>Wie weit die Oberfläche von ihrem Platz abweichen darf; 0: ein Fünfzigstel der Größe.</translation>
    </message>
    <message>
        <source>For quicker solutions: takes tets away where little happens. Edges and corners of the part stay, flat walls stay exactly. Loads stay.</source>
        <translation>Für schnellere Lösungen: nimmt Tetraeder weg, wo wenig geschieht. Kanten und Ecken des Teils bleiben, ebene Flächen bleiben genau. Lasten bleiben.</translation>
    </message>
    <message>
        <source>flat and round</source>
        <translation>ebene und runde</translation>
    </message>
    <message>
        <source>round</source>
        <translation>runde</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Drags a wall, or a patch around a point; what is around it follows smoothly.</source>
        <translation>Zieht eine Fläche oder einen Fleck um einen Punkt; was darum liegt, folgt glatt.</translation>
    </message>
    <message>
        <source>The walls to drag together, or none where a place is given.</source>
        <translation>Die Flächen, die zusammen gezogen werden, oder keine, wo ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>How far along each axis, instead of a distance along the wall&apos;s normal.</source>
        <translation>Wie weit entlang jeder Achse, statt eines Abstands entlang der Flächennormale.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Along the wall&apos;s normal; negative goes into the part.</source>
        <translation>Entlang der Flächennormale; negativ geht ins Teil hinein.</translation>
    </message>
    <message>
        <source>Drags only a patch of the wall around this place.</source>
        <translation>Zieht nur einen Fleck der Fläche um diesen Ort.</translation>
    </message>
    <message>
        <source>Of that patch; 0: about two edges of the mesh.</source>
        <translation>Dieses Flecks; 0: etwa zwei Kanten des Netzes.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How far around the part follows; 0: the side of a square as large as what is dragged, or four edges.</source>
        <translation>Wie weit ringsum das Teil folgt; 0: die Seite eines Quadrats so groß wie das Gezogene, oder vier Kanten.</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Was bleibt</translation>
    </message>
    <message>
        <source>Walls within reach that stay as they are, unless they belong to the edge of what is dragged.</source>
        <translation>Flächen in Reichweite, die bleiben, wie sie sind, außer sie gehören zum Rand des Gezogenen.</translation>
    </message>
    <message>
        <source>Surfaces that stay</source>
        <translation>Flächen, die bleiben</translation>
    </message>
    <message>
        <source>Numbers of more surfaces that must stay, such as supports: 12, 15.</source>
        <translation>Nummern weiterer Flächen, die bleiben müssen, etwa Lager: 12, 15.</translation>
    </message>
    <message>
        <source>Keep the volume</source>
        <translation>Volumen behalten</translation>
    </message>
    <message>
        <source>What is within reach gives way until the part has the volume that it had.</source>
        <translation>Was in Reichweite ist, gibt nach, bis das Teil das Volumen hat, das es hatte.</translation>
    </message>
    <message>
        <source>Walls and their loads keep their names and the mesh its tets: only vertices move. Holes and flat walls that do not touch what is dragged stay as they are. Where a tet would become too flat, the largest distance that works is told; with a larger reach more is possible.</source>
        <translation>Flächen und ihre Lasten behalten ihre Namen und das Netz seine Tetraeder: nur Knoten bewegen sich. Löcher und ebene Flächen, die das Gezogene nicht berühren, bleiben, wie sie sind. Wo ein Tetraeder zu flach würde, wird der größte Abstand genannt, der geht; mit größerer Reichweite geht mehr.</translation>
    </message>
    <message>
        <source>Refine mesh</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Makes the mesh finer at surfaces or around a point, graded outwards.</source>
        <translation>Macht das Netz an Flächen oder um einen Punkt feiner, nach außen abgestuft.</translation>
    </message>
    <message>
        <source>The surfaces at which the mesh is to be finer, or none where a place is given.</source>
        <translation>Die Flächen, an denen das Netz feiner werden soll, oder keine, wo ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Edges there become at most so long; 0: half of what they are now.</source>
        <translation>Kanten dort werden höchstens so lang; 0: die Hälfte von jetzt.</translation>
    </message>
    <message>
        <source>Refines around this place instead of at surfaces.</source>
        <translation>Verfeinert um diesen Ort statt an Flächen.</translation>
    </message>
    <message>
        <source>For more exact stresses where they change fast: fillets, edges of holes, loads on small surfaces. The part keeps its shape; on round walls the finer mesh is rounder. Loads stay.</source>
        <translation>Für genauere Spannungen, wo sie sich schnell ändern: Ausrundungen, Lochränder, Lasten auf kleinen Flächen. Das Teil behält seine Form; auf runden Flächen ist das feinere Netz runder. Lasten bleiben.</translation>
    </message>
    <message>
        <source>vertices that went</source>
        <translation>weggefallene Knoten</translation>
    </message>
    <message>
        <source>tets fewer</source>
        <translation>Tetraeder weniger</translation>
    </message>
    <message>
        <source>furthest that the boundary is from where it was</source>
        <translation>größte Abweichung der Oberfläche von ihrem Platz</translation>
    </message>
    <message>
        <source>how far around the part follows</source>
        <translation>wie weit ringsum das Teil folgt</translation>
    </message>
    <message>
        <source>new vertices</source>
        <translation>neue Knoten</translation>
    </message>
    <message>
        <source>longest edge at what was picked</source>
        <translation>längste Kante am Ausgewählten</translation>
    </message>
    <message>
        <source>Combine with a file</source>
        <translation>Mit einer Datei verknüpfen</translation>
    </message>
    <message>
        <source>Unites the part with the shape in a file, cuts it off, or keeps what both share.</source>
        <translation>Vereinigt das Teil mit der Form in einer Datei, schneidet sie ab oder behält, was beide gemeinsam haben.</translation>
    </message>
    <message>
        <source>Nothing.</source>
        <translation>Nichts.</translation>
    </message>
    <message>
        <source>Takes closed surfaces: STL, OBJ, OFF, PLY, or a Gmsh mesh, of at most 4 MiB. The file&apos;s axes are those of the part unless a direction is given. Its faces become surfaces of the part, divided at edges of more than 30 degrees. The file&apos;s content is kept with the edit.</source>
        <translation>Nimmt geschlossene Oberflächen: STL, OBJ, OFF, PLY oder ein Gmsh-Netz, höchstens 4 MiB. Die Achsen der Datei sind die des Teils, wenn keine Richtung angegeben ist. Ihre Seiten werden Flächen des Teils, getrennt an Kanten von mehr als 30 Grad. Der Inhalt der Datei bleibt bei der Änderung.</translation>
    </message>
    <message>
        <source>Emboss text or logo</source>
        <translation>Text oder Logo prägen</translation>
    </message>
    <message>
        <source>Raises a line of text or a logo from a wall, or sinks it in.</source>
        <translation>Hebt eine Zeile Text oder ein Logo aus einer Wand heraus oder senkt sie ein.</translation>
    </message>
    <message>
        <source>Around round walls</source>
        <translation>Um runde Wände</translation>
    </message>
    <message>
        <source>Letters on a selected round wall follow it; else they stand straight on it.</source>
        <translation>Buchstaben auf einer ausgewählten runden Wand folgen ihr; sonst stehen sie gerade darauf.</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Aushöhlen</translation>
    </message>
    <message>
        <source>Makes a shell of the part: walls of one thickness, nothing inside.</source>
        <translation>Macht aus dem Teil eine Schale: Wände von einer Dicke, innen nichts.</translation>
    </message>
    <message>
        <source>Walls that are left open, or that get a drain hole; or none.</source>
        <translation>Wände, die offen bleiben oder ein Ablaufloch bekommen; oder keine.</translation>
    </message>
    <message>
        <source>Of the walls that stay.</source>
        <translation>Der Wände, die bleiben.</translation>
    </message>
    <message>
        <source>Drain holes</source>
        <translation>Ablauflöcher</translation>
    </message>
    <message>
        <source>Through the middle of each picked wall; 0: the picked walls are open.</source>
        <translation>Durch die Mitte jeder ausgewählten Wand; 0: die ausgewählten Wände sind offen.</translation>
    </message>
    <message>
        <source>Pick the walls that shall be open, as the underside of a cover; or give a diameter for drain holes, which powder or resin runs out of. Without either a closed void is left. What is thinner than two walls stays full. A thin shell takes many tets: they are about as large as the wall is thick.</source>
        <translation>Die Wände auswählen, die offen sein sollen, wie die Unterseite eines Deckels; oder einen Durchmesser für Ablauflöcher angeben, aus denen Pulver oder Harz läuft. Ohne beides bleibt ein geschlossener Hohlraum. Was dünner als zwei Wände ist, bleibt voll. Eine dünne Schale braucht viele Tetraeder: Sie sind etwa so groß, wie die Wand dick ist.</translation>
    </message>
    <message>
        <source>Move hole or boss</source>
        <translation>Loch oder Nocken verschieben</translation>
    </message>
    <message>
        <source>Moves a hole, pocket, boss or rib by a vector, or makes a copy of it there.</source>
        <translation>Verschiebt ein Loch, eine Tasche, einen Nocken oder eine Rippe um einen Vektor oder macht dort eine Kopie davon.</translation>
    </message>
    <message>
        <source>A wall of each hole, or a side of each boss.</source>
        <translation>Eine Wand jedes Lochs oder eine Seite jedes Nockens.</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>How far it moves, in the axes of the part.</source>
        <translation>Wie weit es rückt, in den Achsen des Teils.</translation>
    </message>
    <message>
        <source>0, 0, 0</source>
        <translation>0, 0, 0</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopie</translation>
    </message>
    <message>
        <source>Leave the one that is there, and make another one.</source>
        <translation>Das vorhandene lassen und ein weiteres machen.</translation>
    </message>
    <message>
        <source>Pick one wall: the rest of the hole or boss is found. A hole is closed where it was and cut where it goes; a through hole goes through there, too. Its walls keep their numbers, and so their loads and supports. What shares a side with the rest of the part, as a fin that runs to the part&apos;s end, cannot be moved.</source>
        <translation>Eine Wand auswählen: Der Rest des Lochs oder Nockens wird gefunden. Ein Loch wird geschlossen, wo es war, und geschnitten, wohin es kommt; ein Durchgangsloch geht auch dort durch. Seine Wände behalten ihre Nummern und damit ihre Lasten und Lager. Was eine Seite mit dem übrigen Teil teilt, wie eine Rippe, die bis zum Ende des Teils läuft, lässt sich nicht verschieben.</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Repeats a hole, pocket, boss or rib in rows, around an axis, or mirrored.</source>
        <translation>Wiederholt ein Loch, eine Tasche, einen Nocken oder eine Rippe in Reihen, um eine Achse oder gespiegelt.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>Cuts the part along a plane and keeps one side, or both as bodies of their own.</source>
        <translation>Schneidet das Teil längs einer Ebene und behält eine Seite oder beide als eigene Körper.</translation>
    </message>
    <message>
        <source>Which side stays: below is what the normal points away from; both: in two.</source>
        <translation>Welche Seite bleibt: „unten“ ist, wovon die Normale wegzeigt; beide: in zwei Teilen.</translation>
    </message>
    <message>
        <source>Change diameter</source>
        <translation>Durchmesser ändern</translation>
    </message>
    <message>
        <source>Gives a round bore or pin another diameter.</source>
        <translation>Gibt einer runden Bohrung oder einem Zapfen einen anderen Durchmesser.</translation>
    </message>
    <message>
        <source>A wall of each bore or pin; the other half of a wall is found.</source>
        <translation>Eine Wand jeder Bohrung oder jedes Zapfens; die andere Hälfte einer Wand wird gefunden.</translation>
    </message>
    <message>
        <source>Of the bore or pin afterwards.</source>
        <translation>Der Bohrung oder des Zapfens danach.</translation>
    </message>
    <message>
        <source>The walls keep their numbers, and so their loads and supports: a bearing seat that becomes larger carries what it carried. A counterbore or another step of the hole is a wall of its own. Where the part leaves no room the answer says which diameter can be.</source>
        <translation>Die Wände behalten ihre Nummern und damit ihre Lasten und Lager: Ein Lagersitz, der größer wird, trägt, was er trug. Eine Senkung oder eine andere Stufe des Lochs ist eine eigene Wand. Wo das Teil keinen Platz lässt, sagt die Antwort, welcher Durchmesser sein kann.</translation>
    </message>
    <message>
        <source>taken out</source>
        <translation>herausgenommen</translation>
    </message>
    <message>
        <source>hollow spaces</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source>diameter now</source>
        <translation>Durchmesser jetzt</translation>
    </message>
    <message>
        <source>furthest off it at any vertex</source>
        <translation>größte Abweichung davon an einem Knoten</translation>
    </message>
    <message>
        <source>add</source>
        <translation>vereinigen</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>abschneiden</translation>
    </message>
    <message>
        <source>intersect</source>
        <translation>Gemeinsames behalten</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The shape: STL, OBJ, OFF, PLY or MSH.</source>
        <translation>Die Form: STL, OBJ, OFF, PLY oder MSH.</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was tun</translation>
    </message>
    <message>
        <source>add: unite both; cut: take it off the part; intersect: keep what both have.</source>
        <translation>vereinigen: beide zusammen; abschneiden: vom Teil wegnehmen; Gemeinsames behalten: was beide haben.</translation>
    </message>
    <message>
        <source>Where the file&apos;s origin comes to lie.</source>
        <translation>Wohin der Ursprung der Datei kommt.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Where the file&apos;s z axis points.</source>
        <translation>Wohin die z-Achse der Datei zeigt.</translation>
    </message>
    <message>
        <source>0, 0, 1</source>
        <translation>0, 0, 1</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About that direction.</source>
        <translation>Um diese Richtung.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>How much larger than in the file.</source>
        <translation>Wie viel größer als in der Datei.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Of the file&apos;s numbers: most formats do not say.</source>
        <translation>Der Zahlen in der Datei: Die meisten Formate sagen sie nicht.</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>In rows, around an axis, or mirrored in a plane.</source>
        <translation>In Reihen, um eine Achse oder an einer Ebene gespiegelt.</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>How many there are in a row or around the axis in the end, the one that is there included.</source>
        <translation>Wie viele am Ende in einer Reihe oder um die Achse sind, das vorhandene mitgezählt.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Rows: the way from one to the next.</source>
        <translation>Reihen: der Weg von einem zum nächsten.</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>How many such rows.</source>
        <translation>Wie viele solche Reihen.</translation>
    </message>
    <message>
        <source>Step of rows</source>
        <translation>Schritt der Reihen</translation>
    </message>
    <message>
        <source>The way from one row to the next.</source>
        <translation>Der Weg von einer Reihe zur nächsten.</translation>
    </message>
    <message>
        <source>A point of the axis or of the mirror&apos;s plane.</source>
        <translation>Ein Punkt der Achse oder der Spiegelebene.</translation>
    </message>
    <message>
        <source>Of the axis, or across the mirror&apos;s plane.</source>
        <translation>Der Achse oder quer zur Spiegelebene.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ring: from the first to the last; a whole turn is shared out evenly.</source>
        <translation>Ring: vom ersten bis zum letzten; eine ganze Drehung wird gleichmäßig verteilt.</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Rippe</translation>
    </message>
    <message>
        <source>Adds a rib between two walls: in their corner, or from one to the other.</source>
        <translation>Fügt eine Rippe zwischen zwei Wänden hinzu: in ihrer Ecke oder von einer zur anderen.</translation>
    </message>
    <message>
        <source>The two walls.</source>
        <translation>Die zwei Wände.</translation>
    </message>
    <message>
        <source>Of the rib.</source>
        <translation>Der Rippe.</translation>
    </message>
    <message>
        <source>Of its legs along the walls of a corner; between walls that face each other, how high it is.</source>
        <translation>Ihrer Schenkel längs der Wände einer Ecke; zwischen Wänden, die einander zugewandt sind, ihre Höhe.</translation>
    </message>
    <message>
        <source>A point in the middle of the rib&apos;s thickness. Empty: between the walls&apos; middles.</source>
        <translation>Ein Punkt in der Mitte der Rippendicke. Leer: zwischen den Mitten der Wände.</translation>
    </message>
    <message>
        <source>Along walls that face each other: which way the rib&apos;s height goes.</source>
        <translation>Längs Wänden, die einander zugewandt sind: wohin die Höhe der Rippe geht.</translation>
    </message>
    <message>
        <source>Pick two walls of an inner corner, as those of a bracket, for a triangular rib; or two walls that face each other for a plate between them. Its sides are surfaces of their own.</source>
        <translation>Zwei Wände einer inneren Ecke auswählen, wie die eines Winkels, für eine dreieckige Rippe; oder zwei einander zugewandte Wände für eine Platte dazwischen. Ihre Seiten sind eigene Flächen.</translation>
    </message>
    <message>
        <source>Ring: a point of the axis and its direction, or what of the part has them: instead of place and direction.</source>
        <translation>Ring: ein Punkt der Achse und ihre Richtung, oder was am Teil sie hat: statt Ort und Richtung.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Mirror: a point of the plane and its normal, or what of the part has them: instead of place and direction.</source>
        <translation>Spiegel: ein Punkt der Ebene und ihre Normale, oder was am Teil sie hat: statt Ort und Richtung.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Rows: how far each copy is from the one that is there, the way that the step goes: instead of the count.</source>
        <translation>Reihen: wie weit jede Kopie von der vorhandenen entfernt ist, in der Richtung des Schritts: statt der Anzahl.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ring: where each copy is, from the one that is there on: instead of count and angle.</source>
        <translation>Ring: wo jede Kopie ist, von der vorhandenen an: statt Anzahl und Winkel.</translation>
    </message>
    <message>
        <source>Pick one wall: the rest of the hole or boss is found. The one that is there counts: a count of 4 adds three. Where they are not evenly apart, give distances or angles: one for each copy. The axis of a ring may be a round wall&apos;s, a mirror&apos;s plane a flat wall&apos;s. A through hole goes through everywhere. Where one of the copies cannot be, none is made, and the answer names it.</source>
        <translation>Eine Wand wählen: der Rest des Lochs oder Zapfens wird gefunden. Das vorhandene zählt mit: eine Anzahl von 4 fügt drei hinzu. Wo sie nicht gleich weit auseinander sind, Abstände oder Winkel angeben: einen für jede Kopie. Die Achse eines Rings kann die einer runden Wand sein, die Ebene eines Spiegels die einer flachen. Ein durchgehendes Loch geht überall durch. Wo eine der Kopien nicht sein kann, wird keine gemacht, und die Antwort nennt sie.</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, or what of the part has them: instead of place and normal.</source>
        <translation>Ein Punkt der Ebene und ihre Normale, oder was am Teil sie hat: statt Ort und Normale.</translation>
    </message>
    <message>
        <source>Select a wall and give an offset to cut a slice off, or give any plane by a point and its normal, or by a wall or a round edge that lies in it. The cut is a surface of its own.</source>
        <translation>Eine Wand wählen und einen Versatz angeben, um eine Scheibe abzuschneiden, oder irgendeine Ebene durch einen Punkt und ihre Normale angeben, oder durch eine Wand oder runde Kante, die darin liegt. Der Schnitt ist eine eigene Fläche.</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Profil ziehen</translation>
    </message>
    <message>
        <source>Carries a profile along a path: cuts a groove or a channel, or adds a bead.</source>
        <translation>Führt ein Profil an einem Weg entlang: schneidet eine Nut oder einen Kanal, oder fügt eine Raupe hinzu.</translation>
    </message>
    <message>
        <source>The wall that the profile&apos;s height stands on, or none.</source>
        <translation>Die Wand, auf der die Höhe des Profils steht, oder keine.</translation>
    </message>
    <message>
        <source>Give the path by its points, or pick an edge of the part to go along. The profile&apos;s middle stays on the path, its corners are mitred; a path that ends where it began is closed. Walls and ends are surfaces of their own.</source>
        <translation>Den Weg durch seine Punkte angeben, oder eine Kante des Teils wählen, an der er entlanggeht. Die Mitte des Profils bleibt auf dem Weg, seine Ecken sind auf Gehrung; ein Weg, der endet, wo er begann, ist geschlossen. Wände und Enden sind eigene Flächen.</translation>
    </message>
    <message>
        <source>Several at once, all alike: the middle of each profile.</source>
        <translation>Mehrere auf einmal, alle gleich: die Mitte jedes Profils.</translation>
    </message>
    <message>
        <source>Several at once, all alike: where each hole&apos;s axis enters a wall.</source>
        <translation>Mehrere auf einmal, alle gleich: wo die Achse jedes Lochs in eine Wand eintritt.</translation>
    </message>
    <message>
        <source>Select the wall and give the place, or take its middle. The hole gets surfaces of its own, so loads can be put on them. Holes may cut other holes, edges and fillets. With more places all holes are made, or none.</source>
        <translation>Die Wand wählen und den Ort angeben, oder ihre Mitte nehmen. Das Loch bekommt eigene Flächen, auf die Lasten gelegt werden können. Löcher dürfen andere Löcher, Kanten und Ausrundungen schneiden. Bei mehreren Orten werden alle Löcher gemacht oder keins.</translation>
    </message>
    <message>
        <source>Of capitals; of a logo its longer side, but for a DXF.</source>
        <translation>Der Großbuchstaben; bei einem Logo seine längere Seite, außer bei einer DXF.</translation>
    </message>
    <message>
        <source>A logo instead of the text: the filled shapes of an SVG or the outlines of a DXF.</source>
        <translation>Ein Logo statt des Textes: die gefüllten Formen einer SVG oder die Umrisse einer DXF.</translation>
    </message>
    <message>
        <source>Places for drains</source>
        <translation>Orte für Abläufe</translation>
    </message>
    <message>
        <source>Where more drain holes go, across the wall that is there.</source>
        <translation>Wo weitere Ablauflöcher hinkommen, quer durch die Wand dort.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Of a part with several regions the one that becomes hollow, by name or number. Empty: the one of the picked walls.</source>
        <translation>Bei einem Teil mit mehreren Bereichen der, der hohl wird, mit Name oder Nummer. Leer: der der gewählten Wände.</translation>
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
        <translation>zwischen %1 und %2</translation>
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
    <name>print_phrases</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
</context>
<context>
    <name>print_rows</name>
    <message>
        <source>... and %1 smaller</source>
        <translation>... und %1 kleinere</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no: %1 open edges</source>
        <translation>nein: %1 offene Kanten</translation>
    </message>
    <message>
        <source>Thin walls</source>
        <translation>Dünne Wände</translation>
    </message>
    <message>
        <source>none under %1</source>
        <translation>keine unter %1</translation>
    </message>
    <message>
        <source>%1 under %2, both sides counted</source>
        <translation>%1 unter %2, beide Seiten gezählt</translation>
    </message>
    <message>
        <source>down to %1, %2</source>
        <translation>bis herab zu %1, %2</translation>
    </message>
    <message>
        <source>Overhangs</source>
        <translation>Überhänge</translation>
    </message>
    <message>
        <source>none beyond %1</source>
        <translation>keine über %1</translation>
    </message>
    <message>
        <source>%1 lean more than %2</source>
        <translation>%1 hängen mehr als %2 über</translation>
    </message>
    <message>
        <source>up to %1, %2</source>
        <translation>bis %1, %2</translation>
    </message>
    <message>
        <source>Edges of more than two facets</source>
        <translation>Kanten mit mehr als zwei Facetten</translation>
    </message>
    <message>
        <source>Facets that meet others they should not</source>
        <translation>Facetten, die andere treffen, die sie nicht sollten</translation>
    </message>
    <message>
        <source>Closed voids</source>
        <translation>Geschlossene Hohlräume</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Surface area</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Umgebender Quader</translation>
    </message>
    <message>
        <source>On the plate</source>
        <translation>Auf der Bauplatte</translation>
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
    <name>server</name>
    <message>
        <source>&quot;%1&quot; cannot name a document</source>
        <translation>„%1“ kann kein Dokument heißen</translation>
    </message>
    <message>
        <source>&quot;tedit info&quot; lists the surfaces</source>
        <translation>„tedit info“ zählt die Flächen auf</translation>
    </message>
    <message>
        <source>&quot;tedit ops %1&quot; lists its parameters</source>
        <translation>„tedit ops %1“ zählt die Parameter auf</translation>
    </message>
    <message>
        <source>&quot;tedit ops&quot; lists those that there are</source>
        <translation>„tedit ops“ zählt die auf, die es gibt</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a whole number</source>
        <translation>%1 „%2“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1 %2 is out of range</source>
        <translation>%1 %2 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 %2s of %3 together were dropped</source>
        <translation>weggelassen: %1 × %2, zusammen %3</translation>
    </message>
    <message>
        <source>%1 (gravity) needs the density of every material</source>
        <translation>%1 (Schwerkraft) braucht die Dichte jedes Werkstoffs</translation>
    </message>
    <message>
        <source>%1 acts on no surface</source>
        <translation>%1 wirkt auf keine Fläche</translation>
    </message>
    <message>
        <source>%1 acts on surface</source>
        <translation>%1 wirkt auf Fläche</translation>
    </message>
    <message>
        <source>%1 acts on surfaces</source>
        <translation>%1 wirkt auf Flächen</translation>
    </message>
    <message>
        <source>%1 and %2 are the same tet twice</source>
        <translation>%1 und %2 sind zweimal derselbe Tetraeder</translation>
    </message>
    <message>
        <source>%1 and %2 lie on the same side of face %3: tets overlap</source>
        <translation>%1 und %2 liegen auf derselben Seite von Dreieck %3: Tetraeder überlappen sich</translation>
    </message>
    <message>
        <source>%1 belongs to a document that is not here</source>
        <translation>%1 gehört zu einem Dokument, das nicht da ist</translation>
    </message>
    <message>
        <source>%1 boundary components before, %2 after</source>
        <translation>vorher %1 getrennte Ränder, danach %2</translation>
    </message>
    <message>
        <source>%1 cannot be rounded so far at %2: %3</source>
        <translation>%1 lässt sich bei %2 nicht so weit runden: %3</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>%1 corner</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>%1 did not end within its time limit</source>
        <translation>%1: nicht innerhalb der Zeitgrenze fertig geworden</translation>
    </message>
    <message>
        <source>%1 ends where %2 surfaces meet at %3: it runs out there</source>
        <translation>%1 endet, wo %2 Flächen zusammenstoßen, bei %3: sie läuft dort aus</translation>
    </message>
    <message>
        <source>%1 ends where %2 surfaces meet at %3; only corners of three can be rounded</source>
        <translation>%1 endet, wo %2 Flächen zusammenstoßen, bei %3; gerundet werden nur Ecken von dreien</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 ist gescheitert: %2</translation>
    </message>
    <message>
        <source>%1 failed: its worker is gone (%2)</source>
        <translation>%1: gescheitert, der Arbeitsprozess ist weg (%2)</translation>
    </message>
    <message>
        <source>%1 has %2 along the bore, where its wall cannot take a pin&apos;s pressure</source>
        <translation>%1 hat %2 längs der Bohrung, wo ihre Wand den Druck eines Bolzens nicht aufnehmen kann</translation>
    </message>
    <message>
        <source>%1 has a moment, and its surfaces are only a line</source>
        <translation>%1 hat ein Moment, und die Flächen dazu sind nur eine Linie</translation>
    </message>
    <message>
        <source>%1 has format %2</source>
        <translation>%1 hat das Format %2</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;</source>
        <translation>%1 hat keinen Parameter „%2“</translation>
    </message>
    <message>
        <source>%1 has no vertex inside its border, so no layer of tets lies below it alone</source>
        <translation>%1 hat keine Ecke innerhalb des Randes, also liegt keine Schicht von Tetraedern darunter allein</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>%1 is a database, but no TEdit document</source>
        <translation>%1 ist eine Datenbank, aber kein TEdit-Dokument</translation>
    </message>
    <message>
        <source>%1 is as before</source>
        <translation>%1 ist wie zuvor</translation>
    </message>
    <message>
        <source>%1 is claimed by surface %2 and by surface %3</source>
        <translation>%1 beanspruchen Fläche %2 und Fläche %3</translation>
    </message>
    <message>
        <source>%1 is empty: it is no document</source>
        <translation>%1 ist leer: es ist kein Dokument</translation>
    </message>
    <message>
        <source>%1 is no face of any tet</source>
        <translation>%1 ist Seite keines Tetraeders</translation>
    </message>
    <message>
        <source>%1 is no file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>%1 is not a database</source>
        <translation>%1 ist keine Datenbank</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 is not held: free are %2</source>
        <translation>%1 ist nicht gehalten: frei sind %2</translation>
    </message>
    <message>
        <source>%1 is open already in an older program</source>
        <translation>%1 ist schon in einem älteren Programm offen</translation>
    </message>
    <message>
        <source>%1 is open already%2</source>
        <translation>%1 ist schon offen%2</translation>
    </message>
    <message>
        <source>%1 is open in another program, too</source>
        <translation>%1 ist auch in einem anderen Programm offen</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 is too bent to be closed</source>
        <translation>%1 ist zu krumm, um geschlossen zu werden</translation>
    </message>
    <message>
        <source>%1 is too large for a load case (more than 16 MiB)</source>
        <translation>%1 ist zu groß für einen Lastfall (mehr als 16 MiB)</translation>
    </message>
    <message>
        <source>%1 lies where regions %2 and %3 meet</source>
        <translation>%1 liegt, wo die Bereiche %2 und %3 zusammenstoßen</translation>
    </message>
    <message>
        <source>%1 live, %2 stated</source>
        <translation>%1 vorhanden, %2 angegeben</translation>
    </message>
    <message>
        <source>%1 loose crumbs of the part were removed with it</source>
        <translation>%1 lose Krümel des Bauteils wurden mit entfernt</translation>
    </message>
    <message>
        <source>%1 lost surface %2 and now acts on %3 (area %4)%5</source>
        <translation>%1 verlor Fläche %2 und wirkt jetzt auf %3 (Flächeninhalt %4)%5</translation>
    </message>
    <message>
        <source>%1 made an edit without a version</source>
        <translation>%1 machte eine Änderung ohne Version</translation>
    </message>
    <message>
        <source>%1 made it the head with %2 at %3</source>
        <translation>%1 machte sie dazu mit %2 am %3</translation>
    </message>
    <message>
        <source>%1 may not be written</source>
        <translation>%1 darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1 mm; it cannot be moved by as much towards its axis</source>
        <translation>%1 mm; sie kann nicht so weit zu ihrer Achse hin verschoben werden</translation>
    </message>
    <message>
        <source>%1 names a node that does not exist</source>
        <translation>%1 nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>%1 names node %2, which does not exist</source>
        <translation>%1 nennt Knoten %2, den es nicht gibt</translation>
    </message>
    <message>
        <source>%1 names surface %2, which this version of the mesh does not have</source>
        <translation>%1 nennt Fläche %2, die diese Version des Netzes nicht hat</translation>
    </message>
    <message>
        <source>%1 names the same node twice</source>
        <translation>%1 nennt denselben Knoten zweimal</translation>
    </message>
    <message>
        <source>%1 needs about %2, %3 has %4 left</source>
        <translation>%1 braucht etwa %2, aber %3 hat nur noch %4</translation>
    </message>
    <message>
        <source>%1 needs at least %2 selected surface</source>
        <translation>%1 braucht mindestens %2 ausgewählte Fläche</translation>
    </message>
    <message>
        <source>%1 needs at least %2 selected surfaces</source>
        <translation>%1 braucht mindestens %2 ausgewählte Flächen</translation>
    </message>
    <message>
        <source>%1 new surfaces, split at edges sharper than 30 degrees</source>
        <translation>%1 neue Flächen, getrennt an Kanten schärfer als 30 Grad</translation>
    </message>
    <message>
        <source>%1 no longer acts: surface %2 is gone</source>
        <translation>%1 wirkt nicht mehr: Fläche %2 ist weg</translation>
    </message>
    <message>
        <source>%1 no longer acts: surface %2 is gone and none took its place</source>
        <translation>%1 wirkt nicht mehr: Fläche %2 ist weg, und keine trat an ihre Stelle</translation>
    </message>
    <message>
        <source>%1 nodes lie at the place of another node, from %2 to %3, and are not merged: what touches there is not joined, and no force passes. Merge them where it should be one part (in Gmsh: Coherence)</source>
        <translation>%1 Knoten liegen am Ort eines anderen Knotens, von %2 bis %3, und sind nicht verschmolzen: was sich dort berührt, ist nicht verbunden, und keine Kraft geht hindurch. Sie verschmelzen, wo es ein Teil sein soll (in Gmsh: Coherence)</translation>
    </message>
    <message>
        <source>%1 on its area</source>
        <translation>%1 auf ihren Flächeninhalt</translation>
    </message>
    <message>
        <source>%1 presses on no wall: none of its surfaces faces it</source>
        <translation>%1 drückt auf keine Wand: keine ihrer Flächen ist ihr zugewandt</translation>
    </message>
    <message>
        <source>%1 presses on surface %2, which lies between two regions and has no outer side</source>
        <translation>%1 drückt auf Fläche %2, die zwischen zwei Bereichen liegt und keine Außenseite hat</translation>
    </message>
    <message>
        <source>%1 ran out of memory</source>
        <translation>%1: der Speicher ging aus</translation>
    </message>
    <message>
        <source>%1 runs out at %2, where surface %3 goes on smoothly</source>
        <translation>%1 läuft bei %2 aus, wo Fläche %3 glatt weitergeht</translation>
    </message>
    <message>
        <source>%1 takes at most %2 surface, %3 are selected</source>
        <translation>%1 nimmt höchstens %2 Fläche, ausgewählt sind %3</translation>
    </message>
    <message>
        <source>%1 takes at most %2 surfaces, %3 are selected</source>
        <translation>%1 nimmt höchstens %2 Flächen, ausgewählt sind %3</translation>
    </message>
    <message>
        <source>%1 tets %2: tet %3</source>
        <translation>%1 Tetraeder %2: Tetraeder %3</translation>
    </message>
    <message>
        <source>%1 tets have nodes on their edges; they are read as straight tets of their four corners</source>
        <translation>%1 Tetraeder haben Knoten auf ihren Kanten; gelesen werden sie als gerade Tetraeder ihrer vier Ecken</translation>
    </message>
    <message>
        <source>%1 tets have nodes on their edges; they are read as straight tets of their four corners%2</source>
        <translation>%1 Tetraeder haben Knoten auf ihren Kanten; gelesen werden sie als gerade Tetraeder ihrer vier Ecken%2</translation>
    </message>
    <message>
        <source>%1 tets listed their nodes the wrong way round and were turned: %2</source>
        <translation>%1 Tetraeder nannten ihre Knoten verkehrt herum und wurden gewendet: %2</translation>
    </message>
    <message>
        <source>%1 tets of zero volume lie on faces that other tets share and were left out: %2</source>
        <translation>%1 Tetraeder ohne Volumen liegen auf Seiten, die andere Tetraeder teilen, und wurden ausgelassen: %2</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 Threads</translation>
    </message>
    <message>
        <source>%1 threw something that is no std::exception</source>
        <translation>%1 warf etwas, das keine std::exception ist</translation>
    </message>
    <message>
        <source>%1 triangles are listed twice and counted once</source>
        <translation>%1 Dreiecke stehen zweimal da und zählen einmal</translation>
    </message>
    <message>
        <source>%1 triangles lie inside one region and are left out</source>
        <translation>%1 Dreiecke liegen innerhalb eines Bereichs und werden ausgelassen</translation>
    </message>
    <message>
        <source>%1 was made by another program meanwhile</source>
        <translation>%1 hat inzwischen ein anderes Programm gemacht</translation>
    </message>
    <message>
        <source>%1, ... (%2 in all)</source>
        <translation>%1, ... (%2 insgesamt)</translation>
    </message>
    <message>
        <source>%1: area of surface %2 is now %3 mm2 (%4)%5</source>
        <translation>%1: der Inhalt von Fläche %2 ist jetzt %3 mm2 (%4)%5</translation>
    </message>
    <message>
        <source>%1: its file system might replace another file by it</source>
        <translation>%1: sein Dateisystem könnte eine andere Datei damit ersetzen</translation>
    </message>
    <message>
        <source>%1: surface %2 is gone, its share moved to surface %3</source>
        <translation>%1: Fläche %2 ist weg, ihr Anteil ging auf Fläche %3 über</translation>
    </message>
    <message>
        <source>1 %1 of %2 was dropped</source>
        <translation>weggelassen: 1 %1, %2</translation>
    </message>
    <message>
        <source>13-node pyramid</source>
        <translation>Pyramide mit 13 Knoten</translation>
    </message>
    <message>
        <source>15-node prism</source>
        <translation>Prisma mit 15 Knoten</translation>
    </message>
    <message>
        <source>20-node hexahedron</source>
        <translation>Hexaeder mit 20 Knoten</translation>
    </message>
    <message>
        <source>8-node quadrangle</source>
        <translation>Viereck mit 8 Knoten</translation>
    </message>
    <message>
        <source>Add a load to the load case</source>
        <translation>Dem Lastfall eine Last hinzufügen</translation>
    </message>
    <message>
        <source>Ask for it again</source>
        <translation>Noch einmal verlangen</translation>
    </message>
    <message>
        <source>Ask for order 1 (linear) or 2 (quadratic)</source>
        <translation>Ordnung 1 (linear) oder 2 (quadratisch) verlangen</translation>
    </message>
    <message>
        <source>Ask for some of %1</source>
        <translation>Etwas verlangen von %1</translation>
    </message>
    <message>
        <source>Ask for the history to see which there are</source>
        <translation>Den Verlauf ansehen: er zeigt, welche es gibt</translation>
    </message>
    <message>
        <source>Ask for the preview again when that is done</source>
        <translation>Die Vorschau danach noch einmal verlangen</translation>
    </message>
    <message>
        <source>Assemble it again, or use --device cpu</source>
        <translation>Noch einmal aufstellen, oder --device cpu nehmen</translation>
    </message>
    <message>
        <source>Build or install TEdit again</source>
        <translation>TEdit neu bauen oder installieren</translation>
    </message>
    <message>
        <source>Check for very thin tets (tedit info), and for materials whose stiffness differs by many powers of ten</source>
        <translation>Nach sehr dünnen Tetraedern suchen (tedit info), und nach Werkstoffen, deren Steifigkeit sich um viele Zehnerpotenzen unterscheidet</translation>
    </message>
    <message>
        <source>Check for very thin tets (tedit info), or ask for a larger tolerance</source>
        <translation>Nach sehr dünnen Tetraedern suchen (tedit info), oder eine größere Toleranz verlangen</translation>
    </message>
    <message>
        <source>Check its coordinates and the length unit</source>
        <translation>Seine Koordinaten und die Längeneinheit prüfen</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Die Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>Check that the file and its folder are there</source>
        <translation>Prüfen, ob die Datei und ihr Ordner da sind</translation>
    </message>
    <message>
        <source>Check the coordinates of its nodes</source>
        <translation>Die Koordinaten seiner Knoten prüfen</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Den Pfad prüfen</translation>
    </message>
    <message>
        <source>Check the path and its permissions</source>
        <translation>Den Pfad und seine Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>Check the path, its permissions and the disk</source>
        <translation>Den Pfad, seine Zugriffsrechte und die Platte prüfen</translation>
    </message>
    <message>
        <source>Check the permissions and the owner of the file and its folder</source>
        <translation>Zugriffsrechte und Besitzer der Datei und ihres Ordners prüfen</translation>
    </message>
    <message>
        <source>Check the units of loads, materials and the mesh</source>
        <translation>Die Einheiten von Lasten, Werkstoffen und Netz prüfen</translation>
    </message>
    <message>
        <source>Check their units, and those of the materials</source>
        <translation>Ihre Einheiten und die der Werkstoffe prüfen</translation>
    </message>
    <message>
        <source>Choose a .msh file</source>
        <translation>Eine .msh-Datei wählen</translation>
    </message>
    <message>
        <source>Choose another one</source>
        <translation>Ein anderes wählen</translation>
    </message>
    <message>
        <source>Choose one of</source>
        <translation>Eines davon wählen</translation>
    </message>
    <message>
        <source>Close it in every program and copy its file</source>
        <translation>In jedem Programm schließen und die Datei kopieren</translation>
    </message>
    <message>
        <source>Close it in the other TEdit first</source>
        <translation>Zuerst im anderen TEdit schließen</translation>
    </message>
    <message>
        <source>Close it there, then try again</source>
        <translation>Dort schließen, dann noch einmal versuchen</translation>
    </message>
    <message>
        <source>Close other documents and try again</source>
        <translation>Andere Dokumente schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>Close other programs or take a coarser mesh</source>
        <translation>Andere Programme schließen oder ein gröberes Netz nehmen</translation>
    </message>
    <message>
        <source>Close other programs, raise the limit, or take a coarser mesh</source>
        <translation>Andere Programme schließen, die Grenze anheben oder ein gröberes Netz nehmen</translation>
    </message>
    <message>
        <source>Close the other program that uses the file</source>
        <translation>Das andere Programm schließen, das die Datei benutzt</translation>
    </message>
    <message>
        <source>Connect again.</source>
        <translation>Neu verbinden.</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>Ist %1 gemeint?</translation>
    </message>
    <message>
        <source>Did you mean %1? &quot;tedit ops&quot; lists all</source>
        <translation>Ist %1 gemeint? „tedit ops“ zählt alle auf</translation>
    </message>
    <message>
        <source>Facets over an arc of 90 degrees, at least; where the mesh is finer there are more.</source>
        <translation>Facetten über einen Bogen von 90 Grad, mindestens; wo das Netz feiner ist, sind es mehr.</translation>
    </message>
    <message>
        <source>Fill the hole (fill_hole) instead</source>
        <translation>Statt dessen das Loch schließen (fill_hole)</translation>
    </message>
    <message>
        <source>Fix or support more surfaces of it</source>
        <translation>Mehr seiner Flächen einspannen oder lagern</translation>
    </message>
    <message>
        <source>Give a depth above 0, or a number of layers</source>
        <translation>Eine Tiefe über 0 oder eine Zahl von Schichten angeben</translation>
    </message>
    <message>
        <source>Give a finite number</source>
        <translation>Eine endliche Zahl angeben</translation>
    </message>
    <message>
        <source>Give a number from %1 to %2</source>
        <translation>Eine Zahl von %1 bis %2 angeben</translation>
    </message>
    <message>
        <source>Give at least one</source>
        <translation>Mindestens einen angeben</translation>
    </message>
    <message>
        <source>Give at least one, with Young&apos;s modulus and Poisson&apos;s ratio</source>
        <translation>Mindestens einen angeben, mit E-Modul und Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Give both the same materials, or solve them one at a time</source>
        <translation>Beiden dieselben Werkstoffe geben, oder sie einzeln lösen</translation>
    </message>
    <message>
        <source>Give density_kg_m3</source>
        <translation>density_kg_m3 angeben</translation>
    </message>
    <message>
        <source>Give each boundary triangle one surface</source>
        <translation>Jedem Randdreieck eine Fläche geben</translation>
    </message>
    <message>
        <source>Give every change an edit_id of its own; only a retry has the same</source>
        <translation>Jeder Änderung eine eigene edit_id geben; nur eine Wiederholung hat dieselbe</translation>
    </message>
    <message>
        <source>Give finite numbers and a normal that is not zero</source>
        <translation>Endliche Zahlen angeben und eine Normale, die nicht null ist</translation>
    </message>
    <message>
        <source>Give it one of fixed, displacement, roller</source>
        <translation>Eine Art angeben: fixed, displacement, roller</translation>
    </message>
    <message>
        <source>Give it one of force, normal_force, traction, pressure, moment, remote_force, bearing_force, gravity</source>
        <translation>Eine Art angeben: force, normal_force, traction, pressure, moment, remote_force, bearing_force, gravity</translation>
    </message>
    <message>
        <source>Give surface ids</source>
        <translation>Flächennummern angeben</translation>
    </message>
    <message>
        <source>Give that part as a force of its own</source>
        <translation>Diesen Teil als eigene Kraft angeben</translation>
    </message>
    <message>
        <source>Give the new document another name</source>
        <translation>Dem neuen Dokument einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Give this one another name</source>
        <translation>Diesem einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Import a mesh first</source>
        <translation>Zuerst ein Netz importieren</translation>
    </message>
    <message>
        <source>Import one first</source>
        <translation>Zuerst eines importieren</translation>
    </message>
    <message>
        <source>Import or drop what was sent, or raise limits.upload_bytes in the server&apos;s configuration</source>
        <translation>Importieren oder verwerfen, was gesendet wurde, oder limits.upload_bytes in der Konfiguration des Servers anheben</translation>
    </message>
    <message>
        <source>Import some of them first</source>
        <translation>Zuerst einige davon importieren</translation>
    </message>
    <message>
        <source>Improve the mesh there first</source>
        <translation>Zuerst das Netz dort verbessern</translation>
    </message>
    <message>
        <source>It is cut off: write or copy it again</source>
        <translation>Sie ist abgeschnitten: neu schreiben oder kopieren</translation>
    </message>
    <message>
        <source>It must lie between -1 and 0.5, both excluded</source>
        <translation>Sie muss zwischen -1 und 0.5 liegen, beide ausgeschlossen</translation>
    </message>
    <message>
        <source>It takes %1 to %2 %3</source>
        <translation>Erlaubt sind %1 bis %2 %3</translation>
    </message>
    <message>
        <source>It takes 0 to %1 mm here, a hundredth of the part&apos;s diagonal</source>
        <translation>Erlaubt sind hier 0 bis %1 mm, ein Hundertstel der Diagonale des Bauteils</translation>
    </message>
    <message>
        <source>Look at its name, then ask again</source>
        <translation>Den Namen ansehen, dann noch einmal verlangen</translation>
    </message>
    <message>
        <source>Look at the new head, then ask again</source>
        <translation>Die neue aktuelle Version ansehen, dann noch einmal verlangen</translation>
    </message>
    <message>
        <source>MSH version %1 is not supported</source>
        <translation>MSH-Version %1 wird nicht gelesen</translation>
    </message>
    <message>
        <source>Mesh it first: gmsh part.step -3 -format msh41 -o part.msh</source>
        <translation>Zuerst vernetzen: gmsh part.step -3 -format msh41 -o part.msh</translation>
    </message>
    <message>
        <source>Mesh its volume first, for example with Gmsh</source>
        <translation>Zuerst sein Volumen vernetzen, etwa mit Gmsh</translation>
    </message>
    <message>
        <source>Mesh the part again</source>
        <translation>Das Bauteil neu vernetzen</translation>
    </message>
    <message>
        <source>Mesh the volume in Gmsh (3D) and save all elements</source>
        <translation>Das Volumen in Gmsh vernetzen (3D) und alle Elemente speichern</translation>
    </message>
    <message>
        <source>Mesh the volume with tetrahedra</source>
        <translation>Das Volumen mit Tetraedern vernetzen</translation>
    </message>
    <message>
        <source>Mesh the volume, not only its surface</source>
        <translation>Das Volumen vernetzen, nicht nur seine Oberfläche</translation>
    </message>
    <message>
        <source>Name a TEdit document or a new file</source>
        <translation>Ein TEdit-Dokument oder eine neue Datei nennen</translation>
    </message>
    <message>
        <source>Name a TEdit document or a new file; a mesh file is imported, not opened</source>
        <translation>Ein TEdit-Dokument oder eine neue Datei nennen; eine Netzdatei wird importiert, nicht geöffnet</translation>
    </message>
    <message>
        <source>Name another file</source>
        <translation>Eine andere Datei nennen</translation>
    </message>
    <message>
        <source>Name at least one surface</source>
        <translation>Mindestens eine Fläche nennen</translation>
    </message>
    <message>
        <source>Name each load case once</source>
        <translation>Jeden Lastfall einmal nennen</translation>
    </message>
    <message>
        <source>Name each region in one material</source>
        <translation>Jeden Bereich in einem Werkstoff nennen</translation>
    </message>
    <message>
        <source>Name it in a material, or give one material without regions</source>
        <translation>Ihn in einem Werkstoff nennen, oder einen Werkstoff ohne Bereiche angeben</translation>
    </message>
    <message>
        <source>Name one that the head has</source>
        <translation>Einen nennen, den die aktuelle Version hat</translation>
    </message>
    <message>
        <source>Only one material can stand for all remaining regions</source>
        <translation>Nur ein Werkstoff kann für alle übrigen Bereiche stehen</translation>
    </message>
    <message>
        <source>Open a document first.</source>
        <translation>Zuerst ein Dokument öffnen.</translation>
    </message>
    <message>
        <source>Open a part in it first</source>
        <translation>Zuerst ein Bauteil darin öffnen</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Noch einmal öffnen</translation>
    </message>
    <message>
        <source>Open it with a newer TEdit; this one reads up to %1</source>
        <translation>Mit einem neueren TEdit öffnen; dieses liest bis %1</translation>
    </message>
    <message>
        <source>Pick a surface of a boss, rib or fin, or take the surface alone</source>
        <translation>Eine Fläche eines Auges oder einer Rippe anklicken, oder nur die Fläche nehmen</translation>
    </message>
    <message>
        <source>Pick a wall of a hole, or take the surface alone</source>
        <translation>Eine Wand eines Lochs anklicken, oder nur die Fläche nehmen</translation>
    </message>
    <message>
        <source>Prescribe one value for each direction where surfaces meet</source>
        <translation>Einen Wert für jede Richtung vorgeben, wo Flächen zusammenstoßen</translation>
    </message>
    <message>
        <source>Put it on surfaces with a width</source>
        <translation>Sie auf Flächen mit Breite setzen</translation>
    </message>
    <message>
        <source>Put that document back beside it, or remove it to give its name to another</source>
        <translation>Dieses Dokument wieder daneben legen, oder sie entfernen, um den Namen neu zu vergeben</translation>
    </message>
    <message>
        <source>Put the document itself in its place, then try again</source>
        <translation>Das Dokument selbst an seine Stelle legen, dann noch einmal versuchen</translation>
    </message>
    <message>
        <source>Put the rest into the note</source>
        <translation>Den Rest in die Notiz schreiben</translation>
    </message>
    <message>
        <source>Put them elsewhere first, or let the edit move or drop them</source>
        <translation>Sie zuerst anderswo ansetzen, oder durch die Bearbeitung verschieben oder entfallen lassen</translation>
    </message>
    <message>
        <source>Radius of the ball that rolls along both walls.</source>
        <translation>Radius der Kugel, die an beiden Wänden entlangrollt.</translation>
    </message>
    <message>
        <source>Rebuild it against this version, or remove it</source>
        <translation>Gegen diese Version neu bauen oder entfernen</translation>
    </message>
    <message>
        <source>Remove load cases that are not needed</source>
        <translation>Lastfälle entfernen, die nicht gebraucht werden</translation>
    </message>
    <message>
        <source>Remove one of them: its stiffness would count double</source>
        <translation>Einen davon entfernen: seine Steifigkeit zählte doppelt</translation>
    </message>
    <message>
        <source>Repair or remesh the part there</source>
        <translation>Das Bauteil dort reparieren oder neu vernetzen</translation>
    </message>
    <message>
        <source>Repair the mesh there first</source>
        <translation>Zuerst das Netz dort reparieren</translation>
    </message>
    <message>
        <source>Restore it from a backup, or remove it to begin a new document of this name</source>
        <translation>Aus einer Sicherung wiederherstellen, oder entfernen, um ein neues Dokument dieses Namens zu beginnen</translation>
    </message>
    <message>
        <source>Restore the document from a backup</source>
        <translation>Das Dokument aus einer Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>Save a copy under the other name</source>
        <translation>Unter dem anderen Namen eine Kopie speichern</translation>
    </message>
    <message>
        <source>Save the mesh as MSH 4.1 or 2.2</source>
        <translation>Das Netz als MSH 4.1 oder 2.2 speichern</translation>
    </message>
    <message>
        <source>See the message LoadCase in protocol/tedit/v1/load_case.proto</source>
        <translation>Siehe die Nachricht LoadCase in protocol/tedit/v1/load_case.proto</translation>
    </message>
    <message>
        <source>Select a surface with a simple border</source>
        <translation>Eine Fläche mit einfachem Rand auswählen</translation>
    </message>
    <message>
        <source>Select all surfaces inside the hole, or fill what stands in it first</source>
        <translation>Alle Flächen im Loch auswählen, oder zuerst füllen, was darin steht</translation>
    </message>
    <message>
        <source>Select all surfaces of the hole</source>
        <translation>Alle Flächen des Lochs auswählen</translation>
    </message>
    <message>
        <source>Select all surfaces of the hole, or only those up to a clean edge</source>
        <translation>Alle Flächen des Lochs auswählen, oder nur die bis zu einer klaren Kante</translation>
    </message>
    <message>
        <source>Select all wall surfaces of the hole</source>
        <translation>Alle Wandflächen des Lochs auswählen</translation>
    </message>
    <message>
        <source>Select fewer</source>
        <translation>Weniger auswählen</translation>
    </message>
    <message>
        <source>Select fewer surfaces</source>
        <translation>Weniger Flächen auswählen</translation>
    </message>
    <message>
        <source>Select more surfaces, or take off a metric depth (parameter depth)</source>
        <translation>Mehr Flächen auswählen, oder eine Tiefe als Länge abtragen (Parameter Tiefe)</translation>
    </message>
    <message>
        <source>Select other edges</source>
        <translation>Andere Kanten auswählen</translation>
    </message>
    <message>
        <source>Select other surfaces: a smaller %1 does not work here</source>
        <translation>Andere Flächen auswählen: ein kleinerer Wert (%1) geht hier nicht</translation>
    </message>
    <message>
        <source>Select surface %1, too</source>
        <translation>Auch Fläche %1 auswählen</translation>
    </message>
    <message>
        <source>Select surfaces of the outside</source>
        <translation>Flächen der Außenseite auswählen</translation>
    </message>
    <message>
        <source>Select surfaces of the protrusion alone</source>
        <translation>Nur Flächen des Vorsprungs auswählen</translation>
    </message>
    <message>
        <source>Select the inner walls of a hole</source>
        <translation>Die Innenwände eines Lochs auswählen</translation>
    </message>
    <message>
        <source>Select the sides of a boss, rib or fin</source>
        <translation>Die Seiten eines Auges oder einer Rippe auswählen</translation>
    </message>
    <message>
        <source>Select the sides of one boss, rib or fin</source>
        <translation>Die Seiten eines Auges oder einer Rippe auswählen</translation>
    </message>
    <message>
        <source>Select the sides of one boss, rib or fin; fill_hole closes holes and pockets</source>
        <translation>Die Seiten eines Auges oder einer Rippe auswählen; „Loch schließen“ schließt Löcher und Taschen</translation>
    </message>
    <message>
        <source>Select the walls of a hole</source>
        <translation>Die Wände eines Lochs auswählen</translation>
    </message>
    <message>
        <source>Select the walls of one hole, without surfaces beside it</source>
        <translation>Die Wände eines Lochs auswählen, ohne Flächen daneben</translation>
    </message>
    <message>
        <source>Select the whole hole up to a clean edge</source>
        <translation>Das ganze Loch bis zu einer klaren Kante auswählen</translation>
    </message>
    <message>
        <source>Select two walls that meet at an inner corner, or use open for outer edges</source>
        <translation>Zwei Wände auswählen, die an einer Innenecke zusammenstoßen, oder für Außenkanten „Kanten abrunden“ nehmen</translation>
    </message>
    <message>
        <source>Select two walls that meet at an outer edge, or use close for inner corners</source>
        <translation>Zwei Wände auswählen, die an einer Außenkante zusammenstoßen, oder für Innenecken „Innenecken ausrunden“ nehmen</translation>
    </message>
    <message>
        <source>Select two walls that meet, or one wall for all its edges</source>
        <translation>Zwei Wände auswählen, die zusammenstoßen, oder eine Wand für alle ihre Kanten</translation>
    </message>
    <message>
        <source>Select up to a clean edge</source>
        <translation>Bis zu einer klaren Kante auswählen</translation>
    </message>
    <message>
        <source>Select what to put material on</source>
        <translation>Auswählen, worauf Werkstoff kommen soll</translation>
    </message>
    <message>
        <source>Select what to take material off</source>
        <translation>Auswählen, wovon Werkstoff abgetragen werden soll</translation>
    </message>
    <message>
        <source>Send the file again</source>
        <translation>Die Datei noch einmal senden</translation>
    </message>
    <message>
        <source>Send the file again later, or raise limits.all_upload_bytes in the server&apos;s configuration</source>
        <translation>Die Datei später noch einmal senden, oder limits.all_upload_bytes in der Konfiguration des Servers anheben</translation>
    </message>
    <message>
        <source>Set the load case first</source>
        <translation>Zuerst den Lastfall setzen</translation>
    </message>
    <message>
        <source>Shorten it</source>
        <translation>Kürzer fassen</translation>
    </message>
    <message>
        <source>Surface and volume mesh must fit together: mesh the part again</source>
        <translation>Oberflächen- und Volumennetz müssen zusammenpassen: das Bauteil neu vernetzen</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>Take %1, which works here</source>
        <translation>%1 nehmen: das geht hier</translation>
    </message>
    <message>
        <source>Take %1: the most that works here</source>
        <translation>%1 nehmen: das Größte, was hier geht</translation>
    </message>
    <message>
        <source>Take DROP, MOVE or REFUSE</source>
        <translation>DROP, MOVE oder REFUSE nehmen</translation>
    </message>
    <message>
        <source>Take a coarser mesh, or a machine with more memory</source>
        <translation>Ein gröberes Netz nehmen, oder einen Rechner mit mehr Speicher</translation>
    </message>
    <message>
        <source>Take a coarser mesh, or raise the limit in the server&apos;s configuration</source>
        <translation>Ein gröberes Netz nehmen, oder die Grenze in der Konfiguration des Servers anheben</translation>
    </message>
    <message>
        <source>Take a coarser mesh, or use --device cpu</source>
        <translation>Ein gröberes Netz nehmen, oder --device cpu</translation>
    </message>
    <message>
        <source>Take a smaller %1, or select other surfaces</source>
        <translation>Einen kleineren Wert nehmen (%1), oder andere Flächen auswählen</translation>
    </message>
    <message>
        <source>Take another name</source>
        <translation>Einen anderen Namen nehmen</translation>
    </message>
    <message>
        <source>Take at most %1 printable ASCII characters without spaces, for example a UUID</source>
        <translation>Höchstens %1 druckbare ASCII-Zeichen ohne Leerzeichen nehmen, etwa eine UUID</translation>
    </message>
    <message>
        <source>Take at most 64 letters, digits, &apos;.&apos;, &apos;_&apos; and &apos;-&apos;, not beginning with a dot</source>
        <translation>Höchstens 64 Buchstaben, Ziffern, &apos;.&apos;, &apos;_&apos; und &apos;-&apos; nehmen, nicht mit einem Punkt am Anfang</translation>
    </message>
    <message>
        <source>Take drop, move or refuse</source>
        <translation>drop, move oder refuse nehmen</translation>
    </message>
    <message>
        <source>Take fewer segments or edges, or a radius of at least %1</source>
        <translation>Weniger Segmente oder Kanten nehmen, oder einen Radius von mindestens %1</translation>
    </message>
    <message>
        <source>Take less off</source>
        <translation>Weniger abtragen</translation>
    </message>
    <message>
        <source>Take less off, select fewer surfaces, or say what to keep (erode: parameter pieces)</source>
        <translation>Weniger abtragen, weniger Flächen auswählen, oder sagen, was bleiben soll (Abtragen: Parameter Stücke)</translation>
    </message>
    <message>
        <source>Take off a length (parameter depth), or select the surfaces beside it, too</source>
        <translation>Eine Länge abtragen (Parameter Tiefe), oder auch die Flächen daneben auswählen</translation>
    </message>
    <message>
        <source>Take off fewer layers, or a length (parameter depth)</source>
        <translation>Weniger Schichten abtragen, oder eine Länge (Parameter Tiefe)</translation>
    </message>
    <message>
        <source>Take one line of at most %1 bytes</source>
        <translation>Eine Zeile von höchstens %1 Byte nehmen</translation>
    </message>
    <message>
        <source>Take powers of two, at most %1, and no more rows than invocations</source>
        <translation>Zweierpotenzen nehmen, höchstens %1, und nicht mehr Zeilen als Aufrufe</translation>
    </message>
    <message>
        <source>The disk failed: check it, and restore the file from a backup</source>
        <translation>Die Platte hat versagt: sie prüfen und die Datei aus einer Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>The disk is full: free some space and try again</source>
        <translation>Die Platte ist voll: Platz schaffen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>The file is cut off or damaged: write it again</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt: neu schreiben</translation>
    </message>
    <message>
        <source>The file is no binary MSH file, or it is damaged</source>
        <translation>Die Datei ist keine binäre MSH-Datei, oder sie ist beschädigt</translation>
    </message>
    <message>
        <source>The file system is mounted read-only: choose a folder that can be written</source>
        <translation>Das Dateisystem ist nur lesbar eingehängt: einen Ordner wählen, in den geschrieben werden kann</translation>
    </message>
    <message>
        <source>The history lists those that there are</source>
        <translation>Der Verlauf zählt die auf, die es gibt</translation>
    </message>
    <message>
        <source>The last one is %1</source>
        <translation>Der letzte ist %1</translation>
    </message>
    <message>
        <source>The nearest id that it has is %1</source>
        <translation>Die nächste vorhandene Nummer ist %1</translation>
    </message>
    <message>
        <source>The server restarts workers by itself; try again</source>
        <translation>Der Server startet Arbeitsprozesse von selbst neu; noch einmal versuchen</translation>
    </message>
    <message>
        <source>The system has too many files open: end other programs or raise fs.file-max</source>
        <translation>Im System sind zu viele Dateien offen: andere Programme beenden oder fs.file-max anheben</translation>
    </message>
    <message>
        <source>The version is unchanged. &quot;tedit plugin test&quot; looks for such faults; report this to the plugin&apos;s author</source>
        <translation>Die Version ist unverändert. „tedit plugin test“ sucht nach solchen Fehlern; dem Autor des Plugins melden</translation>
    </message>
    <message>
        <source>The version is unchanged. Close other programs, or take a coarser mesh</source>
        <translation>Die Version ist unverändert. Andere Programme schließen, oder ein gröberes Netz nehmen</translation>
    </message>
    <message>
        <source>The version is unchanged; select fewer or other surfaces</source>
        <translation>Die Version ist unverändert; weniger oder andere Flächen auswählen</translation>
    </message>
    <message>
        <source>The version is unchanged; try other surfaces or parameters</source>
        <translation>Die Version ist unverändert; andere Flächen oder Parameter versuchen</translation>
    </message>
    <message>
        <source>They are started again within a minute; the server&apos;s log says more</source>
        <translation>Sie werden binnen einer Minute neu gestartet; das Protokoll des Servers sagt mehr</translation>
    </message>
    <message>
        <source>This is a defect of TEdit: please report it</source>
        <translation>Dies ist ein Fehler in TEdit: bitte melden</translation>
    </message>
    <message>
        <source>This is a defect of the operation: please report it</source>
        <translation>Dies ist ein Fehler der Operation: bitte melden</translation>
    </message>
    <message>
        <source>This process has too many files open: start it with a higher limit (ulimit -n)</source>
        <translation>Dieser Prozess hat zu viele Dateien offen: mit einer höheren Grenze starten (ulimit -n)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Try again soon</source>
        <translation>Bald noch einmal versuchen</translation>
    </message>
    <message>
        <source>Try other values; if it goes on, report it with the server&apos;s log</source>
        <translation>Andere Werte versuchen; wenn es so bleibt, mit dem Protokoll des Servers melden</translation>
    </message>
    <message>
        <source>Turn the force round, or put it on the wall of a bore</source>
        <translation>Die Kraft umdrehen, oder sie auf die Wand einer Bohrung setzen</translation>
    </message>
    <message>
        <source>Use %1 there</source>
        <translation>Dort %1 nehmen</translation>
    </message>
    <message>
        <source>Use a server and workers of one release</source>
        <translation>Server und Arbeitsprozesse derselben Ausgabe benutzen</translation>
    </message>
    <message>
        <source>Use auto or one of: %1</source>
        <translation>auto nehmen oder eines von: %1</translation>
    </message>
    <message>
        <source>Use the device cpu, or mesh the part in fewer pieces</source>
        <translation>Das Gerät cpu nehmen, oder das Bauteil in weniger Stücken vernetzen</translation>
    </message>
    <message>
        <source>Write the mesh again</source>
        <translation>Das Netz neu schreiben</translation>
    </message>
    <message>
        <source>Your disk quota is used up: free some space and try again</source>
        <translation>Das Plattenkontingent ist erschöpft: Platz schaffen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>a STEP file (CAD geometry)</source>
        <translation>eine STEP-Datei (CAD-Geometrie)</translation>
    </message>
    <message>
        <source>a blocking call from one of the client&apos;s own events</source>
        <translation>ein wartender Aufruf aus einem Ereignis des Clients selbst</translation>
    </message>
    <message>
        <source>a bounding box coordinate of entity %1</source>
        <translation>eine Koordinate der Hülle von Einheit %1</translation>
    </message>
    <message>
        <source>a cap over the hole would cut surface %1</source>
        <translation>ein Deckel über dem Loch würde Fläche %1 schneiden</translation>
    </message>
    <message>
        <source>a cap over the hole would lie inside the part</source>
        <translation>ein Deckel über dem Loch läge im Inneren des Bauteils</translation>
    </message>
    <message>
        <source>a client without a name</source>
        <translation>ein Client ohne Namen</translation>
    </message>
    <message>
        <source>a coordinate of a node</source>
        <translation>eine Koordinate eines Knotens</translation>
    </message>
    <message>
        <source>a coordinate of node %1</source>
        <translation>eine Koordinate von Knoten %1</translation>
    </message>
    <message>
        <source>a corner moved</source>
        <translation>eine Ecke hat sich bewegt</translation>
    </message>
    <message>
        <source>a document is written with all its versions, as they are</source>
        <translation>ein Dokument wird mit allen Versionen geschrieben, wie sie sind</translation>
    </message>
    <message>
        <source>a hole is found from one surface of its wall</source>
        <translation>ein Loch wird von einer Fläche seiner Wand aus gefunden</translation>
    </message>
    <message>
        <source>a mesh holds at most 2^31 tets</source>
        <translation>ein Netz fasst höchstens 2^31 Tetraeder</translation>
    </message>
    <message>
        <source>a newer version is the head</source>
        <translation>eine neuere Version ist die aktuelle</translation>
    </message>
    <message>
        <source>a node block&apos;s dimension or parametric flag is out of range</source>
        <translation>Dimension oder Parameterkennung eines Knotenblocks liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a node of the element</source>
        <translation>ein Knoten des Elements</translation>
    </message>
    <message>
        <source>a page to store is null or over 64 KiB</source>
        <translation>eine zu speichernde Seite ist leer oder größer als 64 KiB</translation>
    </message>
    <message>
        <source>a parametric coordinate</source>
        <translation>eine Parameterkoordinate</translation>
    </message>
    <message>
        <source>a part of this problem has %1 MiB, the device can bind %2</source>
        <translation>ein Teil dieser Aufgabe hat %1 MiB, das Gerät kann %2 binden</translation>
    </message>
    <message>
        <source>a physical name must stand in double quotes</source>
        <translation>ein physikalischer Name muss in doppelten Anführungszeichen stehen</translation>
    </message>
    <message>
        <source>a piece of an upload is missing: it goes on at byte %1 after %2 bytes</source>
        <translation>ein Stück der Übertragung fehlt: sie geht bei Byte %1 weiter nach %2 Byte</translation>
    </message>
    <message>
        <source>a radius of %1 on %2 would need more than %3 facets: the edge is %4 long, the mesh&apos;s edges %5</source>
        <translation>ein Radius von %1 an %2 brauchte mehr als %3 Facetten: die Kante ist %4 lang, die Kanten des Netzes %5</translation>
    </message>
    <message>
        <source>a request cannot be encoded</source>
        <translation>eine Anfrage lässt sich nicht verschlüsseln</translation>
    </message>
    <message>
        <source>a rim crosses itself or another rim</source>
        <translation>ein Rand kreuzt sich selbst oder einen anderen Rand</translation>
    </message>
    <message>
        <source>a rim encloses no area</source>
        <translation>ein Rand umschließt keine Fläche</translation>
    </message>
    <message>
        <source>a section name was expected here, not &quot;%1&quot;</source>
        <translation>hier wurde der Name eines Abschnitts erwartet, nicht „%1“</translation>
    </message>
    <message>
        <source>a traction or a force</source>
        <translation>eine Flächenlast oder eine Kraft</translation>
    </message>
    <message>
        <source>a triangle names a node that does not exist</source>
        <translation>ein Dreieck nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>a version&apos;s name has at most %1 characters and is one line</source>
        <translation>der Name einer Version hat höchstens %1 Zeichen und ist eine Zeile</translation>
    </message>
    <message>
        <source>a version&apos;s note has at most %1 printable characters</source>
        <translation>die Notiz einer Version hat höchstens %1 druckbare Zeichen</translation>
    </message>
    <message>
        <source>a worker has not enough memory for this</source>
        <translation>ein Arbeitsprozess hat dafür nicht genug Speicher</translation>
    </message>
    <message>
        <source>all boundary faces have the surface id %1, though edges sharper than 30 degrees part them into %2 patches: only the whole boundary can be picked. Save the faces of the CAD model as surfaces, or leave the triangles out of the file to have it split at those edges</source>
        <translation>alle Randdreiecke haben die Flächennummer %1, obwohl Kanten schärfer als 30 Grad sie in %2 Stücke teilen: nur der ganze Rand lässt sich anklicken. Die Flächen des CAD-Modells als Flächen speichern, oder die Dreiecke in der Datei weglassen, damit an diesen Kanten geteilt wird</translation>
    </message>
    <message>
        <source>all six rigid-body motions</source>
        <translation>alle sechs Starrkörperbewegungen</translation>
    </message>
    <message>
        <source>an earlier failure left this system incomplete</source>
        <translation>ein früherer Fehler ließ dieses System unvollständig</translation>
    </message>
    <message>
        <source>an edit moved %1 from %2 mm2 to %3 mm2 (surface %4): check that it may act on all of that</source>
        <translation>eine Bearbeitung verlegte %1 von %2 mm2 auf %3 mm2 (Fläche %4): prüfen, ob sie auf all das wirken darf</translation>
    </message>
    <message>
        <source>an edit takes at most %1 surfaces, not %2</source>
        <translation>eine Bearbeitung nimmt höchstens %1 Flächen, nicht %2</translation>
    </message>
    <message>
        <source>an element block&apos;s counts are out of range</source>
        <translation>die Zahlen eines Elementblocks liegen außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>an element has %1 tags</source>
        <translation>ein Element hat %1 Kennungen</translation>
    </message>
    <message>
        <source>another preview was asked for meanwhile</source>
        <translation>inzwischen wurde eine andere Vorschau verlangt</translation>
    </message>
    <message>
        <source>another section was asked for meanwhile</source>
        <translation>inzwischen wurde ein anderer Schnitt verlangt</translation>
    </message>
    <message>
        <source>are inverted (negative volume)</source>
        <translation>sind umgestülpt (negatives Volumen)</translation>
    </message>
    <message>
        <source>around %1</source>
        <translation>um %1</translation>
    </message>
    <message>
        <source>assembling</source>
        <translation>Aufstellen</translation>
    </message>
    <message>
        <source>bearing force</source>
        <translation>Lagerkraft</translation>
    </message>
    <message>
        <source>between surfaces %1 has no concave edge (inner corner) to be rounded</source>
        <translation>zwischen den Flächen %1 liegt keine einspringende Kante (Innenecke) zum Runden</translation>
    </message>
    <message>
        <source>between surfaces %1 has no convex edge (outer edge) to be rounded</source>
        <translation>zwischen den Flächen %1 liegt keine vorspringende Kante (Außenkante) zum Runden</translation>
    </message>
    <message>
        <source>between surfaces %1 there is no concave edge (inner corner) to be rounded</source>
        <translation>zwischen den Flächen %1 liegt keine einspringende Kante (Innenecke) zum Runden</translation>
    </message>
    <message>
        <source>between surfaces %1 there is no convex edge (outer edge) to be rounded</source>
        <translation>zwischen den Flächen %1 liegt keine vorspringende Kante (Außenkante) zum Runden</translation>
    </message>
    <message>
        <source>binary files need 8-byte numbers, this one says %1</source>
        <translation>binäre Dateien brauchen Zahlen von 8 Byte, diese nennt %1</translation>
    </message>
    <message>
        <source>boundary face has its facet</source>
        <translation>Randdreieck hat seine Facette</translation>
    </message>
    <message>
        <source>boundary is a 2-manifold</source>
        <translation>Rand ist eine 2-Mannigfaltigkeit</translation>
    </message>
    <message>
        <source>bounding entities</source>
        <translation>begrenzende Einheiten</translation>
    </message>
    <message>
        <source>bounding entity</source>
        <translation>begrenzende Einheit</translation>
    </message>
    <message>
        <source>byte offset %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>cancelled, but the server did not confirm it</source>
        <translation>abgebrochen, aber der Server hat es nicht bestätigt</translation>
    </message>
    <message>
        <source>cannot compress: %1</source>
        <translation>Verdichten gescheitert: %1</translation>
    </message>
    <message>
        <source>cannot lock %1</source>
        <translation>%1 lässt sich nicht sperren</translation>
    </message>
    <message>
        <source>cannot open &apos;%1&apos;: %2</source>
        <translation>„%1“ lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>cannot read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>cannot read the load case %1</source>
        <translation>der Lastfall %1 lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>nicht schreibbar</translation>
    </message>
    <message>
        <source>change of the radius, fitted</source>
        <translation>Änderung des Radius, angepasst</translation>
    </message>
    <message>
        <source>checking the edit</source>
        <translation>Prüfen der Bearbeitung</translation>
    </message>
    <message>
        <source>closing the document</source>
        <translation>Schließen des Dokuments</translation>
    </message>
    <message>
        <source>concave edge (inner corner)</source>
        <translation>einspringende Kante (Innenecke)</translation>
    </message>
    <message>
        <source>constraint %1</source>
        <translation>Lager %1</translation>
    </message>
    <message>
        <source>constraint %1 (%2)</source>
        <translation>Lager %1 (%2)</translation>
    </message>
    <message>
        <source>constraint %1 contradicts another one on surface %2</source>
        <translation>Lager %1 widerspricht einem anderen auf Fläche %2</translation>
    </message>
    <message>
        <source>constraint %1 names no surface</source>
        <translation>Lager %1 nennt keine Fläche</translation>
    </message>
    <message>
        <source>constraint %1 says no kind</source>
        <translation>Lager %1 nennt keine Art</translation>
    </message>
    <message>
        <source>convex edge (outer edge)</source>
        <translation>vorspringende Kante (Außenkante)</translation>
    </message>
    <message>
        <source>corners exist</source>
        <translation>Ecken sind da</translation>
    </message>
    <message>
        <source>counts are right</source>
        <translation>Zahlen stimmen</translation>
    </message>
    <message>
        <source>crumbs dropped</source>
        <translation>Krümel entfallen</translation>
    </message>
    <message>
        <source>cubic line</source>
        <translation>kubische Linie</translation>
    </message>
    <message>
        <source>cubic tetrahedron</source>
        <translation>kubischer Tetraeder</translation>
    </message>
    <message>
        <source>cubic triangle</source>
        <translation>kubisches Dreieck</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>cutting at the foot</source>
        <translation>Schneiden am Fuß</translation>
    </message>
    <message>
        <source>data size</source>
        <translation>Zahlengröße</translation>
    </message>
    <message>
        <source>did not answer any more</source>
        <translation>antwortete nicht mehr</translation>
    </message>
    <message>
        <source>did not end when it was cancelled</source>
        <translation>endete nicht, als er abgebrochen wurde</translation>
    </message>
    <message>
        <source>did not start in time</source>
        <translation>startete nicht rechtzeitig</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>edge %1-%2 has more than two facets</source>
        <translation>Kante %1-%2 hat mehr als zwei Facetten</translation>
    </message>
    <message>
        <source>edge %1-%2 has one facet</source>
        <translation>Kante %1-%2 hat eine Facette</translation>
    </message>
    <message>
        <source>element %1 names node %2</source>
        <translation>Element %1 nennt Knoten %2</translation>
    </message>
    <message>
        <source>element blocks</source>
        <translation>Elementblöcke</translation>
    </message>
    <message>
        <source>element number</source>
        <translation>Elementnummer</translation>
    </message>
    <message>
        <source>element type</source>
        <translation>Elementart</translation>
    </message>
    <message>
        <source>elements in a block</source>
        <translation>Elemente in einem Block</translation>
    </message>
    <message>
        <source>ended with status %1</source>
        <translation>endete mit Status %1</translation>
    </message>
    <message>
        <source>entity dimension</source>
        <translation>Dimension der Einheit</translation>
    </message>
    <message>
        <source>entity tag</source>
        <translation>Kennung der Einheit</translation>
    </message>
    <message>
        <source>entity tag %1 is out of range</source>
        <translation>Kennung %1 einer Einheit liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>eroded</source>
        <translation>abgetragen</translation>
    </message>
    <message>
        <source>eroded %1</source>
        <translation>abgetragene %1</translation>
    </message>
    <message>
        <source>face %1 belongs to %2 tets (%3, %4, %5): tets overlap</source>
        <translation>Dreieck %1 gehört zu %2 Tetraedern (%3, %4, %5): Tetraeder überlappen sich</translation>
    </message>
    <message>
        <source>face %1-%2-%3</source>
        <translation>Seite %1-%2-%3</translation>
    </message>
    <message>
        <source>facet %1 to cover does not exist</source>
        <translation>die zu bedeckende Facette %1 gibt es nicht</translation>
    </message>
    <message>
        <source>facet has a surface of the table</source>
        <translation>Facette hat eine Fläche der Tabelle</translation>
    </message>
    <message>
        <source>facet lies on its tet</source>
        <translation>Facette liegt an ihrem Tetraeder</translation>
    </message>
    <message>
        <source>facets over each arc</source>
        <translation>Facetten über jeden Bogen</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>gescheitert: %1</translation>
    </message>
    <message>
        <source>fetching the result</source>
        <translation>Abholen des Ergebnisses</translation>
    </message>
    <message>
        <source>file type</source>
        <translation>Dateiart</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>gefüllt</translation>
    </message>
    <message>
        <source>finding edges</source>
        <translation>Kanten suchen</translation>
    </message>
    <message>
        <source>finding rims</source>
        <translation>Ränder suchen</translation>
    </message>
    <message>
        <source>finding the foot</source>
        <translation>Fuß suchen</translation>
    </message>
    <message>
        <source>finding the region</source>
        <translation>Gebiet suchen</translation>
    </message>
    <message>
        <source>first at %1</source>
        <translation>zuerst bei %1</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>growing the slab</source>
        <translation>Aufdicken</translation>
    </message>
    <message>
        <source>have zero volume (flat within rounding)</source>
        <translation>haben kein Volumen (flach bis auf Rundung)</translation>
    </message>
    <message>
        <source>hinges repaired</source>
        <translation>ausgebesserte Scharnierkanten</translation>
    </message>
    <message>
        <source>hung and was killed</source>
        <translation>hing und wurde beendet</translation>
    </message>
    <message>
        <source>improving and checking</source>
        <translation>Verbessern und Prüfen</translation>
    </message>
    <message>
        <source>incident tet holds the vertex</source>
        <translation>anliegender Tetraeder hat die Ecke</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>ist weg</translation>
    </message>
    <message>
        <source>is part open edge, part inner corner: no flat cap closes it</source>
        <translation>ist teils offene Kante, teils Innenecke: kein ebener Deckel schließt ihn</translation>
    </message>
    <message>
        <source>it changed but was not reported</source>
        <translation>er änderte sich, ohne genannt zu sein</translation>
    </message>
    <message>
        <source>it ended early</source>
        <translation>sie endete vorzeitig</translation>
    </message>
    <message>
        <source>it failed while it was loaded: %1</source>
        <translation>es scheiterte beim Laden: %1</translation>
    </message>
    <message>
        <source>it failed while it was loaded: it threw something that is no std::exception</source>
        <translation>es scheiterte beim Laden: es warf etwas, das keine std::exception ist</translation>
    </message>
    <message>
        <source>it has no entry tedit_plugin_query</source>
        <translation>es hat keinen Einstieg tedit_plugin_query</translation>
    </message>
    <message>
        <source>it is a number</source>
        <translation>er ist eine Zahl</translation>
    </message>
    <message>
        <source>it is a text</source>
        <translation>er ist ein Text</translation>
    </message>
    <message>
        <source>it is a whole number</source>
        <translation>er ist eine ganze Zahl</translation>
    </message>
    <message>
        <source>it is given twice, in m and in mm</source>
        <translation>er ist zweimal angegeben, in m und in mm</translation>
    </message>
    <message>
        <source>it is no regular file</source>
        <translation>sie ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is not a finite number</source>
        <translation>er ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>it is true or false</source>
        <translation>er ist wahr oder falsch</translation>
    </message>
    <message>
        <source>it says %1 m3, the tets say %2 m3</source>
        <translation>sie nennt %1 m3, die Tetraeder ergeben %2 m3</translation>
    </message>
    <message>
        <source>its pressure by place kept</source>
        <translation>sein Druck je Ort bleibt</translation>
    </message>
    <message>
        <source>its three edges have different walls</source>
        <translation>ihre drei Kanten haben verschiedene Wände</translation>
    </message>
    <message>
        <source>its type is unknown</source>
        <translation>seine Art ist unbekannt</translation>
    </message>
    <message>
        <source>largest element number</source>
        <translation>größte Elementnummer</translation>
    </message>
    <message>
        <source>largest node number</source>
        <translation>größte Knotennummer</translation>
    </message>
    <message>
        <source>lifting the worst tets</source>
        <translation>Anheben der schlechtesten Tetraeder</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>Last %1</translation>
    </message>
    <message>
        <source>load %1 (%2)</source>
        <translation>Last %1 (%2)</translation>
    </message>
    <message>
        <source>load %1 says no kind</source>
        <translation>Last %1 nennt keine Art</translation>
    </message>
    <message>
        <source>load case &quot;%1&quot; is not among those that were solved</source>
        <translation>der Lastfall „%1“ ist nicht unter den gelösten</translation>
    </message>
    <message>
        <source>load case %1: %2 acts on surface</source>
        <translation>Lastfall %1: %2 wirkt auf Fläche</translation>
    </message>
    <message>
        <source>load case %1: %2 acts on surfaces</source>
        <translation>Lastfall %1: %2 wirkt auf Flächen</translation>
    </message>
    <message>
        <source>load case &apos;%1&apos; has other materials than &apos;%2&apos;, and load cases share one stiffness matrix</source>
        <translation>der Lastfall „%1“ hat andere Werkstoffe als „%2“, und Lastfälle teilen sich eine Steifigkeitsmatrix</translation>
    </message>
    <message>
        <source>load case &apos;%1&apos;: %2</source>
        <translation>Lastfall „%1“: %2</translation>
    </message>
    <message>
        <source>looking at the surfaces</source>
        <translation>Flächen ansehen</translation>
    </message>
    <message>
        <source>loose crumb</source>
        <translation>loser Krümel</translation>
    </message>
    <message>
        <source>loose piece</source>
        <translation>loses Stück</translation>
    </message>
    <message>
        <source>material &quot;%1&quot; names region %2, which no mesh can have</source>
        <translation>der Werkstoff „%1“ nennt den Bereich %2, den kein Netz haben kann</translation>
    </message>
    <message>
        <source>material &quot;%1&quot;: %2</source>
        <translation>Werkstoff „%1“: %2</translation>
    </message>
    <message>
        <source>material &quot;%1&quot;: Poisson&apos;s ratio is %2</source>
        <translation>Werkstoff „%1“: die Querkontraktionszahl ist %2</translation>
    </message>
    <message>
        <source>memory ran out</source>
        <translation>der Speicher ging aus</translation>
    </message>
    <message>
        <source>mending the cut</source>
        <translation>Schnitt ausbessern</translation>
    </message>
    <message>
        <source>meshing around the edge</source>
        <translation>Vernetzen um die Kante</translation>
    </message>
    <message>
        <source>meshing the plug</source>
        <translation>Vernetzen der Füllung</translation>
    </message>
    <message>
        <source>moment %1 N m kept</source>
        <translation>Moment %1 N m bleibt</translation>
    </message>
    <message>
        <source>more than one fan of facets meets there</source>
        <translation>mehr als ein Fächer von Facetten stößt dort zusammen</translation>
    </message>
    <message>
        <source>moving the surfaces</source>
        <translation>Verschieben der Flächen</translation>
    </message>
    <message>
        <source>negative volume (inverted)</source>
        <translation>negatives Volumen (umgestülpt)</translation>
    </message>
    <message>
        <source>neighbours share a face</source>
        <translation>Nachbarn teilen eine Seite</translation>
    </message>
    <message>
        <source>neither a depth nor layers of tets are given</source>
        <translation>weder eine Tiefe noch Schichten von Tetraedern sind angegeben</translation>
    </message>
    <message>
        <source>no %1 worker runs: %2</source>
        <translation>kein Arbeitsprozess (%1) läuft: %2</translation>
    </message>
    <message>
        <source>no ball touches the three walls</source>
        <translation>keine Kugel berührt die drei Wände</translation>
    </message>
    <message>
        <source>no document is open</source>
        <translation>kein Dokument ist offen</translation>
    </message>
    <message>
        <source>no material lies below surface %1</source>
        <translation>unter Fläche %1 liegt kein Werkstoff</translation>
    </message>
    <message>
        <source>no new closed void or separate boundary</source>
        <translation>kein neuer Hohlraum oder getrennter Rand</translation>
    </message>
    <message>
        <source>no surface was picked</source>
        <translation>keine Fläche wurde angeklickt</translation>
    </message>
    <message>
        <source>no surface was selected</source>
        <translation>keine Fläche ist ausgewählt</translation>
    </message>
    <message>
        <source>node %1 has a coordinate that is no number</source>
        <translation>Knoten %1 hat eine Koordinate, die keine Zahl ist</translation>
    </message>
    <message>
        <source>node %1 is listed twice</source>
        <translation>Knoten %1 steht zweimal da</translation>
    </message>
    <message>
        <source>node %1 lies %2 powers of ten metres away; at most 30 are supported</source>
        <translation>Knoten %1 liegt %2 Zehnerpotenzen von Metern entfernt; höchstens 30 gehen</translation>
    </message>
    <message>
        <source>node blocks</source>
        <translation>Knotenblöcke</translation>
    </message>
    <message>
        <source>node number</source>
        <translation>Knotennummer</translation>
    </message>
    <message>
        <source>node numbers start at 1, this one is %1</source>
        <translation>Knotennummern beginnen bei 1, diese ist %1</translation>
    </message>
    <message>
        <source>nodes in a block</source>
        <translation>Knoten in einem Block</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>keines ist vorhanden</translation>
    </message>
    <message>
        <source>normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>nothing acts on the part: no load and no prescribed displacement</source>
        <translation>nichts wirkt auf das Bauteil: keine Last und keine vorgegebene Verschiebung</translation>
    </message>
    <message>
        <source>nothing can be taken off: the rest would hang together by edges or corners only</source>
        <translation>nichts kann abgetragen werden: der Rest hinge nur an Kanten oder Ecken zusammen</translation>
    </message>
    <message>
        <source>nothing stands above the foot of the selected surfaces</source>
        <translation>nichts steht über dem Fuß der ausgewählten Flächen</translation>
    </message>
    <message>
        <source>number of bounding entities</source>
        <translation>Zahl der begrenzenden Einheiten</translation>
    </message>
    <message>
        <source>number of element blocks</source>
        <translation>Zahl der Elementblöcke</translation>
    </message>
    <message>
        <source>number of elements in a block</source>
        <translation>Zahl der Elemente in einem Block</translation>
    </message>
    <message>
        <source>number of entities</source>
        <translation>Zahl der Einheiten</translation>
    </message>
    <message>
        <source>number of node blocks</source>
        <translation>Zahl der Knotenblöcke</translation>
    </message>
    <message>
        <source>number of nodes in a block</source>
        <translation>Zahl der Knoten in einem Block</translation>
    </message>
    <message>
        <source>number of physical tags</source>
        <translation>Zahl der physikalischen Kennungen</translation>
    </message>
    <message>
        <source>number of tags</source>
        <translation>Zahl der Kennungen</translation>
    </message>
    <message>
        <source>of the part&apos;s volume</source>
        <translation>des Volumens des Teils</translation>
    </message>
    <message>
        <source>one of the %1 separate bodies (%2 tets)</source>
        <translation>einer der %1 getrennten Körper (%2 Tetraeder)</translation>
    </message>
    <message>
        <source>only one of load_case, load_cases and all_load_cases may be given</source>
        <translation>nur eines von load_case, load_cases und all_load_cases darf angegeben sein</translation>
    </message>
    <message>
        <source>operation %1 could not be made</source>
        <translation>Operation %1 ließ sich nicht herstellen</translation>
    </message>
    <message>
        <source>page %1 is not in the document</source>
        <translation>Seite %1 ist nicht im Dokument</translation>
    </message>
    <message>
        <source>parameter %1: %2</source>
        <translation>Parameter %1: %2</translation>
    </message>
    <message>
        <source>parameter surface_tolerance: the boundary of this part may not move so far</source>
        <translation>Parameter Flächentoleranz: der Rand dieses Bauteils darf sich nicht so weit bewegen</translation>
    </message>
    <message>
        <source>parametric flag</source>
        <translation>Parameterkennung</translation>
    </message>
    <message>
        <source>physical names</source>
        <translation>physikalische Namen</translation>
    </message>
    <message>
        <source>physical tag</source>
        <translation>physikalische Kennung</translation>
    </message>
    <message>
        <source>physical tag %1 is out of range</source>
        <translation>physikalische Kennung %1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>physical tags</source>
        <translation>physikalische Kennungen</translation>
    </message>
    <message>
        <source>pieces, of %1 bodies</source>
        <translation>Stücke, aus %1 Körpern</translation>
    </message>
    <message>
        <source>pieces, of 1 body</source>
        <translation>Stücke, aus 1 Körper</translation>
    </message>
    <message>
        <source>positive orientation</source>
        <translation>positive Orientierung</translation>
    </message>
    <message>
        <source>preparing the preconditioner</source>
        <translation>Vorbereiten des Vorkonditionierers</translation>
    </message>
    <message>
        <source>put on at the least exact place</source>
        <translation>aufgetragen an der ungenauesten Stelle</translation>
    </message>
    <message>
        <source>q = %1, before %2, floor %3</source>
        <translation>q = %1, vorher %2, Grenze %3</translation>
    </message>
    <message>
        <source>quadratic hexahedron</source>
        <translation>quadratischer Hexaeder</translation>
    </message>
    <message>
        <source>quadratic line</source>
        <translation>quadratische Linie</translation>
    </message>
    <message>
        <source>quadratic prism</source>
        <translation>quadratisches Prisma</translation>
    </message>
    <message>
        <source>quadratic pyramid</source>
        <translation>quadratische Pyramide</translation>
    </message>
    <message>
        <source>quadratic quadrangle</source>
        <translation>quadratisches Viereck</translation>
    </message>
    <message>
        <source>quadratic tetrahedron</source>
        <translation>quadratischer Tetraeder</translation>
    </message>
    <message>
        <source>quadratic triangle</source>
        <translation>quadratisches Dreieck</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>Lesen: %1</translation>
    </message>
    <message>
        <source>recovering stresses</source>
        <translation>Spannungen ermitteln</translation>
    </message>
    <message>
        <source>region %1 has no material</source>
        <translation>der Bereich %1 hat keinen Werkstoff</translation>
    </message>
    <message>
        <source>region %1 has two materials</source>
        <translation>der Bereich %1 hat zwei Werkstoffe</translation>
    </message>
    <message>
        <source>remote force</source>
        <translation>entfernte Kraft</translation>
    </message>
    <message>
        <source>remove %1 to have it tried again</source>
        <translation>%1 entfernen, damit es noch einmal versucht wird</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>renaming the document</source>
        <translation>Umbenennen des Dokuments</translation>
    </message>
    <message>
        <source>rotation about the axis %1 through %2</source>
        <translation>Drehung um die Achse %1 durch %2</translation>
    </message>
    <message>
        <source>rounded</source>
        <translation>gerundet</translation>
    </message>
    <message>
        <source>rounding %1 takes %2 of the edge between surfaces %3 and %4, which is only %5 long, at %6</source>
        <translation>Runden: %1 nimmt %2 der Kante zwischen den Flächen %3 und %4, die nur %5 lang ist, bei %6</translation>
    </message>
    <message>
        <source>runs into surface %1, which reaches beyond the hole</source>
        <translation>läuft in Fläche %1, die über das Loch hinausreicht</translation>
    </message>
    <message>
        <source>runs of edges rounded</source>
        <translation>gerundete Kantenzüge</translation>
    </message>
    <message>
        <source>section %1 is not closed</source>
        <translation>Abschnitt %1 ist nicht geschlossen</translation>
    </message>
    <message>
        <source>section %1 should end here, but &quot;%2&quot; follows: its counts and its content disagree</source>
        <translation>Abschnitt %1 sollte hier enden, aber „%2“ folgt: Zahlen und Inhalt stimmen nicht überein</translation>
    </message>
    <message>
        <source>side above %1</source>
        <translation>Seite über %1</translation>
    </message>
    <message>
        <source>smallest element number</source>
        <translation>kleinste Elementnummer</translation>
    </message>
    <message>
        <source>smallest node number</source>
        <translation>kleinste Knotennummer</translation>
    </message>
    <message>
        <source>smoothing</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>storing the document</source>
        <translation>Speichern des Dokuments</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>surface %1 at %2 finds no place on its neighbours so far away</source>
        <translation>Fläche %1 findet bei %2 so weit entfernt keinen Platz auf ihren Nachbarn</translation>
    </message>
    <message>
        <source>surface %1 bounds no hole or pocket: it is flat, or bends outwards</source>
        <translation>Fläche %1 begrenzt kein Loch und keine Tasche: sie ist eben oder nach außen gewölbt</translation>
    </message>
    <message>
        <source>surface %1 cannot be moved so far: %2</source>
        <translation>Fläche %1 kann nicht so weit verschoben werden: %2</translation>
    </message>
    <message>
        <source>surface %1 has no concave edge (inner corner) to be rounded</source>
        <translation>Fläche %1 hat keine einspringende Kante (Innenecke) zum Runden</translation>
    </message>
    <message>
        <source>surface %1 has no convex edge (outer edge) to be rounded</source>
        <translation>Fläche %1 hat keine vorspringende Kante (Außenkante) zum Runden</translation>
    </message>
    <message>
        <source>surface %1 has no outer side: it lies between two regions, or is gone already</source>
        <translation>Fläche %1 hat keine Außenseite: sie liegt zwischen zwei Bereichen oder ist schon weg</translation>
    </message>
    <message>
        <source>surface %1 has no room for the rounding at %2</source>
        <translation>Fläche %1 hat bei %2 keinen Platz für die Rundung</translation>
    </message>
    <message>
        <source>surface %1 is a wall of the part, of no boss, rib or fin</source>
        <translation>Fläche %1 ist eine Wand des Bauteils, keines Auges und keiner Rippe</translation>
    </message>
    <message>
        <source>surface %1 is in the way at %2</source>
        <translation>Fläche %1 ist bei %2 im Weg</translation>
    </message>
    <message>
        <source>surface %1 is not in this version of the mesh</source>
        <translation>Fläche %1 ist nicht in dieser Version des Netzes</translation>
    </message>
    <message>
        <source>surface %1 is round with a radius of %2</source>
        <translation>Fläche %1 ist rund mit einem Radius von %2</translation>
    </message>
    <message>
        <source>surface %1 itself has a radius of %2</source>
        <translation>Fläche %1 hat selbst einen Radius von %2</translation>
    </message>
    <message>
        <source>surface %1 runs on flush with surface %2 or leaves it no way at %3</source>
        <translation>Fläche %1 geht bündig in Fläche %2 über oder lässt ihr keinen Weg, bei %3</translation>
    </message>
    <message>
        <source>surface %1 there is no concave edge (inner corner) to be rounded</source>
        <translation>an Fläche %1 ist keine einspringende Kante (Innenecke) zum Runden</translation>
    </message>
    <message>
        <source>surface %1 there is no convex edge (outer edge) to be rounded</source>
        <translation>an Fläche %1 ist keine vorspringende Kante (Außenkante) zum Runden</translation>
    </message>
    <message>
        <source>surface id %1 does not fit into a MSH file</source>
        <translation>die Flächennummer %1 passt nicht in eine MSH-Datei</translation>
    </message>
    <message>
        <source>surfaces %1</source>
        <translation>Flächen %1</translation>
    </message>
    <message>
        <source>surfaces %1 cannot be moved so far: %2</source>
        <translation>die Flächen %1 können nicht so weit verschoben werden: %2</translation>
    </message>
    <message>
        <source>taken off at the least exact place</source>
        <translation>abgetragen an der ungenauesten Stelle</translation>
    </message>
    <message>
        <source>taking off</source>
        <translation>Abnehmen</translation>
    </message>
    <message>
        <source>taking off a layer</source>
        <translation>Abtragen einer Schicht</translation>
    </message>
    <message>
        <source>tedit info lists the surfaces</source>
        <translation>tedit info zählt die Flächen auf</translation>
    </message>
    <message>
        <source>tet %1</source>
        <translation>Tetraeder %1</translation>
    </message>
    <message>
        <source>tet %1 is too flat to be cut (radius ratio %2)</source>
        <translation>Tetraeder %1 ist zum Schneiden zu flach (Radienverhältnis %2)</translation>
    </message>
    <message>
        <source>tet %1 to remove does not exist</source>
        <translation>den zu entfernenden Tetraeder %1 gibt es nicht</translation>
    </message>
    <message>
        <source>that is too thin: no tet on it has more than q = %1 (floor %2)</source>
        <translation>das zu schmal ist: kein Tetraeder darauf hat mehr als q = %1 (Grenze %2)</translation>
    </message>
    <message>
        <source>the %1 worker %2 while it worked on this (operation %3), %4 times</source>
        <translation>der Arbeitsprozess (%1) %2 bei dieser Arbeit (Operation %3), %4-mal</translation>
    </message>
    <message>
        <source>the %1 worker %2 while it worked on this, %3 times</source>
        <translation>der Arbeitsprozess (%1) %2 bei dieser Arbeit, %3-mal</translation>
    </message>
    <message>
        <source>the angle must lie between 0 and 180 degrees</source>
        <translation>der Winkel muss zwischen 0 und 180 Grad liegen</translation>
    </message>
    <message>
        <source>the answer to the selection cannot be read: %1</source>
        <translation>die Antwort zur Auswahl ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>the backend&apos;s limit</source>
        <translation>die Grenze des Rechenwerks</translation>
    </message>
    <message>
        <source>the ball does not fit between the walls</source>
        <translation>die Kugel passt nicht zwischen die Wände</translation>
    </message>
    <message>
        <source>the border of surface %1 touches itself</source>
        <translation>der Rand von Fläche %1 berührt sich selbst</translation>
    </message>
    <message>
        <source>the boundary is not a clean surface at edge %1-%2</source>
        <translation>der Rand ist an der Kante %1-%2 keine saubere Fläche</translation>
    </message>
    <message>
        <source>the boundary touches itself along %1 edges (more than two boundary facets meet there)</source>
        <translation>der Rand berührt sich selbst entlang %1 Kanten (mehr als zwei Randfacetten stoßen dort zusammen)</translation>
    </message>
    <message>
        <source>the boundary touches itself at %1 vertices: parts that meet in a vertex only are hinged, not joined</source>
        <translation>der Rand berührt sich selbst an %1 Ecken: Teile, die sich nur in einer Ecke treffen, sind gelenkig, nicht verbunden</translation>
    </message>
    <message>
        <source>the byte-order marker is neither 1 nor a swapped 1</source>
        <translation>die Marke der Bytereihenfolge ist weder 1 noch eine gedrehte 1</translation>
    </message>
    <message>
        <source>the catalogue</source>
        <translation>die Liste der Operationen</translation>
    </message>
    <message>
        <source>the connection to the server is closed</source>
        <translation>die Verbindung zum Server ist geschlossen</translation>
    </message>
    <message>
        <source>the connection was ended</source>
        <translation>die Verbindung wurde beendet</translation>
    </message>
    <message>
        <source>the control group</source>
        <translation>die Kontrollgruppe</translation>
    </message>
    <message>
        <source>the cut below surface %1 would run into material that rises beside it</source>
        <translation>der Schnitt unter Fläche %1 liefe in Werkstoff, der daneben aufragt</translation>
    </message>
    <message>
        <source>the cut would take off surface %1, which lies %2 below surface %3</source>
        <translation>der Schnitt nähme Fläche %1 weg, die %2 unter Fläche %3 liegt</translation>
    </message>
    <message>
        <source>the density</source>
        <translation>die Dichte</translation>
    </message>
    <message>
        <source>the depth was taken off; layers count where the depth is 0</source>
        <translation>die Tiefe wurde abgetragen; Schichten zählen, wo die Tiefe 0 ist</translation>
    </message>
    <message>
        <source>the device &quot;%1&quot; failed its trial and is not used: %2</source>
        <translation>das Gerät „%1“ bestand seine Probe nicht und wird nicht benutzt: %2</translation>
    </message>
    <message>
        <source>the device &quot;%1&quot;, which was the fastest, is gone: %2</source>
        <translation>das Gerät „%1“, das schnellste, ist weg: %2</translation>
    </message>
    <message>
        <source>the device was lost once and opened again</source>
        <translation>das Gerät ging einmal verloren und wurde neu geöffnet</translation>
    </message>
    <message>
        <source>the device was lost; the processor solved instead</source>
        <translation>das Gerät ging verloren; statt dessen rechnete der Prozessor</translation>
    </message>
    <message>
        <source>the document %1 is being added</source>
        <translation>das Dokument %1 wird gerade hinzugefügt</translation>
    </message>
    <message>
        <source>the document has %1 bytes, and a copy may have %2</source>
        <translation>das Dokument hat %1 Byte, und eine Kopie darf %2 haben</translation>
    </message>
    <message>
        <source>the document has no mesh yet</source>
        <translation>das Dokument hat noch kein Netz</translation>
    </message>
    <message>
        <source>the document holds nothing</source>
        <translation>das Dokument enthält nichts</translation>
    </message>
    <message>
        <source>the document holds nothing yet</source>
        <translation>das Dokument enthält noch nichts</translation>
    </message>
    <message>
        <source>the document is a link to %1</source>
        <translation>das Dokument ist ein Verweis auf %1</translation>
    </message>
    <message>
        <source>the document is being changed</source>
        <translation>das Dokument wird gerade geändert</translation>
    </message>
    <message>
        <source>the document is being closed</source>
        <translation>das Dokument wird gerade geschlossen</translation>
    </message>
    <message>
        <source>the document is being renamed</source>
        <translation>das Dokument wird gerade umbenannt</translation>
    </message>
    <message>
        <source>the document is damaged: %1</source>
        <translation>das Dokument ist beschädigt: %1</translation>
    </message>
    <message>
        <source>the document is empty</source>
        <translation>das Dokument ist leer</translation>
    </message>
    <message>
        <source>the document is in use</source>
        <translation>das Dokument ist in Gebrauch</translation>
    </message>
    <message>
        <source>the document is not open</source>
        <translation>das Dokument ist nicht offen</translation>
    </message>
    <message>
        <source>the document was changed meanwhile</source>
        <translation>das Dokument wurde inzwischen geändert</translation>
    </message>
    <message>
        <source>the document was closed</source>
        <translation>das Dokument wurde geschlossen</translation>
    </message>
    <message>
        <source>the edge between surfaces %1 and %2 at %3</source>
        <translation>die Kante zwischen den Flächen %1 und %2 bei %3</translation>
    </message>
    <message>
        <source>the edge is %1 long, which leaves nothing between its ends</source>
        <translation>die Kante ist %1 lang, und das lässt nichts zwischen ihren Enden</translation>
    </message>
    <message>
        <source>the edges that meet there have different angles, and the corner between them stays sharp</source>
        <translation>die Kanten, die dort zusammenstoßen, haben verschiedene Winkel, und die Ecke dazwischen bleibt scharf</translation>
    </message>
    <message>
        <source>the edit takes away surfaces that loads or supports need: %1</source>
        <translation>die Bearbeitung nimmt Flächen weg, die Lasten oder Lager brauchen: %1</translation>
    </message>
    <message>
        <source>the edit was cancelled</source>
        <translation>die Bearbeitung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold (%2)</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 (%2)</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold (%2) and %3 more findings</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 (%2) und %3 weitere Befunde</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold and %2 more findings</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 und %2 weitere Befunde</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold at %2</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 bei %2</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold at %2 (%3)</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 bei %2 (%3)</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold at %2 (%3) and %4 more findings</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 bei %2 (%3) und %4 weitere Befunde</translation>
    </message>
    <message>
        <source>the edit was rolled back: %1 does not hold at %2 and %3 more findings</source>
        <translation>die Bearbeitung wurde zurückgenommen: nicht erfüllt: %1 bei %2 und %3 weitere Befunde</translation>
    </message>
    <message>
        <source>the edit was rolled back: surface %1 would get a facet at %2 %3</source>
        <translation>die Bearbeitung wurde zurückgenommen: Fläche %1 bekäme bei %2 ein Dreieck, %3</translation>
    </message>
    <message>
        <source>the edit_id &quot;%1&quot; was used for another request (%2 at %3)</source>
        <translation>die edit_id „%1“ wurde für eine andere Anfrage benutzt (%2 am %3)</translation>
    </message>
    <message>
        <source>the element order must be 1 or 2, not %1</source>
        <translation>die Elementordnung muss 1 oder 2 sein, nicht %1</translation>
    </message>
    <message>
        <source>the energy tolerance must be a number, 0 or more</source>
        <translation>die Energietoleranz muss eine Zahl sein, 0 oder mehr</translation>
    </message>
    <message>
        <source>the energy tolerance must lie between 1e-9 and 0.5</source>
        <translation>die Energietoleranz muss zwischen 1e-9 und 0.5 liegen</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei ist nicht lesbar</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>die Datei ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>the file ends inside section %1</source>
        <translation>die Datei endet innerhalb von Abschnitt %1</translation>
    </message>
    <message>
        <source>the file ends or cannot be read near byte %1</source>
        <translation>die Datei endet oder ist nicht lesbar nahe Byte %1</translation>
    </message>
    <message>
        <source>the file holds no nodes</source>
        <translation>die Datei enthält keine Knoten</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file lists tets in the opposite orientation; all were turned</source>
        <translation>die Datei nennt Tetraeder verkehrt herum; alle wurden gewendet</translation>
    </message>
    <message>
        <source>the file says %1 %2, more than the %3 bytes that are left can hold</source>
        <translation>die Datei nennt %1 %2, mehr als die übrigen %3 Byte fassen können</translation>
    </message>
    <message>
        <source>the file says %1 elements but lists %2</source>
        <translation>die Datei nennt %1 Elemente, zählt aber %2 auf</translation>
    </message>
    <message>
        <source>the file says %1 nodes but lists %2</source>
        <translation>die Datei nennt %1 Knoten, zählt aber %2 auf</translation>
    </message>
    <message>
        <source>the file starts with %1 instead of $MeshFormat</source>
        <translation>die Datei beginnt mit %1 statt mit $MeshFormat</translation>
    </message>
    <message>
        <source>the file type must be 0 (ASCII) or 1 (binary)</source>
        <translation>die Dateiart muss 0 (ASCII) oder 1 (binär) sein</translation>
    </message>
    <message>
        <source>the file&apos;s name has no suffix that says its format</source>
        <translation>der Name der Datei hat keine Endung, die das Format nennt</translation>
    </message>
    <message>
        <source>the head is version %1 (number %2), not %3</source>
        <translation>die aktuelle Version ist %1 (Nummer %2), nicht %3</translation>
    </message>
    <message>
        <source>the head is version %1 (number %2), not %3: %4</source>
        <translation>die aktuelle Version ist %1 (Nummer %2), nicht %3: %4</translation>
    </message>
    <message>
        <source>the import</source>
        <translation>der Import</translation>
    </message>
    <message>
        <source>the largest diameter</source>
        <translation>der größte Durchmesser</translation>
    </message>
    <message>
        <source>the line has too few numbers: %1 is missing</source>
        <translation>die Zeile hat zu wenige Zahlen: es fehlt %1</translation>
    </message>
    <message>
        <source>the load case &quot;%1&quot; is named twice</source>
        <translation>der Lastfall „%1“ ist zweimal genannt</translation>
    </message>
    <message>
        <source>the load case &quot;%1&quot; was changed</source>
        <translation>der Lastfall „%1“ wurde geändert</translation>
    </message>
    <message>
        <source>the load case &quot;%1&quot; was removed</source>
        <translation>der Lastfall „%1“ wurde entfernt</translation>
    </message>
    <message>
        <source>the load case has no material</source>
        <translation>der Lastfall hat keinen Werkstoff</translation>
    </message>
    <message>
        <source>the load cases of a version may have %1 bytes together (as JSON), not %2</source>
        <translation>die Lastfälle einer Version dürfen zusammen %1 Byte haben (als JSON), nicht %2</translation>
    </message>
    <message>
        <source>the loads and prescribed displacements add up to no finite number</source>
        <translation>die Lasten und vorgegebenen Verschiebungen ergeben keine endliche Zahl</translation>
    </message>
    <message>
        <source>the machine</source>
        <translation>der Rechner</translation>
    </message>
    <message>
        <source>the materials &quot;%1&quot; and &quot;%2&quot; both name no region</source>
        <translation>die Werkstoffe „%1“ und „%2“ nennen beide keinen Bereich</translation>
    </message>
    <message>
        <source>the mesh at %1 leaves no room</source>
        <translation>das Netz lässt bei %1 keinen Platz</translation>
    </message>
    <message>
        <source>the mesh consists of %1 separate bodies</source>
        <translation>das Netz besteht aus %1 getrennten Körpern</translation>
    </message>
    <message>
        <source>the mesh has no volume elements (tets)</source>
        <translation>das Netz hat keine Volumenelemente (Tetraeder)</translation>
    </message>
    <message>
        <source>the mesh holds %1 quadrangles; only triangles and tetrahedra are supported</source>
        <translation>das Netz enthält %1 Vierecke; nur Dreiecke und Tetraeder gehen</translation>
    </message>
    <message>
        <source>the mesh holds a %1 (element type %2); only tetrahedra are supported</source>
        <translation>das Netz enthält ein anderes Element: %1 (Elementart %2); nur Tetraeder gehen</translation>
    </message>
    <message>
        <source>the mesh is too large: at most 2^29 tets are supported</source>
        <translation>das Netz ist zu groß: höchstens 2^29 Tetraeder gehen</translation>
    </message>
    <message>
        <source>the name of a %1 has %2 bytes: &quot;%3...&quot;</source>
        <translation>ein Name (%1) hat %2 Byte: „%3...“</translation>
    </message>
    <message>
        <source>the name of a %1 has control characters</source>
        <translation>ein Name (%1) hat Steuerzeichen</translation>
    </message>
    <message>
        <source>the open document is %1, not %2</source>
        <translation>das offene Dokument ist %1, nicht %2</translation>
    </message>
    <message>
        <source>the operation &quot;%1&quot; of the plugin %2</source>
        <translation>die Operation „%1“ des Plugins %2</translation>
    </message>
    <message>
        <source>the operation %1</source>
        <translation>die Operation %1</translation>
    </message>
    <message>
        <source>the operation %1 did not end within %2 s</source>
        <translation>die Operation %1 wurde nicht innerhalb von %2 s fertig</translation>
    </message>
    <message>
        <source>the operation id %1 is taken already</source>
        <translation>die Operation %1 gibt es schon</translation>
    </message>
    <message>
        <source>the operation made no readable version: %1</source>
        <translation>die Operation machte keine lesbare Version: %1</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>das Bauteil</translation>
    </message>
    <message>
        <source>the part fell apart: %1 pieces more than before</source>
        <translation>das Bauteil zerfiel: %1 Stücke mehr als zuvor</translation>
    </message>
    <message>
        <source>the part is in too many separate pieces for this device: its coarsest level has %1 aggregates, the device takes %2</source>
        <translation>das Bauteil hat für dieses Gerät zu viele getrennte Stücke: die gröbste Stufe hat %1 Aggregate, das Gerät nimmt %2</translation>
    </message>
    <message>
        <source>the part would fall into %1 pieces of %2</source>
        <translation>das Bauteil zerfiele in %1 Stücke von %2</translation>
    </message>
    <message>
        <source>the plugin %1 is not used: %2</source>
        <translation>das Plugin %1 wird nicht benutzt: %2</translation>
    </message>
    <message>
        <source>the preconditioner cannot be set up: the matrix of its coarsest level (%1 unknowns) is not positive definite</source>
        <translation>der Vorkonditionierer lässt sich nicht aufstellen: die Matrix seiner gröbsten Stufe (%1 Unbekannte) ist nicht positiv definit</translation>
    </message>
    <message>
        <source>the preview gave way to other work</source>
        <translation>die Vorschau wich anderer Arbeit</translation>
    </message>
    <message>
        <source>the preview was cancelled</source>
        <translation>die Vorschau wurde abgebrochen</translation>
    </message>
    <message>
        <source>the process&apos;s address space</source>
        <translation>der Adressraum des Prozesses</translation>
    </message>
    <message>
        <source>the program %1 is not there</source>
        <translation>das Programm %1 ist nicht da</translation>
    </message>
    <message>
        <source>the request has %1 bytes, the server takes %2</source>
        <translation>die Anfrage hat %1 Byte, der Server nimmt %2</translation>
    </message>
    <message>
        <source>the request was cancelled</source>
        <translation>die Anfrage wurde abgebrochen</translation>
    </message>
    <message>
        <source>the request was cancelled before it began</source>
        <translation>die Anfrage wurde abgebrochen, bevor sie begann</translation>
    </message>
    <message>
        <source>the result is beyond what a number can hold: displacement %1 m, stress %2 Pa, energy %3 J</source>
        <translation>das Ergebnis geht über das hinaus, was eine Zahl fasst: Verschiebung %1 m, Spannung %2 Pa, Energie %3 J</translation>
    </message>
    <message>
        <source>the rim at %1 with radius %2</source>
        <translation>der Rand bei %1 mit Radius %2</translation>
    </message>
    <message>
        <source>the rounding does not end at the wall there</source>
        <translation>die Rundung endet dort nicht an der Wand</translation>
    </message>
    <message>
        <source>the rounding of %1 does not join the walls around it</source>
        <translation>die Rundung an %1 schließt nicht an die Wände ringsum an</translation>
    </message>
    <message>
        <source>the rounding of %1 leaves the edge between surfaces %2 and %3 by %4 at %5</source>
        <translation>die Rundung an %1 verlässt die Kante zwischen den Flächen %2 und %3 um %4 bei %5</translation>
    </message>
    <message>
        <source>the rounding of %1 would run into surface %2 at %3</source>
        <translation>die Rundung an %1 liefe in Fläche %2 bei %3</translation>
    </message>
    <message>
        <source>the rounding went on smoothly onto surface %1</source>
        <translation>die Rundung ging glatt weiter auf Fläche %1</translation>
    </message>
    <message>
        <source>the rounding would fold over</source>
        <translation>die Rundung würde sich überschlagen</translation>
    </message>
    <message>
        <source>the search was cancelled</source>
        <translation>die Suche wurde abgebrochen</translation>
    </message>
    <message>
        <source>the section was cancelled</source>
        <translation>der Schnitt wurde abgebrochen</translation>
    </message>
    <message>
        <source>the section&apos;s point and normal give no plane</source>
        <translation>Punkt und Normale des Schnitts ergeben keine Ebene</translation>
    </message>
    <message>
        <source>the selected surfaces bound %1 % of the part, not a boss, rib or fin on it</source>
        <translation>die ausgewählten Flächen begrenzen %1 % des Bauteils, kein Auge und keine Rippe daran</translation>
    </message>
    <message>
        <source>the selected surfaces bound material, not a hole</source>
        <translation>die ausgewählten Flächen begrenzen Werkstoff, kein Loch</translation>
    </message>
    <message>
        <source>the selected surfaces have no outer side: they lie between two regions</source>
        <translation>die ausgewählten Flächen haben keine Außenseite: sie liegen zwischen zwei Bereichen</translation>
    </message>
    <message>
        <source>the selected surfaces stand on nothing: no inner corner runs around them</source>
        <translation>die ausgewählten Flächen stehen auf nichts: keine Innenecke läuft um sie herum</translation>
    </message>
    <message>
        <source>the selection</source>
        <translation>die Auswahl</translation>
    </message>
    <message>
        <source>the selection was completed by surface %1</source>
        <translation>die Auswahl wurde ergänzt um Fläche %1</translation>
    </message>
    <message>
        <source>the selection was completed by surface %1 (bottom or inner part of the hole)</source>
        <translation>die Auswahl wurde ergänzt um Fläche %1 (Boden oder Inneres des Lochs)</translation>
    </message>
    <message>
        <source>the server gave an answer of the wrong kind (field %1)</source>
        <translation>der Server gab eine Antwort der falschen Art (Feld %1)</translation>
    </message>
    <message>
        <source>the server gave no answer within %1 ms</source>
        <translation>der Server antwortete nicht innerhalb von %1 ms</translation>
    </message>
    <message>
        <source>the server is stopping</source>
        <translation>der Server wird beendet</translation>
    </message>
    <message>
        <source>the server sent %1 bytes that are no message of the protocol</source>
        <translation>der Server sandte %1 Byte, die keine Nachricht des Protokolls sind</translation>
    </message>
    <message>
        <source>the slab would run into surface %1</source>
        <translation>die Aufdickung liefe in Fläche %1</translation>
    </message>
    <message>
        <source>the slab would run into surface %1, which hangs over surface %2</source>
        <translation>die Aufdickung liefe in Fläche %1, die über Fläche %2 hängt</translation>
    </message>
    <message>
        <source>the smallest diameter</source>
        <translation>der kleinste Durchmesser</translation>
    </message>
    <message>
        <source>the smallest diameter is larger than the largest</source>
        <translation>der kleinste Durchmesser ist größer als der größte</translation>
    </message>
    <message>
        <source>the solve</source>
        <translation>das Lösen</translation>
    </message>
    <message>
        <source>the solve of %1 nodes</source>
        <translation>das Lösen mit %1 Knoten</translation>
    </message>
    <message>
        <source>the solve was cancelled</source>
        <translation>das Lösen wurde abgebrochen</translation>
    </message>
    <message>
        <source>the solver stopped at a relative residual of %1 after %2 iterations; %3 was asked for</source>
        <translation>der Löser endete bei einem relativen Residuum von %1 nach %2 Schritten; verlangt war %3</translation>
    </message>
    <message>
        <source>the space above surface %1 is not bounded by sides that go straight up</source>
        <translation>der Raum über Fläche %1 ist nicht von Seiten begrenzt, die gerade nach oben gehen</translation>
    </message>
    <message>
        <source>the start value has the wrong length</source>
        <translation>der Anfangswert hat die falsche Länge</translation>
    </message>
    <message>
        <source>the surface tolerance must be a length, 0 or more</source>
        <translation>die Flächentoleranz muss eine Länge sein, 0 oder mehr</translation>
    </message>
    <message>
        <source>the system needs about %1 MiB, the device has %2</source>
        <translation>das System braucht etwa %1 MiB, das Gerät hat %2</translation>
    </message>
    <message>
        <source>the target quality must be between 0 and 1</source>
        <translation>die Zielgüte muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>the tolerance must be a positive number</source>
        <translation>die Toleranz muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>the tolerance must lie between 1e-12 and 0.1</source>
        <translation>die Toleranz muss zwischen 1e-12 und 0.1 liegen</translation>
    </message>
    <message>
        <source>the transfer was cancelled</source>
        <translation>die Übertragung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the upload is not complete</source>
        <translation>die Übertragung ist nicht vollständig</translation>
    </message>
    <message>
        <source>the upload was cancelled</source>
        <translation>die Übertragung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the volume of %1 is too large for a number</source>
        <translation>das Volumen von %1 ist zu groß für eine Zahl</translation>
    </message>
    <message>
        <source>the wall below surface %1 is only %2 thick at its thinnest</source>
        <translation>die Wand unter Fläche %1 ist an der dünnsten Stelle nur %2 dick</translation>
    </message>
    <message>
        <source>the whole body of %1 would vanish</source>
        <translation>der ganze Körper von %1 würde verschwinden</translation>
    </message>
    <message>
        <source>the work</source>
        <translation>die Arbeit</translation>
    </message>
    <message>
        <source>the work did not end within %1 s</source>
        <translation>die Arbeit wurde nicht innerhalb von %1 s fertig</translation>
    </message>
    <message>
        <source>the work was cancelled</source>
        <translation>die Arbeit wurde abgebrochen</translation>
    </message>
    <message>
        <source>the work was cancelled before it began</source>
        <translation>die Arbeit wurde abgebrochen, bevor sie begann</translation>
    </message>
    <message>
        <source>the yield strength</source>
        <translation>die Streckgrenze</translation>
    </message>
    <message>
        <source>there are no elements of order %1</source>
        <translation>Elemente der Ordnung %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is a document %1 already</source>
        <translation>das Dokument %1 gibt es schon</translation>
    </message>
    <message>
        <source>there is a file %1 already</source>
        <translation>die Datei %1 gibt es schon</translation>
    </message>
    <message>
        <source>there is no device &quot;%1&quot; here</source>
        <translation>das Gerät „%1“ gibt es hier nicht</translation>
    </message>
    <message>
        <source>there is no file format &quot;%1&quot; to write</source>
        <translation>das Dateiformat „%1“ gibt es zum Schreiben nicht</translation>
    </message>
    <message>
        <source>there is no layer %1: the surface that layer %2 laid bare has no vertex inside its border</source>
        <translation>Schicht %1 gibt es nicht: die Fläche, die Schicht %2 freilegte, hat keine Ecke innerhalb ihres Randes</translation>
    </message>
    <message>
        <source>there is no load case &quot;%1&quot;</source>
        <translation>den Lastfall „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>there is no load case to solve</source>
        <translation>es gibt keinen Lastfall zu lösen</translation>
    </message>
    <message>
        <source>there is no memory for the document, or it cannot be read</source>
        <translation>für das Dokument fehlt der Speicher, oder es ist nicht lesbar</translation>
    </message>
    <message>
        <source>there is no memory to write the file in</source>
        <translation>es fehlt der Speicher, um die Datei zu schreiben</translation>
    </message>
    <message>
        <source>there is no operation &quot;%1&quot;</source>
        <translation>die Operation „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>there is no policy &quot;%1&quot; for loads</source>
        <translation>die Regel „%1“ für Lasten gibt es nicht</translation>
    </message>
    <message>
        <source>there is no quantity &quot;%1&quot; to watch</source>
        <translation>die Größe „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>there is no space to fill: the selected surfaces are flat</source>
        <translation>es gibt keinen Raum zu füllen: die ausgewählten Flächen sind eben</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such improvement</source>
        <translation>diese Verbesserung gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such policy for loads</source>
        <translation>diese Regel für Lasten gibt es nicht</translation>
    </message>
    <message>
        <source>there is no surface %1</source>
        <translation>Fläche %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is no version %1</source>
        <translation>Version %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is not enough memory for this mesh</source>
        <translation>für dieses Netz reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>there is not enough memory to read this mesh</source>
        <translation>der Speicher reicht nicht, um dieses Netz zu lesen</translation>
    </message>
    <message>
        <source>there is nothing to redo</source>
        <translation>es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>thickened</source>
        <translation>aufgedickt</translation>
    </message>
    <message>
        <source>thickness put on</source>
        <translation>aufgetragene Dicke</translation>
    </message>
    <message>
        <source>thickness taken off</source>
        <translation>abgetragene Dicke</translation>
    </message>
    <message>
        <source>this connection has %1 uploads that are not imported yet</source>
        <translation>diese Verbindung hat %1 Übertragungen, die noch nicht importiert sind</translation>
    </message>
    <message>
        <source>this is %1, not a Gmsh mesh</source>
        <translation>dies ist %1, kein Gmsh-Netz</translation>
    </message>
    <message>
        <source>this is no edit_id</source>
        <translation>dies ist keine edit_id</translation>
    </message>
    <message>
        <source>this is no load case: %1</source>
        <translation>dies ist kein Lastfall: %1</translation>
    </message>
    <message>
        <source>this version has no load case</source>
        <translation>diese Version hat keinen Lastfall</translation>
    </message>
    <message>
        <source>those of the faces around</source>
        <translation>die der Dreiecke ringsum</translation>
    </message>
    <message>
        <source>total %1 N kept</source>
        <translation>insgesamt %1 N wie zuvor</translation>
    </message>
    <message>
        <source>total changed from %1 to %2 N</source>
        <translation>insgesamt von %1 auf %2 N geändert</translation>
    </message>
    <message>
        <source>total force %1 N kept</source>
        <translation>Gesamtkraft %1 N wie zuvor</translation>
    </message>
    <message>
        <source>translation along %1</source>
        <translation>Verschiebung entlang %1</translation>
    </message>
    <message>
        <source>triangle %1-%2-%3</source>
        <translation>Dreieck %1-%2-%3</translation>
    </message>
    <message>
        <source>two points of a rim coincide</source>
        <translation>zwei Punkte eines Randes fallen zusammen</translation>
    </message>
    <message>
        <source>unknown element type %1</source>
        <translation>unbekannte Elementart %1</translation>
    </message>
    <message>
        <source>untouched tets are identical</source>
        <translation>unberührte Tetraeder sind gleich geblieben</translation>
    </message>
    <message>
        <source>untouched tets keep their region</source>
        <translation>unberührte Tetraeder behalten ihren Bereich</translation>
    </message>
    <message>
        <source>uploading</source>
        <translation>Übertragen</translation>
    </message>
    <message>
        <source>uploads of %1 that are not imported yet may hold %2 bytes</source>
        <translation>Übertragungen, die noch nicht importiert sind, dürfen %2 Byte haben (%1)</translation>
    </message>
    <message>
        <source>version %1 is not stored</source>
        <translation>Version %1 ist nicht gespeichert</translation>
    </message>
    <message>
        <source>vertex %1 of a new tet does not exist</source>
        <translation>Ecke %1 eines neuen Tetraeders gibt es nicht</translation>
    </message>
    <message>
        <source>volume %1 m3</source>
        <translation>Volumen %1 m3</translation>
    </message>
    <message>
        <source>volume changes as the operation says</source>
        <translation>das Volumen ändert sich, wie die Operation sagt</translation>
    </message>
    <message>
        <source>wall below %1</source>
        <translation>Wand unter %1</translation>
    </message>
    <message>
        <source>walls and caps do not close</source>
        <translation>Wände und Deckel schließen nicht</translation>
    </message>
    <message>
        <source>walls and caps do not form a clean closed surface</source>
        <translation>Wände und Deckel bilden keine saubere geschlossene Fläche</translation>
    </message>
    <message>
        <source>was killed by signal %1 (%2)</source>
        <translation>wurde durch Signal %1 beendet (%2)</translation>
    </message>
    <message>
        <source>what the selected surfaces stand on at %1 is neither flat nor evenly curved</source>
        <translation>worauf die ausgewählten Flächen bei %1 stehen, ist weder eben noch gleichmäßig gekrümmt</translation>
    </message>
    <message>
        <source>workgroups of %1 with slices of %2 rows do not exist on this device</source>
        <translation>Arbeitsgruppen von %1 mit Scheiben von %2 Zeilen gibt es auf diesem Gerät nicht</translation>
    </message>
    <message>
        <source>worst quality of the touched region</source>
        <translation>schlechteste Güte des berührten Gebiets</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>Schreiben: %1</translation>
    </message>
    <message>
        <source>writing the file</source>
        <translation>Schreiben der Datei</translation>
    </message>
    <message>
        <source>zero volume (flat within rounding)</source>
        <translation>kein Volumen (flach bis auf Rundung)</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>Compare load cases that both versions have</source>
        <translation>Lastfälle vergleichen, die beide Versionen haben</translation>
    </message>
    <message>
        <source>Go to that version and solve the load case, then compare again</source>
        <translation>Zu dieser Version gehen und den Lastfall lösen, dann noch einmal vergleichen</translation>
    </message>
    <message>
        <source>Solve both with the same element order, then compare again</source>
        <translation>Beide mit derselben Elementordnung lösen, dann noch einmal vergleichen</translation>
    </message>
    <message>
        <source>They have %1</source>
        <translation>Sie haben %1</translation>
    </message>
    <message>
        <source>They have none</source>
        <translation>Sie haben keinen</translation>
    </message>
    <message>
        <source>a comparison has %1 vertices and %2 values of %3</source>
        <translation>Ein Vergleich hat %1 Knoten und %2 Werte von %3</translation>
    </message>
    <message>
        <source>a comparison&apos;s marks do not fit to its %1 vertices</source>
        <translation>Die Kennzeichen eines Vergleichs passen nicht zu seinen %1 Knoten</translation>
    </message>
    <message>
        <source>neither version %1 nor version %2 has a load case &quot;%3&quot;</source>
        <translation>Weder Version %1 noch Version %2 hat einen Lastfall „%3“</translation>
    </message>
    <message>
        <source>no field of version %1 is at hand</source>
        <translation>Von Version %1 ist kein Feld vorhanden</translation>
    </message>
    <message>
        <source>one version was solved with linear tets and the other with quadratic ones</source>
        <translation>Eine Version wurde mit linearen Tetraedern gelöst und die andere mit quadratischen</translation>
    </message>
    <message>
        <source>the comparison</source>
        <translation>das Vergleichen</translation>
    </message>
    <message>
        <source>version %1 has no such load case</source>
        <translation>Version %1 hat keinen solchen Lastfall</translation>
    </message>
    <message>
        <source>A damaged document is not copied: &quot;tedit doc check&quot; says what is whole</source>
        <translation>Ein beschädigtes Dokument wird nicht kopiert: „tedit doc check“ sagt, was heil ist</translation>
    </message>
    <message>
        <source>Have it closed there, then try again</source>
        <translation>Es dort schließen lassen, dann noch einmal versuchen</translation>
    </message>
    <message>
        <source>The list of documents says which there are</source>
        <translation>Die Liste der Dokumente sagt, welche es gibt</translation>
    </message>
    <message>
        <source>Wait until that is done or cancel it, then try again</source>
        <translation>Warten, bis das fertig ist, oder es abbrechen, dann noch einmal versuchen</translation>
    </message>
    <message>
        <source>cannot find &apos;%1&apos;: %2</source>
        <translation>„%1“ ist nicht zu finden: %2</translation>
    </message>
    <message>
        <source>copying the document</source>
        <translation>Kopieren des Dokuments</translation>
    </message>
    <message>
        <source>deleting the document</source>
        <translation>Löschen des Dokuments</translation>
    </message>
    <message>
        <source>the document %1 is being opened, closed, added, copied or renamed</source>
        <translation>das Dokument %1 wird gerade geöffnet, geschlossen, hinzugefügt, kopiert oder umbenannt</translation>
    </message>
    <message>
        <source>the document %1 is being worked with</source>
        <translation>mit dem Dokument %1 wird gerade gearbeitet</translation>
    </message>
    <message>
        <source>the document is being deleted</source>
        <translation>das Dokument wird gerade gelöscht</translation>
    </message>
    <message>
        <source>the document was deleted</source>
        <translation>das Dokument wurde gelöscht</translation>
    </message>
    <message>
        <source>there is no document %1</source>
        <translation>es gibt kein Dokument %1</translation>
    </message>
    <message>
        <source>there is no file %1</source>
        <translation>es gibt keine Datei %1</translation>
    </message>
    <message>
        <source>Remove the file by hand if it is not needed</source>
        <translation>Die Datei von Hand entfernen, wenn sie nicht gebraucht wird</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung abgelehnt</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenseite abgebrochen</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Zeit für die Verbindung abgelaufen</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>kein Weg zum Rechner</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>das Netz ist nicht erreichbar</translation>
    </message>
    <message>
        <source>Host not found (authoritative)</source>
        <translation>Rechner nicht gefunden</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>Leitung unterbrochen</translation>
    </message>
    <message>
        <source>End of file</source>
        <translation>Ende der Übertragung</translation>
    </message>
    <message>
        <source>%1 has %2 points and %3 values of %4</source>
        <translation>%1: %2 Punkte und %3 Werte von %4</translation>
    </message>
    <message>
        <source>%1 of version %2 did not arrive within %3 ms</source>
        <translation>Version %2: %1 nicht innerhalb von %3 ms angekommen</translation>
    </message>
    <message>
        <source>Give the token that the server wrote when it started (tedit serve --help)</source>
        <translation>Das Token angeben, das der Server beim Start geschrieben hat (tedit serve --help)</translation>
    </message>
    <message>
        <source>HTTP %1 instead of a WebSocket</source>
        <translation>HTTP %1 statt eines WebSockets</translation>
    </message>
    <message>
        <source>Hello was said already</source>
        <translation>Hello wurde schon gesagt</translation>
    </message>
    <message>
        <source>Install it beside tedit-qt, or connect to a server</source>
        <translation>Neben tedit-qt installieren oder mit einem Server verbinden</translation>
    </message>
    <message>
        <source>Look into the server&apos;s log and connect again.</source>
        <translation>Im Protokoll des Servers nachsehen und neu verbinden.</translation>
    </message>
    <message>
        <source>Look whether the server still runs and connect again.</source>
        <translation>Nachsehen, ob der Server noch läuft, und neu verbinden.</translation>
    </message>
    <message>
        <source>Number requests without repeating yourself; the one that runs goes on</source>
        <translation>Anfragen ohne Wiederholung nummerieren; die laufende geht weiter</translation>
    </message>
    <message>
        <source>Open the document again to get the whole surface.</source>
        <translation>Das Dokument neu öffnen, um die ganze Oberfläche zu bekommen.</translation>
    </message>
    <message>
        <source>See %1/server.log</source>
        <translation>Siehe %1/server.log</translation>
    </message>
    <message>
        <source>Send OpenDocument first</source>
        <translation>Zuerst OpenDocument senden</translation>
    </message>
    <message>
        <source>Set XDG_STATE_HOME to a folder that can be written</source>
        <translation>XDG_STATE_HOME auf einen beschreibbaren Ordner setzen</translation>
    </message>
    <message>
        <source>Start a server with tedit serve.</source>
        <translation>Mit tedit serve einen Server starten.</translation>
    </message>
    <message>
        <source>Take HOLE, PROTRUSION, HOLES, SMOOTH or NEIGHBOURS</source>
        <translation>HOLE, PROTRUSION, HOLES, SMOOTH oder NEIGHBOURS nehmen</translation>
    </message>
    <message>
        <source>Use a client and a server of the same release</source>
        <translation>Client und Server derselben Version nehmen</translation>
    </message>
    <message>
        <source>Use a client of the server&apos;s release</source>
        <translation>Einen Client der Version des Servers nehmen</translation>
    </message>
    <message>
        <source>Use the schema of the server&apos;s version</source>
        <translation>Das Schema der Version des Servers nehmen</translation>
    </message>
    <message>
        <source>Wait for answers before asking more</source>
        <translation>Auf Antworten warten, bevor mehr gefragt wird</translation>
    </message>
    <message>
        <source>Wait until it is back, or connect to another one</source>
        <translation>Warten, bis sie wieder da ist, oder mit einem anderen Server verbinden</translation>
    </message>
    <message>
        <source>a field update</source>
        <translation>eine Feldänderung</translation>
    </message>
    <message>
        <source>a field update names a load case that it does not list</source>
        <translation>eine Feldänderung nennt einen Lastfall, den sie nicht aufführt</translation>
    </message>
    <message>
        <source>a request needs a request_id</source>
        <translation>eine Anfrage braucht eine request_id</translation>
    </message>
    <message>
        <source>a section&apos;s triangles do not fit to its %1 points</source>
        <translation>die Dreiecke eines Schnitts passen nicht zu seinen %1 Punkten</translation>
    </message>
    <message>
        <source>a socket connects only once</source>
        <translation>ein Socket verbindet nur einmal</translation>
    </message>
    <message>
        <source>a surface update builds on version %1, but this client holds %2</source>
        <translation>eine Flächenänderung baut auf Version %1 auf, dieser Client hat aber %2</translation>
    </message>
    <message>
        <source>a surface update builds on version %1, but this client holds none</source>
        <translation>eine Flächenänderung baut auf Version %1 auf, dieser Client hat aber keine</translation>
    </message>
    <message>
        <source>a surface update has %1 values in &quot;%2&quot; for %3 items of %4</source>
        <translation>eine Flächenänderung hat %1 Werte in „%2“ für %3 Einträge von %4</translation>
    </message>
    <message>
        <source>a surface update lists slot %1 in &quot;%2&quot;, which no mesh can have</source>
        <translation>eine Flächenänderung führt Platz %1 in „%2“ auf, den kein Netz haben kann</translation>
    </message>
    <message>
        <source>a surface update names no version</source>
        <translation>eine Flächenänderung nennt keine Version</translation>
    </message>
    <message>
        <source>announces %1 bytes, but its arrays end at %2</source>
        <translation>kündigt %1 Bytes an, seine Felder enden aber bei %2</translation>
    </message>
    <message>
        <source>brings more than the announced %1 bytes</source>
        <translation>bringt mehr als die angekündigten %1 Bytes</translation>
    </message>
    <message>
        <source>cannot make the folder %1</source>
        <translation>der Ordner %1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>facet %1 of a surface update names vertex %2, which this client was never sent</source>
        <translation>Facette %1 einer Flächenänderung nennt Knoten %2, den dieser Client nie bekam</translation>
    </message>
    <message>
        <source>goes on at byte %1 after %2 bytes</source>
        <translation>geht nach %2 Bytes bei Byte %1 weiter</translation>
    </message>
    <message>
        <source>has array &quot;%1&quot; in another form</source>
        <translation>hat das Feld „%1“ in anderer Form</translation>
    </message>
    <message>
        <source>has array &quot;%1&quot; inside the one before</source>
        <translation>hat das Feld „%1“ in dem davor</translation>
    </message>
    <message>
        <source>has array &quot;%1&quot; of an unknown type</source>
        <translation>hat das Feld „%1“ unbekannten Typs</translation>
    </message>
    <message>
        <source>is larger than %1 bytes</source>
        <translation>ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>is not complete</source>
        <translation>ist nicht vollständig</translation>
    </message>
    <message>
        <source>no answer within %1 ms</source>
        <translation>keine Antwort innerhalb von %1 ms</translation>
    </message>
    <message>
        <source>no memory is left for a message of the server</source>
        <translation>für eine Nachricht des Servers ist kein Speicher mehr da</translation>
    </message>
    <message>
        <source>no server can be reached at %1: %2</source>
        <translation>unter %1 ist kein Server zu erreichen: %2</translation>
    </message>
    <message>
        <source>request_id %1 is in use</source>
        <translation>request_id %1 ist in Gebrauch</translation>
    </message>
    <message>
        <source>stream %1 %2</source>
        <translation>Datenstrom %1 %2</translation>
    </message>
    <message>
        <source>streams are little-endian</source>
        <translation>Datenströme sind Little-Endian</translation>
    </message>
    <message>
        <source>the address &quot;%1&quot; %2</source>
        <translation>die Adresse „%1“ %2</translation>
    </message>
    <message>
        <source>the client speaks version %1 of the protocol, this server version %2</source>
        <translation>der Client spricht Version %1 des Netzwerkprotokolls, dieser Server Version %2</translation>
    </message>
    <message>
        <source>the client&apos;s I/O thread failed</source>
        <translation>der Thread des Clients für die Übertragung ist gescheitert</translation>
    </message>
    <message>
        <source>the connection to the server broke: %1</source>
        <translation>die Verbindung zum Server ist abgebrochen: %1</translation>
    </message>
    <message>
        <source>the document &quot;%1&quot; is not open in this connection</source>
        <translation>das Dokument „%1“ ist in dieser Verbindung nicht offen</translation>
    </message>
    <message>
        <source>the fields</source>
        <translation>die Felder</translation>
    </message>
    <message>
        <source>the first message must be Hello</source>
        <translation>die erste Nachricht muss Hello sein</translation>
    </message>
    <message>
        <source>the load case &quot;%1&quot; cannot be read and is not shown: %2</source>
        <translation>der Lastfall „%1“ ist nicht lesbar und wird nicht gezeigt: %2</translation>
    </message>
    <message>
        <source>the program &quot;tedit&quot;, which serves the documents, is not there</source>
        <translation>das Programm „tedit“, das die Dokumente verwaltet, fehlt</translation>
    </message>
    <message>
        <source>the server announces stream %1 before it is done</source>
        <translation>der Server kündigt Datenstrom %1 an, bevor dieser fertig ist</translation>
    </message>
    <message>
        <source>the server closed the connection</source>
        <translation>der Server hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>the server did not close the connection in time</source>
        <translation>der Server hat die Verbindung nicht rechtzeitig geschlossen</translation>
    </message>
    <message>
        <source>the server on this computer did not start within 20 s</source>
        <translation>der Server auf diesem Rechner ist nicht innerhalb von 20 s gestartet</translation>
    </message>
    <message>
        <source>the server on this computer ended %1 times within a minute: %2</source>
        <translation>der Server auf diesem Rechner ist in einer Minute %1-mal abgebrochen: %2</translation>
    </message>
    <message>
        <source>the server on this computer ended at once: %1</source>
        <translation>der Server auf diesem Rechner ist sofort abgebrochen: %1</translation>
    </message>
    <message>
        <source>the server sends a piece of stream %1, which it has not announced</source>
        <translation>der Server sendet ein Stück von Datenstrom %1, den er nicht angekündigt hat</translation>
    </message>
    <message>
        <source>the server sends more than %1 streams at once</source>
        <translation>der Server sendet mehr als %1 Datenströme zugleich</translation>
    </message>
    <message>
        <source>the server sent a message of more than %1 bytes</source>
        <translation>der Server hat eine Nachricht von mehr als %1 Bytes gesendet</translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>die Oberfläche</translation>
    </message>
    <message>
        <source>the text %1 has more than %2 bytes</source>
        <translation>der Text %1 hat mehr als %2 Bytes</translation>
    </message>
    <message>
        <source>the token is wrong</source>
        <translation>das Token ist falsch</translation>
    </message>
    <message>
        <source>there is no connection to a server</source>
        <translation>es gibt keine Verbindung zu einem Server</translation>
    </message>
    <message>
        <source>there is no such kind of selection</source>
        <translation>diese Art der Auswahl gibt es nicht</translation>
    </message>
    <message>
        <source>this client closed the connection</source>
        <translation>dieser Client hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>this is no message of tedit.v1</source>
        <translation>das ist keine Nachricht von tedit.v1</translation>
    </message>
    <message>
        <source>this server does not know this request</source>
        <translation>dieser Server kennt diese Anfrage nicht</translation>
    </message>
    <message>
        <source>too many requests at once (%1)</source>
        <translation>zu viele Anfragen zugleich (%1)</translation>
    </message>
    <message>
        <source>the server closed the connection: %1</source>
        <translation>der Server hat die Verbindung geschlossen: %1</translation>
    </message>
    <message>
        <source>Wait for the answer to that</source>
        <translation>Die Antwort darauf abwarten</translation>
    </message>
    <message>
        <source>the document %1 is being deleted</source>
        <translation>Das Dokument %1 wird gerade gelöscht</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a name for documents that go after their last client</source>
        <translation>„%1“ ist ein Name für Dokumente, die nach ihrem letzten Benutzer verschwinden</translation>
    </message>
    <message>
        <source>Open a new one, and give it a name of its own to keep it</source>
        <translation>Ein neues öffnen und ihm einen eigenen Namen geben, damit es bleibt</translation>
    </message>
    <message>
        <source>Take another name: with one of your own a document stays</source>
        <translation>Einen anderen Namen nehmen: mit einem eigenen bleibt ein Dokument</translation>
    </message>
    <message>
        <source>the document %1 is gone: it had no name of its own, and no client had it open</source>
        <translation>das Dokument %1 ist nicht mehr da: es hatte keinen eigenen Namen, und niemand hatte es offen</translation>
    </message>
    <message>
        <source>reading version %1</source>
        <translation>Lesen von Version %1</translation>
    </message>
    <message>
        <source>Start one with &quot;tedit worker --join&quot;, or set work.%1_workers in the server&apos;s configuration</source>
        <translation>Einen mit „tedit worker --join“ starten oder work.%1_workers in der Konfiguration des Servers setzen</translation>
    </message>
    <message>
        <source>no %1 worker has joined this server</source>
        <translation>dieser Server hat keinen Arbeiter für %1</translation>
    </message>
    <message>
        <source>the server turned this worker away: %1</source>
        <translation>der Server hat diesen Arbeiter abgewiesen: %1</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit of open files (ulimit -n)</source>
        <translation>Schließen Sie andere Programme, oder heben Sie die Grenze für offene Dateien an (ulimit -n)</translation>
    </message>
    <message>
        <source>Operations and files run without network, other programs and other people&apos;s files (docs/operating.md, What workers may do). The part is unchanged; report this to the plugin&apos;s author</source>
        <translation>Operationen und Dateien laufen ohne Netz, ohne andere Programme und ohne fremde Dateien (docs/operating.md, What workers may do). Das Bauteil ist unverändert; melden Sie dies dem Autor des Plugins</translation>
    </message>
    <message>
        <source>filled its folder for temporary files</source>
        <translation>hat seinen Ordner für vorübergehende Dateien gefüllt</translation>
    </message>
    <message>
        <source>no line to a child process: %1</source>
        <translation>keine Verbindung zu einem Kindprozess: %1</translation>
    </message>
    <message>
        <source>tried to gain other rights</source>
        <translation>hat versucht, andere Rechte zu erlangen</translation>
    </message>
    <message>
        <source>tried to open a network connection</source>
        <translation>hat versucht, eine Netzverbindung zu öffnen</translation>
    </message>
    <message>
        <source>tried to reach into another process</source>
        <translation>hat versucht, in einen anderen Prozess einzugreifen</translation>
    </message>
    <message>
        <source>tried to start a process</source>
        <translation>hat versucht, einen Prozess zu starten</translation>
    </message>
    <message>
        <source>tried to start a program</source>
        <translation>hat versucht, ein Programm zu starten</translation>
    </message>
    <message>
        <source>tried to start a program, or something else that it may not do</source>
        <translation>hat versucht, ein Programm zu starten oder etwas anderes zu tun, was ihm nicht erlaubt ist</translation>
    </message>
    <message>
        <source>tried to use a part of the system that is closed to it</source>
        <translation>hat versucht, einen Teil des Systems zu benutzen, der ihm verschlossen ist</translation>
    </message>
    <message>
        <source>the operation %1 of the plugin %2 %3</source>
        <translation>die Operation %1 des Plugins %2 %3</translation>
    </message>
    <message>
        <source>the plugin of the operation %1 %2</source>
        <translation>das Plugin der Operation %1 %2</translation>
    </message>
    <message>
        <source>what read or wrote the file %1</source>
        <translation>was die Datei las oder schrieb, %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no SHA-256 of a certificate</source>
        <translation>„%1“ ist kein SHA-256 eines Zertifikats</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a host</source>
        <translation>„%1“ ist kein Name eines Rechners</translation>
    </message>
    <message>
        <source>Ask its operator whether it was exchanged: if so, trust the new one; if not, somebody stands between you and the server.</source>
        <translation>Fragen Sie den Betreiber, ob es ausgetauscht wurde: wenn ja, vertrauen Sie dem neuen; wenn nicht, steht jemand zwischen Ihnen und dem Server.</translation>
    </message>
    <message>
        <source>Ask who keeps the server for another (tedit users token)</source>
        <translation>Bitten Sie den Betreiber des Servers um ein neues (tedit users token)</translation>
    </message>
    <message>
        <source>Ask who keeps the server for another role (tedit users role)</source>
        <translation>Bitten Sie den Betreiber des Servers um eine andere Rolle (tedit users role)</translation>
    </message>
    <message>
        <source>Compare that with the fingerprint that &quot;tedit serve&quot; prints, and trust it (--trust FINGERPRINT), or give the certificate of its authority (--server-ca FILE).</source>
        <translation>Vergleichen Sie ihn mit dem Fingerabdruck, den „tedit serve“ ausgibt, und vertrauen Sie ihm (--trust FINGERABDRUCK), oder nennen Sie das Zertifikat seiner Zertifizierungsstelle (--server-ca DATEI).</translation>
    </message>
    <message>
        <source>Give 64 hexadecimal digits, with or without colons.</source>
        <translation>Geben Sie 64 hexadezimale Ziffern an, mit oder ohne Doppelpunkte.</translation>
    </message>
    <message>
        <source>Give a server&apos;s address such as ws://127.0.0.1:7464/v1.</source>
        <translation>Geben Sie die Adresse eines Servers an, zum Beispiel ws://127.0.0.1:7464/v1.</translation>
    </message>
    <message>
        <source>Mend the line, or take it out</source>
        <translation>Berichtigen Sie die Zeile, oder nehmen Sie sie heraus</translation>
    </message>
    <message>
        <source>Set one of them: the servers that you know are kept below it</source>
        <translation>Setzen Sie eines davon: darunter stehen die Server, die Sie kennen</translation>
    </message>
    <message>
        <source>a line of the known servers is no &quot;HOST:PORT SHA256&quot;</source>
        <translation>eine Zeile der bekannten Server ist kein „RECHNER:PORT SHA256“</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>%1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>chmod 600 %1, and look whether it says what you know</source>
        <translation>chmod 600 %1, und prüfen Sie, ob darin steht, was Sie kennen</translation>
    </message>
    <message>
        <source>neither XDG_STATE_HOME nor HOME is set</source>
        <translation>weder XDG_STATE_HOME noch HOME ist gesetzt</translation>
    </message>
    <message>
        <source>others may write to %1</source>
        <translation>andere dürfen %1 ändern</translation>
    </message>
    <message>
        <source>the certificate of the server at %1 is not trusted here: %2; its SHA-256 is %3</source>
        <translation>dem Zertifikat des Servers bei %1 wird hier nicht vertraut: %2; sein SHA-256 ist %3</translation>
    </message>
    <message>
        <source>the server at %1 shows another certificate (SHA-256 %2) than the one that is trusted (%3)</source>
        <translation>der Server bei %1 zeigt ein anderes Zertifikat (SHA-256 %2) als das, dem vertraut wird (%3)</translation>
    </message>
    <message>
        <source>the token of %1 ended at %2</source>
        <translation>das Token von %1 ist am %2 abgelaufen</translation>
    </message>
    <message>
        <source>the token of %1 was withdrawn</source>
        <translation>das Token von %1 wurde zurückgezogen</translation>
    </message>
    <message>
        <source>this needs the role %1, and your token has %2</source>
        <translation>dafür ist die Rolle %1 nötig, und Ihr Token hat %2</translation>
    </message>
    <message>
        <source>%1 results for %2 load cases</source>
        <translation>%1 Ergebnisse für %2 Lastfälle</translation>
    </message>
    <message>
        <source>Issue it another certificate with &quot;tedit certs issue --role observer&quot;</source>
        <translation>Stellen Sie ihm ein anderes Zertifikat aus: „tedit certs issue --role observer“</translation>
    </message>
    <message>
        <source>Name one actor of the node that asks, each time the same</source>
        <translation>Nennen Sie einen Aktor des Knotens, der fragt, jedes Mal denselben</translation>
    </message>
    <message>
        <source>Solve on another device, and tell whoever made that solver</source>
        <translation>Rechnen Sie auf einem anderen Gerät, und sagen Sie es dem, der diesen Löser gemacht hat</translation>
    </message>
    <message>
        <source>Start that solver again, or choose another device</source>
        <translation>Starten Sie diesen Löser wieder, oder wählen Sie ein anderes Gerät</translation>
    </message>
    <message>
        <source>Tell whoever made that solver, or choose another device</source>
        <translation>Sagen Sie es dem, der diesen Löser gemacht hat, oder wählen Sie ein anderes Gerät</translation>
    </message>
    <message>
        <source>Watch others over a second connection</source>
        <translation>Beobachten Sie weitere über eine zweite Verbindung</translation>
    </message>
    <message>
        <source>a report with numbers that are not finite</source>
        <translation>einen Bericht mit Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
        <source>a result of another version or load case</source>
        <translation>ein Ergebnis einer anderen Version oder eines anderen Lastfalls</translation>
    </message>
    <message>
        <source>a solver sent %1</source>
        <translation>ein Löser hat etwas Falsches geschickt: %1</translation>
    </message>
    <message>
        <source>an array %1 that does not fit the mesh</source>
        <translation>ein Feld %1, das nicht zum Netz passt</translation>
    </message>
    <message>
        <source>an array %1 with numbers that are not finite</source>
        <translation>ein Feld %1 mit Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
        <source>an array that nobody knows</source>
        <translation>ein Feld, das niemand kennt</translation>
    </message>
    <message>
        <source>an envelope of another version, or with numbers that are not finite</source>
        <translation>eine Einhüllende einer anderen Version oder mit Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
        <source>it named an observer that is not its own, or a second one</source>
        <translation>er hat einen Beobachter genannt, der nicht sein eigener ist, oder einen zweiten</translation>
    </message>
    <message>
        <source>leaves a relative residual of %1, and loads and stiffness do different work (%2 apart)</source>
        <translation>lässt ein relatives Residuum von %1, und Lasten und Steifigkeit leisten verschiedene Arbeit (um %2)</translation>
    </message>
    <message>
        <source>nobody who solves on &quot;%1&quot; is joined to this server now</source>
        <translation>niemand, der auf „%1“ rechnet, ist jetzt mit diesem Server verbunden</translation>
    </message>
    <message>
        <source>one connection watches %1 documents at most</source>
        <translation>eine Verbindung beobachtet höchstens %1 Dokumente</translation>
    </message>
    <message>
        <source>the certificate of %1 is one of a %2 worker, not of an observer</source>
        <translation>das Zertifikat von %1 ist das eines Arbeiters (%2), nicht das eines Beobachters</translation>
    </message>
    <message>
        <source>the solver %1 did not give a finite displacement for each of %2 nodes</source>
        <translation>der Löser %1 hat nicht für jeden von %2 Knoten eine endliche Verschiebung gegeben</translation>
    </message>
    <message>
        <source>what the solver %1 gave is no solution: it %2</source>
        <translation>was der Löser %1 gegeben hat, ist keine Lösung: es %2</translation>
    </message>
    <message>
        <source>does not begin with ws:// or wss://</source>
        <translation>beginnt weder mit ws:// noch mit wss://</translation>
    </message>
    <message>
        <source>has a space or control character</source>
        <translation>enthält ein Leer- oder Steuerzeichen</translation>
    </message>
    <message>
        <source>has no closing bracket</source>
        <translation>hat keine schließende Klammer</translation>
    </message>
    <message>
        <source>has something after the bracket that is no port</source>
        <translation>hat hinter der Klammer etwas, das kein Port ist</translation>
    </message>
    <message>
        <source>names no host or no valid port</source>
        <translation>nennt keinen Rechner oder keinen gültigen Port</translation>
    </message>
    <message>
        <source>no solver sent the result of the load case &quot;%1&quot;</source>
        <translation>kein Löser hat das Ergebnis des Lastfalls &quot;%1&quot; geschickt</translation>
    </message>
    <message>
        <source>solvers sent arrays &quot;%1&quot; that do not belong together</source>
        <translation>Löser haben Felder &quot;%1&quot; geschickt, die nicht zusammengehören</translation>
    </message>
    <message>
        <source>waiting for a free worker</source>
        <translation>wartet auf einen freien Arbeiter</translation>
    </message>
    <message>
        <source>waiting for a free worker, about %1 s</source>
        <translation>wartet auf einen freien Arbeiter, etwa %1 s</translation>
    </message>
    <message>
        <source>waiting for a free worker: %1 before it</source>
        <translation>wartet auf einen freien Arbeiter: %1 davor</translation>
    </message>
    <message>
        <source>waiting for a free worker: %1 before it, about %2 s</source>
        <translation>wartet auf einen freien Arbeiter: %1 davor, etwa %2 s</translation>
    </message>
    <message>
        <source>waiting for a worker to start</source>
        <translation>wartet, bis ein Arbeiter gestartet ist</translation>
    </message>
    <message>
        <source>Name one of those that the list of documents has</source>
        <translation>Eines nennen, das in der Liste der Dokumente steht</translation>
    </message>
    <message>
        <source>%1 and %2 slots</source>
        <translation>%1 und %2 Plätze</translation>
    </message>
    <message>
        <source>Install the same version on both machines</source>
        <translation>Auf beiden Rechnern dieselbe Version installieren</translation>
    </message>
    <message>
        <source>Try again; else install the same version on both machines</source>
        <translation>Noch einmal versuchen; sonst auf beiden Rechnern dieselbe Version installieren</translation>
    </message>
    <message>
        <source>arrays of one kind have one length</source>
        <translation>Felder einer Art haben eine Länge</translation>
    </message>
    <message>
        <source>tets and neighbours</source>
        <translation>Tetraeder und Nachbarn</translation>
    </message>
    <message>
        <source>tets and regions</source>
        <translation>Tetraeder und Bereiche</translation>
    </message>
    <message>
        <source>the server does not answer what it is: it is busy, or of another version</source>
        <translation>der Server sagt nicht, was er ist: Er ist beschäftigt oder von einer anderen Version</translation>
    </message>
    <message>
        <source>the server does not say its version and time</source>
        <translation>der Server sagt weder Version noch Uhrzeit</translation>
    </message>
    <message>
        <source>vertices and their tets</source>
        <translation>Ecken und ihre Tetraeder</translation>
    </message>
    <message>
        <source>a document that is there already has a name</source>
        <translation>ein Dokument, das es schon gibt, hat einen Namen</translation>
    </message>
    <message>
        <source>FreeType does not start</source>
        <translation>FreeType startet nicht</translation>
    </message>
    <message>
        <source>Give 0 or a wider tip</source>
        <translation>Geben Sie 0 oder eine weitere Spitze an</translation>
    </message>
    <message>
        <source>Give a height; a negative one is sunk</source>
        <translation>Geben Sie eine Höhe an; eine negative ist eingesenkt</translation>
    </message>
    <message>
        <source>Give a width below its size</source>
        <translation>Geben Sie eine Breite unter seiner Länge an</translation>
    </message>
    <message>
        <source>Give counterbore_depth</source>
        <translation>Geben Sie die Tiefe der Flachsenkung an</translation>
    </message>
    <message>
        <source>Give it in UTF-8</source>
        <translation>Geben Sie ihn in UTF-8 an</translation>
    </message>
    <message>
        <source>Give some letters</source>
        <translation>Geben Sie Buchstaben an</translation>
    </message>
    <message>
        <source>Give text=...</source>
        <translation>Geben Sie einen Text an</translation>
    </message>
    <message>
        <source>Install the package fonts-dejavu-core where operations run</source>
        <translation>Installieren Sie das Paket fonts-dejavu-core, wo die Operationen laufen</translation>
    </message>
    <message>
        <source>Leave out control characters and letters of other scripts</source>
        <translation>Lassen Sie Steuerzeichen und Buchstaben anderer Schriften weg</translation>
    </message>
    <message>
        <source>Make it deeper; 0 is through</source>
        <translation>Machen Sie es tiefer; 0 geht hindurch</translation>
    </message>
    <message>
        <source>Make it wider, or 0</source>
        <translation>Machen Sie sie weiter, oder 0</translation>
    </message>
    <message>
        <source>Move the plane into the part, or keep its other side</source>
        <translation>Verschieben Sie die Ebene in das Teil, oder behalten Sie die andere Seite</translation>
    </message>
    <message>
        <source>Move the tool a little, or make it larger or smaller</source>
        <translation>Verschieben Sie das Werkzeug ein wenig, oder machen Sie es größer oder kleiner</translation>
    </message>
    <message>
        <source>Move the tool a little: something of it nearly meets an edge of the part</source>
        <translation>Verschieben Sie das Werkzeug ein wenig: etwas davon trifft fast auf eine Kante des Teils</translation>
    </message>
    <message>
        <source>Place it so that it cuts the part&apos;s surface</source>
        <translation>Setzen Sie es so, dass es die Oberfläche des Teils schneidet</translation>
    </message>
    <message>
        <source>Place the tool elsewhere</source>
        <translation>Setzen Sie das Werkzeug an eine andere Stelle</translation>
    </message>
    <message>
        <source>Select the wall, or give the place: at_mm=10,20,5</source>
        <translation>Wählen Sie die Fläche, oder geben Sie den Ort an: at_mm=10,20,5</translation>
    </message>
    <message>
        <source>Set one of them to 0</source>
        <translation>Setzen Sie eine davon auf 0</translation>
    </message>
    <message>
        <source>a direction is not 0, 0, 0</source>
        <translation>eine Richtung ist nicht 0, 0, 0</translation>
    </message>
    <message>
        <source>a hole has a counterbore or a countersink, not both</source>
        <translation>ein Loch hat eine Flach- oder eine Kegelsenkung, nicht beides</translation>
    </message>
    <message>
        <source>a point is not finite</source>
        <translation>ein Punkt ist nicht endlich</translation>
    </message>
    <message>
        <source>a tip of less than 29 degrees is a needle</source>
        <translation>eine Spitze unter 29 Grad ist eine Nadel</translation>
    </message>
    <message>
        <source>a triangle has no face</source>
        <translation>ein Dreieck gehört zu keiner Seite</translation>
    </message>
    <message>
        <source>a triangle has no three corners</source>
        <translation>ein Dreieck hat keine drei Ecken</translation>
    </message>
    <message>
        <source>an edge has not one triangle on each side</source>
        <translation>eine Kante hat nicht auf jeder Seite ein Dreieck</translation>
    </message>
    <message>
        <source>bore bottom</source>
        <translation>Grund der Bohrung</translation>
    </message>
    <message>
        <source>counterbore floor</source>
        <translation>Boden der Flachsenkung</translation>
    </message>
    <message>
        <source>furthest off what was asked for</source>
        <translation>größte Abweichung vom Verlangten</translation>
    </message>
    <message>
        <source>improving</source>
        <translation>verbessern</translation>
    </message>
    <message>
        <source>it has too few triangles, or not a face for each</source>
        <translation>sie hat zu wenige Dreiecke oder nicht für jedes eine Seite</translation>
    </message>
    <message>
        <source>it is not three finite numbers</source>
        <translation>es sind keine drei endlichen Zahlen</translation>
    </message>
    <message>
        <source>it is three numbers, as &quot;1, 2.5, 0&quot;</source>
        <translation>es sind drei Zahlen, wie „1, 2.5, 0“</translation>
    </message>
    <message>
        <source>it is turned inside out, or flat</source>
        <translation>sie ist nach innen gekehrt oder flach</translation>
    </message>
    <message>
        <source>letters of no height are none</source>
        <translation>Buchstaben ohne Höhe sind keine</translation>
    </message>
    <message>
        <source>meshing</source>
        <translation>vernetzen</translation>
    </message>
    <message>
        <source>neither a place nor a wall was given</source>
        <translation>weder ein Ort noch eine Fläche wurde angegeben</translation>
    </message>
    <message>
        <source>new surfaces: %1</source>
        <translation>neue Flächen: %1</translation>
    </message>
    <message>
        <source>nothing of the part would be left</source>
        <translation>vom Teil bliebe nichts übrig</translation>
    </message>
    <message>
        <source>surface %1 has no facet on the part&apos;s boundary</source>
        <translation>Fläche %1 hat keine Facette auf dem Rand des Teils</translation>
    </message>
    <message>
        <source>the counterbore has no depth</source>
        <translation>die Flachsenkung hat keine Tiefe</translation>
    </message>
    <message>
        <source>the counterbore is no wider than the hole</source>
        <translation>die Flachsenkung ist nicht weiter als das Loch</translation>
    </message>
    <message>
        <source>the countersink is no wider than the hole</source>
        <translation>die Kegelsenkung ist nicht weiter als das Loch</translation>
    </message>
    <message>
        <source>the font %1 cannot be read</source>
        <translation>die Schrift %1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the font %1 has no outlines</source>
        <translation>die Schrift %1 hat keine Umrisse</translation>
    </message>
    <message>
        <source>the font %1 is damaged</source>
        <translation>die Schrift %1 ist beschädigt</translation>
    </message>
    <message>
        <source>the font %1 is not there</source>
        <translation>die Schrift %1 ist nicht da</translation>
    </message>
    <message>
        <source>the font has no letter for one of the text&apos;s</source>
        <translation>die Schrift hat keinen Buchstaben für einen des Texts</translation>
    </message>
    <message>
        <source>the hole is no deeper than its counterbore</source>
        <translation>das Loch ist nicht tiefer als seine Flachsenkung</translation>
    </message>
    <message>
        <source>the hole is no deeper than its countersink</source>
        <translation>das Loch ist nicht tiefer als seine Kegelsenkung</translation>
    </message>
    <message>
        <source>the mesher&apos;s answer is damaged</source>
        <translation>die Antwort des Vernetzers ist beschädigt</translation>
    </message>
    <message>
        <source>the part&apos;s boundary is no clean surface where the tool is</source>
        <translation>der Rand des Teils ist dort, wo das Werkzeug ist, keine saubere Fläche</translation>
    </message>
    <message>
        <source>the plane leaves the part as it is, or nothing of it</source>
        <translation>die Ebene lässt das Teil, wie es ist, oder nichts davon</translation>
    </message>
    <message>
        <source>the result would be off what was asked for by %1 mm</source>
        <translation>das Ergebnis wiche um %1 mm vom Verlangten ab</translation>
    </message>
    <message>
        <source>the slot is wider than long</source>
        <translation>das Langloch ist breiter als lang</translation>
    </message>
    <message>
        <source>the tets around the tool would be too flat (q = %1)</source>
        <translation>die Tets um das Werkzeug würden zu flach (q = %1)</translation>
    </message>
    <message>
        <source>the text has nothing to emboss</source>
        <translation>der Text hat nichts zu prägen</translation>
    </message>
    <message>
        <source>the text is no UTF-8</source>
        <translation>der Text ist kein UTF-8</translation>
    </message>
    <message>
        <source>the tool and the part could not be cut with each other</source>
        <translation>Werkzeug und Teil ließen sich nicht miteinander schneiden</translation>
    </message>
    <message>
        <source>the tool changes nothing of the part</source>
        <translation>das Werkzeug ändert nichts am Teil</translation>
    </message>
    <message>
        <source>the tool does not meet the part</source>
        <translation>das Werkzeug trifft das Teil nicht</translation>
    </message>
    <message>
        <source>the tool is no clean closed surface</source>
        <translation>das Werkzeug ist keine saubere geschlossene Fläche</translation>
    </message>
    <message>
        <source>the tool is no closed surface: %1</source>
        <translation>das Werkzeug ist keine geschlossene Fläche: %1</translation>
    </message>
    <message>
        <source>the tool would leave an edge at which two solids only touch</source>
        <translation>das Werkzeug ließe eine Kante, an der zwei Körper sich nur berühren</translation>
    </message>
    <message>
        <source>the volume that came out is not that of the tool</source>
        <translation>das Volumen, das herauskam, ist nicht das des Werkzeugs</translation>
    </message>
    <message>
        <source>there is no text to emboss</source>
        <translation>es gibt keinen Text zu prägen</translation>
    </message>
    <message>
        <source>what the tool cuts could not be taken out of the part</source>
        <translation>was das Werkzeug schneidet, ließ sich nicht aus dem Teil nehmen</translation>
    </message>
    <message>
        <source>Make it about %1 times as large</source>
        <translation>Machen Sie es etwa %1-mal so groß</translation>
    </message>
    <message>
        <source>Make it thicker or shorter</source>
        <translation>Machen Sie es dicker oder kürzer</translation>
    </message>
    <message>
        <source>Move it, or make it larger or smaller</source>
        <translation>Verschieben Sie es, oder machen Sie es größer oder kleiner</translation>
    </message>
    <message>
        <source>Select a wall of the part</source>
        <translation>Wählen Sie eine Fläche des Teils</translation>
    </message>
    <message>
        <source>something of what is added would not touch the part</source>
        <translation>etwas von dem, was hinzukommt, berührte das Teil nicht</translation>
    </message>
    <message>
        <source>the part would fall into pieces, or have a closed void</source>
        <translation>das Teil zerfiele in Stücke oder bekäme einen geschlossenen Hohlraum</translation>
    </message>
    <message>
        <source>what is asked for is too small for the mesh there: its edges would measure %1 mm</source>
        <translation>was verlangt ist, ist zu klein für das Netz dort: seine Kanten wären %1 mm lang</translation>
    </message>
    <message>
        <source>what is asked for is too thin for its size: it would take more than %1 edges of %2 mm along it</source>
        <translation>was verlangt ist, ist zu dünn für seine Größe: es bräuchte mehr als %1 Kanten von %2 mm der Länge nach</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>Make it smaller or less bent</source>
        <translation>Es kleiner oder weniger gebogen machen</translation>
    </message>
    <message>
        <source>Move the wall further, or together with those that it runs on into</source>
        <translation>Die Wand weiter bewegen oder zusammen mit denen, in die sie weiterläuft</translation>
    </message>
    <message>
        <source>a step is left where the wall runs on smoothly, beside surface %1; select it, too, to move both</source>
        <translation>wo die Wand glatt weiterläuft, bleibt eine Stufe, neben Fläche %1; auch sie auswählen, um beide zu bewegen</translation>
    </message>
    <message>
        <source>a step of %1 is too small for a mesh whose edges measure %2 there</source>
        <translation>eine Stufe von %1 ist zu klein für ein Netz, dessen Kanten dort %2 messen</translation>
    </message>
    <message>
        <source>beyond surface %1</source>
        <translation>jenseits von Fläche %1</translation>
    </message>
    <message>
        <source>not each face of the tool is told what it continues</source>
        <translation>nicht zu jeder Seite des Werkzeugs steht, was sie fortsetzt</translation>
    </message>
    <message>
        <source>nothing of surface %1 would be left</source>
        <translation>von Fläche %1 bliebe nichts übrig</translation>
    </message>
    <message>
        <source>step beside %1</source>
        <translation>Stufe neben %1</translation>
    </message>
    <message>
        <source>surface %1 before</source>
        <translation>Fläche %1 vorher</translation>
    </message>
    <message>
        <source>surface %1 bends too sharply at %2 to be moved so far</source>
        <translation>Fläche %1 ist bei %2 zu stark gebogen, um so weit bewegt zu werden</translation>
    </message>
    <message>
        <source>surface %1 prolonged</source>
        <translation>Fläche %1 verlängert</translation>
    </message>
    <message>
        <source>the part is only %1 thick</source>
        <translation>das Teil ist nur %1 dick</translation>
    </message>
    <message>
        <source>the part is only %1 thick between surfaces %2 and %3 at %4</source>
        <translation>das Teil ist zwischen den Flächen %2 und %3 bei %4 nur %1 dick</translation>
    </message>
    <message>
        <source>the tool&apos;s surface passes through itself</source>
        <translation>die Oberfläche des Werkzeugs durchdringt sich selbst</translation>
    </message>
    <message>
        <source>the wall would come to lie %1 mm off where it should</source>
        <translation>die Wand käme %1 mm neben ihrem Platz zu liegen</translation>
    </message>
    <message>
        <source>there are only %1 of space</source>
        <translation>es sind nur %1 Platz</translation>
    </message>
    <message>
        <source>there are only %1 of space between surfaces %2 and %3 at %4</source>
        <translation>zwischen den Flächen %2 und %3 sind bei %4 nur %1 Platz</translation>
    </message>
    <message>
        <source>%1 tets without volume are left: no mesh without them was found</source>
        <translation>%1 Tetraeder ohne Volumen sind geblieben: ohne sie fand sich kein Netz</translation>
    </message>
    <message>
        <source>tets without volume meshed anew</source>
        <translation>Tetraeder ohne Volumen neu vernetzt</translation>
    </message>
    <message>
        <source>Improve the mesh (operation improve_mesh), or remesh the part there</source>
        <translation>Das Netz verbessern (Operation improve_mesh) oder das Teil dort neu vernetzen</translation>
    </message>
    <message>
        <source>%1, the first at %2: no stress can be computed until %3 there (%4)</source>
        <translation>%1, der erste bei %2: keine Spannung lässt sich berechnen, bis dort %3 (%4)</translation>
    </message>
    <message>
        <source>the mesh is improved (operation improve_mesh) or the part is remeshed</source>
        <translation>das Netz verbessert (Operation improve_mesh) oder das Teil neu vernetzt ist</translation>
    </message>
    <message>
        <source>the part is repaired or remeshed</source>
        <translation>das Teil repariert oder neu vernetzt ist</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 Millionen</translation>
    </message>
    <message>
        <source>%1 new vertices lie beside their round wall: on it, tets would turn</source>
        <translation>%1 neue Knoten liegen neben ihrer runden Fläche: auf ihr würden Tetraeder umklappen</translation>
    </message>
    <message>
        <source>Around the place.</source>
        <translation>Um den Ort.</translation>
    </message>
    <message>
        <source>Give a distance, or a way: by_mm=x,y,z</source>
        <translation>Geben Sie einen Abstand an oder einen Weg: by_mm=x,y,z</translation>
    </message>
    <message>
        <source>Give a place in or on the part, or a larger radius</source>
        <translation>Geben Sie einen Ort in oder auf dem Teil an oder einen größeren Radius</translation>
    </message>
    <message>
        <source>Give a place on the wall, or a larger radius</source>
        <translation>Geben Sie einen Ort auf der Fläche an oder einen größeren Radius</translation>
    </message>
    <message>
        <source>Give a way: by_mm=x,y,z</source>
        <translation>Geben Sie einen Weg an: by_mm=x,y,z</translation>
    </message>
    <message>
        <source>Give the part better tets first: improve_mesh</source>
        <translation>Geben Sie dem Teil zuerst bessere Tetraeder: improve_mesh</translation>
    </message>
    <message>
        <source>Give the part better tets there: improve_mesh</source>
        <translation>Geben Sie dem Teil dort bessere Tetraeder: improve_mesh</translation>
    </message>
    <message>
        <source>Improve the mesh first: improve_mesh</source>
        <translation>Verbessern Sie zuerst das Netz: improve_mesh</translation>
    </message>
    <message>
        <source>Leave it out, or drag something else</source>
        <translation>Lassen Sie sie weg oder ziehen Sie etwas anderes</translation>
    </message>
    <message>
        <source>List the surfaces with tedit info</source>
        <translation>„tedit info“ zählt die Flächen auf</translation>
    </message>
    <message>
        <source>Mend them first: improve_mesh</source>
        <translation>Bessern Sie sie zuerst aus: improve_mesh</translation>
    </message>
    <message>
        <source>Say which way it goes: by_mm=x,y,z</source>
        <translation>Sagen Sie, wohin: by_mm=x,y,z</translation>
    </message>
    <message>
        <source>Select a surface of the boundary</source>
        <translation>Wählen Sie eine Fläche der Oberfläche</translation>
    </message>
    <message>
        <source>Select surfaces, or give a place: at_mm=10,20,5</source>
        <translation>Wählen Sie Flächen oder geben Sie einen Ort an: at_mm=10,20,5</translation>
    </message>
    <message>
        <source>Select the wall to drag, or give a place on it: at_mm=10,20,5</source>
        <translation>Wählen Sie die Fläche, die gezogen wird, oder geben Sie einen Ort darauf an: at_mm=10,20,5</translation>
    </message>
    <message>
        <source>Take a larger reach, or let the volume change</source>
        <translation>Nehmen Sie eine größere Reichweite oder lassen Sie das Volumen sich ändern</translation>
    </message>
    <message>
        <source>Take a larger size</source>
        <translation>Nehmen Sie eine größere Größe</translation>
    </message>
    <message>
        <source>Take a larger size, or a larger tolerance</source>
        <translation>Nehmen Sie eine größere Größe oder eine größere Toleranz</translation>
    </message>
    <message>
        <source>Take a size of %1 mm or more, or pick less</source>
        <translation>Nehmen Sie eine Größe von %1 mm oder mehr oder wählen Sie weniger aus</translation>
    </message>
    <message>
        <source>Take a smaller size</source>
        <translation>Nehmen Sie eine kleinere Größe</translation>
    </message>
    <message>
        <source>about %1 tets would come out; at most %2 are made</source>
        <translation>es kämen etwa %1 Tetraeder heraus; höchstens %2 werden gemacht</translation>
    </message>
    <message>
        <source>bending</source>
        <translation>biegen</translation>
    </message>
    <message>
        <source>coarsened</source>
        <translation>vergröbert</translation>
    </message>
    <message>
        <source>contracting edges</source>
        <translation>Kanten zusammenziehen</translation>
    </message>
    <message>
        <source>deformed</source>
        <translation>verformt</translation>
    </message>
    <message>
        <source>furthest that the boundary is from where it was</source>
        <translation>größte Abweichung der Oberfläche von ihrem Platz</translation>
    </message>
    <message>
        <source>how far around the part follows</source>
        <translation>wie weit ringsum das Teil folgt</translation>
    </message>
    <message>
        <source>longest edge at what was picked</source>
        <translation>längste Kante am Ausgewählten</translation>
    </message>
    <message>
        <source>looking at what is around</source>
        <translation>die Umgebung ansehen</translation>
    </message>
    <message>
        <source>more than %1 tets would come out</source>
        <translation>es kämen mehr als %1 Tetraeder heraus</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>neither a surface nor a place was given</source>
        <translation>weder eine Fläche noch ein Ort ist angegeben</translation>
    </message>
    <message>
        <source>neither a wall nor a place was given</source>
        <translation>weder eine Fläche noch ein Ort ist angegeben</translation>
    </message>
    <message>
        <source>new vertices</source>
        <translation>neue Knoten</translation>
    </message>
    <message>
        <source>no edge there can go: those shorter than %1 are needed for the part&apos;s shape or for good tets</source>
        <translation>keine Kante dort kann wegfallen: die kürzer als %1 sind, werden für die Form des Teils oder für gute Tetraeder gebraucht</translation>
    </message>
    <message>
        <source>no edge there is longer than %1</source>
        <translation>keine Kante dort ist länger als %1</translation>
    </message>
    <message>
        <source>nothing is beyond the reach: the whole part moves</source>
        <translation>nichts liegt außer Reichweite: das ganze Teil bewegt sich</translation>
    </message>
    <message>
        <source>nothing within reach can give way to keep the volume</source>
        <translation>nichts in Reichweite kann nachgeben, um das Volumen zu behalten</translation>
    </message>
    <message>
        <source>putting the new tets in</source>
        <translation>die neuen Tetraeder einsetzen</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>verfeinert</translation>
    </message>
    <message>
        <source>splitting edges</source>
        <translation>Kanten teilen</translation>
    </message>
    <message>
        <source>surface %1 has no facet on the outside of the part</source>
        <translation>Fläche %1 hat kein Dreieck an der Außenseite des Teils</translation>
    </message>
    <message>
        <source>surface %1 is to stay and touches what is dragged</source>
        <translation>Fläche %1 soll bleiben und berührt das Gezogene</translation>
    </message>
    <message>
        <source>surface %1 would run into surface %2 near %3</source>
        <translation>Fläche %1 liefe bei %3 in Fläche %2 hinein</translation>
    </message>
    <message>
        <source>surface %1, which is to stay, does not exist</source>
        <translation>Fläche %1, die bleiben soll, gibt es nicht</translation>
    </message>
    <message>
        <source>tets fewer</source>
        <translation>Tetraeder weniger</translation>
    </message>
    <message>
        <source>the distance is 0: nothing would move</source>
        <translation>der Abstand ist 0: nichts würde sich bewegen</translation>
    </message>
    <message>
        <source>the part has tets without volume there</source>
        <translation>das Teil hat dort Tetraeder ohne Volumen</translation>
    </message>
    <message>
        <source>the place %1 is %2 mm off the wall, further than the radius of %3 mm</source>
        <translation>der Ort %1 liegt %2 mm neben der Fläche, weiter als der Radius von %3 mm</translation>
    </message>
    <message>
        <source>the place %1 is %2 off the part</source>
        <translation>der Ort %1 liegt %2 neben dem Teil</translation>
    </message>
    <message>
        <source>the selected surfaces have no facet on the outside</source>
        <translation>die ausgewählten Flächen haben kein Dreieck an der Außenseite</translation>
    </message>
    <message>
        <source>the tet near %1 is too flat already, q = %2, and would become %3</source>
        <translation>das Tetraeder bei %1 ist schon zu flach, q = %2, und bekäme %3</translation>
    </message>
    <message>
        <source>the tet near %1 would become too flat: q = %2, at least %3</source>
        <translation>das Tetraeder bei %1 würde zu flach: q = %2, mindestens %3</translation>
    </message>
    <message>
        <source>the tets there are too flat for a smooth field</source>
        <translation>die Tetraeder dort sind zu flach für ein glattes Feld</translation>
    </message>
    <message>
        <source>the way is 0, 0, 0: nothing would move</source>
        <translation>der Weg ist 0, 0, 0: nichts würde sich bewegen</translation>
    </message>
    <message>
        <source>vertices that went</source>
        <translation>weggefallene Knoten</translation>
    </message>
    <message>
        <source>what is dragged faces so many ways that it has no normal</source>
        <translation>das Gezogene weist in so viele Richtungen, dass es keine Normale hat</translation>
    </message>
    <message>
        <source>what is within reach cannot give way so far as to keep the volume</source>
        <translation>was in Reichweite ist, kann nicht so weit nachgeben, dass das Volumen bleibt</translation>
    </message>
    <message>
        <source>within reach these surfaces stay: %1</source>
        <translation>in Reichweite bleiben diese Flächen: %1</translation>
    </message>
    <message>
        <source>Allow more tets, or a larger error</source>
        <translation>Erlauben Sie mehr Tetraeder oder einen größeren Fehler</translation>
    </message>
    <message>
        <source>no tet can become smaller within the limit of tets</source>
        <translation>kein Tetraeder kann innerhalb der Grenze für Tetraeder kleiner werden</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is of no kind that can be combined</source>
        <translation>„%1“ ist von keiner Art, die sich verknüpfen lässt</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1 closed voids are</source>
        <translation>%1 geschlossene Hohlräume bleiben</translation>
    </message>
    <message>
        <source>%1 closed voids are left inside; pick walls for drains, or walls to leave open</source>
        <translation>innen bleiben %1 geschlossene Hohlräume; Wände für Abläufe auswählen oder Wände, die offen bleiben</translation>
    </message>
    <message>
        <source>%1 copies are more than the 1000 that one edit makes</source>
        <translation>%1 Kopien sind mehr als die 1000, die eine Änderung macht</translation>
    </message>
    <message>
        <source>%1 copies that overlap each other are more than the %2 that one edit makes</source>
        <translation>%1 Kopien, die einander überlappen, sind mehr als die %2, die eine Änderung macht</translation>
    </message>
    <message>
        <source>%1 has %2 triangles, more than 200,000</source>
        <translation>%1 hat %2 Dreiecke, mehr als 200.000</translation>
    </message>
    <message>
        <source>%1 has a corner that is no finite number</source>
        <translation>%1 hat eine Ecke, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>%1 has no filled shape</source>
        <translation>%1 hat keine gefüllte Form</translation>
    </message>
    <message>
        <source>%1 has too many curves for its size</source>
        <translation>%1 hat zu viele Kurven für seine Größe</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 ist leer</translation>
    </message>
    <message>
        <source>%1 is no closed surface: %2 edges have not one triangle on each side, the first at %3 of the file</source>
        <translation>%1 ist keine geschlossene Oberfläche: %2 Kanten haben nicht auf jeder Seite ein Dreieck, die erste bei %3 der Datei</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 gibt es nicht</translation>
    </message>
    <message>
        <source>Check its unit, its scale and its place</source>
        <translation>Einheit, Maßstab und Ort prüfen</translation>
    </message>
    <message>
        <source>Check who may read it</source>
        <translation>Prüfen, wer sie lesen darf</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>Choose one: file=PATH</source>
        <translation>Eine wählen: file=PFAD</translation>
    </message>
    <message>
        <source>Close it in the program that it comes from</source>
        <translation>Sie in dem Programm schließen, aus dem sie kommt</translation>
    </message>
    <message>
        <source>Convert texts and strokes to paths, and fill them</source>
        <translation>Texte und Striche in Pfade umwandeln und füllen</translation>
    </message>
    <message>
        <source>Give a count of 2 or more</source>
        <translation>Eine Anzahl ab 2 angeben</translation>
    </message>
    <message>
        <source>Give a file that ends in .stl, .obj, .off, .ply or .msh</source>
        <translation>Eine Datei angeben, die auf .stl, .obj, .off, .ply oder .msh endet</translation>
    </message>
    <message>
        <source>Give a smaller count</source>
        <translation>Eine kleinere Anzahl angeben</translation>
    </message>
    <message>
        <source>Give a smaller count or a larger step</source>
        <translation>Eine kleinere Anzahl oder einen größeren Schritt angeben</translation>
    </message>
    <message>
        <source>Give another diameter</source>
        <translation>Einen anderen Durchmesser angeben</translation>
    </message>
    <message>
        <source>Give it as data:NAME;base64,CONTENT; programs of this kind make that of a path</source>
        <translation>Sie als data:NAME;base64,INHALT angeben; Programme dieser Art machen das aus einem Pfad</translation>
    </message>
    <message>
        <source>Give the angle from the first to the last</source>
        <translation>Den Winkel vom ersten bis zum letzten angeben</translation>
    </message>
    <message>
        <source>Give the way from one to the next: step_mm=20,0,0</source>
        <translation>Den Weg von einem zum nächsten angeben: step_mm=20,0,0</translation>
    </message>
    <message>
        <source>Give the way: by_mm=10,0,0</source>
        <translation>Den Weg angeben: by_mm=10,0,0</translation>
    </message>
    <message>
        <source>Pick a wall of a hole, or a side of a boss that stands free</source>
        <translation>Eine Wand eines Lochs auswählen oder eine Seite eines Nockens, der frei steht</translation>
    </message>
    <message>
        <source>Pick the wall of a round bore or pin; erode and thicken move walls of any form</source>
        <translation>Die Wand einer runden Bohrung oder eines Zapfens auswählen; erode und thicken bewegen Wände jeder Form</translation>
    </message>
    <message>
        <source>Save it again, as a binary STL</source>
        <translation>Sie noch einmal speichern, als binäre STL-Datei</translation>
    </message>
    <message>
        <source>Simplify it first</source>
        <translation>Sie zuerst vereinfachen</translation>
    </message>
    <message>
        <source>Simplify it, or make it smaller</source>
        <translation>Sie vereinfachen oder kleiner machen</translation>
    </message>
    <message>
        <source>Simplify what it holds</source>
        <translation>Vereinfachen, was sie enthält</translation>
    </message>
    <message>
        <source>Take a diameter of %1, which works here</source>
        <translation>Einen Durchmesser von %1 nehmen, der hier geht</translation>
    </message>
    <message>
        <source>Take a diameter of %1: the largest that works here</source>
        <translation>Einen Durchmesser von %1 nehmen: der größte, der hier geht</translation>
    </message>
    <message>
        <source>Take a diameter of %1: the smallest that works here</source>
        <translation>Einen Durchmesser von %1 nehmen: der kleinste, der hier geht</translation>
    </message>
    <message>
        <source>Take a larger thickness</source>
        <translation>Eine größere Dicke nehmen</translation>
    </message>
    <message>
        <source>Take a larger thickness, or open other walls</source>
        <translation>Eine größere Dicke nehmen oder andere Wände öffnen</translation>
    </message>
    <message>
        <source>Take a smaller height</source>
        <translation>Eine kleinere Höhe nehmen</translation>
    </message>
    <message>
        <source>Take a smaller thickness</source>
        <translation>Eine kleinere Dicke nehmen</translation>
    </message>
    <message>
        <source>Take a thickness of at least %1 mm</source>
        <translation>Eine Dicke von mindestens %1 mm nehmen</translation>
    </message>
    <message>
        <source>Take another thickness</source>
        <translation>Eine andere Dicke nehmen</translation>
    </message>
    <message>
        <source>Take one kind at a time</source>
        <translation>Eine Art auf einmal nehmen</translation>
    </message>
    <message>
        <source>a closed void is</source>
        <translation>ein geschlossener Hohlraum bleibt</translation>
    </message>
    <message>
        <source>a closed void is left inside; pick walls for drains, or walls to leave open</source>
        <translation>innen bleibt ein geschlossener Hohlraum; Wände für Abläufe auswählen oder Wände, die offen bleiben</translation>
    </message>
    <message>
        <source>a pattern of one is what is there already</source>
        <translation>ein Muster aus einem ist, was schon da ist</translation>
    </message>
    <message>
        <source>change of the diameter</source>
        <translation>Änderung des Durchmessers</translation>
    </message>
    <message>
        <source>copy %1 of %2: %3</source>
        <translation>Kopie %1 von %2: %3</translation>
    </message>
    <message>
        <source>copy of %1</source>
        <translation>Kopie von %1</translation>
    </message>
    <message>
        <source>cut above</source>
        <translation>Schnitt oben</translation>
    </message>
    <message>
        <source>cut below</source>
        <translation>Schnitt unten</translation>
    </message>
    <message>
        <source>diameter now</source>
        <translation>Durchmesser jetzt</translation>
    </message>
    <message>
        <source>furthest off it at any vertex</source>
        <translation>größte Abweichung davon an einem Knoten</translation>
    </message>
    <message>
        <source>holes and bosses are selected together</source>
        <translation>Löcher und Nocken sind zusammen ausgewählt</translation>
    </message>
    <message>
        <source>hollow spaces</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source>it is not the content of a file</source>
        <translation>das ist nicht der Inhalt einer Datei</translation>
    </message>
    <message>
        <source>it is the content of a file</source>
        <translation>es ist der Inhalt einer Datei</translation>
    </message>
    <message>
        <source>it is too thin for the size of the part: too many triangles</source>
        <translation>das ist zu dünn für die Größe des Teils: zu viele Dreiecke</translation>
    </message>
    <message>
        <source>it would not touch the part</source>
        <translation>es würde das Teil nicht berühren</translation>
    </message>
    <message>
        <source>it would stay where it is</source>
        <translation>es bliebe, wo es ist</translation>
    </message>
    <message>
        <source>letters of that height would reach the middle of the round wall</source>
        <translation>Buchstaben dieser Höhe würden bis zur Mitte der runden Wand reichen</translation>
    </message>
    <message>
        <source>looking for the inside</source>
        <translation>Inneres suchen</translation>
    </message>
    <message>
        <source>nothing of the part is thicker than twice %1 mm</source>
        <translation>nichts am Teil ist dicker als zweimal %1 mm</translation>
    </message>
    <message>
        <source>one of the copies does not meet the part</source>
        <translation>eine der Kopien trifft das Teil nicht</translation>
    </message>
    <message>
        <source>surface %1 belongs neither to a hole nor to a boss</source>
        <translation>Fläche %1 gehört weder zu einem Loch noch zu einem Nocken</translation>
    </message>
    <message>
        <source>surface %1 has a diameter of %2 already</source>
        <translation>Fläche %1 hat schon einen Durchmesser von %2</translation>
    </message>
    <message>
        <source>surface %1 is no round cylinder</source>
        <translation>Fläche %1 ist kein runder Zylinder</translation>
    </message>
    <message>
        <source>taken out</source>
        <translation>herausgenommen</translation>
    </message>
    <message>
        <source>the content of the file is not base64</source>
        <translation>der Inhalt der Datei ist kein base64</translation>
    </message>
    <message>
        <source>the copies would lie in the same place</source>
        <translation>die Kopien lägen an derselben Stelle</translation>
    </message>
    <message>
        <source>the file has more than 4 MiB</source>
        <translation>die Datei hat mehr als 4 MiB</translation>
    </message>
    <message>
        <source>the file&apos;s surface lies beside the part: it measures %1, the part %2</source>
        <translation>die Oberfläche der Datei liegt neben dem Teil: sie misst %1, das Teil %2</translation>
    </message>
    <message>
        <source>the inside&apos;s surface passes through itself</source>
        <translation>die Oberfläche des Inneren durchdringt sich selbst</translation>
    </message>
    <message>
        <source>the most that works</source>
        <translation>das meiste, das geht</translation>
    </message>
    <message>
        <source>the part is %1 bodies now; each needs supports of its own</source>
        <translation>das Teil besteht jetzt aus %1 Körpern; jeder braucht eigene Lager</translation>
    </message>
    <message>
        <source>the part would fall into pieces</source>
        <translation>das Teil würde in Stücke zerfallen</translation>
    </message>
    <message>
        <source>the profile is to come from a file, and none was given</source>
        <translation>das Profil soll aus einer Datei kommen, und keine wurde angegeben</translation>
    </message>
    <message>
        <source>walls of %1 mm are too thin for a part of this size: they would take too many tets</source>
        <translation>Wände von %1 mm sind zu dünn für ein Teil dieser Größe: sie bräuchten zu viele Tetraeder</translation>
    </message>
    <message>
        <source>Check its unit and its scale</source>
        <translation>Einheit und Maßstab prüfen</translation>
    </message>
    <message>
        <source>bore %1</source>
        <translation>Bohrung %1</translation>
    </message>
    <message>
        <source>the file&apos;s surface is so large that it would take more than 400,000 triangles like those of the part</source>
        <translation>die Oberfläche der Datei ist so groß, dass sie mehr als 400.000 Dreiecke wie die des Teils bräuchte</translation>
    </message>
    <message>
        <source>Install it beside this one</source>
        <translation>Es neben diesem installieren</translation>
    </message>
    <message>
        <source>Set TMPDIR to a folder with room that you may write to</source>
        <translation>TMPDIR auf einen Ordner mit Platz setzen, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>no temporary folder can be made</source>
        <translation>es lässt sich kein temporärer Ordner anlegen</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>der Import wurde abgebrochen</translation>
    </message>
    <message>
        <source>the program tedit does not start: %1</source>
        <translation>das Programm tedit startet nicht: %1</translation>
    </message>
    <message>
        <source>%1 died%2 (exit status %3)</source>
        <translation>%1 starb%2 (Status %3)</translation>
    </message>
    <message>
        <source>%1 died%2 (signal %3)</source>
        <translation>%1 starb%2 (Signal %3)</translation>
    </message>
    <message>
        <source>%1 of the import&apos;s folder is damaged</source>
        <translation>%1 im Ordner des Imports ist beschädigt</translation>
    </message>
    <message>
        <source>%1 took longer than %2 s%3</source>
        <translation>%1 brauchte länger als %2 s%3</translation>
    </message>
    <message>
        <source>Build TEdit where the packages libocct-data-exchange-dev and libgmsh-dev are installed (scripts/install_deps.sh), or set TEDIT_LIBEXEC to the program&apos;s folder</source>
        <translation>TEdit bauen, wo die Pakete libocct-data-exchange-dev und libgmsh-dev installiert sind (scripts/install_deps.sh), oder TEDIT_LIBEXEC auf den Ordner des Programms setzen</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limits of open files and processes</source>
        <translation>Andere Programme schließen oder die Grenzen für offene Dateien und Prozesse erhöhen</translation>
    </message>
    <message>
        <source>Export it again from the CAD program</source>
        <translation>Sie noch einmal aus dem CAD-Programm exportieren</translation>
    </message>
    <message>
        <source>Export it again from the CAD program, as STEP where you can</source>
        <translation>Sie noch einmal aus dem CAD-Programm exportieren, wenn möglich als STEP</translation>
    </message>
    <message>
        <source>Export the part again from the CAD program</source>
        <translation>Das Teil noch einmal aus dem CAD-Programm exportieren</translation>
    </message>
    <message>
        <source>Export the part as a STEP file</source>
        <translation>Das Teil als STEP-Datei exportieren</translation>
    </message>
    <message>
        <source>Export the part as a solid (AP203, AP214 or AP242)</source>
        <translation>Das Teil als Volumenkörper exportieren (AP203, AP214 oder AP242)</translation>
    </message>
    <message>
        <source>Export the part as a solid; check in the CAD program that it is closed</source>
        <translation>Das Teil als Volumenkörper exportieren; im CAD-Programm prüfen, dass er geschlossen ist</translation>
    </message>
    <message>
        <source>Export the part from the CAD program again</source>
        <translation>Das Teil noch einmal aus dem CAD-Programm exportieren</translation>
    </message>
    <message>
        <source>Export the part from the CAD program as STEP (AP203, AP214 or AP242)</source>
        <translation>Das Teil aus dem CAD-Programm als STEP exportieren (AP203, AP214 oder AP242)</translation>
    </message>
    <message>
        <source>Export the parts one by one, or unite them in the CAD program</source>
        <translation>Die Teile einzeln exportieren oder im CAD-Programm vereinigen</translation>
    </message>
    <message>
        <source>Gmsh could not fill the part with tets</source>
        <translation>Gmsh konnte das Teil nicht mit Tetraedern füllen</translation>
    </message>
    <message>
        <source>Gmsh could not mesh the part: %1</source>
        <translation>Gmsh konnte das Teil nicht vernetzen: %1</translation>
    </message>
    <message>
        <source>Gmsh made no triangles on %1</source>
        <translation>Gmsh machte keine Dreiecke auf %1</translation>
    </message>
    <message>
        <source>Gmsh numbers the %1 faces and %2 solids otherwise than they were read</source>
        <translation>Gmsh nummeriert die %1 Flächen und %2 Körper anders, als sie gelesen wurden</translation>
    </message>
    <message>
        <source>Import its solids one by one</source>
        <translation>Seine Körper einzeln importieren</translation>
    </message>
    <message>
        <source>Make room on the disk of the temporary folder ($TMPDIR)</source>
        <translation>Auf der Platte des temporären Ordners ($TMPDIR) Platz schaffen</translation>
    </message>
    <message>
        <source>Nothing else is lost. Export the part again from the CAD program, as AP203 or AP214 without annotations, or with fewer details</source>
        <translation>Sonst ist nichts verloren. Das Teil noch einmal aus dem CAD-Programm exportieren, als AP203 oder AP214 ohne Anmerkungen oder mit weniger Einzelheiten</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot read the file: %1 %2</source>
        <translation>OpenCASCADE kann die Datei nicht lesen: %1 %2</translation>
    </message>
    <message>
        <source>The file may be made to do harm: nothing was changed. Report it if it is yours</source>
        <translation>Die Datei kann gemacht sein, um zu schaden: Nichts wurde geändert. Bitte melden, wenn sie Ihre ist</translation>
    </message>
    <message>
        <source>This is a defect of TEdit: please report it with the CAD file</source>
        <translation>Das ist ein Fehler von TEdit: Bitte mit der CAD-Datei melden</translation>
    </message>
    <message>
        <source>Try again; if it stays, report it with the CAD file</source>
        <translation>Noch einmal versuchen; wenn es bleibt, mit der CAD-Datei melden</translation>
    </message>
    <message>
        <source>Write it again with BRepTools::Write of OpenCASCADE, or take a STEP file</source>
        <translation>Sie noch einmal mit BRepTools::Write von OpenCASCADE schreiben oder eine STEP-Datei nehmen</translation>
    </message>
    <message>
        <source>an import&apos;s program wrote what cannot be: %1</source>
        <translation>ein Programm des Imports schrieb, was nicht sein kann: %1</translation>
    </message>
    <message>
        <source>building the mesh</source>
        <translation>Netz aufbauen</translation>
    </message>
    <message>
        <source>cannot read %1: it is no regular file</source>
        <translation>%1 lässt sich nicht lesen: das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>cannot read %1: there is no such file</source>
        <translation>%1 lässt sich nicht lesen: diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1</source>
        <translation>es lässt sich kein temporärer Ordner anlegen: %1</translation>
    </message>
    <message>
        <source>the %1 solids of the assembly cannot be joined where they touch</source>
        <translation>die %1 Körper der Baugruppe lassen sich nicht verbinden, wo sie sich berühren</translation>
    </message>
    <message>
        <source>the CAD file cannot be copied without its annotations</source>
        <translation>die CAD-Datei lässt sich nicht ohne ihre Anmerkungen kopieren</translation>
    </message>
    <message>
        <source>the IGES file holds no geometry that can be transferred</source>
        <translation>die IGES-Datei enthält keine Geometrie, die sich übertragen lässt</translation>
    </message>
    <message>
        <source>the STEP file holds no geometry that can be transferred</source>
        <translation>die STEP-Datei enthält keine Geometrie, die sich übertragen lässt</translation>
    </message>
    <message>
        <source>the mesh cannot be written</source>
        <translation>das Netz lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the mesher needs more memory than it may take</source>
        <translation>der Vernetzer braucht mehr Speicher, als er nehmen darf</translation>
    </message>
    <message>
        <source>the part has more faces than can be taken</source>
        <translation>das Teil hat mehr Flächen, als sich nehmen lassen</translation>
    </message>
    <message>
        <source>the reader needs more memory than it may take</source>
        <translation>der Leser braucht mehr Speicher, als er nehmen darf</translation>
    </message>
    <message>
        <source>the shape that was read cannot be written</source>
        <translation>die gelesene Form lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>there is no solid in the file</source>
        <translation>in der Datei ist kein Volumenkörper</translation>
    </message>
    <message>
        <source>there is no solid in the file: it holds surfaces that close no volume</source>
        <translation>in der Datei ist kein Volumenkörper: sie enthält Flächen, die kein Volumen schließen</translation>
    </message>
    <message>
        <source>this installation reads no CAD files: there is no %1</source>
        <translation>diese Installation liest keine CAD-Dateien: %1 fehlt</translation>
    </message>
    <message>
        <source>this is no STEP, IGES or BREP file: it looks like %1</source>
        <translation>das ist keine STEP-, IGES- oder BREP-Datei: sie sieht aus wie %1</translation>
    </message>
    <message>
        <source>this program is started by &quot;tedit import&quot;</source>
        <translation>dieses Programm wird von „tedit import“ gestartet</translation>
    </message>
    <message>
        <source>Give direction=x,y,z along the walls</source>
        <translation>direction=x,y,z längs der Wände angeben</translation>
    </message>
    <message>
        <source>Give one along the walls</source>
        <translation>Eine längs der Wände angeben</translation>
    </message>
    <message>
        <source>Move it: at_mm=x,y,z, or make it larger</source>
        <translation>Sie verschieben: at_mm=x,y,z, oder größer machen</translation>
    </message>
    <message>
        <source>Pick two walls</source>
        <translation>Zwei Wände auswählen</translation>
    </message>
    <message>
        <source>Pick two walls with the rib&apos;s space between them</source>
        <translation>Zwei Wände mit dem Platz der Rippe dazwischen auswählen</translation>
    </message>
    <message>
        <source>a rib stands between two walls</source>
        <translation>eine Rippe steht zwischen zwei Wänden</translation>
    </message>
    <message>
        <source>the direction goes from wall to wall</source>
        <translation>die Richtung geht von Wand zu Wand</translation>
    </message>
    <message>
        <source>the rib would not touch surface %1</source>
        <translation>die Rippe würde Fläche %1 nicht berühren</translation>
    </message>
    <message>
        <source>the walls face each other: it is not known which way the rib stands</source>
        <translation>die Wände sind einander zugewandt: es ist nicht bekannt, wohin die Rippe steht</translation>
    </message>
    <message>
        <source>the walls neither meet in an inner corner nor face each other</source>
        <translation>die Wände treffen sich weder in einer inneren Ecke, noch sind sie einander zugewandt</translation>
    </message>
    <message>
        <source>opening %1 failed: %2</source>
        <translation>Öffnen von %1 misslang: %2</translation>
    </message>
    <message>
        <source>Try again; it may be starting anew</source>
        <translation>Noch einmal versuchen; er startet vielleicht gerade neu</translation>
    </message>
    <message>
        <source>the server did not say whether this worker may join: it is busy, or gone</source>
        <translation>der Server sagte nicht, ob dieser Arbeiter beitreten darf: er ist beschäftigt oder weg</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number</source>
        <translation>%1 „%2“ ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 is %2, numbers start at 1</source>
        <translation>%1 ist %2, Nummern beginnen bei 1</translation>
    </message>
    <message>
        <source>%1 of a %2 is &quot;%3&quot;, not a finite number (field %4)</source>
        <translation>%1 einer Karte %2 ist „%3“, keine endliche Zahl (Feld %4)</translation>
    </message>
    <message>
        <source>%1 of a %2 is &quot;%3&quot;, not a whole number from 1 (field %4)</source>
        <translation>%1 einer Karte %2 ist „%3“, keine ganze Zahl ab 1 (Feld %4)</translation>
    </message>
    <message>
        <source>%1 of the %2 faces of &quot;%3&quot; belong to smaller surfaces, too, and stay with those: a face has one surface</source>
        <translation>%1 der %2 Seiten von „%3“ gehören auch zu kleineren Flächen und bleiben bei diesen: eine Seite hat eine Fläche</translation>
    </message>
    <message>
        <source>%1 supports and loads are on nodes that no tet has, and are left out</source>
        <translation>%1 Lager und Lasten sitzen auf Knoten, die kein Tetraeder hat, und werden ausgelassen</translation>
    </message>
    <message>
        <source>(without a name)</source>
        <translation>(ohne Namen)</translation>
    </message>
    <message>
        <source>*BOUNDARY holds no component on this line</source>
        <translation>*BOUNDARY hält in dieser Zeile keine Komponente</translation>
    </message>
    <message>
        <source>*BOUNDARY holds the components %1 to %2; there are 1 to 3</source>
        <translation>*BOUNDARY hält die Komponenten %1 bis %2; es gibt 1 bis 3</translation>
    </message>
    <message>
        <source>*CLOAD has too few fields on this line</source>
        <translation>*CLOAD hat in dieser Zeile zu wenige Felder</translation>
    </message>
    <message>
        <source>*ELASTIC stands outside of a *MATERIAL</source>
        <translation>*ELASTIC steht außerhalb von *MATERIAL</translation>
    </message>
    <message>
        <source>*NODE with cylindrical or spherical coordinates</source>
        <translation>*NODE mit Zylinder- oder Kugelkoordinaten</translation>
    </message>
    <message>
        <source>A mesh: %1</source>
        <translation>Ein Netz: %1</translation>
    </message>
    <message>
        <source>Correct the card or write the file again</source>
        <translation>Die Karte berichtigen oder die Datei neu schreiben</translation>
    </message>
    <message>
        <source>Correct the line</source>
        <translation>Die Zeile berichtigen</translation>
    </message>
    <message>
        <source>Correct the line or write the file again</source>
        <translation>Die Zeile berichtigen oder die Datei neu schreiben</translation>
    </message>
    <message>
        <source>Define that set</source>
        <translation>Diese Menge definieren</translation>
    </message>
    <message>
        <source>Define that set first</source>
        <translation>Diese Menge zuerst definieren</translation>
    </message>
    <message>
        <source>GRAV in a coordinate system of its own</source>
        <translation>GRAV in einem eigenen Koordinatensystem</translation>
    </message>
    <message>
        <source>GRID %1 is in coordinate system %2; only the basic one (0) is read</source>
        <translation>GRID %1 steht im Koordinatensystem %2; nur das Grundsystem (0) wird gelesen</translation>
    </message>
    <message>
        <source>It is cut off or damaged: write it again</source>
        <translation>Sie ist abgeschnitten oder beschädigt: neu schreiben</translation>
    </message>
    <message>
        <source>Mesh the volume with tetrahedra and write them, too</source>
        <translation>Das Volumen mit Tetraedern vernetzen und diese auch schreiben</translation>
    </message>
    <message>
        <source>Number the elements anew, or remove one of the two</source>
        <translation>Die Elemente neu nummerieren oder eines der beiden entfernen</translation>
    </message>
    <message>
        <source>Number the nodes anew, or remove one of the two</source>
        <translation>Die Knoten neu nummerieren oder einen der beiden entfernen</translation>
    </message>
    <message>
        <source>Number the properties anew</source>
        <translation>Die Eigenschaften neu nummerieren</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>die Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Put it behind its *MATERIAL</source>
        <translation>Es hinter sein *MATERIAL setzen</translation>
    </message>
    <message>
        <source>Put its lines in the place of INCLUDE: files are read one by one</source>
        <translation>Ihre Zeilen an die Stelle von INCLUDE setzen: Dateien werden einzeln gelesen</translation>
    </message>
    <message>
        <source>Take linear tets (--order 1) or a coarser mesh</source>
        <translation>Lineare Tetraeder (--order 1) oder ein gröberes Netz nehmen</translation>
    </message>
    <message>
        <source>The file is damaged: write it again</source>
        <translation>Die Datei ist beschädigt: neu schreiben</translation>
    </message>
    <message>
        <source>The file is no deck of Abaqus or CalculiX, or it is damaged</source>
        <translation>Die Datei ist keine Eingabedatei von Abaqus oder CalculiX, oder sie ist beschädigt</translation>
    </message>
    <message>
        <source>Write a flat deck (in Abaqus: &quot;Do not use parts and assemblies&quot;)</source>
        <translation>Eine flache Datei schreiben (in Abaqus: „Do not use parts and assemblies“)</translation>
    </message>
    <message>
        <source>Write a flat deck (in Abaqus: *PREPRINT, MODEL or &quot;Do not use parts and assemblies&quot;), or each part by itself</source>
        <translation>Eine flache Datei schreiben (in Abaqus: *PREPRINT, MODEL oder „Do not use parts and assemblies“) oder jedes Teil für sich</translation>
    </message>
    <message>
        <source>Write another format, or coarsen the mesh</source>
        <translation>Ein anderes Format schreiben oder das Netz vergröbern</translation>
    </message>
    <message>
        <source>Write each line as: element or set, S1</source>
        <translation>Jede Zeile so schreiben: Element oder Menge, S1</translation>
    </message>
    <message>
        <source>Write each support and load once</source>
        <translation>Jedes Lager und jede Last einmal schreiben</translation>
    </message>
    <message>
        <source>Write it as one piece, for example with ParaView&apos;s filter Clean to Grid</source>
        <translation>Als ein Stück schreiben, etwa mit dem Filter Clean to Grid von ParaView</translation>
    </message>
    <message>
        <source>Write it without compression, or with zlib</source>
        <translation>Ohne Kompression oder mit zlib schreiben</translation>
    </message>
    <message>
        <source>Write nodes as dataset 2411 and elements as 2412</source>
        <translation>Knoten als Datensatz 2411 und Elemente als 2412 schreiben</translation>
    </message>
    <message>
        <source>Write the file again</source>
        <translation>Die Datei neu schreiben</translation>
    </message>
    <message>
        <source>Write the file with all of its elements</source>
        <translation>Die Datei mit allen ihren Elementen schreiben</translation>
    </message>
    <message>
        <source>Write the file with all of its nodes</source>
        <translation>Die Datei mit allen ihren Knoten schreiben</translation>
    </message>
    <message>
        <source>Write the mesh in m, cm, mm, um, nm, in or ft</source>
        <translation>Das Netz in m, cm, mm, um, nm, in oder ft schreiben</translation>
    </message>
    <message>
        <source>Write the nodes in Cartesian coordinates</source>
        <translation>Die Knoten in kartesischen Koordinaten schreiben</translation>
    </message>
    <message>
        <source>Write the nodes in basic coordinates</source>
        <translation>Die Knoten in Grundkoordinaten schreiben</translation>
    </message>
    <message>
        <source>Write the volume mesh as an unstructured grid (.vtu)</source>
        <translation>Das Volumennetz als unstrukturiertes Gitter (.vtu) schreiben</translation>
    </message>
    <message>
        <source>Write: node or set, component, force</source>
        <translation>So schreiben: Knoten oder Menge, Komponente, Kraft</translation>
    </message>
    <message>
        <source>Write: node or set, first component, last component, value</source>
        <translation>So schreiben: Knoten oder Menge, erste Komponente, letzte Komponente, Wert</translation>
    </message>
    <message>
        <source>a beam&apos;s orientation</source>
        <translation>die Ausrichtung eines Balkens</translation>
    </message>
    <message>
        <source>a dataset&apos;s end</source>
        <translation>das Ende eines Datensatzes</translation>
    </message>
    <message>
        <source>a dataset&apos;s number</source>
        <translation>die Nummer eines Datensatzes</translation>
    </message>
    <message>
        <source>a deck of Nastran numbers at most 99 999 999 nodes and elements</source>
        <translation>eine Eingabedatei von Nastran nummeriert höchstens 99 999 999 Knoten und Elemente</translation>
    </message>
    <message>
        <source>a face of &quot;%1&quot; names node %2, which does not exist</source>
        <translation>eine Seite von „%1“ nennt den Knoten %2, den es nicht gibt</translation>
    </message>
    <message>
        <source>a force acts on the set &quot;%1&quot;, which is not there</source>
        <translation>eine Kraft wirkt auf die Menge „%1“, die es nicht gibt</translation>
    </message>
    <message>
        <source>a group&apos;s members</source>
        <translation>die Mitglieder einer Gruppe</translation>
    </message>
    <message>
        <source>a group&apos;s name</source>
        <translation>der Name einer Gruppe</translation>
    </message>
    <message>
        <source>a line that begins with * was expected, not &quot;%1&quot;</source>
        <translation>eine Zeile, die mit * beginnt, wurde erwartet, nicht „%1“</translation>
    </message>
    <message>
        <source>a node&apos;s coordinate</source>
        <translation>die Koordinate eines Knotens</translation>
    </message>
    <message>
        <source>a node&apos;s coordinates</source>
        <translation>die Koordinaten eines Knotens</translation>
    </message>
    <message>
        <source>a node&apos;s first record needs its number, from 1</source>
        <translation>der erste Satz eines Knotens braucht seine Nummer, ab 1</translation>
    </message>
    <message>
        <source>a node&apos;s number</source>
        <translation>die Nummer eines Knotens</translation>
    </message>
    <message>
        <source>a node&apos;s x</source>
        <translation>das x eines Knotens</translation>
    </message>
    <message>
        <source>a node&apos;s y</source>
        <translation>das y eines Knotens</translation>
    </message>
    <message>
        <source>a node&apos;s z</source>
        <translation>das z eines Knotens</translation>
    </message>
    <message>
        <source>a number of an element</source>
        <translation>eine Nummer eines Elements</translation>
    </message>
    <message>
        <source>a set has more members than such a file can have nodes or elements</source>
        <translation>eine Menge hat mehr Mitglieder, als eine solche Datei Knoten oder Elemente haben kann</translation>
    </message>
    <message>
        <source>a support acts on the set &quot;%1&quot;, which is not there</source>
        <translation>ein Lager wirkt auf die Menge „%1“, die es nicht gibt</translation>
    </message>
    <message>
        <source>an element has more nodes than its first record says</source>
        <translation>ein Element hat mehr Knoten, als sein erster Satz sagt</translation>
    </message>
    <message>
        <source>an element names node %1</source>
        <translation>ein Element nennt den Knoten %1</translation>
    </message>
    <message>
        <source>an element&apos;s first record has six numbers: its own, descriptor, property, material, colour and how many nodes</source>
        <translation>der erste Satz eines Elements hat sechs Zahlen: seine eigene, Kennung, Eigenschaft, Werkstoff, Farbe und wie viele Knoten</translation>
    </message>
    <message>
        <source>an element&apos;s nodes</source>
        <translation>die Knoten eines Elements</translation>
    </message>
    <message>
        <source>array &quot;%1&quot;</source>
        <translation>Feld „%1“</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>cell %1 names point %2, which does not exist</source>
        <translation>Zelle %1 nennt den Punkt %2, den es nicht gibt</translation>
    </message>
    <message>
        <source>cell %1 of type %2 has %3 points</source>
        <translation>Zelle %1 vom Typ %2 hat %3 Punkte</translation>
    </message>
    <message>
        <source>curved beam</source>
        <translation>gekrümmter Balken</translation>
    </message>
    <message>
        <source>dataset %1</source>
        <translation>Datensatz %1</translation>
    </message>
    <message>
        <source>dataset %1 is of an older kind of UNV</source>
        <translation>Datensatz %1 gehört zu einer älteren Art von UNV</translation>
    </message>
    <message>
        <source>element %1 is listed twice</source>
        <translation>Element %1 steht zweimal da</translation>
    </message>
    <message>
        <source>element %1 of type %2 lists %3 nodes, it has %4</source>
        <translation>Element %1 vom Typ %2 nennt %3 Knoten, es hat %4</translation>
    </message>
    <message>
        <source>element %1, a %2, has %3 nodes</source>
        <translation>Element %1 (%2) hat %3 Knoten</translation>
    </message>
    <message>
        <source>ends inside the header of its data</source>
        <translation>endet im Kopf seiner Daten</translation>
    </message>
    <message>
        <source>forces on %1, %2 together, make up no whole surface and are left out</source>
        <translation>Kräfte auf %1, zusammen %2, ergeben keine ganze Fläche und werden ausgelassen</translation>
    </message>
    <message>
        <source>group &quot;%1&quot; says %2 members, but its lines have %3</source>
        <translation>Gruppe „%1“ nennt %2 Mitglieder, aber ihre Zeilen haben %3</translation>
    </message>
    <message>
        <source>has %1 numbers where %2 should be</source>
        <translation>hat %1 Zahlen, wo %2 sein sollten</translation>
    </message>
    <message>
        <source>has a block that zlib cannot read</source>
        <translation>hat einen Block, den zlib nicht lesen kann</translation>
    </message>
    <message>
        <source>has the format &quot;%1&quot;, which is not known</source>
        <translation>hat das Format „%1“, das nicht bekannt ist</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot; where a number should be</source>
        <translation>enthält „%1“, wo eine Zahl sein sollte</translation>
    </message>
    <message>
        <source>instance &quot;%1&quot; is moved from where its part is</source>
        <translation>Instanz „%1“ ist gegenüber ihrem Teil verschoben</translation>
    </message>
    <message>
        <source>is of type &quot;%1&quot;, which is not known</source>
        <translation>ist vom Typ „%1“, der nicht bekannt ist</translation>
    </message>
    <message>
        <source>lengths in %1</source>
        <translation>Längen in %1</translation>
    </message>
    <message>
        <source>material &quot;%1&quot; has no isotropic elasticity and is left out</source>
        <translation>Werkstoff „%1“ hat keine isotrope Elastizität und wird ausgelassen</translation>
    </message>
    <message>
        <source>material &quot;%1&quot; is of no element and is left out</source>
        <translation>Werkstoff „%1“ gehört zu keinem Element und wird ausgelassen</translation>
    </message>
    <message>
        <source>nodal component</source>
        <translation>Knotenkomponente</translation>
    </message>
    <message>
        <source>nodal forces on surface %1 are not spread evenly: read is their sum, %2, spread evenly</source>
        <translation>Knotenkräfte auf Fläche %1 sind nicht gleichmäßig verteilt: gelesen wird ihre Summe, %2, gleichmäßig verteilt</translation>
    </message>
    <message>
        <source>nodal forces on surfaces %1 are not spread evenly: read is their sum, %2, spread evenly</source>
        <translation>Knotenkräfte auf den Flächen %1 sind nicht gleichmäßig verteilt: gelesen wird ihre Summe, %2, gleichmäßig verteilt</translation>
    </message>
    <message>
        <source>not read, because nothing here can hold it: %1</source>
        <translation>nicht gelesen, weil nichts hier es aufnehmen kann: %1</translation>
    </message>
    <message>
        <source>parabolic beam</source>
        <translation>parabolischer Balken</translation>
    </message>
    <message>
        <source>parabolic brick</source>
        <translation>parabolischer Quader</translation>
    </message>
    <message>
        <source>parabolic quadrangle</source>
        <translation>parabolisches Viereck</translation>
    </message>
    <message>
        <source>parabolic tetrahedron</source>
        <translation>parabolischer Tetraeder</translation>
    </message>
    <message>
        <source>parabolic triangle</source>
        <translation>parabolisches Dreieck</translation>
    </message>
    <message>
        <source>parabolic wedge</source>
        <translation>parabolischer Keil</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is not a finite number</source>
        <translation>Punkt %1 hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>pressures on %1 make up no whole surface of one pressure and are left out</source>
        <translation>Drücke auf %1 ergeben keine ganze Fläche eines Drucks und werden ausgelassen</translation>
    </message>
    <message>
        <source>property %1 is out of range</source>
        <translation>Eigenschaft %1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>says %1 blocks, more than its bytes can hold</source>
        <translation>nennt %1 Blöcke, mehr als seine Bytes fassen</translation>
    </message>
    <message>
        <source>says %1 bytes, but %2 are left</source>
        <translation>nennt %1 Byte, aber %2 sind übrig</translation>
    </message>
    <message>
        <source>set &quot;%1&quot; names &quot;%2&quot;, which is neither a number nor a set</source>
        <translation>Menge „%1“ nennt „%2“, was weder eine Nummer noch eine Menge ist</translation>
    </message>
    <message>
        <source>solid or shell</source>
        <translation>Volumen- oder Schalenelement</translation>
    </message>
    <message>
        <source>supports and loads of the file are left out, as tets were</source>
        <translation>Lager und Lasten der Datei werden ausgelassen, wie auch Tetraeder</translation>
    </message>
    <message>
        <source>supports of %1 make up no whole surface and are left out</source>
        <translation>Lager von %1 ergeben keine ganze Fläche und werden ausgelassen</translation>
    </message>
    <message>
        <source>surface &quot;%1&quot; names element %2, which is no tet</source>
        <translation>Fläche „%1“ nennt das Element %2, das kein Tetraeder ist</translation>
    </message>
    <message>
        <source>surface &quot;%1&quot; names face &quot;%2&quot;; tets have S1 to S4</source>
        <translation>Fläche „%1“ nennt die Seite „%2“; Tetraeder haben S1 bis S4</translation>
    </message>
    <message>
        <source>surface &quot;%1&quot; names the set &quot;%2&quot;, which is not there</source>
        <translation>Fläche „%1“ nennt die Menge „%2“, die es nicht gibt</translation>
    </message>
    <message>
        <source>tapered beam</source>
        <translation>verjüngter Balken</translation>
    </message>
    <message>
        <source>tet %1 names node %2, which does not exist</source>
        <translation>Tetraeder %1 nennt den Knoten %2, den es nicht gibt</translation>
    </message>
    <message>
        <source>the acceleration</source>
        <translation>die Beschleunigung</translation>
    </message>
    <message>
        <source>the appended data do not begin with _</source>
        <translation>die angehängten Daten beginnen nicht mit _</translation>
    </message>
    <message>
        <source>the array &quot;%1&quot; %2</source>
        <translation>das Feld „%1“ %2</translation>
    </message>
    <message>
        <source>the cells have no array &quot;%1&quot;</source>
        <translation>die Zellen haben kein Feld „%1“</translation>
    </message>
    <message>
        <source>the component of a force</source>
        <translation>die Komponente einer Kraft</translation>
    </message>
    <message>
        <source>the components of a %1 are &quot;%2&quot;; they are digits from 1 to 6</source>
        <translation>die Komponenten einer Karte %1 sind „%2“; es sind Ziffern von 1 bis 6</translation>
    </message>
    <message>
        <source>the deck has more supports and loads than can be read</source>
        <translation>die Eingabedatei hat mehr Lager und Lasten, als gelesen werden können</translation>
    </message>
    <message>
        <source>the deck has more than one *%1, here &quot;%2&quot;</source>
        <translation>die Eingabedatei hat mehr als ein *%1, hier „%2“</translation>
    </message>
    <message>
        <source>the deck holds a %1; only tetrahedra (CTETRA) are supported</source>
        <translation>die Eingabedatei enthält %1; nur Tetraeder (CTETRA) gehen</translation>
    </message>
    <message>
        <source>the deck holds elements of type &quot;%1&quot;; only tetrahedra (C3D4, C3D10) are supported</source>
        <translation>die Eingabedatei enthält Elemente vom Typ „%1“; nur Tetraeder (C3D4, C3D10) gehen</translation>
    </message>
    <message>
        <source>the deck takes in another file by INCLUDE</source>
        <translation>die Eingabedatei holt mit INCLUDE eine andere Datei</translation>
    </message>
    <message>
        <source>the direction of gravity</source>
        <translation>die Richtung der Schwerkraft</translation>
    </message>
    <message>
        <source>the element</source>
        <translation>das Element</translation>
    </message>
    <message>
        <source>the factor</source>
        <translation>der Faktor</translation>
    </message>
    <message>
        <source>the factor of lengths</source>
        <translation>der Faktor der Längen</translation>
    </message>
    <message>
        <source>the factor of lengths is %1, that of no unit that is known</source>
        <translation>der Faktor der Längen ist %1, der keiner bekannten Einheit</translation>
    </message>
    <message>
        <source>the file ends where %1 should stand (dataset of line %2)</source>
        <translation>die Datei endet, wo %1 stehen sollte (Datensatz der Zeile %2)</translation>
    </message>
    <message>
        <source>the file holds %1 pieces; one is read</source>
        <translation>die Datei enthält %1 Stücke; eines wird gelesen</translation>
    </message>
    <message>
        <source>the file holds a %1 (descriptor %2); only tetrahedra (111, 118) are supported</source>
        <translation>die Datei enthält: %1 (Kennung %2); nur Tetraeder (111, 118) gehen</translation>
    </message>
    <message>
        <source>the file holds a solid or shell (descriptor %1); only tetrahedra (111, 118) are supported</source>
        <translation>die Datei enthält ein Volumen- oder Schalenelement (Kennung %1); nur Tetraeder (111, 118) gehen</translation>
    </message>
    <message>
        <source>the file holds no points</source>
        <translation>die Datei enthält keine Punkte</translation>
    </message>
    <message>
        <source>the file is no sound XML: %1</source>
        <translation>die Datei ist kein heiles XML: %1</translation>
    </message>
    <message>
        <source>the file is packed by %1; zlib is read</source>
        <translation>die Datei ist mit %1 gepackt; zlib wird gelesen</translation>
    </message>
    <message>
        <source>the file says that its lengths are in %1; they are read so, not in %2</source>
        <translation>die Datei sagt, dass ihre Längen in %1 sind; sie werden so gelesen, nicht in %2</translation>
    </message>
    <message>
        <source>the first component</source>
        <translation>die erste Komponente</translation>
    </message>
    <message>
        <source>the force</source>
        <translation>die Kraft</translation>
    </message>
    <message>
        <source>the last component</source>
        <translation>die letzte Komponente</translation>
    </message>
    <message>
        <source>the last node</source>
        <translation>der letzte Knoten</translation>
    </message>
    <message>
        <source>the load case that TEdit wrote into the file is left out: its cards were changed since, and are read as they are</source>
        <translation>der Lastfall, den TEdit in die Datei schrieb, wird ausgelassen: seine Karten wurden seither geändert und werden gelesen, wie sie sind</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>der Werkstoff</translation>
    </message>
    <message>
        <source>the mesh holds a %1 (cell type %2); only tetrahedra are supported</source>
        <translation>das Netz enthält: %1 (Zelltyp %2); nur Tetraeder gehen</translation>
    </message>
    <message>
        <source>the node</source>
        <translation>der Knoten</translation>
    </message>
    <message>
        <source>the number</source>
        <translation>die Nummer</translation>
    </message>
    <message>
        <source>the opposite corner</source>
        <translation>die gegenüberliegende Ecke</translation>
    </message>
    <message>
        <source>the prescribed value</source>
        <translation>der vorgeschriebene Wert</translation>
    </message>
    <message>
        <source>the pressure</source>
        <translation>der Druck</translation>
    </message>
    <message>
        <source>the property</source>
        <translation>die Eigenschaft</translation>
    </message>
    <message>
        <source>the set</source>
        <translation>die Menge</translation>
    </message>
    <message>
        <source>the shear modulus</source>
        <translation>der Schubmodul</translation>
    </message>
    <message>
        <source>the units</source>
        <translation>die Einheiten</translation>
    </message>
    <message>
        <source>this is a VTK file of type &quot;%1&quot;, not UnstructuredGrid</source>
        <translation>dies ist eine VTK-Datei vom Typ „%1“, nicht UnstructuredGrid</translation>
    </message>
    <message>
        <source>%1 of the edit&apos;s folder is damaged</source>
        <translation>%1 im Ordner der Änderung ist beschädigt</translation>
    </message>
    <message>
        <source>Import the CAD file again</source>
        <translation>Die CAD-Datei noch einmal importieren</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot compare the shapes: %1 %2</source>
        <translation>OpenCASCADE kann die Formen nicht vergleichen: %1 %2</translation>
    </message>
    <message>
        <source>Try again; if it stays, report it with the part</source>
        <translation>Noch einmal versuchen; wenn es bleibt, mit dem Teil melden</translation>
    </message>
    <message>
        <source>Try again; make room on the disk of the temporary folder</source>
        <translation>Noch einmal versuchen; auf der Platte des temporären Ordners Platz schaffen</translation>
    </message>
    <message>
        <source>the CAD model cannot be written</source>
        <translation>das CAD-Modell lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the CAD model that was kept has other faces than it says</source>
        <translation>das aufbewahrte CAD-Modell hat andere Flächen, als es sagt</translation>
    </message>
    <message>
        <source>the CAD model that was kept is damaged</source>
        <translation>das aufbewahrte CAD-Modell ist beschädigt</translation>
    </message>
    <message>
        <source>the edit cannot be made: %1</source>
        <translation>die Änderung lässt sich nicht machen: %1</translation>
    </message>
    <message>
        <source>the edit cannot be written for the CAD model</source>
        <translation>die Änderung lässt sich nicht für das CAD-Modell schreiben</translation>
    </message>
    <message>
        <source>the edit needs more memory than it may take</source>
        <translation>die Änderung braucht mehr Speicher, als sie nehmen darf</translation>
    </message>
    <message>
        <source>the surface in the edit&apos;s folder is damaged</source>
        <translation>die Oberfläche im Ordner der Änderung ist beschädigt</translation>
    </message>
    <message>
        <source>what is known of the CAD model&apos;s faces is damaged</source>
        <translation>was über die Flächen des CAD-Modells bekannt ist, ist beschädigt</translation>
    </message>
    <message>
        <source>cannot write the file: %1</source>
        <translation>die Datei lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>the program tedit ended without an answer</source>
        <translation>das Programm tedit endete ohne Antwort</translation>
    </message>
    <message>
        <source>It has %1</source>
        <translation>Sie hat %1</translation>
    </message>
    <message>
        <source>Take the file that &quot;tedit solve -o&quot; writes</source>
        <translation>Die Datei nehmen, die „tedit solve -o“ schreibt</translation>
    </message>
    <message>
        <source>Take three numbers that are not all zero, as 0,0,1</source>
        <translation>Drei Zahlen nehmen, die nicht alle null sind, etwa 0,0,1</translation>
    </message>
    <message>
        <source>Take um, mm, cm, m, in or ft as its unit</source>
        <translation>um, mm, cm, m, in oder ft als Einheit nehmen</translation>
    </message>
    <message>
        <source>Write it as .stl, or make the mesh coarser</source>
        <translation>Es als .stl schreiben, oder das Netz gröber machen</translation>
    </message>
    <message>
        <source>a 3MF file cannot be in %1</source>
        <translation>eine 3MF-Datei kann nicht in %1 sein</translation>
    </message>
    <message>
        <source>has %1 components</source>
        <translation>hat %1 Komponenten</translation>
    </message>
    <message>
        <source>the build direction has no length</source>
        <translation>die Baurichtung hat keine Länge</translation>
    </message>
    <message>
        <source>the check was cancelled</source>
        <translation>die Prüfung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the file has no field &quot;%1&quot; at its points</source>
        <translation>die Datei hat kein Feld „%1“ an ihren Punkten</translation>
    </message>
    <message>
        <source>the mesh is no VTU file, which alone has fields</source>
        <translation>das Netz ist keine VTU-Datei; nur diese hat Felder</translation>
    </message>
    <message>
        <source>the part is too large for a 3MF file, which ends at 4 GiB</source>
        <translation>das Bauteil ist zu groß für eine 3MF-Datei, die bei 4 GiB endet</translation>
    </message>
    <message>
        <source>there is not enough memory to read this field</source>
        <translation>der Speicher reicht nicht, um dieses Feld zu lesen</translation>
    </message>
    <message>
        <source>Run &quot;tedit %1&quot; on the command line to see why</source>
        <translation>„tedit %1“ auf der Befehlszeile ausführen, um zu sehen, warum</translation>
    </message>
    <message>
        <source>%1 new surfaces: planes, cylinders, cones, spheres and free forms</source>
        <translation>%1 neue Flächen: Ebenen, Zylinder, Kegel, Kugeln und freie Formen</translation>
    </message>
    <message>
        <source>%1those of the faces around</source>
        <translation>%1der Flächen ringsum</translation>
    </message>
    <message>
        <source>free form</source>
        <translation>freie Form</translation>
    </message>
    <message>
        <source>%1 lies between surfaces %2 and %3</source>
        <translation>%1 liegt zwischen den Flächen %2 und %3</translation>
    </message>
    <message>
        <source>%1, its own faces</source>
        <translation>%1, seine eigenen Flächen</translation>
    </message>
    <message>
        <source>Give a point inside the surface that is meant</source>
        <translation>Einen Punkt im Inneren der gemeinten Fläche angeben</translation>
    </message>
    <message>
        <source>Give a point instead, at_mm</source>
        <translation>Stattdessen einen Punkt angeben, at_mm</translation>
    </message>
    <message>
        <source>Give a point on the surface that is meant, or a larger within_mm</source>
        <translation>Einen Punkt auf der gemeinten Fläche angeben, oder ein größeres within_mm</translation>
    </message>
    <message>
        <source>Give a shorter one</source>
        <translation>Einen kürzeren angeben</translation>
    </message>
    <message>
        <source>Give the edit that makes them &quot;label&quot;: &quot;%1&quot;</source>
        <translation>Der Bearbeitung, die sie macht, &quot;label&quot;: &quot;%1&quot; geben</translation>
    </message>
    <message>
        <source>Try again when less runs on it</source>
        <translation>Noch einmal versuchen, wenn weniger auf ihm läuft</translation>
    </message>
    <message>
        <source>a face of it, around %1, is nowhere in the mesh</source>
        <translation>eine Fläche des Modells bei %1 gibt es im Netz nicht</translation>
    </message>
    <message>
        <source>a triangle of surface %1 at %2 is %3 off its faces</source>
        <translation>ein Dreieck der Fläche %1 bei %2 liegt %3 neben den Flächen des Modells</translation>
    </message>
    <message>
        <source>as it was</source>
        <translation>wie es war</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>beide Seiten</translation>
    </message>
    <message>
        <source>comparing &quot;%1&quot; with the mesh</source>
        <translation>„%1“ mit dem Netz vergleichen</translation>
    </message>
    <message>
        <source>deform bends walls point by point: there is no plane, cylinder or other surface of CAD that they would be</source>
        <translation>deform biegt Wände Punkt für Punkt: keine Ebene, kein Zylinder und keine andere CAD-Fläche hat ihre Form</translation>
    </message>
    <message>
        <source>it cannot be done so</source>
        <translation>so geht es nicht</translation>
    </message>
    <message>
        <source>it has %1 solids, the mesh %2 bodies</source>
        <translation>es hat %1 Volumenkörper, das Netz %2 Körper</translation>
    </message>
    <message>
        <source>it has %1 solids, the model before %2</source>
        <translation>es hat %1 Volumenkörper, das Modell davor %2</translation>
    </message>
    <message>
        <source>its face at %1 is %2 off the mesh</source>
        <translation>seine Fläche bei %1 liegt %2 neben dem Netz</translation>
    </message>
    <message>
        <source>its own faces</source>
        <translation>seine eigenen Flächen</translation>
    </message>
    <message>
        <source>its volume changes by %1 mm3, the mesh&apos;s by %2</source>
        <translation>sein Volumen ändert sich um %1 mm3, das des Netzes um %2</translation>
    </message>
    <message>
        <source>layers of tets were taken off, which is no length</source>
        <translation>es wurden Lagen von Tetraedern abgetragen, das ist keine Länge</translation>
    </message>
    <message>
        <source>listing the operations</source>
        <translation>Operationen auflisten</translation>
    </message>
    <message>
        <source>neighbours extended</source>
        <translation>Nachbarn verlängert</translation>
    </message>
    <message>
        <source>no edit so far was labelled &quot;%1&quot;</source>
        <translation>bisher hatte keine Bearbeitung das Kennwort „%1“</translation>
    </message>
    <message>
        <source>no file was given</source>
        <translation>es wurde keine Datei angegeben</translation>
    </message>
    <message>
        <source>no surface is called &quot;%1&quot;</source>
        <translation>keine Fläche heißt „%1“</translation>
    </message>
    <message>
        <source>no wall was given</source>
        <translation>es wurde keine Wand genannt</translation>
    </message>
    <message>
        <source>of what the edit &quot;%1&quot; made no surface is called &quot;%2&quot;</source>
        <translation>von dem, was die Bearbeitung „%1“ machte, heißt keine Fläche „%2“</translation>
    </message>
    <message>
        <source>of what the edit &quot;%1&quot; made no surface is left</source>
        <translation>von dem, was die Bearbeitung „%1“ machte, ist keine Fläche übrig</translation>
    </message>
    <message>
        <source>outlines dropped</source>
        <translation>Umrisse weggelassen</translation>
    </message>
    <message>
        <source>reading the CAD model</source>
        <translation>CAD-Modell lesen</translation>
    </message>
    <message>
        <source>reading the shape</source>
        <translation>Form lesen</translation>
    </message>
    <message>
        <source>surface %1 of the mesh is no face of it</source>
        <translation>Fläche %1 des Netzes ist keine Fläche des Modells</translation>
    </message>
    <message>
        <source>the CAD model of version %1 is gone</source>
        <translation>das CAD-Modell von Version %1 fehlt</translation>
    </message>
    <message>
        <source>the copy was cancelled</source>
        <translation>die Kopie wurde abgebrochen</translation>
    </message>
    <message>
        <source>the document does not say how it was made</source>
        <translation>das Dokument sagt nicht, wie sie entstanden ist</translation>
    </message>
    <message>
        <source>the edit &quot;%1&quot; made no surface of its own</source>
        <translation>die Bearbeitung „%1“ machte keine eigene Fläche</translation>
    </message>
    <message>
        <source>the edit on the CAD model</source>
        <translation>die Änderung am CAD-Modell</translation>
    </message>
    <message>
        <source>the edit on the CAD model was cancelled</source>
        <translation>die Änderung am CAD-Modell wurde abgebrochen</translation>
    </message>
    <message>
        <source>the edited shape cannot be written</source>
        <translation>die geänderte Form lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the machine was too busy to make the edit on the CAD model within %1 s</source>
        <translation>der Rechner war zu beschäftigt, um die Änderung in %1 s am CAD-Modell auszuführen</translation>
    </message>
    <message>
        <source>the mesh&apos;s vertex at %1 on surface %2 is %3 off its faces</source>
        <translation>der Knoten des Netzes bei %1 auf Fläche %2 liegt %3 neben den Flächen des Modells</translation>
    </message>
    <message>
        <source>the mesh&apos;s vertex at %1 on surface %2 is more than %3 off its faces</source>
        <translation>der Knoten des Netzes bei %1 auf Fläche %2 liegt mehr als %3 neben den Flächen des Modells</translation>
    </message>
    <message>
        <source>the nearest surface to %1, %2, is %3 mm away</source>
        <translation>die nächste Fläche zu %1, %2, ist %3 mm entfernt</translation>
    </message>
    <message>
        <source>the operation %1 is a plugin&apos;s, which works on meshes: what it does to a CAD model is not known</source>
        <translation>die Operation %1 gehört einem Plugin, das an Netzen arbeitet: was sie an einem CAD-Modell täte, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the part has no surface &quot;%1&quot; to give a size of its own</source>
        <translation>das Teil hat keine Fläche „%1“, die eine eigene Größe bekommen könnte</translation>
    </message>
    <message>
        <source>the part is too large for a GLB file, which ends at 4 GiB</source>
        <translation>das Teil ist zu groß für eine GLB-Datei, die bei 4 GiB endet</translation>
    </message>
    <message>
        <source>the surfaces are no faces of the CAD model any more</source>
        <translation>die Flächen sind keine Flächen des CAD-Modells mehr</translation>
    </message>
    <message>
        <source>the text is longer than 200 bytes</source>
        <translation>der Text ist länger als 200 Bytes</translation>
    </message>
    <message>
        <source>the tool in the edit&apos;s folder is damaged</source>
        <translation>das Werkzeug im Ordner der Bearbeitung ist beschädigt</translation>
    </message>
    <message>
        <source>the wall is no cylinder in the mesh</source>
        <translation>die Wand ist im Netz kein Zylinder</translation>
    </message>
    <message>
        <source>version %1 (%2) is in the mesh only: %3</source>
        <translation>Version %1 (%2) ist nur im Netz: %3</translation>
    </message>
    <message>
        <source>version %1 is in the mesh only</source>
        <translation>Version %1 ist nur im Netz</translation>
    </message>
    <message>
        <source>walls moved inward</source>
        <translation>Wände nach innen versetzt</translation>
    </message>
    <message>
        <source>what came of the edit cannot be written</source>
        <translation>was bei der Änderung herauskam, lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>carried over from version %1: what was changed since then is elsewhere</source>
        <translation>von Version %1 übernommen: was seitdem geändert wurde, liegt woanders</translation>
    </message>
    <message>
        <source>one without a name</source>
        <translation>eines ohne Namen</translation>
    </message>
    <message>
        <source>the document %1 is open in other clients (%2: %3)</source>
        <translation>das Dokument %1 ist in anderen Programmen offen (%2: %3)</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, not %3 or %4</source>
        <translation>%1 ist „%2“, nicht %3 oder %4</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, not a whole number from 0 to %3</source>
        <translation>%1 ist „%2“, keine ganze Zahl von 0 bis %3</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is not %3</source>
        <translation>%1 ist „%2“; gebraucht wird %3</translation>
    </message>
    <message>
        <source>%1 stands where %2 should be: the section&apos;s counts and its content disagree</source>
        <translation>%1 steht, wo %2 sein sollte: Anzahlen und Inhalt des Abschnitts stimmen nicht überein</translation>
    </message>
    <message>
        <source>*%1 does not say the name of its set</source>
        <translation>*%1 nennt nicht den Namen seiner Menge</translation>
    </message>
    <message>
        <source>*ELEMENT does not say its TYPE</source>
        <translation>*ELEMENT nennt seinen TYPE nicht</translation>
    </message>
    <message>
        <source>A line is lost or too much: write the file again</source>
        <translation>Eine Zeile fehlt oder ist zu viel: die Datei neu schreiben</translation>
    </message>
    <message>
        <source>Check first, last and step of GENERATE, and sets that hold each other</source>
        <translation>Anfang, Ende und Schritt von GENERATE prüfen, und Mengen, die einander enthalten</translation>
    </message>
    <message>
        <source>Choose a .msh (2.2 or 4.1), .vtu, .inp, .bdf or .unv file</source>
        <translation>Eine Datei .msh (2.2 oder 4.1), .vtu, .inp, .bdf oder .unv wählen</translation>
    </message>
    <message>
        <source>Choose the file of a load case</source>
        <translation>Die Datei eines Lastfalls wählen</translation>
    </message>
    <message>
        <source>Choose the file of the part</source>
        <translation>Die Datei des Teils wählen</translation>
    </message>
    <message>
        <source>Correct the text there</source>
        <translation>Den Text dort berichtigen</translation>
    </message>
    <message>
        <source>Download the file again</source>
        <translation>Die Datei neu herunterladen</translation>
    </message>
    <message>
        <source>Export the part as STEP</source>
        <translation>Das Teil als STEP ausgeben</translation>
    </message>
    <message>
        <source>Export the part as STEP, STL or 3MF</source>
        <translation>Das Teil als STEP, STL oder 3MF ausgeben</translation>
    </message>
    <message>
        <source>Fetch the file: git lfs pull</source>
        <translation>Die Datei holen: git lfs pull</translation>
    </message>
    <message>
        <source>GENERATE goes back, from %1 to %2</source>
        <translation>GENERATE läuft rückwärts, von %1 bis %2</translation>
    </message>
    <message>
        <source>GRID %1 has the whole number %2 as a coordinate, and fields behind its coordinates</source>
        <translation>GRID %1 hat die ganze Zahl %2 als Koordinate, und Felder hinter seinen Koordinaten</translation>
    </message>
    <message>
        <source>GRID with displacements in a coordinate system of its own</source>
        <translation>GRID mit Verschiebungen in einem eigenen Koordinatensystem</translation>
    </message>
    <message>
        <source>GRID with supports of its own</source>
        <translation>GRID mit eigenen Lagern</translation>
    </message>
    <message>
        <source>It is cut off or damaged: write it again, or take a STEP file</source>
        <translation>Sie ist abgeschnitten oder beschädigt: neu schreiben, oder eine STEP-Datei nehmen</translation>
    </message>
    <message>
        <source>It is cut off, or was saved without its mesh: write it again</source>
        <translation>Sie ist abgeschnitten oder wurde ohne ihr Netz gesichert: neu schreiben</translation>
    </message>
    <message>
        <source>Mesh surfaces with triangles</source>
        <translation>Flächen mit Dreiecken vernetzen</translation>
    </message>
    <message>
        <source>Mesh the part coarser</source>
        <translation>Das Teil gröber vernetzen</translation>
    </message>
    <message>
        <source>Open it as a document: its name ends with .tedit</source>
        <translation>Sie als Dokument öffnen: ihr Name endet mit .tedit</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Piece</translation>
    </message>
    <message>
        <source>Put its lines in the place of %1: files are read one by one</source>
        <translation>Ihre Zeilen an die Stelle von %1 setzen: Dateien werden einzeln gelesen</translation>
    </message>
    <message>
        <source>Remove it, or mesh the part again</source>
        <translation>Ihn entfernen oder das Teil neu vernetzen</translation>
    </message>
    <message>
        <source>Save it as UTF-8 or ASCII</source>
        <translation>Als UTF-8 oder ASCII sichern</translation>
    </message>
    <message>
        <source>Save it as UTF-8, or choose a file of JSON</source>
        <translation>Als UTF-8 sichern, oder eine JSON-Datei wählen</translation>
    </message>
    <message>
        <source>Save the mesh with all of its nodes</source>
        <translation>Das Netz mit allen seinen Knoten sichern</translation>
    </message>
    <message>
        <source>THRU of a SPC1 goes from %1 to %2, more nodes than such a file can have</source>
        <translation>THRU einer Karte SPC1 geht von %1 bis %2, mehr Knoten, als eine solche Datei haben kann</translation>
    </message>
    <message>
        <source>THRU of a SPC1 goes from %1 to %2, which is back</source>
        <translation>THRU einer Karte SPC1 geht von %1 bis %2, also rückwärts</translation>
    </message>
    <message>
        <source>The file is damaged, or was written wrongly: write it again</source>
        <translation>Die Datei ist beschädigt oder falsch geschrieben: neu schreiben</translation>
    </message>
    <message>
        <source>Unpack it first</source>
        <translation>Sie erst entpacken</translation>
    </message>
    <message>
        <source>Unpack it first: gunzip FILE</source>
        <translation>Sie erst entpacken: gunzip DATEI</translation>
    </message>
    <message>
        <source>UnstructuredGrid</source>
        <translation>UnstructuredGrid</translation>
    </message>
    <message>
        <source>Write *%1, %2=NAME</source>
        <translation>*%1, %2=NAME schreiben</translation>
    </message>
    <message>
        <source>Write *ELEMENT, TYPE=C3D4</source>
        <translation>*ELEMENT, TYPE=C3D4 schreiben</translation>
    </message>
    <message>
        <source>Write decimals with a point</source>
        <translation>Dezimalzahlen mit Punkt schreiben</translation>
    </message>
    <message>
        <source>Write decimals with a point, and leave out normals</source>
        <translation>Dezimalzahlen mit Punkt schreiben, und Normalen weglassen</translation>
    </message>
    <message>
        <source>Write it as .vtu, for example with ParaView</source>
        <translation>Sie als .vtu schreiben, zum Beispiel mit ParaView</translation>
    </message>
    <message>
        <source>Write it on a 64-bit machine, or as text</source>
        <translation>Sie auf einem 64-Bit-Rechner oder als Text schreiben</translation>
    </message>
    <message>
        <source>Write or copy it again</source>
        <translation>Sie neu schreiben oder kopieren</translation>
    </message>
    <message>
        <source>Write them as one of these</source>
        <translation>Sie als eines von diesen schreiben</translation>
    </message>
    <message>
        <source>Write: first, last, step</source>
        <translation>Zu schreiben ist: Anfang, Ende, Schritt</translation>
    </message>
    <message>
        <source>a %1 goes on over more than %2 empty lines</source>
        <translation>eine Karte %1 geht über mehr als %2 leere Zeilen weiter</translation>
    </message>
    <message>
        <source>a *STEP of the deck has no *END STEP: it may be cut off</source>
        <translation>ein *STEP der Eingabedatei hat kein *END STEP: sie ist vielleicht abgeschnitten</translation>
    </message>
    <message>
        <source>a database, such as a document of TEdit</source>
        <translation>eine Datenbank, etwa ein Dokument von TEdit</translation>
    </message>
    <message>
        <source>a dataset should begin here with a line -1, but &quot;%1&quot; follows the one of line %2</source>
        <translation>hier sollte ein Datensatz mit einer Zeile -1 beginnen, aber „%1“ folgt auf den der Zeile %2</translation>
    </message>
    <message>
        <source>a file of Windows programs (OLE), such as a part of SolidWorks</source>
        <translation>eine Datei von Windows-Programmen (OLE), etwa ein Teil von SolidWorks</translation>
    </message>
    <message>
        <source>a file that is packed by gzip</source>
        <translation>eine mit gzip gepackte Datei</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a group&apos;s first record has eight numbers, the last says how many members</source>
        <translation>der erste Satz einer Gruppe hat acht Zahlen, die letzte nennt die Zahl der Mitglieder</translation>
    </message>
    <message>
        <source>a mesh of Medit (.mesh)</source>
        <translation>ein Netz von Medit (.mesh)</translation>
    </message>
    <message>
        <source>a node has more than three coordinates</source>
        <translation>ein Knoten hat mehr als drei Koordinaten</translation>
    </message>
    <message>
        <source>a node of an element</source>
        <translation>ein Knoten eines Elements</translation>
    </message>
    <message>
        <source>a number of a group&apos;s first record</source>
        <translation>eine Zahl des ersten Satzes einer Gruppe</translation>
    </message>
    <message>
        <source>a number of a group&apos;s members</source>
        <translation>eine Zahl der Mitglieder einer Gruppe</translation>
    </message>
    <message>
        <source>a number of a node&apos;s first record</source>
        <translation>eine Zahl des ersten Satzes eines Knotens</translation>
    </message>
    <message>
        <source>a number of a set</source>
        <translation>eine Nummer einer Menge</translation>
    </message>
    <message>
        <source>a number of an element&apos;s first record</source>
        <translation>eine Zahl des ersten Satzes eines Elements</translation>
    </message>
    <message>
        <source>a pointer of Git LFS in place of the file</source>
        <translation>ein Verweis von Git LFS an Stelle der Datei</translation>
    </message>
    <message>
        <source>a pressure acts on the set &quot;%1&quot;, which is not there</source>
        <translation>ein Druck wirkt auf die Menge „%1“, die es nicht gibt</translation>
    </message>
    <message>
        <source>a web page, as where a download failed</source>
        <translation>eine Webseite, wie nach einem fehlgeschlagenen Herunterladen</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a whole number from 0 on</source>
        <translation>eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>ein Zip-Archiv</translation>
    </message>
    <message>
        <source>an Inventor scene</source>
        <translation>eine Inventor-Szene</translation>
    </message>
    <message>
        <source>an archive of 7-Zip</source>
        <translation>ein Archiv von 7-Zip</translation>
    </message>
    <message>
        <source>an old VTK file</source>
        <translation>eine alte VTK-Datei</translation>
    </message>
    <message>
        <source>begins at the byte %1 of the appended data, which have %2</source>
        <translation>beginnt bei Byte %1 der angehängten Daten, die %2 haben</translation>
    </message>
    <message>
        <source>cell %1 ends at %2 of the connectivity, where it begins at %3 and all end at %4</source>
        <translation>Zelle %1 endet bei %2 der Konnektivität, wo sie bei %3 beginnt und alle bei %4 enden</translation>
    </message>
    <message>
        <source>element %1</source>
        <translation>Element %1</translation>
    </message>
    <message>
        <source>element %1 says that it has %2 nodes: numbers start at 1, nodes are up to 1000</source>
        <translation>Element %1 nennt %2 Knoten: Nummern beginnen bei 1, Knoten sind es bis zu 1000</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>has %1 bytes and a block of %2 more, where %3 should be</source>
        <translation>hat %1 Byte und einen Block von %2 mehr, wo %3 sein sollten</translation>
    </message>
    <message>
        <source>has %1 bytes where %2 should be</source>
        <translation>hat %1 Byte, wo %2 sein sollten</translation>
    </message>
    <message>
        <source>has a block of %1 packed bytes that should be %2, more than zlib can pack so small</source>
        <translation>hat einen Block von %1 gepackten Byte, aus denen %2 werden sollen; so klein packt zlib nicht</translation>
    </message>
    <message>
        <source>has a block of %1 packed bytes, but %2 are left</source>
        <translation>hat einen Block von %1 gepackten Byte, aber %2 sind übrig</translation>
    </message>
    <message>
        <source>has more than the %1 numbers that should be</source>
        <translation>hat mehr als die %1 Zahlen, die es sein sollten</translation>
    </message>
    <message>
        <source>has not 3 components</source>
        <translation>hat nicht 3 Komponenten</translation>
    </message>
    <message>
        <source>has the offset &quot;%1&quot;, which is no place in the file</source>
        <translation>hat den Versatz „%1“, der keine Stelle der Datei ist</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which is no letter of base64</source>
        <translation>enthält „%1“, das kein Zeichen von Base64 ist</translation>
    </message>
    <message>
        <source>input of Ansys (.cdb)</source>
        <translation>eine Eingabe von Ansys (.cdb)</translation>
    </message>
    <message>
        <source>members of group &quot;%1&quot; that are no tets or triangles</source>
        <translation>Mitglieder der Gruppe „%1“, die keine Tetraeder oder Dreiecke sind</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>Knoten %1</translation>
    </message>
    <message>
        <source>node %1 has %2 coordinates, not 3</source>
        <translation>Knoten %1 hat %2 Koordinaten, nicht 3</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>section %1, %2</source>
        <translation>Abschnitt %1, %2</translation>
    </message>
    <message>
        <source>surface &quot;%1&quot;</source>
        <translation>Fläche „%1“</translation>
    </message>
    <message>
        <source>the BREP file says that it has %1 %2, more than the %3 bytes behind can hold</source>
        <translation>die BREP-Datei nennt %1 %2, mehr als die %3 Byte dahinter fassen können</translation>
    </message>
    <message>
        <source>the appended data are neither raw nor in base64</source>
        <translation>die angehängten Daten sind weder roh noch in Base64</translation>
    </message>
    <message>
        <source>the card &quot;%1&quot; has both columns and commas</source>
        <translation>die Karte „%1“ hat Spalten und Kommas zugleich</translation>
    </message>
    <message>
        <source>the deck asks for the load set %1, and no card that is read has it</source>
        <translation>die Eingabedatei verlangt den Lastsatz %1, und keine gelesene Karte hat ihn</translation>
    </message>
    <message>
        <source>the deck asks for the supports %1, and no card that is read has them</source>
        <translation>die Eingabedatei verlangt die Lager %1, und keine gelesene Karte hat sie</translation>
    </message>
    <message>
        <source>the deck takes in another file by %1 (%2)</source>
        <translation>die Eingabedatei holt mit %1 eine andere Datei (%2)</translation>
    </message>
    <message>
        <source>the file has no section $Elements</source>
        <translation>die Datei hat keinen Abschnitt $Elements</translation>
    </message>
    <message>
        <source>the file holds blanks alone</source>
        <translation>die Datei enthält nur Leerzeichen</translation>
    </message>
    <message>
        <source>the file holds no piece of a grid</source>
        <translation>die Datei enthält kein Stück eines Gitters</translation>
    </message>
    <message>
        <source>the file is of no format that is read: it does not begin with $MeshFormat, nor as a VTU, Abaqus, Nastran or UNV file does</source>
        <translation>die Datei hat kein Format, das gelesen wird: sie beginnt weder mit $MeshFormat noch wie eine Datei von VTU, Abaqus, Nastran oder UNV</translation>
    </message>
    <message>
        <source>the file is text in UTF-16</source>
        <translation>die Datei ist Text in UTF-16</translation>
    </message>
    <message>
        <source>the number of an element</source>
        <translation>die Nummer eines Elements</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>die Zahl der Elemente</translation>
    </message>
    <message>
        <source>the number of nodes</source>
        <translation>die Zahl der Knoten</translation>
    </message>
    <message>
        <source>the number of physical names</source>
        <translation>die Zahl der physikalischen Namen</translation>
    </message>
    <message>
        <source>this is %1, which is not read</source>
        <translation>dies ist %1; das wird nicht gelesen</translation>
    </message>
    <message>
        <source>this is no load case: it is empty</source>
        <translation>dies ist kein Lastfall: die Datei ist leer</translation>
    </message>
    <message>
        <source>this is no load case: it is no text in UTF-8</source>
        <translation>dies ist kein Lastfall: es ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>triangle %1 of the file</source>
        <translation>Dreieck %1 der Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a place of a part, and there is no part to look at</source>
        <translation>„%1“ ist ein Ort eines Teils, und hier ist kein Teil</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no place</source>
        <translation>„%1“ nennt keinen Ort</translation>
    </message>
    <message>
        <source>%1 end</source>
        <translation>%1, Ende</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 start</source>
        <translation>%1, Anfang</translation>
    </message>
    <message>
        <source>Each takes %1 to %2 %3</source>
        <translation>Jede nimmt %1 bis %2 %3</translation>
    </message>
    <message>
        <source>For the profile &quot;points&quot;: the corners of the outline on the wall, in the order in which they go around.</source>
        <translation>Für das Profil „Punkte“: die Ecken des Umrisses auf der Wand, in der Reihenfolge, in der sie herumgehen.</translation>
    </message>
    <message>
        <source>Give each distance or angle once, and none for the one that is there</source>
        <translation>Jeden Abstand oder Winkel einmal angeben, und keinen für das, was da ist</translation>
    </message>
    <message>
        <source>Give each point once</source>
        <translation>Jeden Punkt einmal angeben</translation>
    </message>
    <message>
        <source>Give its points</source>
        <translation>Seine Punkte angeben</translation>
    </message>
    <message>
        <source>Give its points, path_mm=0,0,10;40,0,10, or an edge of the part, path=edge:3,7</source>
        <translation>Seine Punkte angeben, path_mm=0,0,10;40,0,10, oder eine Kante des Teils, path=edge:3,7</translation>
    </message>
    <message>
        <source>Give points that lie around an area of the wall</source>
        <translation>Punkte angeben, die um ein Stück der Wand liegen</translation>
    </message>
    <message>
        <source>Give the corners: points_mm=0,0,10;20,0,10;20,15,10</source>
        <translation>Die Ecken angeben: points_mm=0,0,10;20,0,10;20,15,10</translation>
    </message>
    <message>
        <source>Give the numbers of the place that is meant</source>
        <translation>Die Zahlen des gemeinten Orts angeben</translation>
    </message>
    <message>
        <source>Give the plane alone, or the place and the direction</source>
        <translation>Die Ebene allein angeben, oder Ort und Richtung</translation>
    </message>
    <message>
        <source>Give the points in the order in which they go around</source>
        <translation>Die Punkte in der Reihenfolge angeben, in der sie herumgehen</translation>
    </message>
    <message>
        <source>Give the step, whose length then means nothing: step=1,0,0</source>
        <translation>Den Schritt angeben, dessen Länge dann nichts bedeutet: step=1,0,0</translation>
    </message>
    <message>
        <source>Let it turn by less than 150 degrees at a point</source>
        <translation>Ihn an einem Punkt um weniger als 150 Grad abbiegen lassen</translation>
    </message>
    <message>
        <source>Make the profile smaller, or the bend wider</source>
        <translation>Das Profil kleiner machen, oder die Biegung weiter</translation>
    </message>
    <message>
        <source>Name three surfaces or more that have one corner in common</source>
        <translation>Drei oder mehr Flächen nennen, die eine Ecke gemeinsam haben</translation>
    </message>
    <message>
        <source>Name two surfaces that meet</source>
        <translation>Zwei Flächen nennen, die zusammenstoßen</translation>
    </message>
    <message>
        <source>Set profile=points, or leave the points out</source>
        <translation>profile=points setzen, oder die Punkte weglassen</translation>
    </message>
    <message>
        <source>Write surface:12, edge:3,7 or corner:3,7,9</source>
        <translation>surface:12, edge:3,7 oder corner:3,7,9 schreiben</translation>
    </message>
    <message>
        <source>a path has two points or more</source>
        <translation>ein Weg hat zwei Punkte oder mehr</translation>
    </message>
    <message>
        <source>a plane is given, and a place or a direction beside it</source>
        <translation>eine Ebene ist angegeben, und daneben ein Ort oder eine Richtung</translation>
    </message>
    <message>
        <source>at its point %1 the path %2</source>
        <translation>an seinem Punkt %1: der Weg %2</translation>
    </message>
    <message>
        <source>between its points %1 and %2 the path bends too narrowly for what is carried along it</source>
        <translation>zwischen seinen Punkten %1 und %2: der Weg biegt sich zu eng für das, was an ihm entlanggeführt wird</translation>
    </message>
    <message>
        <source>it has %1 points, and takes %2 to %3</source>
        <translation>es sind %1 Punkte, erlaubt sind %2 bis %3</translation>
    </message>
    <message>
        <source>it has more than %1 numbers</source>
        <translation>es sind mehr als %1 Zahlen</translation>
    </message>
    <message>
        <source>it is a point and a direction, as &quot;0, 0, 1; 0, 0, 1&quot;</source>
        <translation>es ist ein Punkt und eine Richtung, wie „0, 0, 1; 0, 0, 1“</translation>
    </message>
    <message>
        <source>it is a point and a normal, as &quot;0, 0, 1; 0, 0, 1&quot;</source>
        <translation>es ist ein Punkt und eine Normale, wie „0, 0, 1; 0, 0, 1“</translation>
    </message>
    <message>
        <source>it is numbers, as &quot;0.5, 1, 2&quot;</source>
        <translation>es sind Zahlen, wie „0.5, 1, 2“</translation>
    </message>
    <message>
        <source>it is points of three numbers each, as &quot;0, 0, 0; 1, 0, 0; 1, 2.5, 0&quot;</source>
        <translation>es sind Punkte aus je drei Zahlen, wie „0, 0, 0; 1, 0, 0; 1, 2.5, 0“</translation>
    </message>
    <message>
        <source>it names more than %1 places</source>
        <translation>es nennt mehr als %1 Orte</translation>
    </message>
    <message>
        <source>its direction is 0, 0, 0</source>
        <translation>die Richtung ist 0, 0, 0</translation>
    </message>
    <message>
        <source>its normal is 0, 0, 0</source>
        <translation>die Normale ist 0, 0, 0</translation>
    </message>
    <message>
        <source>no path was given</source>
        <translation>es wurde kein Weg angegeben</translation>
    </message>
    <message>
        <source>no point</source>
        <translation>keinem Punkt</translation>
    </message>
    <message>
        <source>not all of its numbers are finite</source>
        <translation>nicht alle Zahlen sind endlich</translation>
    </message>
    <message>
        <source>number %1, %2, is out of range</source>
        <translation>Zahl %1, %2, ist außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>only an edge gives all points of a polyline</source>
        <translation>nur eine Kante gibt alle Punkte eines Linienzugs</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same</source>
        <translation>die Punkte %1 und %2 sind derselbe</translation>
    </message>
    <message>
        <source>points are given, and the profile is another one</source>
        <translation>Punkte sind angegeben, und das Profil ist ein anderes</translation>
    </message>
    <message>
        <source>seen along the direction, the points enclose nothing</source>
        <translation>entlang der Richtung gesehen umschließen die Punkte nichts</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>bleibt stehen</translation>
    </message>
    <message>
        <source>surfaces %1 have no edge in common</source>
        <translation>die Flächen %1 haben keine Kante gemeinsam</translation>
    </message>
    <message>
        <source>surfaces %1 meet in %2 edges, at %3 and %4</source>
        <translation>die Flächen %1 stoßen an %2 Kanten zusammen, bei %3 und %4</translation>
    </message>
    <message>
        <source>surfaces %1 meet in %2 edges, at %3 and %4 and others</source>
        <translation>die Flächen %1 stoßen an %2 Kanten zusammen, bei %3 und %4 und anderen</translation>
    </message>
    <message>
        <source>surfaces %1 meet in %2 points</source>
        <translation>die Flächen %1 stoßen an %2 Punkten zusammen</translation>
    </message>
    <message>
        <source>surfaces %1 meet in no point</source>
        <translation>die Flächen %1 stoßen an keinem Punkt zusammen</translation>
    </message>
    <message>
        <source>the outline crosses itself between its points %1 and %2</source>
        <translation>der Umriss kreuzt sich selbst zwischen seinen Punkten %1 und %2</translation>
    </message>
    <message>
        <source>the profile is to be points, and none were given</source>
        <translation>das Profil soll aus Punkten sein, und es wurden keine angegeben</translation>
    </message>
    <message>
        <source>turns back</source>
        <translation>kehrt um</translation>
    </message>
    <message>
        <source>two copies would lie in the same place</source>
        <translation>zwei Kopien lägen am selben Ort</translation>
    </message>
    <message>
        <source>what is there is neither flat, round nor straight, and has no direction</source>
        <translation>was dort ist, ist weder flach noch rund noch gerade, und hat keine Richtung</translation>
    </message>
    <message>
        <source>which way the distances go is not given</source>
        <translation>in welche Richtung die Abstände gehen, ist nicht angegeben</translation>
    </message>
    <message>
        <source>surface %1, ...</source>
        <translation>Fläche %1, ...</translation>
    </message>
    <message>
        <source>surfaces %1, ...</source>
        <translation>Flächen %1, ...</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no %2</source>
        <translation>&quot;%1&quot; ist nicht bekannt als %2</translation>
    </message>
    <message>
        <source>Give a finer size for the whole part</source>
        <translation>Das ganze Teil feiner vernetzen</translation>
    </message>
    <message>
        <source>Give another name: a document is not written over</source>
        <translation>Einen anderen Namen angeben: Dokumente werden nicht überschrieben</translation>
    </message>
    <message>
        <source>Give one of %1</source>
        <translation>Eines davon angeben: %1</translation>
    </message>
    <message>
        <source>Mesh it with &quot;tedit import PART -o PART.tedit&quot; and add that document, or set work.import_jobs in the server&apos;s configuration</source>
        <translation>Mit „tedit import PART -o PART.tedit“ vernetzen und dieses Dokument hinzufügen, oder work.import_jobs in der Konfiguration des Servers setzen</translation>
    </message>
    <message>
        <source>There must be room in the server&apos;s temporary folder</source>
        <translation>Im temporären Ordner des Servers muss Platz sein</translation>
    </message>
    <message>
        <source>the server cannot write the file that was sent</source>
        <translation>der Server kann die gesendete Datei nicht schreiben</translation>
    </message>
    <message>
        <source>there are more than %1 local sizes</source>
        <translation>es sind mehr als %1 örtliche Größen</translation>
    </message>
    <message>
        <source>there are too many local sizes</source>
        <translation>es sind zu viele örtliche Größen</translation>
    </message>
    <message>
        <source>this server meshes no CAD files</source>
        <translation>dieser Server vernetzt keine CAD-Dateien</translation>
    </message>
    <message>
        <source>waiting for another import</source>
        <translation>wartet auf einen anderen Import</translation>
    </message>
    <message>
        <source>writing the document</source>
        <translation>schreibt das Dokument</translation>
    </message>
    <message>
        <source>Ask for inp (CalculiX, Abaqus) or bdf (Nastran), or name no load case</source>
        <translation>inp (CalculiX, Abaqus) oder bdf (Nastran) wählen oder keinen Lastfall nennen</translation>
    </message>
    <message>
        <source>Leave version_id, length_unit and load_case out</source>
        <translation>version_id, length_unit und load_case weglassen</translation>
    </message>
    <message>
        <source>a file of the format %1 holds no load case</source>
        <translation>eine Datei des Formats %1 enthält keinen Lastfall</translation>
    </message>
    <message>
        <source>Leave length_unit out</source>
        <translation>length_unit weglassen</translation>
    </message>
    <message>
        <source>a deck with a load case is in metres</source>
        <translation>ein Deck mit einem Lastfall ist in Metern</translation>
    </message>
    <message>
        <source>the worker %1</source>
        <translation>der Arbeiter %1</translation>
    </message>
    <message>
        <source>waiting for %1 change of this document before it</source>
        <translation>wartet auf %1 Änderung dieses Dokuments davor</translation>
    </message>
    <message>
        <source>waiting for %1 changes of this document before it</source>
        <translation>wartet auf %1 Änderungen dieses Dokuments davor</translation>
    </message>
    <message>
        <source>Give it more memory, or mesh it coarser</source>
        <translation>Mehr Speicher geben oder gröber vernetzen</translation>
    </message>
    <message>
        <source>Give it more memory, or take a simpler part</source>
        <translation>Mehr Speicher geben oder ein einfacheres Teil nehmen</translation>
    </message>
    <message>
        <source>Give it more time, mesh it coarser, or take a simpler part</source>
        <translation>Mehr Zeit geben, gröber vernetzen oder ein einfacheres Teil nehmen</translation>
    </message>
    <message>
        <source>Its surfaces are 1 to %1; a part that was imported lists them with their names</source>
        <translation>Seine Flächen sind 1 bis %1; ein importiertes Teil zählt sie mit ihren Namen auf</translation>
    </message>
    <message>
        <source>Mesh it coarser or finer, or mend that face in the CAD program</source>
        <translation>Gröber oder feiner vernetzen oder diese Fläche im CAD-Programm ausbessern</translation>
    </message>
    <message>
        <source>Mesh it coarser or finer; if neither works, check in the CAD program that no faces cut each other</source>
        <translation>Gröber oder feiner vernetzen; wenn beides nicht geht, im CAD-Programm prüfen, dass keine Flächen einander schneiden</translation>
    </message>
    <message>
        <source>Mesh it coarser or finer; if neither works, mend the part in the CAD program</source>
        <translation>Gröber oder feiner vernetzen; wenn beides nicht geht, das Teil im CAD-Programm ausbessern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no encoding of a PLY file</source>
        <translation>„%1“ ist keine Kodierung einer PLY-Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no type of a PLY file</source>
        <translation>„%1“ ist kein Typ einer PLY-Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no word of an STL file</source>
        <translation>„%1“ ist kein Wort einer STL-Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of place in the header of a PLY file</source>
        <translation>„%1“ steht im Kopf einer PLY-Datei am falschen Platz</translation>
    </message>
    <message>
        <source>%1 edge has more than two triangles, the first at %2</source>
        <translation>%1 Kante hat mehr als zwei Dreiecke, die erste bei %2</translation>
    </message>
    <message>
        <source>%1 edges have more than two triangles, the first at %2</source>
        <translation>%1 Kanten haben mehr als zwei Dreiecke, die erste bei %2</translation>
    </message>
    <message>
        <source>%1: it is cut off</source>
        <translation>%1: sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>Bodies may touch but not share an edge, and no wall may lie within the material: part them, or unite them, in the program that the file comes from</source>
        <translation>Körper dürfen sich berühren, aber keine Kante teilen, und keine Wand darf im Material liegen: im Programm, von dem die Datei stammt, trennen oder vereinigen</translation>
    </message>
    <message>
        <source>Check the unit and the coordinates of the file</source>
        <translation>Die Einheit und die Koordinaten der Datei prüfen</translation>
    </message>
    <message>
        <source>Close it in the program that the file comes from, for example by MeshLab&apos;s &quot;Close holes&quot;; holes up to a twentieth of the part&apos;s extent around are closed here</source>
        <translation>Im Programm, von dem die Datei stammt, schließen, zum Beispiel mit „Close holes“ von MeshLab; Löcher bis zu einem Zwanzigstel der Teilgröße Umfang werden hier geschlossen</translation>
    </message>
    <message>
        <source>Close them in the program that the file comes from</source>
        <translation>Im Programm, von dem die Datei stammt, schließen</translation>
    </message>
    <message>
        <source>Export the part as STL, or as a 3MF of the core specification alone</source>
        <translation>Das Teil als STL oder als 3MF allein der Kernspezifikation ausgeben</translation>
    </message>
    <message>
        <source>Give it more memory, or simplify the surface</source>
        <translation>Mehr Speicher geben oder die Oberfläche vereinfachen</translation>
    </message>
    <message>
        <source>Leave the unit out</source>
        <translation>Die Einheit weglassen</translation>
    </message>
    <message>
        <source>Mesh it coarser or finer; if neither works, repair the surface in the program that it comes from</source>
        <translation>Gröber oder feiner vernetzen; wenn beides nicht geht, die Oberfläche in dem Programm reparieren, von dem sie stammt</translation>
    </message>
    <message>
        <source>Mesh it without, and make it finer afterwards with the operation refine</source>
        <translation>Ohne vernetzen und danach mit der Operation refine verfeinern</translation>
    </message>
    <message>
        <source>Part what touches there, or unite it, in the program that the file comes from</source>
        <translation>Was sich dort berührt, im Programm, von dem die Datei stammt, trennen oder vereinigen</translation>
    </message>
    <message>
        <source>Put the part on the plate, and save the file again</source>
        <translation>Das Teil auf die Platte setzen und die Datei noch einmal speichern</translation>
    </message>
    <message>
        <source>Repair it in the program that the file comes from</source>
        <translation>Im Programm, von dem die Datei stammt, reparieren</translation>
    </message>
    <message>
        <source>Save it without one</source>
        <translation>Ohne eines speichern</translation>
    </message>
    <message>
        <source>Save the part as STL, or simplify it</source>
        <translation>Das Teil als STL speichern oder vereinfachen</translation>
    </message>
    <message>
        <source>Save the part&apos;s surface again, as a binary STL or a 3MF</source>
        <translation>Die Oberfläche des Teils noch einmal speichern, als binäres STL oder 3MF</translation>
    </message>
    <message>
        <source>Simplify it first, for example in MeshLab</source>
        <translation>Zuerst vereinfachen, zum Beispiel in MeshLab</translation>
    </message>
    <message>
        <source>Simplify the part first</source>
        <translation>Das Teil zuerst vereinfachen</translation>
    </message>
    <message>
        <source>Simplify the part first, for example in MeshLab</source>
        <translation>Das Teil zuerst vereinfachen, zum Beispiel in MeshLab</translation>
    </message>
    <message>
        <source>Take out what is no part of it, for example by MeshLab&apos;s &quot;Remove isolated pieces&quot;</source>
        <translation>Herausnehmen, was nicht dazugehört, zum Beispiel mit „Remove isolated pieces“ von MeshLab</translation>
    </message>
    <message>
        <source>Unite its parts in the program that the file comes from, or repair it there</source>
        <translation>Ihre Teile im Programm, von dem die Datei stammt, vereinigen oder sie dort reparieren</translation>
    </message>
    <message>
        <source>Write each face on one line</source>
        <translation>Jede Facette in eine Zeile schreiben</translation>
    </message>
    <message>
        <source>a corner has %1 coordinates, not 3</source>
        <translation>eine Ecke hat %1 Koordinaten, nicht 3</translation>
    </message>
    <message>
        <source>a corner stands outside of all facets</source>
        <translation>eine Ecke steht außerhalb aller Facetten</translation>
    </message>
    <message>
        <source>a face has %1 corners, not 3</source>
        <translation>eine Facette hat %1 Ecken, nicht 3</translation>
    </message>
    <message>
        <source>a face names vertex %1 of %2 so far; they count from 1, or back from -1</source>
        <translation>eine Facette nennt Knoten %1 von bisher %2; sie zählen ab 1 oder rückwärts ab -1</translation>
    </message>
    <message>
        <source>a facet of the STL file has %1 corners, not 3</source>
        <translation>eine Facette der STL-Datei hat %1 Ecken, nicht 3</translation>
    </message>
    <message>
        <source>a file in the 3MF archive says that it has %1 bytes unpacked, more than %2</source>
        <translation>eine Datei im 3MF-Archiv hat nach eigener Angabe entpackt %1 Byte, mehr als %2</translation>
    </message>
    <message>
        <source>a line of the OBJ file goes on in the next one</source>
        <translation>eine Zeile der OBJ-Datei geht in der nächsten weiter</translation>
    </message>
    <message>
        <source>a unit is for STL, OBJ and PLY files: a CAD file says its own</source>
        <translation>eine Einheit ist für STL-, OBJ- und PLY-Dateien: eine CAD-Datei nennt ihre eigene</translation>
    </message>
    <message>
        <source>a vertex has %1 coordinates, not 3</source>
        <translation>ein Knoten hat %1 Koordinaten, nicht 3</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>byte %1 of the model</source>
        <translation>Byte %1 des Modells</translation>
    </message>
    <message>
        <source>byte 80</source>
        <translation>Byte 80</translation>
    </message>
    <message>
        <source>holes of the surface meet in one point, at %1</source>
        <translation>Löcher der Oberfläche treffen sich in einem Punkt, bei %1</translation>
    </message>
    <message>
        <source>local sizes are for CAD files: the surfaces of this file are found while it is meshed</source>
        <translation>örtliche Größen sind für CAD-Dateien: die Flächen dieser Datei werden erst beim Vernetzen gefunden</translation>
    </message>
    <message>
        <source>the %1 file holds no triangle</source>
        <translation>die %1-Datei enthält kein Dreieck</translation>
    </message>
    <message>
        <source>the 3MF archive has sizes of 64 bits (ZIP64)</source>
        <translation>das 3MF-Archiv hat Größen von 64 Bit (ZIP64)</translation>
    </message>
    <message>
        <source>the 3MF archive is locked by a password</source>
        <translation>das 3MF-Archiv ist durch ein Kennwort gesperrt</translation>
    </message>
    <message>
        <source>the 3MF archive is packed in a way that is not read</source>
        <translation>das 3MF-Archiv ist auf eine Art gepackt, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>the PLY file says that it has %1 of &quot;%2&quot;</source>
        <translation>die PLY-Datei hat nach eigener Angabe %1 von „%2“</translation>
    </message>
    <message>
        <source>the STL file ends within a facet</source>
        <translation>die STL-Datei endet in einer Facette</translation>
    </message>
    <message>
        <source>the STL file is cut off: it has %1 bytes, its header alone has 84</source>
        <translation>die STL-Datei ist abgeschnitten: sie hat %1 Byte, ihr Kopf allein hat 84</translation>
    </message>
    <message>
        <source>the STL file says that it has %1 triangles, but its bytes end after %2</source>
        <translation>die STL-Datei hat nach eigener Angabe %1 Dreiecke, ihre Bytes enden aber nach %2</translation>
    </message>
    <message>
        <source>the archive holds no %1: it is no 3MF file</source>
        <translation>das Archiv enthält kein %1: es ist keine 3MF-Datei</translation>
    </message>
    <message>
        <source>the archive of the 3MF file is damaged: %1</source>
        <translation>das Archiv der 3MF-Datei ist beschädigt: %1</translation>
    </message>
    <message>
        <source>the file holds %1 separate closed surfaces, more than 1,000</source>
        <translation>die Datei enthält %1 getrennte geschlossene Oberflächen, mehr als 1.000</translation>
    </message>
    <message>
        <source>the file&apos;s triangles enclose nothing</source>
        <translation>die Dreiecke der Datei umschließen nichts</translation>
    </message>
    <message>
        <source>the header of the PLY file does not say its format</source>
        <translation>der Kopf der PLY-Datei nennt ihr Format nicht</translation>
    </message>
    <message>
        <source>the header of the PLY file has no end</source>
        <translation>der Kopf der PLY-Datei hat kein Ende</translation>
    </message>
    <message>
        <source>the model of the 3MF file is no XML: %1</source>
        <translation>das Modell der 3MF-Datei ist kein XML: %1</translation>
    </message>
    <message>
        <source>the surface cannot be mended: %1</source>
        <translation>die Oberfläche lässt sich nicht ausbessern: %1</translation>
    </message>
    <message>
        <source>the surface cannot be written</source>
        <translation>die Oberfläche lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the surface goes through itself: %1 pair of triangles cuts or covers each other, the first at %2</source>
        <translation>die Oberfläche geht durch sich selbst: %1 Paar Dreiecke schneidet oder überdeckt sich, das erste bei %2</translation>
    </message>
    <message>
        <source>the surface goes through itself: %1 pairs of triangles cut or cover each other, the first at %2</source>
        <translation>die Oberfläche geht durch sich selbst: %1 Paare Dreiecke schneiden oder überdecken sich, das erste bei %2</translation>
    </message>
    <message>
        <source>the surface has %1 triangles, more than 2,000,000</source>
        <translation>die Oberfläche hat %1 Dreiecke, mehr als 2.000.000</translation>
    </message>
    <message>
        <source>the surface has one side only, as a Moebius strip has, at %1</source>
        <translation>die Oberfläche hat nur eine Seite, wie ein Möbiusband, bei %1</translation>
    </message>
    <message>
        <source>the surface is not closed to the last bit</source>
        <translation>die Oberfläche ist nicht bis auf das letzte Bit geschlossen</translation>
    </message>
    <message>
        <source>the surface is not closed: it has %1 hole, the longest is %2 mm around, its middle at %3</source>
        <translation>die Oberfläche ist nicht geschlossen: sie hat %1 Loch, das längste hat %2 mm Umfang, seine Mitte liegt bei %3</translation>
    </message>
    <message>
        <source>the surface is not closed: it has %1 holes, the longest is %2 mm around, its middle at %3</source>
        <translation>die Oberfläche ist nicht geschlossen: sie hat %1 Löcher, das längste hat %2 mm Umfang, seine Mitte liegt bei %3</translation>
    </message>
    <message>
        <source>the surface measures %1 mm across</source>
        <translation>die Oberfläche misst %1 mm quer</translation>
    </message>
    <message>
        <source>the surface of the import&apos;s folder is damaged</source>
        <translation>die Oberfläche im Ordner des Imports ist beschädigt</translation>
    </message>
    <message>
        <source>the surface touches itself in one point, at %1</source>
        <translation>die Oberfläche berührt sich in einem Punkt, bei %1</translation>
    </message>
    <message>
        <source>the triangles do not make up one closed surface</source>
        <translation>die Dreiecke ergeben keine geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>the vertices of the PLY file have no %1</source>
        <translation>die Knoten der PLY-Datei haben kein %1</translation>
    </message>
    <message>
        <source>there is no memory to unpack the 3MF file</source>
        <translation>zum Entpacken der 3MF-Datei fehlt Speicher</translation>
    </message>
    <message>
        <source>this property has not a type and a name, or list, two types and a name</source>
        <translation>diese Eigenschaft hat nicht einen Typ und einen Namen oder list, zwei Typen und einen Namen</translation>
    </message>
    <message>
        <source>this property stands before all elements</source>
        <translation>diese Eigenschaft steht vor allen Elementen</translation>
    </message>
    <message>
        <source>triangle %1 of the STL file has a corner that is no finite number</source>
        <translation>Dreieck %1 der STL-Datei hat eine Ecke, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>Report this to the plugin&apos;s author: they may go round in a circle</source>
        <translation>Dem Verfasser des Plugins melden: sie laufen vielleicht im Kreis</translation>
    </message>
    <message>
        <source>operations ask for each other %1 deep, the last for %2</source>
        <translation>Operationen rufen einander %1 tief auf, die letzte %2</translation>
    </message>
    <message>
        <source>the operation &quot;%1&quot; was asked of no version</source>
        <translation>die Operation „%1“ wurde ohne Fassung aufgerufen</translation>
    </message>
    <message>
        <source>Try again once its file is written; describe() must say the same every time</source>
        <translation>Nochmals versuchen, sobald seine Datei geschrieben ist; describe() muss jedes Mal dasselbe sagen</translation>
    </message>
    <message>
        <source>gave no answer that can be read</source>
        <translation>gab keine lesbare Antwort</translation>
    </message>
    <message>
        <source>its description holds control characters, or bytes that are no UTF-8</source>
        <translation>seine Beschreibung enthält Steuerzeichen oder Bytes, die kein UTF-8 sind</translation>
    </message>
    <message>
        <source>its description is longer than 4 MiB</source>
        <translation>seine Beschreibung ist länger als 4 MiB</translation>
    </message>
    <message>
        <source>the plugin %1 describes %2 otherwise than a moment ago</source>
        <translation>das Plugin %1 beschreibt %2 anders als eben noch</translation>
    </message>
    <message>
        <source>looking for crossing facets</source>
        <translation>sucht Facetten, die einander schneiden</translation>
    </message>
    <message>
        <source>looking for overhangs</source>
        <translation>sucht Überhänge</translation>
    </message>
    <message>
        <source>measuring walls</source>
        <translation>misst Wände</translation>
    </message>
    <message>
        <source>the check</source>
        <translation>die Prüfung</translation>
    </message>
    <message>
        <source>the marks of a check for printing do not fit to its %1 facets</source>
        <translation>die Marken einer Prüfung auf Druckbarkeit passen nicht zu ihren %1 Facetten</translation>
    </message>
    <message>
        <source>%1 field of results is left out</source>
        <translation>%1 Ergebnisfeld wird weggelassen</translation>
    </message>
    <message>
        <source>%1 fields of results are left out</source>
        <translation>%1 Ergebnisfelder werden weggelassen</translation>
    </message>
    <message>
        <source>%1 while it was reading the file</source>
        <translation>%1, während es die Datei las</translation>
    </message>
    <message>
        <source>%1 while it was writing the file</source>
        <translation>%1, während es die Datei schrieb</translation>
    </message>
    <message>
        <source>Build TEdit where the package libmedc-dev is installed (scripts/install_deps.sh), or set TEDIT_LIBEXEC to the program&apos;s folder</source>
        <translation>TEdit dort erstellen, wo das Paket libmedc-dev installiert ist (scripts/install_deps.sh), oder TEDIT_LIBEXEC auf den Ordner des Programms setzen</translation>
    </message>
    <message>
        <source>Copy it again, not as text</source>
        <translation>Noch einmal kopieren, nicht als Text</translation>
    </message>
    <message>
        <source>Export it in cartesian coordinates</source>
        <translation>In kartesischen Koordinaten exportieren</translation>
    </message>
    <message>
        <source>Export it with three coordinates for each node</source>
        <translation>Mit drei Koordinaten je Knoten exportieren</translation>
    </message>
    <message>
        <source>Export one of them alone</source>
        <translation>Eines davon allein exportieren</translation>
    </message>
    <message>
        <source>Export the mesh as MED, .unv or .inp</source>
        <translation>Das Netz als MED, .unv oder .inp exportieren</translation>
    </message>
    <message>
        <source>HDF5 cannot open the file: it is damaged, or no MED</source>
        <translation>HDF5 kann die Datei nicht öffnen: Sie ist beschädigt oder keine MED-Datei</translation>
    </message>
    <message>
        <source>Mesh the volume with tetrahedra and export that mesh</source>
        <translation>Das Volumen mit Tetraedern vernetzen und dieses Netz exportieren</translation>
    </message>
    <message>
        <source>Open it in Salome and export it as MED 4</source>
        <translation>In Salome öffnen und als MED 4 exportieren</translation>
    </message>
    <message>
        <source>The file may be damaged, or made to do harm. %1</source>
        <translation>Die Datei ist vielleicht beschädigt oder soll Schaden anrichten. %1</translation>
    </message>
    <message>
        <source>The file may be damaged: write or copy it again</source>
        <translation>Die Datei ist vielleicht beschädigt: neu schreiben oder kopieren</translation>
    </message>
    <message>
        <source>Try again, or write .unv</source>
        <translation>Noch einmal versuchen oder .unv schreiben</translation>
    </message>
    <message>
        <source>Write .vtu</source>
        <translation>Als .vtu schreiben</translation>
    </message>
    <message>
        <source>Write it as .msh, .vtu, .inp, .bdf, .unv or .med in the program that it comes from</source>
        <translation>In dem Programm, aus dem sie kommt, als .msh, .vtu, .inp, .bdf, .unv oder .med schreiben</translation>
    </message>
    <message>
        <source>Write or copy the file again</source>
        <translation>Die Datei neu schreiben oder kopieren</translation>
    </message>
    <message>
        <source>Write the file with fewer groups</source>
        <translation>Die Datei mit weniger Gruppen schreiben</translation>
    </message>
    <message>
        <source>Write the mesh as .msh or .unv, without fields</source>
        <translation>Das Netz als .msh oder .unv schreiben, ohne Felder</translation>
    </message>
    <message>
        <source>Write the mesh as .unv, .msh or .inp there; nothing else is lost</source>
        <translation>Das Netz dort als .unv, .msh oder .inp schreiben; sonst ist nichts verloren</translation>
    </message>
    <message>
        <source>a MED file has at most 2147483647 nodes</source>
        <translation>eine MED-Datei hat höchstens 2147483647 Knoten</translation>
    </message>
    <message>
        <source>a coordinate of node %1 is infinite</source>
        <translation>eine Koordinate von Knoten %1 ist unendlich</translation>
    </message>
    <message>
        <source>a coordinate of node %1 is no number (nan)</source>
        <translation>eine Koordinate von Knoten %1 ist keine Zahl (nan)</translation>
    </message>
    <message>
        <source>a tet has one region: groups of tets that overlap others are not kept: %1</source>
        <translation>ein Tetraeder hat eine Region: Gruppen von Tetraedern, die andere überlappen, bleiben nicht erhalten: %1</translation>
    </message>
    <message>
        <source>an HDF5 file, such as MED, whose first bytes are damaged</source>
        <translation>eine HDF5-Datei wie MED, deren erste Bytes beschädigt sind</translation>
    </message>
    <message>
        <source>dimension %1</source>
        <translation>Dimension %1</translation>
    </message>
    <message>
        <source>elements of %1 nodes</source>
        <translation>Elemente mit %1 Knoten</translation>
    </message>
    <message>
        <source>families of elements</source>
        <translation>Familien von Elementen</translation>
    </message>
    <message>
        <source>families of nodes</source>
        <translation>Familien von Knoten</translation>
    </message>
    <message>
        <source>family %1</source>
        <translation>Familie %1</translation>
    </message>
    <message>
        <source>hexagonal prisms (OCTA12)</source>
        <translation>sechsseitige Prismen (OCTA12)</translation>
    </message>
    <message>
        <source>hexahedra (HEXA20)</source>
        <translation>Hexaeder (HEXA20)</translation>
    </message>
    <message>
        <source>hexahedra (HEXA27)</source>
        <translation>Hexaeder (HEXA27)</translation>
    </message>
    <message>
        <source>hexahedra (HEXA8)</source>
        <translation>Hexaeder (HEXA8)</translation>
    </message>
    <message>
        <source>how many %1 there are</source>
        <translation>wie viele %1 es gibt</translation>
    </message>
    <message>
        <source>how many meshes there are</source>
        <translation>wie viele Netze es gibt</translation>
    </message>
    <message>
        <source>libmed cannot finish the file</source>
        <translation>libmed kann die Datei nicht abschließen</translation>
    </message>
    <message>
        <source>libmed cannot make a file in memory</source>
        <translation>libmed kann keine Datei im Speicher anlegen</translation>
    </message>
    <message>
        <source>libmed cannot read %1: the file is damaged</source>
        <translation>libmed kann %1 nicht lesen: Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>libmed cannot write %1</source>
        <translation>libmed kann %1 nicht schreiben</translation>
    </message>
    <message>
        <source>mesh &quot;%1&quot; has %2 coordinates for each node, not three</source>
        <translation>Netz „%1“ hat %2 Koordinaten je Knoten, nicht drei</translation>
    </message>
    <message>
        <source>mesh &quot;%1&quot; has no cartesian coordinates</source>
        <translation>Netz „%1“ hat keine kartesischen Koordinaten</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>Netz %1</translation>
    </message>
    <message>
        <source>no number (nan)</source>
        <translation>keine Zahl (nan)</translation>
    </message>
    <message>
        <source>other meshes of the file are left out: %1</source>
        <translation>andere Netze der Datei werden weggelassen: %1</translation>
    </message>
    <message>
        <source>pyramids (PYRA13)</source>
        <translation>Pyramiden (PYRA13)</translation>
    </message>
    <message>
        <source>pyramids (PYRA5)</source>
        <translation>Pyramiden (PYRA5)</translation>
    </message>
    <message>
        <source>quadrangles (QUAD4)</source>
        <translation>Vierecke (QUAD4)</translation>
    </message>
    <message>
        <source>quadrangles (QUAD8)</source>
        <translation>Vierecke (QUAD8)</translation>
    </message>
    <message>
        <source>quadrangles (QUAD9)</source>
        <translation>Vierecke (QUAD9)</translation>
    </message>
    <message>
        <source>quadratic polygons</source>
        <translation>quadratische Polygone</translation>
    </message>
    <message>
        <source>reading the file</source>
        <translation>die Datei wird gelesen</translation>
    </message>
    <message>
        <source>tedit-med found no end while it was reading the file</source>
        <translation>tedit-med fand kein Ende, während es die Datei las</translation>
    </message>
    <message>
        <source>tedit-med found no end while it was writing the file</source>
        <translation>tedit-med fand kein Ende, während es die Datei schrieb</translation>
    </message>
    <message>
        <source>tedit-med needs more memory than it may take</source>
        <translation>tedit-med braucht mehr Speicher, als es nehmen darf</translation>
    </message>
    <message>
        <source>the answer of tedit-med is no mesh</source>
        <translation>die Antwort von tedit-med ist kein Netz</translation>
    </message>
    <message>
        <source>the coordinates of the nodes</source>
        <translation>die Koordinaten der Knoten</translation>
    </message>
    <message>
        <source>the families of %1</source>
        <translation>die Familien: %1</translation>
    </message>
    <message>
        <source>the family zero</source>
        <translation>die Familie null</translation>
    </message>
    <message>
        <source>the file has %1 bytes of the %2 that its head says</source>
        <translation>die Datei hat %1 Bytes von den %2, die ihr Kopf nennt</translation>
    </message>
    <message>
        <source>the file has %1 family numbers for %2 %3</source>
        <translation>die Datei hat %1 Familiennummern für %2 %3</translation>
    </message>
    <message>
        <source>the file has %1 meshes of solids: %2</source>
        <translation>die Datei hat %1 Netze von Körpern: %2</translation>
    </message>
    <message>
        <source>the file has no mesh</source>
        <translation>die Datei hat kein Netz</translation>
    </message>
    <message>
        <source>the file has no mesh with tets: %1</source>
        <translation>die Datei hat kein Netz mit Tetraedern: %1</translation>
    </message>
    <message>
        <source>the file holds %1, %2 in all; only tetrahedra (TETRA4, TETRA10) are supported</source>
        <translation>die Datei enthält %1, insgesamt %2; nur Tetraeder (TETRA4, TETRA10) werden unterstützt</translation>
    </message>
    <message>
        <source>the file is MED %1.%2; read are 3 and 4</source>
        <translation>die Datei ist MED %1.%2; gelesen werden 3 und 4</translation>
    </message>
    <message>
        <source>the file says that it has %1 %2, but it has %3 bytes</source>
        <translation>die Datei nennt %1 %2, aber sie hat %3 Bytes</translation>
    </message>
    <message>
        <source>the file says that its lengths are in &quot;%1&quot;, which is no unit that is known</source>
        <translation>die Datei nennt für ihre Längen „%1“, eine Einheit, die nicht bekannt ist</translation>
    </message>
    <message>
        <source>the first step of mesh &quot;%1&quot;</source>
        <translation>den ersten Schritt von Netz „%1“</translation>
    </message>
    <message>
        <source>the groups hold each %1 more than %2 times on average</source>
        <translation>die Gruppen enthalten jedes Element (%1) im Mittel öfter als %2-mal</translation>
    </message>
    <message>
        <source>the head of the HDF5 file is cut off or damaged</source>
        <translation>der Kopf der HDF5-Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the mesh</source>
        <translation>das Netz</translation>
    </message>
    <message>
        <source>the mesh changes in %1 steps; the first is read</source>
        <translation>das Netz ändert sich in %1 Schritten; der erste wird gelesen</translation>
    </message>
    <message>
        <source>the nodes of %1</source>
        <translation>die Knoten: %1</translation>
    </message>
    <message>
        <source>the version of MED</source>
        <translation>die Version von MED</translation>
    </message>
    <message>
        <source>this installation reads and writes no MED files: there is no %1</source>
        <translation>diese Installation liest und schreibt keine MED-Dateien: %1 fehlt</translation>
    </message>
    <message>
        <source>this is an HDF5 file, but no MED: it has no INFOS_GENERALES</source>
        <translation>dies ist eine HDF5-Datei, aber keine MED-Datei: Sie hat kein INFOS_GENERALES</translation>
    </message>
    <message>
        <source>what the tool leaves of two regions does not fit together</source>
        <translation>was das Werkzeug von zwei Bereichen übrig lässt, passt nicht zusammen</translation>
    </message>
    <message>
        <source>%1 ends early: the mark of its end is not there</source>
        <translation>%1 endet zu früh: Das Zeichen für das Ende fehlt</translation>
    </message>
    <message>
        <source>%1 is a DWG drawing, which is not read</source>
        <translation>%1 ist eine DWG-Zeichnung, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>%1 is a binary DXF, which is not read</source>
        <translation>%1 ist eine binäre DXF, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>%1 is damaged: %2 is no code of a group</source>
        <translation>%1 ist beschädigt: %2 ist kein Code einer Gruppe</translation>
    </message>
    <message>
        <source>%1 is no SVG picture and no DXF drawing</source>
        <translation>%1 ist kein SVG-Bild und keine DXF-Zeichnung</translation>
    </message>
    <message>
        <source>%1 is no number that a drawing can have</source>
        <translation>%1 ist keine Zahl, die eine Zeichnung haben kann</translation>
    </message>
    <message>
        <source>%1 lines of the drawing are there twice and count once</source>
        <translation>%1 Linien der Zeichnung sind doppelt da und zählen einmal</translation>
    </message>
    <message>
        <source>%1 lines of the drawing meet at %2: which of them is the outline cannot be told</source>
        <translation>%1 Linien der Zeichnung treffen sich bei %2: Welche davon der Umriss ist, lässt sich nicht sagen</translation>
    </message>
    <message>
        <source>Check the scales of its blocks</source>
        <translation>Die Maßstäbe ihrer Blöcke prüfen</translation>
    </message>
    <message>
        <source>Close it, or put what is no outline on a layer that is frozen or off</source>
        <translation>Ihn schließen, oder was kein Umriss ist auf einen gefrorenen oder ausgeschalteten Layer legen</translation>
    </message>
    <message>
        <source>Convert it to a polyline</source>
        <translation>Ihn in eine Polylinie umwandeln</translation>
    </message>
    <message>
        <source>Draw each outline once, without crossings, a little apart from others</source>
        <translation>Jeden Umriss einmal zeichnen, ohne Kreuzungen, mit etwas Abstand zu anderen</translation>
    </message>
    <message>
        <source>Draw it again, or put it on a layer that is frozen or off</source>
        <translation>Neu zeichnen, oder auf einen gefrorenen oder ausgeschalteten Layer legen</translation>
    </message>
    <message>
        <source>Draw it with lines, arcs, polylines, circles, ellipses or splines on layers that are shown</source>
        <translation>Mit Linien, Bögen, Polylinien, Kreisen, Ellipsen oder Splines auf sichtbaren Layern zeichnen</translation>
    </message>
    <message>
        <source>Explode the blocks</source>
        <translation>Die Blöcke auflösen</translation>
    </message>
    <message>
        <source>Explode the blocks, or export it again</source>
        <translation>Die Blöcke auflösen, oder neu exportieren</translation>
    </message>
    <message>
        <source>Export it again</source>
        <translation>Neu exportieren</translation>
    </message>
    <message>
        <source>Export it again as an ASCII DXF</source>
        <translation>Neu als ASCII-DXF exportieren</translation>
    </message>
    <message>
        <source>Export it again: numbers have a decimal point and are below 1e9</source>
        <translation>Neu exportieren: Zahlen haben einen Dezimalpunkt und liegen unter 1e9</translation>
    </message>
    <message>
        <source>For the profile &quot;file&quot;: the filled shapes of an SVG or the outlines of a DXF.</source>
        <translation>Für das Profil &quot;file&quot;: die gefüllten Formen einer SVG oder die Umrisse einer DXF.</translation>
    </message>
    <message>
        <source>Give a file that ends in .svg or .dxf</source>
        <translation>Eine Datei angeben, die auf .svg oder .dxf endet</translation>
    </message>
    <message>
        <source>Give a place on a wall</source>
        <translation>Einen Ort auf einer Wand angeben</translation>
    </message>
    <message>
        <source>Give each place once; the one of its own counts as the first</source>
        <translation>Jeden Ort einmal angeben; der eigene zählt als der erste</translation>
    </message>
    <message>
        <source>Give it: drain_diameter_mm=4</source>
        <translation>Ihn angeben: drain_diameter_mm=4</translation>
    </message>
    <message>
        <source>Give the scale that its unit lacks: scale=0.001</source>
        <translation>Den Maßstab angeben, der ihrer Einheit fehlt: scale=0.001</translation>
    </message>
    <message>
        <source>Leave it out: put it on a layer that is frozen or off</source>
        <translation>Ihn weglassen: auf einen gefrorenen oder ausgeschalteten Layer legen</translation>
    </message>
    <message>
        <source>Leave out what is no outline: put it on a layer that is frozen or off</source>
        <translation>Weglassen, was kein Umriss ist: auf einen gefrorenen oder ausgeschalteten Layer legen</translation>
    </message>
    <message>
        <source>Leave the places out, or take another profile</source>
        <translation>Die Orte weglassen, oder ein anderes Profil nehmen</translation>
    </message>
    <message>
        <source>More places</source>
        <translation>Weitere Orte</translation>
    </message>
    <message>
        <source>Name one: region=NAME; it has %1</source>
        <translation>Einen nennen: region=NAME; es hat %1</translation>
    </message>
    <message>
        <source>Of a DXF, which is as large as it is drawn: 25.4 for one in inches that does not say so.</source>
        <translation>Einer DXF, die so groß ist, wie sie gezeichnet ist: 25.4 für eine in Zoll, die das nicht sagt.</translation>
    </message>
    <message>
        <source>Pick walls of one region, or name it: region=NAME</source>
        <translation>Wände eines Bereichs wählen, oder ihn nennen: region=NAME</translation>
    </message>
    <message>
        <source>Put what is no outline on a layer that is frozen or off</source>
        <translation>Was kein Umriss ist, auf einen gefrorenen oder ausgeschalteten Layer legen</translation>
    </message>
    <message>
        <source>Save it as an ASCII DXF</source>
        <translation>Als ASCII-DXF speichern</translation>
    </message>
    <message>
        <source>Set it to millimetres or inches and export it again</source>
        <translation>Auf Millimeter oder Zoll setzen und neu exportieren</translation>
    </message>
    <message>
        <source>Take another wall or place for the drain</source>
        <translation>Eine andere Wand oder einen anderen Ort für den Ablauf nehmen</translation>
    </message>
    <message>
        <source>The circle&apos;s and the polygon&apos;s diameter, the longer side of all others but a DXF.</source>
        <translation>Der Durchmesser von Kreis und Vieleck, die längere Seite aller anderen außer einer DXF.</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>US-Vermessungsfuß</translation>
    </message>
    <message>
        <source>a %1 of the drawing %2</source>
        <translation>%1 in der Zeichnung: %2</translation>
    </message>
    <message>
        <source>a SPLINE of the drawing has no control points</source>
        <translation>ein SPLINE der Zeichnung hat keine Kontrollpunkte</translation>
    </message>
    <message>
        <source>an outline by its points is in one place, and more are given</source>
        <translation>ein Umriss aus Punkten liegt an einem Ort, und es sind mehrere angegeben</translation>
    </message>
    <message>
        <source>an outline of the drawing encloses nothing at %1</source>
        <translation>ein Umriss der Zeichnung bei %1 umschließt nichts</translation>
    </message>
    <message>
        <source>an outline of the drawing is open: it ends at %1 and at %2, %3 apart</source>
        <translation>ein Umriss der Zeichnung ist offen: Er endet bei %1 und bei %2, Abstand %3</translation>
    </message>
    <message>
        <source>behind %1 lies no hollow</source>
        <translation>hinter %1 liegt kein Hohlraum</translation>
    </message>
    <message>
        <source>blocks of the drawing are inserted in each other without end</source>
        <translation>Blöcke der Zeichnung sind endlos ineinander eingefügt</translation>
    </message>
    <message>
        <source>does not lie in the plane of the drawing</source>
        <translation>liegt nicht in der Ebene der Zeichnung</translation>
    </message>
    <message>
        <source>drain %1 (%2, %3, %4 mm): %5</source>
        <translation>Ablauf %1 (%2, %3, %4 mm): %5</translation>
    </message>
    <message>
        <source>has %1 knots for %2 control points and degree %3</source>
        <translation>hat %1 Knoten für %2 Kontrollpunkte und Grad %3</translation>
    </message>
    <message>
        <source>has knots in no order</source>
        <translation>hat ungeordnete Knoten</translation>
    </message>
    <message>
        <source>has no radius</source>
        <translation>hat keinen Radius</translation>
    </message>
    <message>
        <source>has no width</source>
        <translation>hat keine Breite</translation>
    </message>
    <message>
        <source>has not one weight for each control point</source>
        <translation>hat nicht für jeden Kontrollpunkt ein Gewicht</translation>
    </message>
    <message>
        <source>has weights that make no curve</source>
        <translation>hat Gewichte, die keine Kurve ergeben</translation>
    </message>
    <message>
        <source>is a surface</source>
        <translation>ist eine Fläche</translation>
    </message>
    <message>
        <source>left out of the drawing: %1</source>
        <translation>in der Zeichnung ausgelassen: %1</translation>
    </message>
    <message>
        <source>one of the places is beside the part</source>
        <translation>einer der Orte liegt neben dem Teil</translation>
    </message>
    <message>
        <source>outlines of the drawing cross or touch at %1</source>
        <translation>Umrisse der Zeichnung kreuzen oder berühren sich bei %1</translation>
    </message>
    <message>
        <source>place %1 of %2 (%3, %4, %5 mm): %6</source>
        <translation>Ort %1 von %2 (%3, %4, %5 mm): %6</translation>
    </message>
    <message>
        <source>places for drain holes are given, and no diameter</source>
        <translation>Orte für Ablauflöcher sind angegeben, aber kein Durchmesser</translation>
    </message>
    <message>
        <source>side %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>surface %1 is no wall of one region that is meant</source>
        <translation>Fläche %1 ist keine Wand des einen gemeinten Bereichs</translation>
    </message>
    <message>
        <source>the drawing does not say its unit: it is taken for millimetres</source>
        <translation>die Zeichnung nennt ihre Einheit nicht: Es werden Millimeter angenommen</translation>
    </message>
    <message>
        <source>the drawing has more than 20,000 lines and arcs</source>
        <translation>die Zeichnung hat mehr als 20.000 Linien und Bögen</translation>
    </message>
    <message>
        <source>the drawing has no closed outline</source>
        <translation>die Zeichnung hat keinen geschlossenen Umriss</translation>
    </message>
    <message>
        <source>the drawing inserts a block that it does not have</source>
        <translation>die Zeichnung fügt einen Block ein, den sie nicht hat</translation>
    </message>
    <message>
        <source>the drawing is %1 m long; a profile has 0.000001 to 10 m</source>
        <translation>die Zeichnung ist %1 m lang; ein Profil hat 0,000001 bis 10 m</translation>
    </message>
    <message>
        <source>the drawing reaches further than any part</source>
        <translation>die Zeichnung reicht weiter als jedes Teil</translation>
    </message>
    <message>
        <source>the drawing&apos;s unit, $INSUNITS %1, is none that parts are measured in</source>
        <translation>die Einheit der Zeichnung, $INSUNITS %1, ist keine, in der Teile gemessen werden</translation>
    </message>
    <message>
        <source>the middle of surface %1</source>
        <translation>der Mitte von Fläche %1</translation>
    </message>
    <message>
        <source>the part has %1 regions, and which is to be hollow is not said</source>
        <translation>das Teil hat %1 Bereiche, und welcher hohl werden soll, ist nicht gesagt</translation>
    </message>
    <message>
        <source>the part has no region &quot;%1&quot;</source>
        <translation>das Teil hat keinen Bereich &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the place</source>
        <translation>dem Ort</translation>
    </message>
    <message>
        <source>the places %1 and %2 are the same</source>
        <translation>die Orte %1 und %2 sind derselbe</translation>
    </message>
    <message>
        <source>there is no wall within %1 mm of it</source>
        <translation>innerhalb von %1 mm davon ist keine Wand</translation>
    </message>
    <message>
        <source>%1 places that overlap others are more than the 30 that one edit makes</source>
        <translation>%1 Orte, die andere überlappen, sind mehr als die 30, die eine Bearbeitung macht</translation>
    </message>
    <message>
        <source>Give fewer, or further apart</source>
        <translation>Weniger angeben, oder weiter auseinander</translation>
    </message>
    <message>
        <source>it is beside the part</source>
        <translation>er liegt neben dem Teil</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot read the BREP file</source>
        <translation>OpenCASCADE kann die BREP-Datei nicht lesen</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot read the IGES file</source>
        <translation>OpenCASCADE kann die IGES-Datei nicht lesen</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot read the STEP file</source>
        <translation>OpenCASCADE kann die STEP-Datei nicht lesen</translation>
    </message>
    <message>
        <source>below the wall lies another region</source>
        <translation>unter der Wand liegt ein anderer Bereich</translation>
    </message>
    <message>
        <source>%1 has its parameters at P%2, in %3 lines, and section P has %4</source>
        <translation>%1 hat seine Parameter ab P%2, in %3 Zeilen, und Abschnitt P hat %4</translation>
    </message>
    <message>
        <source>%1 has no number in the directory where one must be</source>
        <translation>%1 hat im Verzeichnis keine Zahl, wo eine stehen muss</translation>
    </message>
    <message>
        <source>%1 has parameters that do not end with %2</source>
        <translation>%1 hat Parameter, die nicht mit %2 enden</translation>
    </message>
    <message>
        <source>Copy or download the file again, or export the part again from the CAD program</source>
        <translation>Kopieren oder laden Sie die Datei noch einmal, oder exportieren Sie das Teil noch einmal aus dem CAD-Programm</translation>
    </message>
    <message>
        <source>Copy or download the file again, or export the part again, as STEP where you can</source>
        <translation>Kopieren oder laden Sie die Datei noch einmal, oder exportieren Sie das Teil noch einmal, wenn möglich als STEP</translation>
    </message>
    <message>
        <source>Export it with exact geometry, or as STL or 3MF</source>
        <translation>Exportieren Sie es mit genauer Geometrie, oder als STL oder 3MF</translation>
    </message>
    <message>
        <source>Export the part again from the CAD program, as STEP where you can</source>
        <translation>Exportieren Sie das Teil noch einmal aus dem CAD-Programm, wenn möglich als STEP</translation>
    </message>
    <message>
        <source>Export the part again from the CAD program, or mend this entity</source>
        <translation>Exportieren Sie das Teil noch einmal aus dem CAD-Programm, oder berichtigen Sie diesen Eintrag</translation>
    </message>
    <message>
        <source>Export the part as AP203, AP214 or AP242</source>
        <translation>Exportieren Sie das Teil als AP203, AP214 oder AP242</translation>
    </message>
    <message>
        <source>Export the part as a solid (AP203, AP214 or AP242); check in the CAD program that it is closed</source>
        <translation>Exportieren Sie das Teil als Volumenkörper (AP203, AP214 oder AP242); prüfen Sie im CAD-Programm, ob es geschlossen ist</translation>
    </message>
    <message>
        <source>Export the part with its surfaces, as STEP where you can</source>
        <translation>Exportieren Sie das Teil mit seinen Flächen, wenn möglich als STEP</translation>
    </message>
    <message>
        <source>a ; is missing before %1</source>
        <translation>vor %1 fehlt ein ;</translation>
    </message>
    <message>
        <source>a comment is not closed by */</source>
        <translation>ein Kommentar ist nicht mit */ geschlossen</translation>
    </message>
    <message>
        <source>a finite number must be here, and not %1</source>
        <translation>hier muss eine endliche Zahl stehen und nicht %1</translation>
    </message>
    <message>
        <source>a loop of edges</source>
        <translation>ein Umlauf von Kanten</translation>
    </message>
    <message>
        <source>a text is not closed by &apos;: %1</source>
        <translation>ein Text ist nicht mit &apos; geschlossen: %1</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>entities begin without DATA before them</source>
        <translation>Einträge beginnen, ohne dass DATA davor steht</translation>
    </message>
    <message>
        <source>has %1 coordinates: a decimal comma, where STEP wants a point?</source>
        <translation>hat %1 Koordinaten: ein Dezimalkomma, wo STEP einen Punkt verlangt?</translation>
    </message>
    <message>
        <source>has %1 parameters in place of %2</source>
        <translation>hat %1 Parameter statt %2</translation>
    </message>
    <message>
        <source>has coordinates that are no list of finite numbers</source>
        <translation>hat Koordinaten, die keine Liste endlicher Zahlen sind</translation>
    </message>
    <message>
        <source>has the parameters of another type, %1</source>
        <translation>hat die Parameter eines anderen Typs, %1</translation>
    </message>
    <message>
        <source>is open: %1 of its %2 edges are on one face only, the first is %3</source>
        <translation>ist offen: %1 ihrer %2 Kanten liegen an nur einer Fläche, die erste ist %3</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>ist zweimal da</translation>
    </message>
    <message>
        <source>it ends before its entities (DATA)</source>
        <translation>sie endet vor ihren Einträgen (DATA)</translation>
    </message>
    <message>
        <source>it ends within its header</source>
        <translation>sie endet innerhalb ihres Kopfes</translation>
    </message>
    <message>
        <source>it ends without END-ISO-10303-21</source>
        <translation>sie endet ohne END-ISO-10303-21</translation>
    </message>
    <message>
        <source>it is cut off: %1</source>
        <translation>sie ist abgeschnitten: %1</translation>
    </message>
    <message>
        <source>it is cut off: behind its shapes there must be which of them is the part</source>
        <translation>sie ist abgeschnitten: hinter ihren Formen muss stehen, welche davon das Teil ist</translation>
    </message>
    <message>
        <source>it is cut off: it ends before its section %1</source>
        <translation>sie ist abgeschnitten: sie endet vor ihrem Abschnitt %1</translation>
    </message>
    <message>
        <source>it is cut off: it ends within its section %1</source>
        <translation>sie ist abgeschnitten: sie endet innerhalb ihres Abschnitts %1</translation>
    </message>
    <message>
        <source>it is cut off: it ends without its last line (section T)</source>
        <translation>sie ist abgeschnitten: sie endet ohne ihre letzte Zeile (Abschnitt T)</translation>
    </message>
    <message>
        <source>its format is version %1, and 1 to 3 are known</source>
        <translation>ihr Format ist Version %1, bekannt sind 1 bis 3</translation>
    </message>
    <message>
        <source>its schema is IFC, a building&apos;s, which is no CAD part</source>
        <translation>ihr Schema ist IFC, das eines Bauwerks, und kein CAD-Teil</translation>
    </message>
    <message>
        <source>line P%1 is not of %2</source>
        <translation>Zeile P%1 gehört nicht zu %2</translation>
    </message>
    <message>
        <source>names no entity where %1 must be</source>
        <translation>nennt keinen Eintrag, wo %1 stehen muss</translation>
    </message>
    <message>
        <source>no letter</source>
        <translation>kein Buchstabe</translation>
    </message>
    <message>
        <source>nothing in STEP begins like this: %1</source>
        <translation>nichts in STEP beginnt so: %1</translation>
    </message>
    <message>
        <source>points nowhere: all its coordinates are 0</source>
        <translation>zeigt nirgendwohin: alle seine Koordinaten sind 0</translation>
    </message>
    <message>
        <source>refers to #%1, which is not there</source>
        <translation>verweist auf #%1, das es nicht gibt</translation>
    </message>
    <message>
        <source>refers to %1 where %2 must be</source>
        <translation>verweist auf %1, wo %2 stehen muss</translation>
    </message>
    <message>
        <source>refers to D%1, where no entity begins</source>
        <translation>verweist auf D%1, wo kein Eintrag beginnt</translation>
    </message>
    <message>
        <source>refers to D, where no entity begins</source>
        <translation>verweist auf D, wo kein Eintrag beginnt</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Abschnitt %1</translation>
    </message>
    <message>
        <source>section %1 says that it has %2, and only %3 numbers follow</source>
        <translation>Abschnitt %1 sagt, dass er %2 hat, und nur %3 Zahlen folgen</translation>
    </message>
    <message>
        <source>shape %1 (%2) is made of nothing</source>
        <translation>Form %1 (%2) besteht aus nichts</translation>
    </message>
    <message>
        <source>shape %1 of %2 must begin here (Ve, Ed, Wi, Fa, Sh, So, CS or Co), and not %3</source>
        <translation>Form %1 von %2 muss hier beginnen (Ve, Ed, Wi, Fa, Sh, So, CS oder Co) und nicht %3</translation>
    </message>
    <message>
        <source>shape %1 refers to shape %2, and only %3 to %4 stand before it</source>
        <translation>Form %1 verweist auf Form %2, und nur %3 bis %4 stehen davor</translation>
    </message>
    <message>
        <source>the 73rd letter of the line is %1, and none of the sections that may follow (%2) begins so</source>
        <translation>das 73. Zeichen der Zeile ist %1, und keiner der Abschnitte, die folgen dürfen (%2), beginnt so</translation>
    </message>
    <message>
        <source>the count of section %1 is no number: %2</source>
        <translation>die Anzahl des Abschnitts %1 ist keine Zahl: %2</translation>
    </message>
    <message>
        <source>the directory has %1 lines, and each entity has two of it</source>
        <translation>das Verzeichnis hat %1 Zeilen, und jeder Eintrag hat zwei davon</translation>
    </message>
    <message>
        <source>the last line says &quot;%1&quot; of section %2, which has %3 lines</source>
        <translation>die letzte Zeile sagt „%1“ von Abschnitt %2, der %3 Zeilen hat</translation>
    </message>
    <message>
        <source>the line has %1 letters in place of 80</source>
        <translation>die Zeile hat %1 Zeichen statt 80</translation>
    </message>
    <message>
        <source>the line is numbered %1 where number %2 must be: lines are missing, or there twice</source>
        <translation>die Zeile trägt die Nummer %1, wo Nummer %2 stehen muss: Zeilen fehlen oder sind zweimal da</translation>
    </message>
    <message>
        <source>the part has triangles in place of CAD faces</source>
        <translation>das Teil hat Dreiecke statt CAD-Flächen</translation>
    </message>
    <message>
        <source>the part is shape %1, and there are %2</source>
        <translation>das Teil ist Form %1, und es gibt %2</translation>
    </message>
    <message>
        <source>the part is shape %1, which is %2</source>
        <translation>das Teil ist Form %1, und die ist %2</translation>
    </message>
    <message>
        <source>the section %1 must begin here, and not %2</source>
        <translation>hier muss der Abschnitt %1 beginnen und nicht %2</translation>
    </message>
    <message>
        <source>there is a ) that no ( belongs to</source>
        <translation>da ist eine ), zu der keine ( gehört</translation>
    </message>
    <message>
        <source>there is a byte that is no text, %1</source>
        <translation>da ist ein Byte, das kein Text ist, %1</translation>
    </message>
    <message>
        <source>there is a byte that is no text, 0x00</source>
        <translation>da ist ein Byte, das kein Text ist, 0x00</translation>
    </message>
    <message>
        <source>there is no = behind the number</source>
        <translation>hinter der Nummer fehlt das =</translation>
    </message>
    <message>
        <source>there is no solid, no shell and no face among its entities (%1)</source>
        <translation>unter ihren Einträgen (%1) ist kein Volumenkörper, keine Schale und keine Fläche</translation>
    </message>
    <message>
        <source>there is no surface and no solid among its entities (%1)</source>
        <translation>unter ihren Einträgen (%1) ist keine Fläche und kein Volumenkörper</translation>
    </message>
    <message>
        <source>this is no number of an entity</source>
        <translation>das ist keine Nummer eines Eintrags</translation>
    </message>
    <message>
        <source>Give the machine or its container more memory (&quot;tedit doctor&quot; says what there is), take a coarser mesh or linear tets, or let fewer work at once</source>
        <translation>Der Maschine oder ihrem Container mehr Speicher geben („tedit doctor“ sagt, was da ist), ein gröberes Netz oder lineare Tetraeder nehmen oder weniges zugleich arbeiten lassen</translation>
    </message>
    <message>
        <source>memory ran out while the %1 worker worked on this, %2 times: the system ended it</source>
        <translation>Der Speicher ging %2-mal aus, während der Arbeitsprozess „%1“ daran arbeitete: das System hat ihn beendet</translation>
    </message>
    <message>
        <source>the solve of %1 tets</source>
        <translation>die Rechnung mit %1 Tetraedern</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>region %1</source>
        <translation>Bereich %1</translation>
    </message>
    <message>
        <source>its new vertices do not fit on their walls</source>
        <translation>die neuen Knoten finden keinen Platz auf ihren Wänden</translation>
    </message>
    <message>
        <source>the round walls at the tool follow their arcs closer now: %1 mm3 of the change of volume come of that</source>
        <translation>die runden Wände am Werkzeug folgen ihren Bögen jetzt genauer: %1 mm3 der Volumenänderung kommen davon</translation>
    </message>
    <message>
        <source>Select two walls that are; free form cannot be rounded by this version</source>
        <translation>Wählen Sie zwei solche Wände; Freiform kann diese Version nicht abrunden</translation>
    </message>
    <message>
        <source>in place</source>
        <translation>an Ort und Stelle</translation>
    </message>
    <message>
        <source>rounds at the wall went along with it: surface %1</source>
        <translation>Rundungen an der Wand sind mit ihr gegangen: Fläche %1</translation>
    </message>
    <message>
        <source>surface %1 is neither a plane, a cylinder, a cone, a sphere nor a torus</source>
        <translation>Fläche %1 ist weder Ebene noch Zylinder, Kegel, Kugel oder Torus</translation>
    </message>
    <message>
        <source>the surface finds no way by its own vertices</source>
        <translation>die Fläche findet mit ihren eigenen Knoten keinen Weg</translation>
    </message>
    <message>
        <source>Select the walls of one region at a time</source>
        <translation>Wählen Sie die Wände eines Bereichs auf einmal</translation>
    </message>
    <message>
        <source>a slab would be of one of the surface&apos;s regions alone</source>
        <translation>eine Platte gehörte zu einem der Bereiche der Fläche allein</translation>
    </message>
    <message>
        <source>what is put on surface %1 would be of one region alone</source>
        <translation>was auf Fläche %1 aufgetragen wird, gehörte zu einem Bereich allein</translation>
    </message>
    <message>
        <source>Take a smaller depth, or other surfaces</source>
        <translation>Nehmen Sie eine kleinere Tiefe, oder andere Flächen</translation>
    </message>
    <message>
        <source>the face between two regions leaves surface %1 no way at %2</source>
        <translation>die Fläche zwischen zwei Bereichen lässt Fläche %1 bei %2 keinen Weg</translation>
    </message>
    <message>
        <source>what the reader wrote of the faces&apos; geometry is damaged</source>
        <translation>was das Leseprogramm über die Geometrie der Flächen schrieb, ist beschädigt</translation>
    </message>
    <message>
        <source>slab by edges around</source>
        <translation>Scheibe nach Kanten ringsum</translation>
    </message>
    <message>
        <source>slab by planes around</source>
        <translation>Scheibe nach Ebenen ringsum</translation>
    </message>
    <message>
        <source>a closed surface has at least four triangles</source>
        <translation>eine geschlossene Oberfläche hat mindestens vier Dreiecke</translation>
    </message>
    <message>
        <source>no tets fit between the walls there (%1)</source>
        <translation>zwischen die Wände dort passen keine Tetraeder (%1)</translation>
    </message>
    <message>
        <source>the mesher did not keep the surface&apos;s triangles</source>
        <translation>der Vernetzer hat die Dreiecke der Oberfläche nicht behalten</translation>
    </message>
    <message>
        <source>the mesher left gaps</source>
        <translation>der Vernetzer hat Lücken gelassen</translation>
    </message>
    <message>
        <source>the mesher made a flat tet</source>
        <translation>der Vernetzer hat ein flaches Tetraeder gemacht</translation>
    </message>
    <message>
        <source>the mesher moved a point of the surface</source>
        <translation>der Vernetzer hat einen Punkt der Oberfläche verschoben</translation>
    </message>
    <message>
        <source>the tool and the part could not be cut with each other (%1)</source>
        <translation>Werkzeug und Teil ließen sich nicht miteinander schneiden (%1)</translation>
    </message>
    <message>
        <source>not each face has a geometry, or none</source>
        <translation>nicht jede Seite hat eine Form, oder keine</translation>
    </message>
    <message>
        <source>the geometry of a face is of no known kind, or not finite</source>
        <translation>die Form einer Seite ist von keiner bekannten Art oder nicht endlich</translation>
    </message>
    <message>
        <source>annotations (tolerances, datums, notes) were left out, %1 in all: the file could not be read with them</source>
        <translation>Anmerkungen (Toleranzen, Bezüge, Hinweise) wurden weggelassen, zusammen %1: mit ihnen war die Datei nicht zu lesen</translation>
    </message>
    <message>
        <source>edges shorter than %1 mm were closed up, %2 in all, the first at %3, %4, %5 mm</source>
        <translation>Kanten, die kürzer als %1 mm sind, wurden geschlossen, zusammen %2, die erste bei %3, %4, %5 mm</translation>
    </message>
    <message>
        <source>faces that belong to no solid were left out</source>
        <translation>Flächen, die zu keinem Körper gehören, wurden weggelassen</translation>
    </message>
    <message>
        <source>joining %1 solids where they touch</source>
        <translation>%1 Körper werden verbunden, wo sie sich berühren</translation>
    </message>
    <message>
        <source>leaving out annotations</source>
        <translation>Anmerkungen werden weggelassen</translation>
    </message>
    <message>
        <source>looking for edges of no length</source>
        <translation>Kanten ohne Länge werden gesucht</translation>
    </message>
    <message>
        <source>sewing faces to solids</source>
        <translation>Flächen werden zu Körpern vernäht</translation>
    </message>
    <message>
        <source>solids overlap (%1): what two have in common is a region of its own with the first&apos;s name</source>
        <translation>Körper überschneiden sich (%1): was zwei gemeinsam haben, ist ein eigener Bereich mit dem Namen des ersten</translation>
    </message>
    <message>
        <source>the file has surfaces and no solid: those that close a volume, with gaps up to 0.001 mm, were made solids</source>
        <translation>die Datei hat Flächen und keinen Körper: die ein Volumen schließen, mit Lücken bis 0,001 mm, wurden zu Körpern gemacht</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>writing the shape</source>
        <translation>die Form wird geschrieben</translation>
    </message>
    <message>
        <source>OpenCASCADE gives up: %1</source>
        <translation>OpenCASCADE gibt auf: %1</translation>
    </message>
    <message>
        <source>it is not valid by OpenCASCADE&apos;s checks</source>
        <translation>es ist nach den Prüfungen von OpenCASCADE nicht gültig</translation>
    </message>
    <message>
        <source>solid %1 is not valid by OpenCASCADE&apos;s checks: look at its mesh</source>
        <translation>Körper %1 ist nach den Prüfungen von OpenCASCADE nicht gültig: das Netz ansehen</translation>
    </message>
    <message>
        <source>slab by edges beyond</source>
        <translation>Scheibe nach Kanten dahinter</translation>
    </message>
    <message>
        <source>straight on</source>
        <translation>gerade weiter</translation>
    </message>
    <message>
        <source>faces that are narrower than a twentieth of the wall went into their neighbours (%1): surface %2</source>
        <translation>Flächen, die schmaler als ein Zwanzigstel der Wand sind, gingen in ihren Nachbarn auf (%1): Fläche %2</translation>
    </message>
    <message>
        <source>faces that are narrower than a twentieth of the wall went into their neighbours (%1): surface %2, ...</source>
        <translation>Flächen, die schmaler als ein Zwanzigstel der Wand sind, gingen in ihren Nachbarn auf (%1): Fläche %2, ...</translation>
    </message>
    <message>
        <source>flat tets at narrow places were mended: the surface moved there by up to %1 mm. A finer size, or a local size of the surfaces there, keeps it</source>
        <translation>Flache Tetraeder an schmalen Stellen wurden ausgebessert: die Oberfläche verschob sich dort um bis zu %1 mm. Mit feinerer Größe, oder einer eigenen Größe für die Flächen dort, bleibt sie</translation>
    </message>
    <message>
        <source>the worst tet has a radius ratio of %1, below %2: stresses beside it are not to be trusted</source>
        <translation>das schlechteste Tetraeder hat ein Radienverhältnis von %1, unter %2: Spannungen daneben ist nicht zu trauen</translation>
    </message>
    <message>
        <source>only %1 mm of the part are left between two of its walls near %2</source>
        <translation>zwischen zwei Wänden des Teils bleiben nur %1 mm stehen, bei %2</translation>
    </message>
    <message>
        <source>Let the tool go through there, or leave more of the part</source>
        <translation>Führen Sie das Werkzeug dort durch, oder lassen Sie mehr vom Teil stehen</translation>
    </message>
    <message>
        <source>only %1 mm of the part would be left near %2, too little for good tets (q = %3)</source>
        <translation>bei %2 bliebe vom Teil nur %1 mm stehen, zu wenig für gute Tetraeder (q = %3)</translation>
    </message>
</context>
<context>
    <name>server_lists</name>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
</context>
<context>
    <name>server_tables</name>
    <message>
        <source>Open documents</source>
        <translation>Offene Dokumente</translation>
    </message>
    <message>
        <source>Pages that were used last</source>
        <translation>Zuletzt benutzte Seiten</translation>
    </message>
    <message>
        <source>Versions that were read</source>
        <translation>Gelesene Versionen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Files that are sent to it</source>
        <translation>Dateien, die er erhält</translation>
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
        <source>idle</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>working</source>
        <translation>arbeitet</translation>
    </message>
    <message>
        <source>leaving</source>
        <translation>geht</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 Tage</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Belegt</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>what is open</source>
        <translation>was offen ist</translation>
    </message>
    <message>
        <source>Workers</source>
        <translation>Arbeitsprozesse</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Running and waiting</source>
        <translation>In Arbeit und wartend</translation>
    </message>
    <message>
        <source>Started again</source>
        <translation>Neu gestartet</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Other machines</source>
        <translation>Andere Rechner</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Jobs done</source>
        <translation>Aufträge erledigt</translation>
    </message>
    <message>
        <source>There for</source>
        <translation>Dabei seit</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>TEdit</source>
        <translation>TEdit</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
</context>
<context>
    <name>snap_places</name>
    <message>
        <source>centre of a round edge, Ø %1</source>
        <translation>Mitte einer runden Kante, Ø %1</translation>
    </message>
    <message>
        <source>centre of surface %1</source>
        <translation>Mitte der Fläche %1</translation>
    </message>
    <message>
        <source>on the middle line of surface %1</source>
        <translation>auf der Mittellinie der Fläche %1</translation>
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
    <name>tedit::desktop::axis_field</name>
    <message>
        <source>Click a wall or an edge of the part that has it</source>
        <translation>Eine Wand oder Kante des Teils anklicken, die sie hat</translation>
    </message>
    <message>
        <source>through x; y; z in %1</source>
        <translation>durch x; y; z in %1</translation>
    </message>
    <message>
        <source>A point of the axis</source>
        <translation>Ein Punkt der Achse</translation>
    </message>
    <message>
        <source>A point of the plane</source>
        <translation>Ein Punkt der Ebene</translation>
    </message>
    <message>
        <source>along x; y; z</source>
        <translation>entlang x; y; z</translation>
    </message>
    <message>
        <source>normal x; y; z</source>
        <translation>Normale x; y; z</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Richtung der Achse</translation>
    </message>
    <message>
        <source>Normal of the plane</source>
        <translation>Normale der Ebene</translation>
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
    <name>tedit::desktop::certificate_dialog</name>
    <message>
        <source>%1 differs on %2 of %3 load cases of version %4.</source>
        <translation>%1 weicht bei %2 von %3 Lastfällen der Version %4 ab.</translation>
    </message>
    <message>
        <source>%1 agrees on the load case of version %2.</source>
        <translation>%1 stimmt beim Lastfall der Version %2 überein.</translation>
    </message>
    <message>
        <source>%1 agrees on all %2 load cases of version %3.</source>
        <translation>%1 stimmt bei allen %2 Lastfällen der Version %3 überein.</translation>
    </message>
    <message>
        <source>Checked with CalculiX</source>
        <translation>Mit CalculiX geprüft</translation>
    </message>
    <message>
        <source>Both programs solved the same deck. Differences are relative to the largest displacement, the sum of reactions and the largest stress. Stress at nodes is a mean of the elements around: it is compared with the same mean; as each program shows it, half of the nodes differ by less than %1 %.</source>
        <translation>Beide Programme haben dieselbe Eingabedatei gerechnet. Unterschiede beziehen sich auf die größte Verschiebung, die Summe der Auflagerkräfte und die größte Spannung. Die Spannung an einem Knoten ist ein Mittel der Elemente um ihn: verglichen wird mit demselben Mittel; so, wie jedes Programm sie zeigt, weicht die Hälfte der Knoten um weniger als %1 % ab.</translation>
    </message>
    <message>
        <source>Decks and results: %1</source>
        <translation>Eingabedateien und Ergebnisse: %1</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Load case</source>
        <translation>Lastfall</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Reactions</source>
        <translation>Auflagerkräfte</translation>
    </message>
    <message>
        <source>Compliance</source>
        <translation>Nachgiebigkeit</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Largest, MPa</source>
        <translation>Größte, MPa</translation>
    </message>
    <message>
        <source>CalculiX, MPa</source>
        <translation>CalculiX, MPa</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::certify_tool</name>
    <message>
        <source>Check with CalculiX</source>
        <translation>Mit CalculiX prüfen</translation>
    </message>
    <message>
        <source>CalculiX solves this version&apos;s load cases, too; decks, results and how far both agree go into a folder</source>
        <translation>Auch CalculiX rechnet die Lastfälle dieser Version; Eingabedateien, Ergebnisse und wie weit beide übereinstimmen, kommen in einen Ordner</translation>
    </message>
    <message>
        <source>It needs a part with a load case</source>
        <translation>Es braucht ein Teil mit einem Lastfall</translation>
    </message>
    <message>
        <source>Where shall decks and results be kept?</source>
        <translation>Wo sollen Eingabedateien und Ergebnisse bleiben?</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
    <message>
        <source>v%1 minus v%2, on the surface of v%1; dark grey: outside of v%2</source>
        <translation>v%1 minus v%2, auf der Oberfläche von v%1; dunkelgrau: außerhalb von v%2</translation>
    </message>
    <message>
        <source>The server compares the versions.</source>
        <translation>Der Server vergleicht die Versionen.</translation>
    </message>
    <message>
        <source>  (seen without this quantity)</source>
        <translation>  (ohne diese Größe gesehen)</translation>
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
    <message>
        <source>Area %1</source>
        <translation>Inhalt %1</translation>
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
    <message>
        <source>The connection is slow: %1 MB wait for this computer. If that does not change the server ends it in %2 s; it is made anew then.</source>
        <translation>Die Verbindung ist langsam: %1 MB warten auf diesen Rechner. Ändert sich das nicht, beendet der Server sie in %2 s; sie wird dann neu aufgebaut.</translation>
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
    <name>tedit::desktop::documents_dialog</name>
    <message>
        <source>holds nothing yet</source>
        <translation>noch leer</translation>
    </message>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>here and elsewhere (%1)</source>
        <translation>hier und anderswo (%1)</translation>
    </message>
    <message>
        <source>elsewhere (%1)</source>
        <translation>anderswo (%1)</translation>
    </message>
    <message>
        <source>Documents on the server</source>
        <translation>Dokumente auf dem Server</translation>
    </message>
    <message>
        <source>Search documents</source>
        <translation>Dokumente suchen</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>Neuer Name</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Name of the copy of %1</source>
        <translation>Name der Kopie von %1</translation>
    </message>
    <message>
        <source>New name of %1</source>
        <translation>Neuer Name von %1</translation>
    </message>
    <message>
        <source>Delete %1 with all its versions? It cannot be brought back.</source>
        <translation>%1 mit allen Versionen löschen? Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Delete for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Geöffnet</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::documents_tool</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
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
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Writes the part as a file for other programs: the mesh, its boundary or its fields</source>
        <translation>Schreibt das Teil als Datei für andere Programme: das Netz, seine Oberfläche oder seine Felder</translation>
    </message>
    <message>
        <source>A mesh or a CAD file with its load cases, a document, or a recipe, which is run</source>
        <translation>Ein Netz oder eine CAD-Datei mit Lastfällen, ein Dokument oder ein Rezept, das ausgeführt wird</translation>
    </message>
    <message>
        <source>Open a CAD file</source>
        <translation>CAD-Datei öffnen</translation>
    </message>
    <message>
        <source>How fine shall the mesh of %1 be?</source>
        <translation>Wie fein soll das Netz von %1 sein?</translation>
    </message>
    <message>
        <source>Coarse: one quadratic tet through a usual wall. Medium: two. Fine: three.</source>
        <translation>Grob: ein quadratisches Tetraeder durch eine übliche Wand. Mittel: zwei. Fein: drei.</translation>
    </message>
    <message>
        <source>Coarse</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>CAD model with all edits (*.step)</source>
        <translation>CAD-Modell mit allen Änderungen (*.step)</translation>
    </message>
    <message>
        <source>Open a mesh, a CAD file or a surface and its load cases, a document or a recipe</source>
        <translation>Ein Netz, eine CAD-Datei oder eine Oberfläche mit ihren Lastfällen, ein Dokument oder ein Rezept öffnen</translation>
    </message>
    <message>
        <source>Meshes, CAD files, surfaces, load cases, recipes, documents (%1)</source>
        <translation>Netze, CAD-Dateien, Oberflächen, Lastfälle, Rezepte, Dokumente (%1)</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Its lengths are in, where it does not say it</source>
        <translation>Ihre Längen sind, wo sie es nicht sagt, in</translation>
    </message>
    <message>
        <source>Open a surface</source>
        <translation>Oberfläche öffnen</translation>
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
        <source>The envelope of all load cases has no deformation: choose one of them</source>
        <translation>Die Einhüllende aller Lastfälle hat keine Verformung: einen davon wählen</translation>
    </message>
    <message>
        <source>For the safety factor only</source>
        <translation>Nur für den Sicherheitsfaktor</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::file_field</name>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
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
    <message>
        <source>made by %1, %2</source>
        <translation>von %1, %2</translation>
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
        <source>Nothing of yours runs.</source>
        <translation>Von Ihnen läuft nichts.</translation>
    </message>
    <message>
        <source>The server still solves %1, which was open here before.</source>
        <translation>Der Server rechnet noch an %1, das hier vorher offen war.</translation>
    </message>
    <message>
        <source>Open documents: %1, connections: %2</source>
        <translation>Offene Dokumente: %1, Verbindungen: %2</translation>
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
    <message>
        <source>Server and workers</source>
        <translation>Server und Arbeitsprozesse</translation>
    </message>
    <message>
        <source>What the server is, its memory, and the machines that work for it</source>
        <translation>Was der Server ist, sein Speicher und die Rechner, die für ihn arbeiten</translation>
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
        <translation>Streckgrenze</translation>
    </message>
    <message>
        <source>Regions of the mesh</source>
        <translation>Bereiche des Netzes</translation>
    </message>
    <message>
        <source>all that no other material names</source>
        <translation>alle übrigen</translation>
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
        <translation>  · geändert</translation>
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
    <name>tedit::desktop::polyline_field</name>
    <message>
        <source>Click an edge of the part to go along</source>
        <translation>Eine Kante des Teils anklicken, an der es entlanggeht</translation>
    </message>
    <message>
        <source>x; y; z in %1, a line for each point</source>
        <translation>x; y; z in %1, eine Zeile für jeden Punkt</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
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
    <message>
        <source>Its shape alone, as while it was dragged: ask for the preview, or apply it.</source>
        <translation>Nur seine Form, wie beim Ziehen: Fordern Sie die Vorschau an oder wenden Sie es an.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::print_panel</name>
    <message>
        <source>Least wall thickness</source>
        <translation>Kleinste Wandstärke</translation>
    </message>
    <message>
        <source>not looked for</source>
        <translation>nicht gesucht</translation>
    </message>
    <message>
        <source>Largest overhang</source>
        <translation>Größter Überhang</translation>
    </message>
    <message>
        <source>From the build direction: 0 is an upright wall, 90 a ceiling</source>
        <translation>Von der Baurichtung aus: 0 ist eine senkrechte Wand, 90 eine Decke</translation>
    </message>
    <message>
        <source>Build direction</source>
        <translation>Baurichtung</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>z, downwards</source>
        <translation>z, abwärts</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x, backwards</source>
        <translation>x, rückwärts</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y, backwards</source>
        <translation>y, rückwärts</translation>
    </message>
    <message>
        <source>Off the selected flat wall</source>
        <translation>Weg von der gewählten ebenen Wand</translation>
    </message>
    <message>
        <source>From the plate on</source>
        <translation>Von der Bauplatte aus</translation>
    </message>
    <message>
        <source>Least wall</source>
        <translation>Kleinste Wand</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überhang</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>dünn</translation>
    </message>
    <message>
        <source>overhanging</source>
        <translation>überhängend</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beides</translation>
    </message>
    <message>
        <source>The least wall is a length, as 1.2; empty: thin walls are not looked for.</source>
        <translation>Die kleinste Wand ist eine Länge, etwa 1,2; leer: dünne Wände werden nicht gesucht.</translation>
    </message>
    <message>
        <source>The overhang is an angle from 0° (an upright wall) to 90° (a ceiling).</source>
        <translation>Der Überhang ist ein Winkel von 0° (eine senkrechte Wand) bis 90° (eine Decke).</translation>
    </message>
    <message>
        <source>Select one flat wall: it lies on the plate, and the part is built away from it.</source>
        <translation>Eine ebene Wand auswählen: Sie liegt auf der Bauplatte, und das Teil wird von ihr weg gebaut.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Checking ...</source>
        <translation>Wird geprüft ...</translation>
    </message>
    <message>
        <source>Something in version %1 hinders printing.</source>
        <translation>In Version %1 steht etwas dem Druck im Weg.</translation>
    </message>
    <message>
        <source>Nothing in version %1 hinders printing.</source>
        <translation>In Version %1 steht dem Druck nichts im Weg.</translation>
    </message>
    <message>
        <source>A click turns the view there, Enter picks the surfaces</source>
        <translation>Ein Klick dreht die Ansicht dorthin, die Eingabetaste wählt die Flächen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::print_tool</name>
    <message>
        <source>Check for printing</source>
        <translation>Auf Druckbarkeit prüfen</translation>
    </message>
    <message>
        <source>Watertight, thin walls and overhangs, marked on the part; volume and bounding box</source>
        <translation>Wasserdicht, dünne Wände und Überhänge, am Teil markiert; Volumen und umgebender Quader</translation>
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
        <source>Recipes for other meshes and sizes, surfaces by name and place (*.json)</source>
        <translation>Rezepte für andere Netze und Größen, Flächen nach Name und Ort (*.json)</translation>
    </message>
    <message>
        <source>Recipes, surfaces by number (*.json)</source>
        <translation>Rezepte, Flächen nach Nummer (*.json)</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::remesh_form</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Mesh anew with another size</source>
        <translation>Neu vernetzen, mit anderer Größe</translation>
    </message>
    <message>
        <source>Coarse: one quadratic tet through a usual wall</source>
        <translation>Grob: ein quadratischer Tetraeder durch eine übliche Wand</translation>
    </message>
    <message>
        <source>Medium: two</source>
        <translation>Mittel: zwei</translation>
    </message>
    <message>
        <source>Fine: three</source>
        <translation>Fein: drei</translation>
    </message>
    <message>
        <source>as elsewhere</source>
        <translation>wie sonst</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>How fine</source>
        <translation>Wie fein</translation>
    </message>
    <message>
        <source>Longest edge on what is picked</source>
        <translation>Längste Kante auf dem Gewählten</translation>
    </message>
    <message>
        <source>Nothing is picked: pick walls of the part to give them a length of their own.</source>
        <translation>Nichts ist gewählt: Wände des Bauteils wählen, um ihnen eine eigene Länge zu geben.</translation>
    </message>
    <message>
        <source>Picked: %1.</source>
        <translation>Gewählt: %1.</translation>
    </message>
    <message>
        <source>%1 is read once more, into a new document. Edits and loads of this document stay in this one.</source>
        <translation>%1 wird noch einmal gelesen, in ein neues Dokument. Änderungen und Lasten dieses Dokuments bleiben in diesem.</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::remeshing</name>
    <message>
        <source>Mesh anew with another size</source>
        <translation>Neu vernetzen, mit anderer Größe</translation>
    </message>
    <message>
        <source>Reads the part&apos;s CAD file once more: finer or coarser, with shorter edges on picked walls</source>
        <translation>Liest die CAD-Datei des Bauteils noch einmal: feiner oder gröber, mit kürzeren Kanten auf gewählten Wänden</translation>
    </message>
    <message>
        <source>The part was not meshed from a CAD file since the window was opened: open its STEP, IGES or BREP file</source>
        <translation>Das Bauteil wurde nicht aus einer CAD-Datei vernetzt, seit das Fenster offen ist: seine STEP-, IGES- oder BREP-Datei öffnen</translation>
    </message>
    <message>
        <source>meshing %1 anew</source>
        <translation>%1 wird neu vernetzt</translation>
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
    <message>
        <source>deformation × %1</source>
        <translation>Verformung × %1</translation>
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
    <message>
        <source>Show everything (Shift+H)</source>
        <translation>Alles zeigen (Umschalt+H)</translation>
    </message>
    <message>
        <source>Hidden surfaces: %1 - show all</source>
        <translation>Ausgeblendete Flächen: %1 - alle zeigen</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::server_dialog</name>
    <message>
        <source>Server and workers</source>
        <translation>Server und Arbeitsprozesse</translation>
    </message>
    <message>
        <source>All work is done on the server&apos;s own machine. How workers on others join it stands in the manual, &quot;Workers on other machines&quot;.</source>
        <translation>Alles wird auf dem Rechner des Servers selbst gerechnet. Wie andere Rechner dazukommen, steht im Handbuch unter „Workers on other machines“.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>All that stands here, for a mail or a spreadsheet</source>
        <translation>Alles, was hier steht, für eine E-Mail oder eine Tabelle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>There is no connection to a server. It is started when a part is opened.</source>
        <translation>Es gibt keine Verbindung zu einem Server. Er wird gestartet, wenn ein Bauteil geöffnet wird.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 unter %2</translation>
    </message>
    <message>
        <source>Answers in %1</source>
        <translation>Antwortet in %1</translation>
    </message>
    <message>
        <source>Open documents: %1, connections: %2</source>
        <translation>Offene Dokumente: %1, Verbindungen: %2</translation>
    </message>
</context>
<context>
    <name>tedit::desktop::server_library</name>
    <message>
        <source>Documents on the server</source>
        <translation>Dokumente auf dem Server</translation>
    </message>
    <message>
        <source>Which there are, to be opened, copied, renamed or deleted</source>
        <translation>Welche es gibt; zum Öffnen, Kopieren, Umbenennen oder Löschen</translation>
    </message>
    <message>
        <source>%1 is a copy of %2 now.</source>
        <translation>%1 ist jetzt eine Kopie von %2.</translation>
    </message>
    <message>
        <source>%1 is called %2 now.</source>
        <translation>%1 heißt jetzt %2.</translation>
    </message>
    <message>
        <source>%1 is deleted.</source>
        <translation>%1 ist gelöscht.</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Kopie von %1</translation>
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
    <name>tedit::desktop::trust_dialog</name>
    <message>
        <source>Is this the right server?</source>
        <translation>Ist das der richtige Server?</translation>
    </message>
    <message>
        <source>The server at %1 is not known here, and no authority that this computer trusts vouches for it. Its certificate ends on %2 and has the fingerprint (SHA-256):</source>
        <translation>Der Server bei %1 ist hier nicht bekannt, und keine Zertifizierungsstelle, der dieser Rechner vertraut, steht für ihn ein. Sein Zertifikat endet am %2 und hat den Fingerabdruck (SHA-256):</translation>
    </message>
    <message>
        <source>The server at %1 shows another certificate than the one that you trust. Either it was exchanged, or somebody stands between you and the server. You trust:</source>
        <translation>Der Server bei %1 zeigt ein anderes Zertifikat als das, dem Sie vertrauen. Entweder wurde es ausgetauscht, oder jemand steht zwischen Ihnen und dem Server. Sie vertrauen:</translation>
    </message>
    <message>
        <source>It shows one that ends on %1:</source>
        <translation>Er zeigt eines, das am %1 endet:</translation>
    </message>
    <message>
        <source>Trust it only if the operator of the server says the same one; &quot;tedit serve&quot; prints it. It is then known on this computer.</source>
        <translation>Vertrauen Sie ihm nur, wenn der Betreiber des Servers denselben nennt; „tedit serve“ gibt ihn aus. Er ist dann auf diesem Rechner bekannt.</translation>
    </message>
    <message>
        <source>Trust this server</source>
        <translation>Diesem Server vertrauen</translation>
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
        <translation>wartend: %1</translation>
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
    <message>
        <source>somebody</source>
        <translation>jemand</translation>
    </message>
    <message>
        <source>%1 watches since %2</source>
        <translation>%1 sieht zu seit: %2</translation>
    </message>
    <message>
        <source>%1 is here since %2</source>
        <translation>%1 ist hier seit: %2</translation>
    </message>
    <message>
        <source>also here: %1</source>
        <translation>auch hier: %1</translation>
    </message>
    <message>
        <source>%1 others here</source>
        <translation>%1 andere hier</translation>
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
    <message>
        <source>Open a CAD file (STEP, IGES, BREP) or a tetrahedral mesh with surface ids (Gmsh .msh) by dropping it here, or start with a shipped part:</source>
        <translation>Eine CAD-Datei (STEP, IGES, BREP) oder ein Tetraedernetz mit Flächennummern (Gmsh .msh) hierher ziehen oder mit einem mitgelieferten Teil beginnen:</translation>
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
