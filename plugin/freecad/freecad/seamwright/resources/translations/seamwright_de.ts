<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A larger move is refused, in mm; 0: no limit</source>
        <translation>Eine größere Verschiebung wird abgelehnt, in mm; 0: keine Grenze</translation>
    </message>
    <message>
        <source>A seam counts as an intended crease if its angle is larger than this, in degrees</source>
        <translation>Eine Naht gilt als gewollte Knickkante, wenn ihr Winkel größer ist, in Grad</translation>
    </message>
    <message>
        <source>A side counts as flat if all its radii of curvature are larger than this, in mm</source>
        <translation>Eine Seite gilt als eben, wenn alle ihre Krümmungsradien größer sind, in mm</translation>
    </message>
    <message>
        <source>A side of a hole ends where its tangent turns by more than this, in degrees</source>
        <translation>Eine Seite eines Lochs endet, wo ihre Tangente sich um mehr dreht, in Grad</translation>
    </message>
    <message>
        <source>Also measure points that lie beyond a free edge of the other shape: their distance is that to the edge, and has no sign</source>
        <translation>Auch Punkte messen, die jenseits einer freien Kante der anderen Form liegen: Ihr Abstand ist der zur Kante und hat kein Vorzeichen</translation>
    </message>
    <message>
        <source>Angle by which the stripes lean; 0: upright, 90: level</source>
        <translation>Winkel, um den die Streifen geneigt sind; 0: senkrecht, 90: waagrecht</translation>
    </message>
    <message>
        <source>Angle from one isophote to the next</source>
        <translation>Winkel von einer Isophote zur nächsten</translation>
    </message>
    <message>
        <source>Angle of the seam after the match, in degrees</source>
        <translation>Winkel der Naht nach der Anpassung, in Grad</translation>
    </message>
    <message>
        <source>Angle of the seam before the match, in degrees</source>
        <translation>Winkel der Naht vor der Anpassung, in Grad</translation>
    </message>
    <message>
        <source>Arcs and other rational edges stay as they are, and the faces are rational</source>
        <translation>Bögen und andere rationale Kanten bleiben, wie sie sind, und die Flächen sind rational</translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written</source>
        <translation>Bei wie vielen der schlechtesten gezeigten Nähte der größte Wert angeschrieben wird</translation>
    </message>
    <message>
        <source>Automatic: the colours cover all values but the outermost 2 % of the area</source>
        <translation>Automatisch: Die Farben decken alle Werte außer den äußersten 2 % der Fläche ab</translation>
    </message>
    <message>
        <source>Begin at the other end of the first edge</source>
        <translation>Am anderen Ende der ersten Kante beginnen</translation>
    </message>
    <message>
        <source>Begin at the other end of the first of two edges</source>
        <translation>Am anderen Ende der ersten von zwei Kanten beginnen</translation>
    </message>
    <message>
        <source>Below 1 an ellipse, 1 a parabola, above 1 a hyperbola</source>
        <translation>Unter 1 eine Ellipse, 1 eine Parabel, über 1 eine Hyperbel</translation>
    </message>
    <message>
        <source>By how much the points of the sources were moved, in mm; one for each, or none</source>
        <translation>Um wie viel die Punkte der Quellen verschoben wurden, in mm; für jeden einer, oder keiner</translation>
    </message>
    <message>
        <source>By how much the tangent turns, in degrees</source>
        <translation>Um wie viel sich die Tangente dreht, in Grad</translation>
    </message>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation>Schließt Löcher des ausgewählten Objekts mit Flächen, die tangential an ihre Nachbarn anschließen. Um nur einige Löcher zu füllen, je eine Kante auswählen. Um eine Fläche zu ersetzen, diese auswählen.</translation>
    </message>
    <message>
        <source>Colour each point by how far it moved, with a legend</source>
        <translation>Jeden Punkt danach färben, wie weit er verschoben wurde, mit Legende</translation>
    </message>
    <message>
        <source>Direction at the first point, against the first axis of the plane, in degrees</source>
        <translation>Richtung am ersten Punkt gegen die erste Achse der Ebene, in Grad</translation>
    </message>
    <message>
        <source>Direction at the last point, against the first axis of the plane, in degrees</source>
        <translation>Richtung am letzten Punkt gegen die erste Achse der Ebene, in Grad</translation>
    </message>
    <message>
        <source>Distance from one lamp to the next; 0: 12 lamps over the model</source>
        <translation>Abstand von einer Lampe zur nächsten; 0: 12 Lampen über dem Modell</translation>
    </message>
    <message>
        <source>Distance from the curves, in mm</source>
        <translation>Abstand von den Kurven, in mm</translation>
    </message>
    <message>
        <source>Distance of the ends before, in mm</source>
        <translation>Abstand der Enden vorher, in mm</translation>
    </message>
    <message>
        <source>Distances from the vertex at which the fillets end, in mm, in the order of CornerEdges, or one distance for all edges; 0 or empty: automatic</source>
        <translation>Abstände vom Eckpunkt, in denen die Verrundungen enden, in mm, in der Reihenfolge von CornerEdges, oder ein Abstand für alle Kanten; 0 oder leer: automatisch</translation>
    </message>
    <message>
        <source>Divide the selected curves into corresponding pieces; otherwise, splines near them take their place, so that the curves between are fairer</source>
        <translation>Die gewählten Kurven in einander entsprechende Stücke teilen; sonst treten Splines nahe bei ihnen an ihre Stelle, so dass die Kurven dazwischen glatter sind</translation>
    </message>
    <message>
        <source>Draw the curvature comb</source>
        <translation>Den Krümmungskamm zeichnen</translation>
    </message>
    <message>
        <source>Edges at which the faces end: one or two from the end of an edge to that of the next</source>
        <translation>Kanten, an denen die Flächen enden: eine oder zwei vom Ende einer Kante zu dem der nächsten</translation>
    </message>
    <message>
        <source>Edges at which two faces meet, or edges side by side</source>
        <translation>Kanten, an denen zwei Flächen sich treffen, oder Kanten, die nebeneinander liegen</translation>
    </message>
    <message>
        <source>Edges between the ends of the sides, along which the lateral boundaries run, and the faces beside them</source>
        <translation>Kanten zwischen den Enden der Seiten, an denen die seitlichen Ränder verlaufen, und die Flächen daneben</translation>
    </message>
    <message>
        <source>Edges of the first side, and faces to continue</source>
        <translation>Kanten der ersten Seite und fortzusetzende Flächen</translation>
    </message>
    <message>
        <source>Edges of the second side, and faces to continue</source>
        <translation>Kanten der zweiten Seite und fortzusetzende Flächen</translation>
    </message>
    <message>
        <source>Edges of the side, and faces to continue</source>
        <translation>Kanten der Seite und fortzusetzende Flächen</translation>
    </message>
    <message>
        <source>Edges, wires or faces</source>
        <translation>Kanten, Drähte oder Flächen</translation>
    </message>
    <message>
        <source>Edges, wires or sketches from which the surface is made</source>
        <translation>Kanten, Drähte oder Skizzen, aus denen die Fläche entsteht</translation>
    </message>
    <message>
        <source>End at the other end of the second edge</source>
        <translation>Am anderen Ende der zweiten Kante enden</translation>
    </message>
    <message>
        <source>End at the other end of the second of two edges</source>
        <translation>Am anderen Ende der zweiten von zwei Kanten enden</translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation>Extrema der Krümmung</translation>
    </message>
    <message>
        <source>Extrema of the curvature before</source>
        <translation>Extrema der Krümmung vorher</translation>
    </message>
    <message>
        <source>Extrema of the curvature now</source>
        <translation>Extrema der Krümmung jetzt</translation>
    </message>
    <message>
        <source>Faces that must not move</source>
        <translation>Flächen, die sich nicht verändern dürfen</translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the half that is pulled</source>
        <translation>Flächen mit mindestens dieser Formschräge lösen sich aus der Hälfte, die gezogen wird</translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the other half</source>
        <translation>Flächen mit mindestens dieser Formschräge lösen sich aus der anderen Hälfte</translation>
    </message>
    <message>
        <source>Factor by which the variation of the curvature of a face may grow</source>
        <translation>Faktor, um den die Änderung der Krümmung einer Fläche wachsen darf</translation>
    </message>
    <message>
        <source>Four-sided faces, or three-sided ones, which are three faces each</source>
        <translation>Vierseitige Flächen, oder dreiseitige, die je drei Flächen sind</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are a seam, in mm</source>
        <translation>Freie Kanten, die nicht weiter voneinander entfernt sind, sind eine Naht, in mm</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are measured as seams too, in mm; 0: off</source>
        <translation>Freie Kanten mit höchstens diesem Abstand werden auch als Nähte gemessen, in mm; 0: aus</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are repaired as seams too, in mm; 0: off</source>
        <translation>Freie Kanten mit höchstens diesem Abstand werden auch als Nähte repariert, in mm; 0: aus</translation>
    </message>
    <message>
        <source>Free edges no further apart than this may be the common boundary, in mm</source>
        <translation>Freie Kanten mit höchstens diesem Abstand können der gemeinsame Rand sein, in mm</translation>
    </message>
    <message>
        <source>From the first point to the next pole, in mm; 0: the end is free</source>
        <translation>Vom ersten Punkt zum nächsten Kontrollpunkt, in mm; 0: Das Ende ist frei</translation>
    </message>
    <message>
        <source>From the last pole but one to the last point, in mm; 0: the end is free</source>
        <translation>Vom vorletzten Kontrollpunkt zum letzten Punkt, in mm; 0: Das Ende ist frei</translation>
    </message>
    <message>
        <source>From the middle of the model; 0: half of the size of the model</source>
        <translation>Von der Mitte des Modells; 0: die halbe Größe des Modells</translation>
    </message>
    <message>
        <source>Further faces that the moving face joins as the other face, or edges of them</source>
        <translation>Weitere Flächen, an die die verschobene Fläche wie an die andere anschließt, oder Kanten von ihnen</translation>
    </message>
    <message>
        <source>Gap of the seam after the match, in mm</source>
        <translation>Spalt der Naht nach der Anpassung, in mm</translation>
    </message>
    <message>
        <source>Gap of the seam before the match, in mm</source>
        <translation>Spalt der Naht vor der Anpassung, in mm</translation>
    </message>
    <message>
        <source>Height of the legend's letters, in pixels</source>
        <translation>Höhe der Buchstaben der Legende, in Pixeln</translation>
    </message>
    <message>
        <source>How far from the seam the moved face may change, in mm; 0: as little as needed</source>
        <translation>Wie weit von der Naht die verschobene Fläche geändert werden darf, in mm; 0: so wenig wie nötig</translation>
    </message>
    <message>
        <source>How far the surface keeps its direction, by the distance of the sides</source>
        <translation>Wie weit die Fläche ihre Richtung behält, im Verhältnis zum Abstand der Seiten</translation>
    </message>
    <message>
        <source>How smoothly the curves between change at a selected curve that is neither the first nor the last</source>
        <translation>Wie glatt sich die Zwischenkurven an einer gewählten Kurve ändern, die weder die erste noch die letzte ist</translation>
    </message>
    <message>
        <source>How the spline is made of the points</source>
        <translation>Wie der Spline aus den Punkten entsteht</translation>
    </message>
    <message>
        <source>Inflections of a planar curve</source>
        <translation>Wendepunkte einer ebenen Kurve</translation>
    </message>
    <message>
        <source>Iso-curves of a face in each direction</source>
        <translation>Isolinien einer Fläche in jeder Richtung</translation>
    </message>
    <message>
        <source>Join the last point to the first; wires that are closed always are</source>
        <translation>Den letzten Punkt mit dem ersten verbinden; geschlossene Drähte sind es immer</translation>
    </message>
    <message>
        <source>Joints at which the curvature jumps</source>
        <translation>Verbindungsstellen, an denen die Krümmung springt</translation>
    </message>
    <message>
        <source>Keep a fill even if it misses the target</source>
        <translation>Eine Füllung behalten, auch wenn sie die Zielstufe verfehlt</translation>
    </message>
    <message>
        <source>Keep the two other boundaries that end at the seam</source>
        <translation>Die beiden anderen Ränder, die an der Naht enden, beibehalten</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that is G1, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen einer Naht, die G1 ist, in Grad</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that meets G1, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen einer Naht, die G1 erreicht, in Grad</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam for G1 and G2, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen jeder neuen Naht für G1 und G2, in Grad</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen jeder neuen Naht, in Grad</translation>
    </message>
    <message>
        <source>Largest angle of a tangent with the plane of all tangents, in degrees; the edges are turned into that plane</source>
        <translation>Größter Winkel einer Tangente mit der Ebene aller Tangenten, in Grad; die Kanten werden in diese Ebene gedreht</translation>
    </message>
    <message>
        <source>Largest angle seen after the repair, creases excluded, in degrees</source>
        <translation>Größter gesehener Winkel nach der Reparatur, ohne Knickkanten, in Grad</translation>
    </message>
    <message>
        <source>Largest angle seen before the repair, creases excluded, in degrees</source>
        <translation>Größter gesehener Winkel vor der Reparatur, ohne Knickkanten, in Grad</translation>
    </message>
    <message>
        <source>Largest angle that was seen, creases excluded, in degrees</source>
        <translation>Größter gesehener Winkel, ohne Knickkanten, in Grad</translation>
    </message>
    <message>
        <source>Largest angle that was seen, in degrees</source>
        <translation>Größter gesehener Winkel, in Grad</translation>
    </message>
    <message>
        <source>Largest curvature, in 1/mm</source>
        <translation>Größte Krümmung, in 1/mm</translation>
    </message>
    <message>
        <source>Largest distance between the sides of the patches and the fillets, in mm</source>
        <translation>Größter Abstand zwischen den Seiten der Flächenstücke und der Verrundungen, in mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam that meets G0, in mm</source>
        <translation>Größter Abstand zwischen den beiden Seiten einer Naht, die G0 erreicht, in mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam, in mm</source>
        <translation>Größter Abstand zwischen den beiden Seiten einer Naht, in mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of each new seam, in mm</source>
        <translation>Größter Abstand zwischen den beiden Seiten jeder neuen Naht, in mm</translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the input, in both directions, in mm</source>
        <translation>Größter Abstand der Bögen von der Eingabe, in beiden Richtungen, in mm</translation>
    </message>
    <message>
        <source>Largest distance of the clothoids from edges, in mm; points are passed through</source>
        <translation>Größter Abstand der Klothoiden von Kanten, in mm; durch Punkte laufen sie</translation>
    </message>
    <message>
        <source>Largest distance of the curves that take the place of edges which are no single polynomial curve, such as arcs, in mm</source>
        <translation>Größter Abstand der Kurven, die an die Stelle von Kanten treten, die keine einzelne polynomiale Kurve sind, etwa von Bögen, in mm</translation>
    </message>
    <message>
        <source>Largest distance of the ends of the edges from their mean, in mm</source>
        <translation>Größter Abstand der Enden der Kanten von ihrem Mittel, in mm</translation>
    </message>
    <message>
        <source>Largest distance of the splines from the spiral, in mm</source>
        <translation>Größter Abstand der Splines von der Spirale, in mm</translation>
    </message>
    <message>
        <source>Largest distance of these splines and of the surface, in mm</source>
        <translation>Größter Abstand dieser Splines und der Fläche, in mm</translation>
    </message>
    <message>
        <source>Largest gap seen after the repair, creases excluded, in mm</source>
        <translation>Größter gesehener Spalt nach der Reparatur, ohne Knickkanten, in mm</translation>
    </message>
    <message>
        <source>Largest gap seen before the repair, creases excluded, in mm</source>
        <translation>Größter gesehener Spalt vor der Reparatur, ohne Knickkanten, in mm</translation>
    </message>
    <message>
        <source>Largest gap that was seen, creases excluded, in mm</source>
        <translation>Größter gesehener Spalt, ohne Knickkanten, in mm</translation>
    </message>
    <message>
        <source>Largest gap that was seen, in mm</source>
        <translation>Größter gesehener Spalt, in mm</translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm</source>
        <translation>Größte Verschiebung eines Kontrollpunkts, in mm</translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm; no point of a face moved further</source>
        <translation>Größte Verschiebung eines Kontrollpunkts, in mm; kein Punkt einer Fläche wurde weiter verschoben</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that is G2; 0.02 is 2 %</source>
        <translation>Größter relativer Unterschied der Krümmung einer Naht, die G2 ist; 0.02 ist 2 %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that meets G2; 0.02 is 2 %</source>
        <translation>Größter relativer Unterschied der Krümmung einer Naht, die G2 erreicht; 0.02 ist 2 %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of each new seam for G2; 0.02 is 2 %</source>
        <translation>Größter relativer Unterschied der Krümmung jeder neuen Naht für G2; 0.02 ist 2 %</translation>
    </message>
    <message>
        <source>Length of the lines of the comb; 1: the longest is 15 % of the size of the curve</source>
        <translation>Länge der Linien des Kamms; 1: Die längste ist 15 % der Größe der Kurve</translation>
    </message>
    <message>
        <source>Length of the lines; 1: the longest is 15 % of the size of all curves</source>
        <translation>Länge der Linien; 1: Die längste ist 15 % der Größe aller Kurven</translation>
    </message>
    <message>
        <source>Length of the surface, in mm</source>
        <translation>Länge der Fläche, in mm</translation>
    </message>
    <message>
        <source>Length of the tangent at the first edge, by the distance of the ends</source>
        <translation>Länge der Tangente an der ersten Kante, im Verhältnis zum Abstand der Enden</translation>
    </message>
    <message>
        <source>Length of the tangent at the second edge, by the distance of the ends</source>
        <translation>Länge der Tangente an der zweiten Kante, im Verhältnis zum Abstand der Enden</translation>
    </message>
    <message>
        <source>Let the end run in the other direction than that in which the surface is less twisted; lateral boundaries say the direction</source>
        <translation>Das Ende in der anderen Richtung als der laufen lassen, in der die Fläche weniger verdreht ist; seitliche Ränder geben die Richtung vor</translation>
    </message>
    <message>
        <source>Level of continuity after the match</source>
        <translation>Stufe der Stetigkeit nach der Anpassung</translation>
    </message>
    <message>
        <source>Level of continuity before the match</source>
        <translation>Stufe der Stetigkeit vor der Anpassung</translation>
    </message>
    <message>
        <source>Level of continuity to reach</source>
        <translation>Zu erreichende Stufe der Stetigkeit</translation>
    </message>
    <message>
        <source>Level that every new seam must meet; G0: position only</source>
        <translation>Stufe, die jede neue Naht erreichen muss; G0: nur Position</translation>
    </message>
    <message>
        <source>Level that every seam should meet</source>
        <translation>Stufe, die jede Naht erreichen soll</translation>
    </message>
    <message>
        <source>Light stripes on a whole ball</source>
        <translation>Helle Streifen auf einer ganzen Kugel</translation>
    </message>
    <message>
        <source>Lines of the comb on each curve</source>
        <translation>Linien des Kamms auf jeder Kurve</translation>
    </message>
    <message>
        <source>Make no face in the largest sector between two edges</source>
        <translation>Im größten Sektor zwischen zwei Kanten keine Fläche erzeugen</translation>
    </message>
    <message>
        <source>Mean: half the sum of the principal curvatures. Gaussian: their product. Largest: the larger one without its sign. Smallest radius: 1 by the largest curvature</source>
        <translation>Mittlere: die halbe Summe der Hauptkrümmungen. Gaußsche: ihr Produkt. Größte: die größere ohne ihr Vorzeichen. Kleinster Radius: 1 durch die größte Krümmung</translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation>Misst Spalt, Winkel und Krümmung, wo Flächen der ausgewählten Objekte sich treffen, und färbt die Nähte nach dem Ergebnis. Ohne Auswahl werden alle Körper und Schalen des Dokuments analysiert, oder wenn es keine hat, alle Flächen.</translation>
    </message>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation>Verschiebt Flächen des ausgewählten Objekts so wenig wie möglich, bis seine Nähte glatt sind: ohne Knick (G1) oder mit gleicher Krümmung (G2). Um nur einige Nähte zu reparieren, deren Kanten oder Zeilen einer Analyse auswählen.</translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation>Verschiebt die zweite von zwei ausgewählten Flächen, oder beide, bis sie ohne Knick (G1) oder mit gleicher Krümmung (G2) aneinanderschließen. Haben sie mehrere gemeinsame Kanten, auch die anzupassende Kante auswählen. Von mehr Flächen wird die letzte verschoben und schließt an alle anderen an; Kanten stehen für ihre Flächen.</translation>
    </message>
    <message>
        <source>Names of the Sources at the last analysis</source>
        <translation>Namen der Sources bei der letzten Analyse</translation>
    </message>
    <message>
        <source>No point moved further, in mm</source>
        <translation>Kein Punkt wurde weiter verschoben, in mm</translation>
    </message>
    <message>
        <source>No point moves further than this, in mm</source>
        <translation>Kein Punkt wird weiter als so verschoben, in mm</translation>
    </message>
    <message>
        <source>No point of a face may move further than this, in mm; 0: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation>Kein Punkt einer Fläche darf weiter verschoben werden, in mm; 0: ein Hundertstel der Größe der Fläche plus der doppelte größte Spalt ihrer Nähte</translation>
    </message>
    <message>
        <source>No pole may move further than this, in mm; 0: no limit</source>
        <translation>Kein Kontrollpunkt darf weiter verschoben werden, in mm; 0: keine Grenze</translation>
    </message>
    <message>
        <source>No pole of an edge moved further, in mm</source>
        <translation>Kein Kontrollpunkt einer Kante wurde weiter verschoben, in mm</translation>
    </message>
    <message>
        <source>No pole, or no point of a continuation, moved further, in mm</source>
        <translation>Kein Kontrollpunkt, oder kein Punkt einer Fortsetzung, wurde weiter verschoben, in mm</translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation>Anzahl der Bögen</translation>
    </message>
    <message>
        <source>Number of arcs; 0: as few as possible</source>
        <translation>Anzahl der Bögen; 0: so wenige wie möglich</translation>
    </message>
    <message>
        <source>Number of clothoids, arcs and lines</source>
        <translation>Anzahl der Klothoiden, Bögen und Strecken</translation>
    </message>
    <message>
        <source>Number of conics</source>
        <translation>Anzahl der Kegelschnitte</translation>
    </message>
    <message>
        <source>Number of curves with a comb</source>
        <translation>Anzahl der Kurven mit einem Kamm</translation>
    </message>
    <message>
        <source>Number of curves, with the first and the last of the selected ones</source>
        <translation>Anzahl der Kurven, mit der ersten und der letzten der gewählten</translation>
    </message>
    <message>
        <source>Number of defects after the repair</source>
        <translation>Anzahl der Fehler nach der Reparatur</translation>
    </message>
    <message>
        <source>Number of defects before the repair</source>
        <translation>Anzahl der Fehler vor der Reparatur</translation>
    </message>
    <message>
        <source>Number of edges that bound one face and are in no seam</source>
        <translation>Anzahl der Kanten, die eine Fläche begrenzen und in keiner Naht sind</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>Anzahl der Flächen</translation>
    </message>
    <message>
        <source>Number of faces of the surface</source>
        <translation>Anzahl der Einzelflächen der Fläche</translation>
    </message>
    <message>
        <source>Number of faces that moved</source>
        <translation>Anzahl der verschobenen Flächen</translation>
    </message>
    <message>
        <source>Number of holes that were filled</source>
        <translation>Anzahl der gefüllten Löcher</translation>
    </message>
    <message>
        <source>Number of holes that were to be filled</source>
        <translation>Anzahl der zu füllenden Löcher</translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation>Anzahl der Linien</translation>
    </message>
    <message>
        <source>Number of lines of the comb, on all edges together</source>
        <translation>Anzahl der Linien des Kamms, auf allen Kanten zusammen</translation>
    </message>
    <message>
        <source>Number of new faces</source>
        <translation>Anzahl der neuen Flächen</translation>
    </message>
    <message>
        <source>Number of patches of the corner</source>
        <translation>Anzahl der Flächenstücke der Ecke</translation>
    </message>
    <message>
        <source>Number of points at which each seam is sampled</source>
        <translation>Anzahl der Punkte, an denen jede Naht gemessen wird</translation>
    </message>
    <message>
        <source>Number of points taken between the ends of each edge that is not straight</source>
        <translation>Anzahl der Punkte zwischen den Enden jeder Kante, die nicht gerade ist</translation>
    </message>
    <message>
        <source>Number of seams</source>
        <translation>Anzahl der Nähte</translation>
    </message>
    <message>
        <source>Number of seams of two free edges that lie side by side</source>
        <translation>Anzahl der Nähte aus zwei freien Kanten, die nebeneinander liegen</translation>
    </message>
    <message>
        <source>Number of seams sharper than the crease angle</source>
        <translation>Anzahl der Nähte, die schärfer sind als der Winkel einer Knickkante</translation>
    </message>
    <message>
        <source>Number of seams that fall short of the level</source>
        <translation>Anzahl der Nähte, die die Stufe verfehlen</translation>
    </message>
    <message>
        <source>Number of seams that were repaired</source>
        <translation>Anzahl der reparierten Nähte</translation>
    </message>
    <message>
        <source>Number of seams that were to be repaired</source>
        <translation>Anzahl der zu reparierenden Nähte</translation>
    </message>
    <message>
        <source>Number of seams whose verdict is not certain</source>
        <translation>Anzahl der Nähte, deren Urteil nicht sicher ist</translation>
    </message>
    <message>
        <source>Objects with faces</source>
        <translation>Objekte mit Flächen</translation>
    </message>
    <message>
        <source>Of all faces; 0: the lowest that suffices</source>
        <translation>Aller Flächen; 0: der niedrigste, der ausreicht</translation>
    </message>
    <message>
        <source>One edge of each hole to fill; empty: all holes except outer boundaries</source>
        <translation>Je eine Kante der zu füllenden Löcher; leer: alle Löcher außer äußeren Rändern</translation>
    </message>
    <message>
        <source>One number above 0.5, up to 1, for each segment, or one for all: 1 is nearest to the polygon</source>
        <translation>Eine Zahl über 0.5, bis 1, für jedes Segment, oder eine für alle: 1 ist am nächsten am Polygon</translation>
    </message>
    <message>
        <source>One number for each point, or one for all. It tightens the spline: the larger the number without bias, the more negative with bias</source>
        <translation>Eine Zahl für jeden Punkt, oder eine für alle. Sie strafft den Spline: ohne Bias, je größer die Zahl, mit Bias, je negativer sie ist</translation>
    </message>
    <message>
        <source>One number for each point, or one for all: the speed before the point by that after it</source>
        <translation>Eine Zahl für jeden Punkt, oder eine für alle: die Geschwindigkeit vor dem Punkt durch die danach</translation>
    </message>
    <message>
        <source>One number for each segment, or one for all: 1 is the B-spline, smaller ones draw the curve to the polygon</source>
        <translation>Eine Zahl für jedes Segment, oder eine für alle: 1 ist der B-Spline, kleinere ziehen die Kurve zum Polygon</translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation>Die Dokumentation von Seamwright öffnen. Ist ein Objekt von Seamwright ausgewählt, öffnet sie sich beim Abschnitt über dessen Befehl.</translation>
    </message>
    <message>
        <source>Points and edges may be off their common plane by no more, in mm</source>
        <translation>Punkte und Kanten dürfen höchstens so weit von ihrer gemeinsamen Ebene liegen, in mm</translation>
    </message>
    <message>
        <source>Points of the spline that belong to no other object, in mm; where there are any, the sources are not used</source>
        <translation>Punkte des Splines, die keinem anderen Objekt gehören, in mm; gibt es welche, werden die Quellen nicht verwendet</translation>
    </message>
    <message>
        <source>Points, edges, wires or sketches from which the curve is made</source>
        <translation>Punkte, Kanten, Drähte oder Skizzen, aus denen die Kurve entsteht</translation>
    </message>
    <message>
        <source>Poles at the joint move as little as possible, or the second edge begins as the continuation of the first says</source>
        <translation>Kontrollpunkte an der Verbindungsstelle werden so wenig wie möglich verschoben, oder die zweite Kante beginnt, wie die Fortsetzung der ersten es vorgibt</translation>
    </message>
    <message>
        <source>Proven bound of the distance, in mm</source>
        <translation>Bewiesene Schranke des Abstands, in mm</translation>
    </message>
    <message>
        <source>Radii in mm, in the order of CornerEdges, or one radius for all edges</source>
        <translation>Radien in mm, in der Reihenfolge von CornerEdges, oder ein Radius für alle Kanten</translation>
    </message>
    <message>
        <source>Radius of curvature at the end, in mm</source>
        <translation>Krümmungsradius am Ende, in mm</translation>
    </message>
    <message>
        <source>Radius of curvature at the start, in mm</source>
        <translation>Krümmungsradius am Anfang, in mm</translation>
    </message>
    <message>
        <source>Relative difference of curvature after the match</source>
        <translation>Relativer Unterschied der Krümmung nach der Anpassung</translation>
    </message>
    <message>
        <source>Relative difference of curvature before the match</source>
        <translation>Relativer Unterschied der Krümmung vor der Anpassung</translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation>Verrundet die 3 bis 6 Kanten am ausgewählten Eckpunkt eines Körpers, jede mit eigenem Radius. Flächenstücke schließen die Ecke zwischen den Verrundungen ohne Knick.</translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its first inner pole lies; one number for each side, or one for all</source>
        <translation>Anteil jeder Seite des Polygons, bei dem ihr erster innerer Kontrollpunkt liegt; eine Zahl für jede Seite, oder eine für alle</translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its second inner pole lies; one number for each side, or one for all</source>
        <translation>Anteil jeder Seite des Polygons, bei dem ihr zweiter innerer Kontrollpunkt liegt; eine Zahl für jede Seite, oder eine für alle</translation>
    </message>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation>Zeigt, wie die Flächen der ausgewählten Objekte, oder aller sichtbaren Objekte, Streifen spiegeln. Die Streifen brechen ab, wo Flächen sich unter einem Winkel treffen, und knicken, wo die Krümmung springt. Ein erneuter Aufruf entfernt sie.</translation>
    </message>
    <message>
        <source>Show the legend in the view</source>
        <translation>Die Legende in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Single curves, or a surface</source>
        <translation>Einzelne Kurven, oder eine Fläche</translation>
    </message>
    <message>
        <source>Smallest radius, in mm; 0: straight</source>
        <translation>Kleinster Radius, in mm; 0: gerade</translation>
    </message>
    <message>
        <source>Splines near the spiral, or tangent arcs of one sweep whose radii are a geometric progression</source>
        <translation>Splines nahe der Spirale, oder tangentiale Bögen mit gleichem Drehwinkel, deren Radien eine geometrische Folge sind</translation>
    </message>
    <message>
        <source>The common edge along which the faces are matched; empty: the longest one</source>
        <translation>Die gemeinsame Kante, an der die Flächen angepasst werden; leer: die längste</translation>
    </message>
    <message>
        <source>The continuity of the faces across the edges: tangent planes (G1) or curvature, too (G2)</source>
        <translation>Der Übergang der Flächen über die Kanten: Tangentialebenen (G1) oder auch Krümmung (G2)</translation>
    </message>
    <message>
        <source>The continuity of the joint</source>
        <translation>Die Stetigkeit der Verbindungsstelle</translation>
    </message>
    <message>
        <source>The continuity that every joint keeps: tangents (G1), curvature (G2) or more</source>
        <translation>Die Stetigkeit, die jede Verbindungsstelle behält: Tangenten (G1), Krümmung (G2) oder mehr</translation>
    </message>
    <message>
        <source>The continuity with the faces beside the lateral boundaries</source>
        <translation>Die Stetigkeit mit den Flächen neben den seitlichen Rändern</translation>
    </message>
    <message>
        <source>The continuity with the faces of the end</source>
        <translation>Die Stetigkeit mit den Flächen des Endes</translation>
    </message>
    <message>
        <source>The continuity with the faces of the side; G1 is ruled</source>
        <translation>Die Stetigkeit mit den Flächen der Seite; G1 ist eine Regelfläche</translation>
    </message>
    <message>
        <source>The continuity with the faces of the start</source>
        <translation>Die Stetigkeit mit den Flächen des Anfangs</translation>
    </message>
    <message>
        <source>The continuity with the first edge</source>
        <translation>Die Stetigkeit mit der ersten Kante</translation>
    </message>
    <message>
        <source>The continuity with the second edge</source>
        <translation>Die Stetigkeit mit der zweiten Kante</translation>
    </message>
    <message>
        <source>The edge that moves</source>
        <translation>Die Kante, die verschoben wird</translation>
    </message>
    <message>
        <source>The edges at the vertex, in the order of Radii and Setbacks</source>
        <translation>Die Kanten am Eckpunkt, in der Reihenfolge von Radii und Setbacks</translation>
    </message>
    <message>
        <source>The edges of the seams to repair; empty: all defects</source>
        <translation>Die Kanten der zu reparierenden Nähte; leer: alle Fehler</translation>
    </message>
    <message>
        <source>The face at which the surface ends</source>
        <translation>Die Fläche, an der die Fläche endet</translation>
    </message>
    <message>
        <source>The face that moves; away from the seam it keeps its shape</source>
        <translation>Die Fläche, die verschoben wird; abseits der Naht behält sie ihre Form</translation>
    </message>
    <message>
        <source>The face to replace; empty: holes are filled</source>
        <translation>Die zu ersetzende Fläche; leer: Löcher werden gefüllt</translation>
    </message>
    <message>
        <source>The first face</source>
        <translation>Die erste Fläche</translation>
    </message>
    <message>
        <source>The largest value at the points of the mesh</source>
        <translation>Der größte Wert an den Punkten des Netzes</translation>
    </message>
    <message>
        <source>The least value at the points of the mesh</source>
        <translation>Der kleinste Wert an den Punkten des Netzes</translation>
    </message>
    <message>
        <source>The object whose holes are filled</source>
        <translation>Das Objekt, dessen Löcher gefüllt werden</translation>
    </message>
    <message>
        <source>The object whose holes are filled, or one of its faces</source>
        <translation>Das Objekt, dessen Löcher gefüllt werden, oder eine seiner Flächen</translation>
    </message>
    <message>
        <source>The object whose seams are repaired</source>
        <translation>Das Objekt, dessen Nähte repariert werden</translation>
    </message>
    <message>
        <source>The object with the corner</source>
        <translation>Das Objekt mit der Ecke</translation>
    </message>
    <message>
        <source>The objects from which distances are measured</source>
        <translation>Die Objekte, von denen aus Abstände gemessen werden</translation>
    </message>
    <message>
        <source>The objects that were analysed</source>
        <translation>Die Objekte, die analysiert wurden</translation>
    </message>
    <message>
        <source>The objects to analyse; empty: all solids and shells of the document, or where it has none, all objects with faces</source>
        <translation>Die zu analysierenden Objekte; leer: alle Körper und Schalen des Dokuments, oder wenn es keine hat, alle Objekte mit Flächen</translation>
    </message>
    <message>
        <source>The objects whose points are measured and coloured</source>
        <translation>Die Objekte, deren Punkte gemessen und gefärbt werden</translation>
    </message>
    <message>
        <source>The report of the kernel, as JSON</source>
        <translation>Der Bericht des Kerns, als JSON</translation>
    </message>
    <message>
        <source>The result in one line, or why there is none</source>
        <translation>Das Ergebnis in einer Zeile, oder warum es keines gibt</translation>
    </message>
    <message>
        <source>The seams that are shown in the view and in the table</source>
        <translation>Die Nähte, die in der Ansicht und in der Tabelle gezeigt werden</translation>
    </message>
    <message>
        <source>The second face</source>
        <translation>Die zweite Fläche</translation>
    </message>
    <message>
        <source>The sources as they were chosen: property, object, name</source>
        <translation>Die Quellen, wie sie gewählt wurden: Eigenschaft, Objekt, Name</translation>
    </message>
    <message>
        <source>The surface ends after a length, or at a face</source>
        <translation>Die Fläche endet nach einer Länge, oder an einer Fläche</translation>
    </message>
    <message>
        <source>The value that has the first colour</source>
        <translation>Der Wert mit der ersten Farbe</translation>
    </message>
    <message>
        <source>The value that has the last colour</source>
        <translation>Der Wert mit der letzten Farbe</translation>
    </message>
    <message>
        <source>The vertex whose edges are rounded</source>
        <translation>Der Eckpunkt, dessen Kanten verrundet werden</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction from the model to the lamps</source>
        <translation>Drei Zahlen x; y; z: die Richtung vom Modell zu den Lampen</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction in which the mould is pulled off</source>
        <translation>Drei Zahlen x; y; z: die Richtung, in der die Form abgezogen wird</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction of the parallel lamps</source>
        <translation>Drei Zahlen x; y; z: die Richtung der parallelen Lampen</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction to which angles are measured</source>
        <translation>Drei Zahlen x; y; z: die Richtung, zu der Winkel gemessen werden</translation>
    </message>
    <message>
        <source>Upper bound of the angles of seams that are to be G1 or more, in degrees</source>
        <translation>Obere Schranke der Winkel von Nähten, die G1 oder mehr sein sollen, in Grad</translation>
    </message>
    <message>
        <source>Upper bound of the angles of the new seams, in degrees</source>
        <translation>Obere Schranke der Winkel der neuen Nähte, in Grad</translation>
    </message>
    <message>
        <source>Upper bound of the angles of the seams, in degrees</source>
        <translation>Obere Schranke der Winkel der Nähte, in Grad</translation>
    </message>
    <message>
        <source>Upper bound of the gaps of the new seams, in mm</source>
        <translation>Obere Schranke der Spalte der neuen Nähte, in mm</translation>
    </message>
    <message>
        <source>Upper bound of the gaps, in mm</source>
        <translation>Obere Schranke der Spalte, in mm</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature at the new seams</source>
        <translation>Obere Schranke der relativen Unterschiede der Krümmung an den neuen Nähten</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of seams that are to be G2 or more</source>
        <translation>Obere Schranke der relativen Unterschiede der Krümmung von Nähten, die G2 oder mehr sein sollen</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of the seams; 0 for G1</source>
        <translation>Obere Schranke der relativen Krümmungsunterschiede der Nähte; 0 bei G1</translation>
    </message>
    <message>
        <source>Version of Seamwright that wrote the results</source>
        <translation>Version von Seamwright, die die Ergebnisse geschrieben hat</translation>
    </message>
    <message>
        <source>What is given at the ends of open points: the directions of the circles through the three outer points, the curvature 0, or directions</source>
        <translation>Was an den Enden offener Punkte gegeben ist: die Richtungen der Kreise durch die drei äußeren Punkte, die Krümmung 0, oder Richtungen</translation>
    </message>
    <message>
        <source>What is made least: the energy by the parameter, or the variation of the curvature by the length, which takes longer; of edges only</source>
        <translation>Was am kleinsten gemacht wird: die Energie nach dem Parameter, oder die Änderung der Krümmung nach der Länge, was länger dauert; nur von Kanten</translation>
    </message>
    <message>
        <source>What stays at both ends of a curve; where edges meet, the tangent stays</source>
        <translation>Was an beiden Enden einer Kurve bleibt; wo Kanten sich treffen, bleibt die Tangente</translation>
    </message>
    <message>
        <source>What the colours of the seams show: their class or their level of continuity</source>
        <translation>Was die Farben der Nähte zeigen: ihre Klasse oder ihre Stufe der Stetigkeit</translation>
    </message>
    <message>
        <source>What the points mean</source>
        <translation>Was die Punkte bedeuten</translation>
    </message>
    <message>
        <source>Where the parts lie that contain the sources, as JSON</source>
        <translation>Lage der Parts, in denen die Quellen liegen, als JSON</translation>
    </message>
    <message>
        <source>Whether every new seam certainly meets the target</source>
        <translation>Ob jede neue Naht die Zielstufe sicher erreicht</translation>
    </message>
    <message>
        <source>Whether every seam certainly has its level</source>
        <translation>Ob jede Naht ihre Stufe sicher hat</translation>
    </message>
    <message>
        <source>Whether no seam is a defect</source>
        <translation>Ob keine Naht ein Fehler ist</translation>
    </message>
    <message>
        <source>Whether single points are samples of a smooth curve or corners of a polygon</source>
        <translation>Ob einzelne Punkte Stützpunkte einer glatten Kurve oder Ecken eines Polygons sind</translation>
    </message>
    <message>
        <source>Whether the faces certainly meet the target</source>
        <translation>Ob die Flächen die Zielstufe sicher erreichen</translation>
    </message>
    <message>
        <source>Whether the poles meet the target exactly up to rounding, not only within the tolerance</source>
        <translation>Ob die Kontrollpunkte die Zielstufe bis auf Rundung exakt erreichen, nicht nur innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Whether the shape changed</source>
        <translation>Ob sich die Form geändert hat</translation>
    </message>
    <message>
        <source>Whether the solid is valid and every new seam certainly meets the tolerances</source>
        <translation>Ob der Körper gültig ist und jede neue Naht die Toleranzen sicher einhält</translation>
    </message>
    <message>
        <source>Whether the verdict about the new seam is certain</source>
        <translation>Ob das Urteil über die neue Naht sicher ist</translation>
    </message>
    <message>
        <source>Which iso-curves of a face have a comb, or its edges. Selected edges always have one</source>
        <translation>Welche Isolinien einer Fläche einen Kamm haben, oder ihre Kanten. Ausgewählte Kanten haben immer einen</translation>
    </message>
    <message>
        <source>Which points of the curves correspond</source>
        <translation>Welche Punkte der Kurven einander entsprechen</translation>
    </message>
    <message>
        <source>Width of a light stripe, as a part of a light and a dark one</source>
        <translation>Breite eines hellen Streifens, als Teil eines hellen und eines dunklen</translation>
    </message>
    <message>
        <source>Width of a line, as a part of the distance of two</source>
        <translation>Breite einer Linie, als Teil des Abstands von zweien</translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation>Schreibt die Ergebnisse der ausgewählten Nahtanalyse in eine Datei, als Tabelle (CSV) oder als Bericht (JSON). Ohne Auswahl wird die neueste Analyse geschrieben.</translation>
    </message>
    <message>
        <source>Zebra stripes: a mirror of light tubes, which moves with the view. Isophotes: lines of equal angle to a direction. Highlight lines: where the normals meet parallel lamps</source>
        <translation>Zebrastreifen: ein Spiegel von Leuchtröhren, der mit der Ansicht mitgeht. Isophoten: Linien gleichen Winkels zu einer Richtung. Glanzlinien: wo die Normalen parallele Lampen treffen</translation>
    </message>
</context>
<context>
    <name>Seamwright</name>
    <message>
        <source>
Shown: {show}</source>
        <translation>
Gezeigt: {show}</translation>
    </message>
    <message>
        <source> (proven).</source>
        <translation> (bewiesen).</translation>
    </message>
    <message>
        <source> (proven); no fewer than {least_arcs} will do.</source>
        <translation> (bewiesen); weniger als {least_arcs} genügen nicht.</translation>
    </message>
    <message>
        <source> ({share} % less)</source>
        <translation> ({share} % weniger)</translation>
    </message>
    <message>
        <source> ({share} % more)</source>
        <translation> ({share} % mehr)</translation>
    </message>
    <message>
        <source> Filled by OpenCASCADE; not by patches: {patches_reason}.</source>
        <translation> Von OpenCASCADE gefüllt; nicht mit Flächenstücken: {patches_reason}.</translation>
    </message>
    <message>
        <source> If all points are vertices, the spline follows them; else the points are its own, and it follows no sources.</source>
        <translation> Sind alle Punkte Ecken, folgt der Spline diesen; sonst gehören die Punkte ihm selbst, und er folgt keinen Quellen.</translation>
    </message>
    <message>
        <source> The shape is not valid: it may cross itself; try smaller numbers.</source>
        <translation> Die Form ist nicht gültig: sie schneidet sich vielleicht selbst; kleinere Zahlen versuchen.</translation>
    </message>
    <message>
        <source> There are {curves} separate curves: edges that do not touch are not joined; Bridge Curve does that.</source>
        <translation> Es sind {curves} getrennte Kurven: Kanten, die sich nicht berühren, werden nicht verbunden; das macht „Brückenkurve“.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source> and {intervals} more intervals</source>
        <translation> und {intervals} weitere Intervalle</translation>
    </message>
    <message>
        <source> and {more} more</source>
        <translation> und {more} weitere</translation>
    </message>
    <message>
        <source> for {curves} curves</source>
        <translation> für {curves} Kurven</translation>
    </message>
    <message>
        <source> instead of {along} x {across}</source>
        <translation> statt {along} x {across}</translation>
    </message>
    <message>
        <source>+ concave, {minus} convex, seen from the side of the normals</source>
        <translation>+ konkav, {minus} konvex, von der Seite der Normalen aus gesehen</translation>
    </message>
    <message>
        <source>, as {arcs} of one sweep</source>
        <translation>, als {arcs} mit gleichem Drehwinkel</translation>
    </message>
    <message>
        <source>, at most {distance_mm} mm from the spiral</source>
        <translation>, höchstens {distance_mm} mm von der Spirale</translation>
    </message>
    <message>
        <source>, but the surface turns back {distance_mm} mm from the start; less tension may help</source>
        <translation>, aber die Fläche kehrt {distance_mm} mm vom Anfang um; weniger Spannung kann helfen</translation>
    </message>
    <message>
        <source>, curvature at most {curvature_rel} %</source>
        <translation>, Krümmung höchstens {curvature_rel} %</translation>
    </message>
    <message>
        <source>, curves within {fit} mm of them</source>
        <translation>, Kurven höchstens {fit} mm von ihnen</translation>
    </message>
    <message>
        <source>, excluding {intervals} of it</source>
        <translation>, ohne {intervals} von ihr</translation>
    </message>
    <message>
        <source>, largest at {at:.3g} of the edge</source>
        <translation>, am größten bei {at:.3g} der Kante</translation>
    </message>
    <message>
        <source>, on the grid</source>
        <translation>, auf dem Raster</translation>
    </message>
    <message>
        <source>, or select nothing</source>
        <translation> oder wählen Sie nichts aus</translation>
    </message>
    <message>
        <source>, the longest loop: an outer boundary?</source>
        <translation>, die längste Schleife: ein äußerer Rand?</translation>
    </message>
    <message>
        <source>, variation of curvature {before} → {after} 1/mm³</source>
        <translation>, Änderung der Krümmung {before} → {after} 1/mm³</translation>
    </message>
    <message>
        <source>, {faults} not drawn correctly</source>
        <translation>, {faults} nicht richtig gezeichnet</translation>
    </message>
    <message>
        <source>, {matched} of them matched</source>
        <translation>, davon {matched} zugeordnet</translation>
    </message>
    <message>
        <source>0 extrema</source>
        <translation>0 Extrema</translation>
    </message>
    <message>
        <source>: the points are samples of these.</source>
        <translation>: Die Punkte sind Stützpunkte von diesen.</translation>
    </message>
    <message>
        <source>; seen up to {distance_mm} mm from the edges</source>
        <translation>; an gemessenen Punkten bis zu {distance_mm} mm von den Kanten entfernt</translation>
    </message>
    <message>
        <source>; the outer boundary stays</source>
        <translation>; der äußere Rand bleibt</translation>
    </message>
    <message>
        <source>; the results are those of the last complete run.</source>
        <translation>; die Ergebnisse sind die des letzten vollständigen Laufs.</translation>
    </message>
    <message>
        <source>; there are no results yet.</source>
        <translation>; es gibt noch keine Ergebnisse.</translation>
    </message>
    <message>
        <source>; {beyond} beyond the edges of the other shape left out</source>
        <translation>; {beyond} jenseits der Ränder der anderen Form weggelassen</translation>
    </message>
    <message>
        <source>; {joints} with a jump of the curvature</source>
        <translation>; {joints} mit einem Sprung der Krümmung</translation>
    </message>
    <message>
        <source>; {kept} kept as given</source>
        <translation>; {kept} wie gegeben belassen</translation>
    </message>
    <message>
        <source>; {least_mm} to {most_mm} mm long</source>
        <translation>; {least_mm} bis {most_mm} mm lang</translation>
    </message>
    <message>
        <source>A click selects them in the view</source>
        <translation>Ein Klick wählt sie in der Ansicht aus</translation>
    </message>
    <message>
        <source>A hyperbola of weight {weight}</source>
        <translation>Eine Hyperbel mit Gewicht {weight}</translation>
    </message>
    <message>
        <source>A parabola</source>
        <translation>Eine Parabel</translation>
    </message>
    <message>
        <source>A picked edge is not among the seams shown before: all are shown.</source>
        <translation>Eine gewählte Kante gehört nicht zu den bisher gezeigten Nähten: alle werden gezeigt.</translation>
    </message>
    <message>
        <source>Add a sketch of arcs and lines near the planar curve as it is now; the sketch does not follow the sources</source>
        <translation>Fügt eine Skizze aus Bögen und Strecken nahe der ebenen Kurve hinzu, wie sie jetzt ist; die Skizze folgt den Quellen nicht</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>Add the edges that go on with the tangent of those chosen</source>
        <translation>Die Kanten hinzufügen, die die gewählten tangential fortsetzen</translation>
    </message>
    <message>
        <source>Add what is selected in the view to the list</source>
        <translation>Der Liste hinzufügen, was in der Ansicht ausgewählt ist</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>After: each point coloured by how far it moved</source>
        <translation>Nachher: jeder Punkt gefärbt danach, wie weit er verschoben wurde</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>All defects. To choose, select rows or edges and add them:</source>
        <translation>Alle Fehler. Zum Auswählen Zeilen oder Kanten markieren und hinzufügen:</translation>
    </message>
    <message>
        <source>All seams</source>
        <translation>Alle Nähte</translation>
    </message>
    <message>
        <source>Allow what the best fill needs, so that it can be kept as one that meets the target</source>
        <translation>Erlauben, was die beste Füllung braucht, damit sie als eine behalten werden kann, die das Ziel erreicht</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Also draw the comb of the edges from which the curve is made</source>
        <translation>Auch den Kamm der Kanten zeichnen, aus denen die Kurve entsteht</translation>
    </message>
    <message>
        <source>An ellipse of weight {weight}</source>
        <translation>Eine Ellipse mit Gewicht {weight}</translation>
    </message>
    <message>
        <source>Analysing seams…</source>
        <translation>Nähte werden analysiert…</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Analyse läuft…</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Analyze seams</source>
        <translation>Nähte analysieren</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle between lines</source>
        <translation>Winkel zwischen Linien</translation>
    </message>
    <message>
        <source>Angle tolerance</source>
        <translation>Winkeltoleranz</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Winkel °</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Arcs of one sweep</source>
        <translation>Bögen mit gleichem Drehwinkel</translation>
    </message>
    <message>
        <source>As in sources</source>
        <translation>Wie in Quellen</translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written. It is always written at the seams of the selected rows.</source>
        <translation>Bei wie vielen der schlechtesten gezeigten Nähte der größte Wert angeschrieben wird. An den Nähten der markierten Zeilen steht er immer.</translation>
    </message>
    <message>
        <source>At the ends keep</source>
        <translation>An den Enden bleibt</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Before and after: each point coloured by its mean curvature, both with the same scale</source>
        <translation>Vorher und nachher: jeder Punkt gefärbt nach seiner mittleren Krümmung, beide mit derselben Skala</translation>
    </message>
    <message>
        <source>Before and after: stripes break where faces meet at an angle, and bend where the curvature jumps</source>
        <translation>Vorher und nachher: Streifen brechen ab, wo Flächen sich unter einem Winkel treffen, und knicken, wo die Krümmung springt</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>Beyond edges too</source>
        <translation>Auch jenseits der Kanten</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Bias</translation>
    </message>
    <message>
        <source>Bind to an expression (=)</source>
        <translation>An einen Ausdruck binden (=)</translation>
    </message>
    <message>
        <source>Blend Curves</source>
        <translation>Zwischenkurven</translation>
    </message>
    <message>
        <source>Blend Surface</source>
        <translation>Übergangsfläche</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Bridge Curve</source>
        <translation>Brückenkurve</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>By class</source>
        <translation>Nach Klasse</translation>
    </message>
    <message>
        <source>By level</source>
        <translation>Nach Stufe</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Cancelled; the results are those of the last complete run.</source>
        <translation>Abgebrochen; die Ergebnisse sind die des letzten vollständigen Laufs.</translation>
    </message>
    <message>
        <source>Cancelled; there are no results yet.</source>
        <translation>Abgebrochen; es gibt noch keine Ergebnisse.</translation>
    </message>
    <message>
        <source>Certain</source>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>Change %</source>
        <translation>Änderung %</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Class A</source>
        <translation>Class A</translation>
    </message>
    <message>
        <source>Click adds a point, at a vertex or on the grid; Ctrl: free. Backspace removes the last point, a click on the first one closes, Enter ends, Esc cancels.</source>
        <translation>Ein Klick fügt einen Punkt hinzu, an einem Eckpunkt oder auf dem Raster; Strg: frei. Die Rücktaste entfernt den letzten Punkt, ein Klick auf den ersten schließt, Eingabe beendet, Esc bricht ab.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Clothoid</source>
        <translation>Klothoide</translation>
    </message>
    <message>
        <source>Colour of {name}; click to choose another one</source>
        <translation>Farbe von {name}; klicken, um eine andere zu wählen</translation>
    </message>
    <message>
        <source>Coloured</source>
        <translation>Gefärbt</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colours of seams</source>
        <translation>Farben der Nähte</translation>
    </message>
    <message>
        <source>Common edge (may be empty)</source>
        <translation>Gemeinsame Kante (kann fehlen)</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>Compute shortly after each change of a field; otherwise when Preview is pressed</source>
        <translation>Kurz nach jeder Änderung eines Felds berechnen; sonst, wenn „Vorschau“ gedrückt wird</translation>
    </message>
    <message>
        <source>Compute with the values of the fields</source>
        <translation>Mit den Werten der Felder berechnen</translation>
    </message>
    <message>
        <source>Computing and drawing</source>
        <translation>Berechnen und Zeichnen</translation>
    </message>
    <message>
        <source>Computing colours…</source>
        <translation>Farben werden berechnet…</translation>
    </message>
    <message>
        <source>Computing moves…</source>
        <translation>Verschiebungen werden berechnet…</translation>
    </message>
    <message>
        <source>Computing zebra stripes…</source>
        <translation>Zebrastreifen werden berechnet…</translation>
    </message>
    <message>
        <source>Conic</source>
        <translation>Kegelschnitt</translation>
    </message>
    <message>
        <source>Continues with</source>
        <translation>Setzt fort mit</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Stetigkeit</translation>
    </message>
    <message>
        <source>Coordinates, tension and bias of each point; a bad number is not taken</source>
        <translation>Koordinaten, Spannung und Bias jedes Punkts; eine unzulässige Zahl wird nicht übernommen</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>Zeilen kopieren</translation>
    </message>
    <message>
        <source>Corner Fillet</source>
        <translation>Eckverrundung</translation>
    </message>
    <message>
        <source>Corner fillet</source>
        <translation>Eckverrundung</translation>
    </message>
    <message>
        <source>Corner of a hole above</source>
        <translation>Ecke eines Lochs ab</translation>
    </message>
    <message>
        <source>Corner of {rounded} rounded with radii {radii} mm; {seams}; {target} is met.</source>
        <translation>Ecke aus {rounded} mit Radien {radii} mm verrundet; {seams}; {target} ist erreicht.</translation>
    </message>
    <message>
        <source>Corners and extrema</source>
        <translation>Ecken und Extrema</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Knickkante</translation>
    </message>
    <message>
        <source>Crease above</source>
        <translation>Knickkante ab</translation>
    </message>
    <message>
        <source>Crease angle</source>
        <translation>Winkel der Knickkante</translation>
    </message>
    <message>
        <source>Curv. %</source>
        <translation>Krüm. %</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Curvature %</source>
        <translation>Krümmung %</translation>
    </message>
    <message>
        <source>Curvature (relative)</source>
        <translation>Krümmung (relativ)</translation>
    </message>
    <message>
        <source>Curvature Comb</source>
        <translation>Krümmungskamm</translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>Krümmungsbild</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Krümmungskamm</translation>
    </message>
    <message>
        <source>Curvature extrema {extrema} → {extrema_after}, inflections {inflections} → {inflections_after}{variation}; moved at most {moved_mm} mm{kept}.</source>
        <translation>Extrema der Krümmung {extrema} → {extrema_after}, Wendepunkte {inflections} → {inflections_after}{variation}; höchstens {moved_mm} mm verschoben{kept}.</translation>
    </message>
    <message>
        <source>Curvature tolerance</source>
        <translation>Krümmungstoleranz</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Curves within</source>
        <translation>Kurven innerhalb</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Defaults of this page</source>
        <translation>Standardwerte dieser Seite</translation>
    </message>
    <message>
        <source>Defect</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Defect, crease or smooth</source>
        <translation>Fehler, Knickkante oder glatt</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Difference of curvature</source>
        <translation>Unterschied der Krümmung</translation>
    </message>
    <message>
        <source>Difference of the change of curvature</source>
        <translation>Unterschied der Krümmungsänderung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of pull</source>
        <translation>Entformungsrichtung</translation>
    </message>
    <message>
        <source>Direction of the lamps</source>
        <translation>Richtung der Lampen</translation>
    </message>
    <message>
        <source>Direction of the stripes</source>
        <translation>Richtung der Streifen</translation>
    </message>
    <message>
        <source>Discard the changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Distance from the vertex at which the fillet ends</source>
        <translation>Abstand vom Eckpunkt, in dem die Verrundung endet</translation>
    </message>
    <message>
        <source>Distance of the lamps</source>
        <translation>Abstand der Lampen</translation>
    </message>
    <message>
        <source>Divide the selected curves only</source>
        <translation>Gewählte Kurven nur teilen</translation>
    </message>
    <message>
        <source>Do it again (Ctrl+Shift+Z)</source>
        <translation>Nochmals ausführen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>Formschräge</translation>
    </message>
    <message>
        <source>Draft angle</source>
        <translation>Formschräge</translation>
    </message>
    <message>
        <source>Draw lines across the curve, as long as its curvature is large</source>
        <translation>Linien quer zur Kurve zeichnen, so lang wie ihre Krümmung groß ist</translation>
    </message>
    <message>
        <source>Draw zebra stripes on the surface and on the faces beside it</source>
        <translation>Zebrastreifen auf die Fläche und die Flächen daneben zeichnen</translation>
    </message>
    <message>
        <source>Drawn on</source>
        <translation>Gezeichnet auf</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edge {number}</source>
        <translation>Kante {number}</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edges lie side by side within</source>
        <translation>Kanten liegen nebeneinander innerhalb</translation>
    </message>
    <message>
        <source>Edges meet within</source>
        <translation>Kanten treffen sich innerhalb</translation>
    </message>
    <message>
        <source>Edit seam repair</source>
        <translation>Nahtreparatur bearbeiten</translation>
    </message>
    <message>
        <source>Edit {label}</source>
        <translation>{label} bearbeiten</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>End joins</source>
        <translation>Ende schließt an mit</translation>
    </message>
    <message>
        <source>End runs the other way</source>
        <translation>Ende läuft andersherum</translation>
    </message>
    <message>
        <source>End tangent</source>
        <translation>Tangente am Ende</translation>
    </message>
    <message>
        <source>Ends by</source>
        <translation>Endet durch</translation>
    </message>
    <message>
        <source>Ends of points</source>
        <translation>Enden der Punkte</translation>
    </message>
    <message>
        <source>Equal lengths</source>
        <translation>Gleiche Längen</translation>
    </message>
    <message>
        <source>Every seam has its level</source>
        <translation>Jede Naht hat ihre Stufe</translation>
    </message>
    <message>
        <source>Exchange the first and the second face, so that the other one moves</source>
        <translation>Erste und zweite Fläche vertauschen, so dass die andere verschoben wird</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Export JSON…</source>
        <translation>JSON exportieren…</translation>
    </message>
    <message>
        <source>Export seam report</source>
        <translation>Nahtbericht exportieren</translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>Fläche verlängern</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces join with</source>
        <translation>Flächen schließen an mit</translation>
    </message>
    <message>
        <source>Failed: {error}</source>
        <translation>Fehlgeschlagen: {error}</translation>
    </message>
    <message>
        <source>Fair Curve</source>
        <translation>Kurve glätten</translation>
    </message>
    <message>
        <source>Fairness</source>
        <translation>Glätte</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familie</translation>
    </message>
    <message>
        <source>Fill in the usual tolerances of one kind of work</source>
        <translation>Die üblichen Toleranzen einer Art von Arbeit eintragen</translation>
    </message>
    <message>
        <source>Fill only the holes whose edges are selected in the view</source>
        <translation>Nur die Löcher füllen, deren Kanten in der Ansicht ausgewählt sind</translation>
    </message>
    <message>
        <source>Fill that is not kept</source>
        <translation>Füllung, die nicht behalten wird</translation>
    </message>
    <message>
        <source>Filling holes…</source>
        <translation>Löcher werden gefüllt…</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erste</translation>
    </message>
    <message>
        <source>First direction</source>
        <translation>Erste Richtung</translation>
    </message>
    <message>
        <source>First face</source>
        <translation>Erste Fläche</translation>
    </message>
    <message>
        <source>First pole at</source>
        <translation>Erster Kontrollpunkt bei</translation>
    </message>
    <message>
        <source>FirstFace and SecondFace must be faces</source>
        <translation>FirstFace und SecondFace müssen Flächen sein</translation>
    </message>
    <message>
        <source>Fixed faces</source>
        <translation>Feste Flächen</translation>
    </message>
    <message>
        <source>Flat above radius</source>
        <translation>Eben ab Radius</translation>
    </message>
    <message>
        <source>Flat within</source>
        <translation>Eben innerhalb</translation>
    </message>
    <message>
        <source>Four-sided</source>
        <translation>Vierseitig</translation>
    </message>
    <message>
        <source>Free ends</source>
        <translation>Freie Enden</translation>
    </message>
    <message>
        <source>G0: position only; G1: without a kink; G2: with the same curvature</source>
        <translation>G0: nur Position; G1: ohne Knick; G2: mit gleicher Krümmung</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>Gap of patch to fillet</source>
        <translation>Spalt von Flächenstück zu Verrundung</translation>
    </message>
    <message>
        <source>Gap tolerance</source>
        <translation>Spalttoleranz</translation>
    </message>
    <message>
        <source>Gap {unit}</source>
        <translation>Spalt {unit}</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>Gaußsche</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Give all edges the radius of the first one</source>
        <translation>Allen Kanten den Radius der ersten geben</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Gegeben</translation>
    </message>
    <message>
        <source>Given directions</source>
        <translation>Gegebene Richtungen</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Hidden: {objects}. Show what is to have stripes.</source>
        <translation>Ausgeblendet: {objects}. Einblenden, was Streifen haben soll.</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Höchster</translation>
    </message>
    <message>
        <source>Highest level of continuity the seam meets</source>
        <translation>Höchste Stufe der Stetigkeit, die die Naht erreicht</translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>Glanzlinien</translation>
    </message>
    <message>
        <source>Hold side boundaries</source>
        <translation>Seitliche Ränder halten</translation>
    </message>
    <message>
        <source>Hole {hole}</source>
        <translation>Loch {hole}</translation>
    </message>
    <message>
        <source>Hole {id}: {sides}, length {length}, centre ({centre})</source>
        <translation>Loch {id}: {sides}, Länge {length}, Mitte ({centre})</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>How dense the lines of new curvature combs are on each curve</source>
        <translation>Wie dicht die Linien neuer Krümmungskämme auf jeder Kurve stehen</translation>
    </message>
    <message>
        <source>How many light stripes zebra stripes have on a whole ball, in panels too</source>
        <translation>Wie viele helle Streifen Zebrastreifen auf einer ganzen Kugel haben, auch in den Fenstern</translation>
    </message>
    <message>
        <source>How many threads a computation uses</source>
        <translation>Wie viele Threads eine Berechnung benutzt</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Isophotes</source>
        <translation>Isophoten</translation>
    </message>
    <message>
        <source>It was built for Python {python} and OpenCASCADE {occt}. </source>
        <translation>Es wurde für Python {python} und OpenCASCADE {occt} gebaut. </translation>
    </message>
    <message>
        <source>Join Curves</source>
        <translation>Kurven verbinden</translation>
    </message>
    <message>
        <source>Joined G{order}; the ends were {gap_mm} mm apart, no {what} moved further than {moved_mm} mm.</source>
        <translation>G{order} verbunden; die Enden waren {gap_mm} mm auseinander, kein {what} wurde weiter als {moved_mm} mm verschoben.</translation>
    </message>
    <message>
        <source>Joins the first</source>
        <translation>Anschluss an die erste</translation>
    </message>
    <message>
        <source>Joins the first edge {first} and the second {second}, {figures}.</source>
        <translation>Schließt an die erste Kante mit {first} und an die zweite mit {second} an, {figures}.</translation>
    </message>
    <message>
        <source>Joins the second</source>
        <translation>Anschluss an die zweite</translation>
    </message>
    <message>
        <source>Joints keep</source>
        <translation>Verbindungsstellen behalten</translation>
    </message>
    <message>
        <source>Keep anyway</source>
        <translation>Trotzdem behalten</translation>
    </message>
    <message>
        <source>Keep arcs exactly</source>
        <translation>Bögen exakt beibehalten</translation>
    </message>
    <message>
        <source>Label the worst</source>
        <translation>Beschriften</translation>
    </message>
    <message>
        <source>Lamps lie towards</source>
        <translation>Lampen liegen in Richtung</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, before and after, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen, vorher und nachher, in Grad</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, in degrees</source>
        <translation>Größter Winkel zwischen den Tangentialebenen, in Grad</translation>
    </message>
    <message>
        <source>Largest deviation {furthest_mm} mm {furthest_at}; {least} to {largest} mm</source>
        <translation>Größte Abweichung {furthest_mm} mm {furthest_at}; {least} bis {largest} mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides, before and after, in {unit}</source>
        <translation>Größter Abstand zwischen den beiden Seiten, vorher und nachher, in {unit}</translation>
    </message>
    <message>
        <source>Largest distance between the two sides, in {unit}</source>
        <translation>Größter Abstand zwischen den beiden Seiten, in {unit}</translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the curve</source>
        <translation>Größter Abstand der Bögen von der Kurve</translation>
    </message>
    <message>
        <source>Largest move</source>
        <translation>Größte Verschiebung</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, before and after, in %</source>
        <translation>Größter relativer Unterschied der Krümmung, vorher und nachher, in %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, in %</source>
        <translation>Größter relativer Unterschied der Krümmung, in %</translation>
    </message>
    <message>
        <source>Largest relative difference of the change of curvature, in % (measured for G3)</source>
        <translation>Größter relativer Unterschied der Krümmungsänderung, in % (für G3 gemessen)</translation>
    </message>
    <message>
        <source>Last direction</source>
        <translation>Letzte Richtung</translation>
    </message>
    <message>
        <source>Lateral</source>
        <translation>Seitlich</translation>
    </message>
    <message>
        <source>Lateral boundaries (may be empty)</source>
        <translation>Seitliche Ränder (können fehlen)</translation>
    </message>
    <message>
        <source>Lateral boundaries join</source>
        <translation>Seitliche Ränder schließen an mit</translation>
    </message>
    <message>
        <source>Least draft away from it</source>
        <translation>Kleinste Schräge von ihr weg</translation>
    </message>
    <message>
        <source>Least draft towards it</source>
        <translation>Kleinste Schräge zu ihr hin</translation>
    </message>
    <message>
        <source>Least energy</source>
        <translation>Kleinste Energie</translation>
    </message>
    <message>
        <source>Least variation of curvature</source>
        <translation>Kleinste Änderung der Krümmung</translation>
    </message>
    <message>
        <source>Leave the largest sector open</source>
        <translation>Größten Sektor offen lassen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the lines of the comb</source>
        <translation>Länge der Linien des Kamms</translation>
    </message>
    <message>
        <source>Length of the seam, in {unit}</source>
        <translation>Länge der Naht, in {unit}</translation>
    </message>
    <message>
        <source>Length {unit}</source>
        <translation>Länge {unit}</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Level and tolerances</source>
        <translation>Stufe und Toleranzen</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Lines inside the surface at which the curves have their joints</source>
        <translation>Linien in der Fläche, an denen die Kurven ihre Verbindungen haben</translation>
    </message>
    <message>
        <source>Lines of a comb</source>
        <translation>Linien eines Kamms</translation>
    </message>
    <message>
        <source>Loft through Frames</source>
        <translation>Fläche durch Zwischenkurven</translation>
    </message>
    <message>
        <source>Log Spiral</source>
        <translation>Logarithmische Spirale</translation>
    </message>
    <message>
        <source>Look of seams</source>
        <translation>Aussehen der Nähte</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Niedrigster</translation>
    </message>
    <message>
        <source>Lowest = {least:g}: a radius is larger than 0</source>
        <translation>Niedrigster = {least:g}: Ein Radius ist größer als 0</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Erzeugt aus</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Erzeugen</translation>
    </message>
    <message>
        <source>Make the curve from what is selected now: {needs}</source>
        <translation>Die Kurve aus dem erzeugen, was jetzt ausgewählt ist: {needs}</translation>
    </message>
    <message>
        <source>Make {label}</source>
        <translation>{label} erzeugen</translation>
    </message>
    <message>
        <source>Making the surface…</source>
        <translation>Die Fläche wird erzeugt…</translation>
    </message>
    <message>
        <source>Making the {group}…</source>
        <translation>{group} wird erzeugt…</translation>
    </message>
    <message>
        <source>Match Surfaces</source>
        <translation>Flächen anpassen</translation>
    </message>
    <message>
        <source>Match by</source>
        <translation>Zuordnen nach</translation>
    </message>
    <message>
        <source>Match free edges within</source>
        <translation>Freie Kanten zuordnen innerhalb</translation>
    </message>
    <message>
        <source>Match free edges within {proposal:g} mm</source>
        <translation>Freie Kanten innerhalb {proposal:g} mm zuordnen</translation>
    </message>
    <message>
        <source>Match surfaces</source>
        <translation>Flächen anpassen</translation>
    </message>
    <message>
        <source>Matched: {parts} ({reason}).</source>
        <translation>Angepasst: {parts} ({reason}).</translation>
    </message>
    <message>
        <source>Matching surfaces…</source>
        <translation>Flächen werden angepasst…</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittlere</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Measuring the seams…</source>
        <translation>Die Nähte werden gemessen…</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>More faces (may be empty)</source>
        <translation>Weitere Flächen (darf leer sein)</translation>
    </message>
    <message>
        <source>Move all points back to those of the sources</source>
        <translation>Alle Punkte zu denen der Quellen zurücksetzen</translation>
    </message>
    <message>
        <source>Move the mouse: the point is marked on the seam in the view</source>
        <translation>Maus bewegen: Der Punkt wird auf der Naht in der Ansicht markiert</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Moves of points</source>
        <translation>Verschiebung der Punkte</translation>
    </message>
    <message>
        <source>Near the polygon of {points} points, {figures}.</source>
        <translation>Nahe dem Polygon von {points} Punkten, {figures}.</translation>
    </message>
    <message>
        <source>No curvature</source>
        <translation>Keine Krümmung</translation>
    </message>
    <message>
        <source>No deviation above rounding</source>
        <translation>Keine Abweichung über der Rundung</translation>
    </message>
    <message>
        <source>No level</source>
        <translation>Keine Stufe</translation>
    </message>
    <message>
        <source>No point lies over the other shape</source>
        <translation>Kein Punkt liegt über der anderen Form</translation>
    </message>
    <message>
        <source>No point of a face may move further than this. By size of face: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation>Kein Punkt einer Fläche darf weiter verschoben werden. Nach Größe der Fläche: ein Hundertstel der Größe der Fläche plus der doppelte größte Spalt ihrer Nähte</translation>
    </message>
    <message>
        <source>No seams: no two faces share an edge.</source>
        <translation>Keine Nähte: Keine zwei Flächen haben eine gemeinsame Kante.</translation>
    </message>
    <message>
        <source>No two faces share an edge: free edges are matched within {proposed:g} mm, as proposed. </source>
        <translation>Keine zwei Flächen haben eine gemeinsame Kante: Freie Kanten werden wie vorgeschlagen innerhalb {proposed:g} mm zugeordnet. </translation>
    </message>
    <message>
        <source>No value is defined</source>
        <translation>Kein Wert ist definiert</translation>
    </message>
    <message>
        <source>No visible object has faces to draw zebra stripes on.</source>
        <translation>Kein sichtbares Objekt hat Flächen, auf die Zebrastreifen gezeichnet werden können.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Not allowed: enter a number from {least} to {largest}.</source>
        <translation>Nicht zulässig: eine Zahl von {least} bis {largest} eingeben.</translation>
    </message>
    <message>
        <source>Not analysed: {reason}</source>
        <translation>Nicht analysiert: {reason}</translation>
    </message>
    <message>
        <source>Not filled: {reasons}</source>
        <translation>Nicht gefüllt: {reasons}</translation>
    </message>
    <message>
        <source>Not filled: {reason}</source>
        <translation>Nicht gefüllt: {reason}</translation>
    </message>
    <message>
        <source>Not made: {reason}.</source>
        <translation>Nicht erzeugt: {reason}.</translation>
    </message>
    <message>
        <source>Not matched: {reason}.</source>
        <translation>Nicht angepasst: {reason}.</translation>
    </message>
    <message>
        <source>Not reached ({missed})</source>
        <translation>Nicht erreicht ({missed})</translation>
    </message>
    <message>
        <source>Not repaired: {reason}</source>
        <translation>Nicht repariert: {reason}</translation>
    </message>
    <message>
        <source>Not rounded: {error}.</source>
        <translation>Nicht verrundet: {error}.</translation>
    </message>
    <message>
        <source>Not rounded: {reason}.</source>
        <translation>Nicht verrundet: {reason}.</translation>
    </message>
    <message>
        <source>Not smooth</source>
        <translation>Nicht glatt</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Nothing to repair: no seam falls short of {target}; the model is unchanged.</source>
        <translation>Nichts zu reparieren: Keine Naht verfehlt {target}; das Modell ist unverändert.</translation>
    </message>
    <message>
        <source>Nothing to repair: no two faces share an edge, and none are matched.</source>
        <translation>Nichts zu reparieren: Keine zwei Flächen haben eine gemeinsame Kante, und keine sind zugeordnet.</translation>
    </message>
    <message>
        <source>Nothing to repair: the chosen seams meet {target}; the model is unchanged.</source>
        <translation>Nichts zu reparieren: Die gewählten Nähte erreichen {target}; das Modell ist unverändert.</translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation>Anzahl der Bögen</translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation>Anzahl der Kurven</translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation>Anzahl der Linien</translation>
    </message>
    <message>
        <source>Number of lines of the comb</source>
        <translation>Anzahl der Linien des Kamms</translation>
    </message>
    <message>
        <source>Number of stripes</source>
        <translation>Anzahl der Streifen</translation>
    </message>
    <message>
        <source>Number of the seam in the report</source>
        <translation>Nummer der Naht im Bericht</translation>
    </message>
    <message>
        <source>Number the points</source>
        <translation>Punkte nummerieren</translation>
    </message>
    <message>
        <source>Numbers of the two faces that meet</source>
        <translation>Nummern der beiden Flächen, die sich treffen</translation>
    </message>
    <message>
        <source>Objects that exist keep theirs. The new faces of Umbrella Fill have tolerances of their own.</source>
        <translation>Vorhandene Objekte behalten ihre. Die neuen Flächen der Schirmfüllung haben eigene Toleranzen.</translation>
    </message>
    <message>
        <source>Of the area, {towards} % drafts towards the pull, {away} % away, {steep} % is too steep. {mesh}.</source>
        <translation>Von der Fläche haben {towards} % eine Schräge zur Entformungsrichtung hin, {away} % von ihr weg, {steep} % sind zu steil. {mesh}.</translation>
    </message>
    <message>
        <source>On faces</source>
        <translation>Auf Flächen</translation>
    </message>
    <message>
        <source>Only selected</source>
        <translation>Nur ausgewählte</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Other end of the first</source>
        <translation>Anderes Ende der ersten</translation>
    </message>
    <message>
        <source>Other end of the second</source>
        <translation>Anderes Ende der zweiten</translation>
    </message>
    <message>
        <source>Outer boundary (may be empty)</source>
        <translation>Äußerer Rand (darf leer sein)</translation>
    </message>
    <message>
        <source>Own points</source>
        <translation>Eigene Punkte</translation>
    </message>
    <message>
        <source>Pick points</source>
        <translation>Punkte setzen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>Punkte sind</translation>
    </message>
    <message>
        <source>Points are of a</source>
        <translation>Punkte gehören zu</translation>
    </message>
    <message>
        <source>Points on a seam</source>
        <translation>Punkte auf einer Naht</translation>
    </message>
    <message>
        <source>Points on curved edges</source>
        <translation>Punkte auf gekrümmten Kanten</translation>
    </message>
    <message>
        <source>Points that are picked or dragged snap to a grid; Ctrl: free</source>
        <translation>Gesetzte oder gezogene Punkte rasten auf einem Raster ein; Strg: frei</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Polygon, alpha curves</source>
        <translation>Polygon, Alpha-Kurven</translation>
    </message>
    <message>
        <source>Polygon, direct G2</source>
        <translation>Polygon, direkt G2</translation>
    </message>
    <message>
        <source>Polygon, gamma</source>
        <translation>Polygon, Gamma</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Preview while fields are changed</source>
        <translation>Vorschau, während Felder geändert werden</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Recompute (values were changed)</source>
        <translation>Neu berechnen (Werte wurden geändert)</translation>
    </message>
    <message>
        <source>Recompute and close</source>
        <translation>Neu berechnen und schließen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>Reflexionslinien</translation>
    </message>
    <message>
        <source>Relative curvature</source>
        <translation>Relative Krümmung</translation>
    </message>
    <message>
        <source>Relative difference of curvature</source>
        <translation>Relativer Unterschied der Krümmung</translation>
    </message>
    <message>
        <source>Relative difference of the change of curvature</source>
        <translation>Relativer Unterschied der Krümmungsänderung</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected names from the list, or all names if none is selected</source>
        <translation>Die markierten Namen aus der Liste entfernen, oder alle, wenn keiner markiert ist</translation>
    </message>
    <message>
        <source>Remove the tangents that were given to the ends</source>
        <translation>Die Tangenten entfernen, die den Enden gegeben wurden</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Repair seams</source>
        <translation>Nähte reparieren</translation>
    </message>
    <message>
        <source>Repair the seams of the selected rows, or all defects if no row is selected</source>
        <translation>Die Nähte der markierten Zeilen reparieren, oder alle Fehler, wenn keine Zeile markiert ist</translation>
    </message>
    <message>
        <source>Repair the seams with these values</source>
        <translation>Die Nähte mit diesen Werten reparieren</translation>
    </message>
    <message>
        <source>Repair these…</source>
        <translation>Diese reparieren…</translation>
    </message>
    <message>
        <source>Repaired, or why not</source>
        <translation>Repariert, oder warum nicht</translation>
    </message>
    <message>
        <source>Repairing seams…</source>
        <translation>Nähte werden repariert…</translation>
    </message>
    <message>
        <source>Repair…</source>
        <translation>Reparieren…</translation>
    </message>
    <message>
        <source>Report (*.json)</source>
        <translation>Bericht (*.json)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Rounding the corner…</source>
        <translation>Die Ecke wird verrundet…</translation>
    </message>
    <message>
        <source>Same radius for all</source>
        <translation>Gleicher Radius für alle</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Seam Analysis</source>
        <translation>Nahtanalyse</translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>Nahtdiagramm</translation>
    </message>
    <message>
        <source>Seam Repair</source>
        <translation>Nahtreparatur</translation>
    </message>
    <message>
        <source>Seam tolerances</source>
        <translation>Nahttoleranzen</translation>
    </message>
    <message>
        <source>Seam {id} ({kind})</source>
        <translation>Naht {id} ({kind})</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Seamwright was built for OpenCASCADE {built}, but this FreeCAD runs OpenCASCADE {running}. Install the Seamwright that was built for this FreeCAD.</source>
        <translation>Seamwright wurde für OpenCASCADE {built} gebaut, aber dieses FreeCAD läuft mit OpenCASCADE {running}. Installieren Sie das Seamwright, das für dieses FreeCAD gebaut wurde.</translation>
    </message>
    <message>
        <source>Seamwright: help</source>
        <translation>Seamwright: Hilfe</translation>
    </message>
    <message>
        <source>Seamwright: the colours are not shown: {error}
</source>
        <translation>Seamwright: Die Farben werden nicht gezeigt: {error}
</translation>
    </message>
    <message>
        <source>Seamwright: the moves of {names} are not shown: {error}
</source>
        <translation>Seamwright: Die Verschiebungen von {names} werden nicht gezeigt: {error}
</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweite</translation>
    </message>
    <message>
        <source>Second continues the first</source>
        <translation>Zweite setzt die erste fort</translation>
    </message>
    <message>
        <source>Second face</source>
        <translation>Zweite Fläche</translation>
    </message>
    <message>
        <source>Second pole at</source>
        <translation>Zweiter Kontrollpunkt bei</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Select edges</source>
        <translation>Kanten auswählen</translation>
    </message>
    <message>
        <source>Select either edges of holes or one face to replace. Selected: {faces}, {edges}.</source>
        <translation>Wählen Sie entweder Kanten von Löchern oder eine zu ersetzende Fläche aus. Ausgewählt: {faces}, {edges}.</translation>
    </message>
    <message>
        <source>Select one vertex of a solid at which 3 to 6 edges meet. Selected: {vertices}.</source>
        <translation>Wählen Sie einen Eckpunkt eines Körpers aus, an dem 3 bis 6 Kanten sich treffen. Ausgewählt: {vertices}.</translation>
    </message>
    <message>
        <source>Select two faces: first the one that stays, then the one that moves. You may also select one common edge, or more faces that stay, or edges of them. Selected: {faces}, {edges}.</source>
        <translation>Wählen Sie zwei Flächen aus: zuerst die, die bleibt, dann die, die verschoben wird. Sie können auch eine gemeinsame Kante auswählen, oder weitere Flächen, die bleiben, oder Kanten von ihnen. Ausgewählt: {faces}, {edges}.</translation>
    </message>
    <message>
        <source>Set by the expression {expression}</source>
        <translation>Durch den Ausdruck {expression} bestimmt</translation>
    </message>
    <message>
        <source>Setback</source>
        <translation>Rückversatz</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show handles in the view: circles are points, squares the tangents of the ends, diamonds the tensions. Drag them; Esc takes a drag back.</source>
        <translation>Griffe in der Ansicht zeigen: Kreise sind Punkte, Quadrate die Tangenten der Enden, Rauten die Spannungen. Ziehen Sie daran; Esc nimmt ein Ziehen zurück.</translation>
    </message>
    <message>
        <source>Show the page before</source>
        <translation>Die vorige Seite zeigen</translation>
    </message>
    <message>
        <source>Show the values that Seamwright has at first</source>
        <translation>Die Werte zeigen, die Seamwright anfangs hat</translation>
    </message>
    <message>
        <source>Show which number of a list belongs to which point</source>
        <translation>Zeigen, welche Zahl einer Liste zu welchem Punkt gehört</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Smallest move</source>
        <translation>Kleinste Verschiebung</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>Kleinster Radius</translation>
    </message>
    <message>
        <source>Smallest radius of curvature</source>
        <translation>Kleinster Krümmungsradius</translation>
    </message>
    <message>
        <source>Smallest radius {least} mm {least_at}. {mesh}.</source>
        <translation>Kleinster Radius {least} mm {least_at}. {mesh}.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Smooth curve</source>
        <translation>Glatte Kurve</translation>
    </message>
    <message>
        <source>Sort by class: defects by how much their figures exceed the tolerances, others by the figure of the level, such as the angle for G1</source>
        <translation>Nach Klasse sortieren: Fehler danach, wie weit ihre Werte die Toleranzen überschreiten, andere nach dem Wert der Stufe, etwa dem Winkel bei G1</translation>
    </message>
    <message>
        <source>Spacing of the lamps</source>
        <translation>Abstand zwischen den Lampen</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>Spline through points</source>
        <translation>Spline durch Punkte</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Start joins</source>
        <translation>Anfang schließt an mit</translation>
    </message>
    <message>
        <source>Start tangent</source>
        <translation>Tangente am Anfang</translation>
    </message>
    <message>
        <source>Start, corner and end</source>
        <translation>Anfang, Ecke und Ende</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop and keep the earlier results. Esc does the same.</source>
        <translation>Anhalten und die früheren Ergebnisse behalten. Esc tut dasselbe.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Surface of {faces}</source>
        <translation>Fläche aus {faces}</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Take the last drag or change of a point back (Ctrl+Z)</source>
        <translation>Das letzte Ziehen oder die letzte Änderung eines Punkts zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Take these tolerances</source>
        <translation>Diese Toleranzen übernehmen</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>Tangent chain</source>
        <translation>Tangentenkette</translation>
    </message>
    <message>
        <source>Tangents in one plane within</source>
        <translation>Tangenten in einer Ebene innerhalb</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielstufe</translation>
    </message>
    <message>
        <source>Target and limits</source>
        <translation>Zielstufe und Grenzen</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Tension at the end</source>
        <translation>Spannung am Ende</translation>
    </message>
    <message>
        <source>Tension at the first</source>
        <translation>Spannung an der ersten</translation>
    </message>
    <message>
        <source>Tension at the second</source>
        <translation>Spannung an der zweiten</translation>
    </message>
    <message>
        <source>Tension at the start</source>
        <translation>Spannung am Anfang</translation>
    </message>
    <message>
        <source>The analysis is hidden: the view shows its colours and labels once it is shown.</source>
        <translation>Die Analyse ist ausgeblendet: die Ansicht zeigt ihre Farben und Beschriftungen, sobald sie eingeblendet wird.</translation>
    </message>
    <message>
        <source>The best fill needs {tolerances}; Keep anyway keeps it.</source>
        <translation>Die beste Füllung braucht {tolerances}; „Trotzdem behalten“ behält sie.</translation>
    </message>
    <message>
        <source>The compiled part of Seamwright cannot be loaded ({reason}). {built}This FreeCAD runs Python {python} and OpenCASCADE {occt}: install the Seamwright that was built for it.</source>
        <translation>Der kompilierte Teil von Seamwright kann nicht geladen werden ({reason}). {built}Dieses FreeCAD läuft mit Python {python} und OpenCASCADE {occt}: Installieren Sie das Seamwright, das dafür gebaut wurde.</translation>
    </message>
    <message>
        <source>The crease angle, {crease:g}°, must be larger than the angle tolerance, {angle:g}°</source>
        <translation>Der Winkel der Knickkante, {crease:g}°, muss größer sein als die Winkeltoleranz, {angle:g}°</translation>
    </message>
    <message>
        <source>The edge of the model, or the lines inside the surface</source>
        <translation>Die Kante des Modells oder die Linien in der Fläche</translation>
    </message>
    <message>
        <source>The edge of the seam in the result, or in the model where nothing was kept</source>
        <translation>Die Kante der Naht im Ergebnis, oder im Modell, wo nichts behalten wurde</translation>
    </message>
    <message>
        <source>The edge or edges of the seam</source>
        <translation>Die Kante oder die Kanten der Naht</translation>
    </message>
    <message>
        <source>The faces are flat: they have no radius</source>
        <translation>Die Flächen sind eben: Sie haben keinen Radius</translation>
    </message>
    <message>
        <source>The faces as they look in the document</source>
        <translation>Die Flächen, wie sie im Dokument aussehen</translation>
    </message>
    <message>
        <source>The faces that meet at the seam</source>
        <translation>Die Flächen, die sich an der Naht treffen</translation>
    </message>
    <message>
        <source>The first face was deleted: choose another one in the property FirstFace</source>
        <translation>Die erste Fläche wurde gelöscht: Wählen Sie eine andere in der Eigenschaft FirstFace</translation>
    </message>
    <message>
        <source>The largest value on the whole seam, proven where an upper bound is known. The curve is sampled.</source>
        <translation>Der größte Wert auf der ganzen Naht, bewiesen, wo eine obere Schranke bekannt ist. Die Kurve ist an Punkten gemessen.</translation>
    </message>
    <message>
        <source>The model was changed during the computation</source>
        <translation>Das Modell wurde während der Berechnung geändert</translation>
    </message>
    <message>
        <source>The preferences are not stored: {error}.</source>
        <translation>Die Einstellungen werden nicht gespeichert: {error}.</translation>
    </message>
    <message>
        <source>The property Vertex names {vertices} vertices: name exactly one</source>
        <translation>Die Eigenschaft Vertex nennt {vertices} Eckpunkte: Nennen Sie genau einen</translation>
    </message>
    <message>
        <source>The result itself is selected. Show Before, and select in the model.</source>
        <translation>Das Ergebnis selbst ist ausgewählt. Lassen Sie „Vorher“ anzeigen und wählen Sie im Modell aus.</translation>
    </message>
    <message>
        <source>The seams at these edges:</source>
        <translation>Die Nähte an diesen Kanten:</translation>
    </message>
    <message>
        <source>The seams in the table and in the view</source>
        <translation>Die Nähte in der Tabelle und in der Ansicht</translation>
    </message>
    <message>
        <source>The second face was deleted: choose another one in the property SecondFace</source>
        <translation>Die zweite Fläche wurde gelöscht: Wählen Sie eine andere in der Eigenschaft SecondFace</translation>
    </message>
    <message>
        <source>The side of the surface, or inside it</source>
        <translation>Die Seite der Fläche oder ihr Inneres</translation>
    </message>
    <message>
        <source>The source was deleted: choose another one</source>
        <translation>Die Quelle wurde gelöscht: eine andere wählen</translation>
    </message>
    <message>
        <source>The two faces that meet</source>
        <translation>Die beiden Flächen, die sich treffen</translation>
    </message>
    <message>
        <source>The verdict is certain: it is the same for every value within the bounds</source>
        <translation>Das Urteil ist sicher: Es ist für jeden Wert innerhalb der Schranken dasselbe</translation>
    </message>
    <message>
        <source>The verdict is not certain</source>
        <translation>Das Urteil ist nicht sicher</translation>
    </message>
    <message>
        <source>The {faces} faces of {label} share no edges, so that their outlines are no holes: sew them first, with Repair Seams for example, or select the edges of a hole.</source>
        <translation>Die {faces} Flächen von {label} haben keine gemeinsamen Kanten, daher sind ihre Umrisse keine Löcher: zuerst vernähen, etwa mit „Nähte reparieren“, oder die Kanten eines Lochs auswählen.</translation>
    </message>
    <message>
        <source>There are no points: pick some, or select points or edges and press Use selection.</source>
        <translation>Es gibt keine Punkte: Setzen Sie welche, oder wählen Sie Punkte oder Kanten aus und drücken Sie Auswahl verwenden.</translation>
    </message>
    <message>
        <source>There is nothing to analyse: the document has no faces.</source>
        <translation>Es gibt nichts zu analysieren: Das Dokument hat keine Flächen.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Three-sided</source>
        <translation>Dreiseitig</translation>
    </message>
    <message>
        <source>Through inner curves</source>
        <translation>Durch innere Kurven</translation>
    </message>
    <message>
        <source>Through points, tension</source>
        <translation>Durch Punkte, Spannung</translation>
    </message>
    <message>
        <source>Through points, tension and bias</source>
        <translation>Durch Punkte, Spannung und Bias</translation>
    </message>
    <message>
        <source>Through {points} points, {figures}.</source>
        <translation>Durch {points} Punkte, {figures}.</translation>
    </message>
    <message>
        <source>Ticked holes are filled. Click a hole to see it and to select its edges.</source>
        <translation>Angehakte Löcher werden gefüllt. Ein Klick auf ein Loch zeigt es und wählt seine Kanten.</translation>
    </message>
    <message>
        <source>To Sketch</source>
        <translation>In Skizze</translation>
    </message>
    <message>
        <source>To fill holes, select one object or some of its edges. To replace a face, select it. Found: {chosen}.</source>
        <translation>Um Löcher zu füllen, wählen Sie ein Objekt oder einige seiner Kanten aus. Um eine Fläche zu ersetzen, wählen Sie diese aus. Gefunden: {chosen}.</translation>
    </message>
    <message>
        <source>To repair seams, select one object or some of its edges. Found: {objects}.</source>
        <translation>Um Nähte zu reparieren, wählen Sie ein Objekt oder einige seiner Kanten aus. Gefunden: {objects}.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Tolerances of new objects</source>
        <translation>Toleranzen neuer Objekte</translation>
    </message>
    <message>
        <source>U and V lines</source>
        <translation>U- und V-Linien</translation>
    </message>
    <message>
        <source>U lines</source>
        <translation>U-Linien</translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>Schirm</translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>Schirmfüllung</translation>
    </message>
    <message>
        <source>Umbrella fill</source>
        <translation>Schirmfüllung</translation>
    </message>
    <message>
        <source>Uncertain</source>
        <translation>Unsicher</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Up to (may be empty)</source>
        <translation>Bis zu (kann fehlen)</translation>
    </message>
    <message>
        <source>Update preview</source>
        <translation>Vorschau aktualisieren</translation>
    </message>
    <message>
        <source>Use selection</source>
        <translation>Auswahl verwenden</translation>
    </message>
    <message>
        <source>Use what is selected now instead: {needs}</source>
        <translation>Stattdessen verwenden, was jetzt ausgewählt ist: {needs}</translation>
    </message>
    <message>
        <source>Use what is selected now instead: {tip}</source>
        <translation>Stattdessen verwenden, was jetzt ausgewählt ist: {tip}</translation>
    </message>
    <message>
        <source>V lines</source>
        <translation>V-Linien</translation>
    </message>
    <message>
        <source>Values were changed, but the seams were not analysed with them.</source>
        <translation>Werte wurden geändert, aber die Nähte noch nicht mit ihnen analysiert.</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>What is plotted along the seam</source>
        <translation>Was entlang der Naht aufgetragen wird</translation>
    </message>
    <message>
        <source>What the colours of the faces show</source>
        <translation>Was die Farben der Flächen zeigen</translation>
    </message>
    <message>
        <source>What the colours of the seams in the view show</source>
        <translation>Was die Farben der Nähte in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Whether class and level are the same for every value within the bounds</source>
        <translation>Ob Klasse und Stufe für jeden Wert innerhalb der Schranken dieselben sind</translation>
    </message>
    <message>
        <source>Whether the seam certainly has its level</source>
        <translation>Ob die Naht ihre Stufe sicher hat</translation>
    </message>
    <message>
        <source>Whether the seam certainly meets the target</source>
        <translation>Ob die Naht die Zielstufe sicher erreicht</translation>
    </message>
    <message>
        <source>Width = {width:g}: less than 1 is needed</source>
        <translation>Breite = {width:g}: Weniger als 1 ist nötig</translation>
    </message>
    <message>
        <source>Width of the lines</source>
        <translation>Breite der Linien</translation>
    </message>
    <message>
        <source>Width of the stripes</source>
        <translation>Breite der Streifen</translation>
    </message>
    <message>
        <source>Worst first</source>
        <translation>Schlechteste zuerst</translation>
    </message>
    <message>
        <source>Write a table with a line for each seam that is shown, in this order</source>
        <translation>Eine Tabelle mit einer Zeile für jede gezeigte Naht schreiben, in dieser Reihenfolge</translation>
    </message>
    <message>
        <source>Write the report of all seams as the command seamwright does</source>
        <translation>Den Bericht über alle Nähte schreiben, wie der Befehl seamwright es tut</translation>
    </message>
    <message>
        <source>Zebra stripes</source>
        <translation>Zebrastreifen</translation>
    </message>
    <message>
        <source>Zebra stripes on a ball</source>
        <translation>Zebrastreifen auf einer Kugel</translation>
    </message>
    <message>
        <source>Zoom to seam</source>
        <translation>Auf Naht zoomen</translation>
    </message>
    <message>
        <source>a closed spline</source>
        <translation>ein geschlossener Spline</translation>
    </message>
    <message>
        <source>a curvature tolerance of {figure} %</source>
        <translation>eine Krümmungstoleranz von {figure} %</translation>
    </message>
    <message>
        <source>a curve of degree {degree} is {distance:.3g} mm from {edge}, and {tolerance_mm:g} mm are allowed: divide the edge, or allow more</source>
        <translation>eine Kurve vom Grad {degree} ist {distance:.3g} mm von {edge} entfernt, und {tolerance_mm:g} mm sind erlaubt: Teilen Sie die Kante, oder erlauben Sie mehr</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a face has no curve in its parameters along the seam</source>
        <translation>eine Fläche hat entlang der Naht keine Kurve in ihren Parametern</translation>
    </message>
    <message>
        <source>a gap tolerance of {figure} mm</source>
        <translation>eine Spalttoleranz von {figure} mm</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>a point is ({point}): coordinates must be finite and below {most:g} mm</source>
        <translation>ein Punkt ist ({point}): Koordinaten müssen endlich und kleiner als {most:g} mm sein</translation>
    </message>
    <message>
        <source>a point is chosen: choose edges, wires or sketches</source>
        <translation>ein Punkt ist gewählt: Wählen Sie Kanten, Drähte oder Skizzen</translation>
    </message>
    <message>
        <source>a pole</source>
        <translation>ein Kontrollpunkt</translation>
    </message>
    <message>
        <source>a vertex</source>
        <translation>ein Eckpunkt</translation>
    </message>
    <message>
        <source>along the seam, mm</source>
        <translation>entlang der Naht, mm</translation>
    </message>
    <message>
        <source>an angle tolerance of {figure}°</source>
        <translation>eine Winkeltoleranz von {figure}°</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>an edge has no tangent at its end: choose another end</source>
        <translation>eine Kante hat an ihrem Ende keine Tangente: Wählen Sie ein anderes Ende</translation>
    </message>
    <message>
        <source>an edge has no tangent at the point: choose other edges</source>
        <translation>eine Kante hat am Punkt keine Tangente: Wählen Sie andere Kanten</translation>
    </message>
    <message>
        <source>angle at most {figure}°</source>
        <translation>Winkel höchstens {figure}°</translation>
    </message>
    <message>
        <source>angle unknown</source>
        <translation>Winkel unbekannt</translation>
    </message>
    <message>
        <source>angle {figure}°</source>
        <translation>Winkel {figure}°</translation>
    </message>
    <message>
        <source>angle ≤ {angle_deg:g}°</source>
        <translation>Winkel ≤ {angle_deg:g}°</translation>
    </message>
    <message>
        <source>apart from creases, largest gap {gap} mm, largest angle {angle}°</source>
        <translation>abgesehen von Knickkanten größter Spalt {gap} mm, größter Winkel {angle}°</translation>
    </message>
    <message>
        <source>arcs and rational splines can only be divided for single curves: for a surface, let splines take their place</source>
        <translation>Bögen und rationale Splines können nur für einzelne Kurven geteilt werden: Für eine Fläche lassen Sie Splines an ihre Stelle treten</translation>
    </message>
    <message>
        <source>as a bowl or a dome</source>
        <translation>wie eine Schale oder eine Kuppel</translation>
    </message>
    <message>
        <source>as a saddle</source>
        <translation>wie ein Sattel</translation>
    </message>
    <message>
        <source>as a sphere of radius {radius} mm</source>
        <translation>wie eine Kugel vom Radius {radius} mm</translation>
    </message>
    <message>
        <source>as little as needed</source>
        <translation>so wenig wie nötig</translation>
    </message>
    <message>
        <source>at ({point})</source>
        <translation>bei ({point})</translation>
    </message>
    <message>
        <source>at least {least:g}</source>
        <translation>mindestens {least:g}</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>höchstens {most}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto: {setback:.4g} {unit}</source>
        <translation>auto: {setback:.4g} {unit}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>between</source>
        <translation>dazwischen</translation>
    </message>
    <message>
        <source>beyond the edges of the other shape</source>
        <translation>jenseits der Ränder der anderen Form</translation>
    </message>
    <message>
        <source>by size of face</source>
        <translation>nach Größe der Fläche</translation>
    </message>
    <message>
        <source>change of curvature {figure}</source>
        <translation>Krümmungsänderung {figure}</translation>
    </message>
    <message>
        <source>choose edges, or nothing</source>
        <translation>Wählen Sie Kanten, oder nichts</translation>
    </message>
    <message>
        <source>choose faces or edges of faces, or nothing</source>
        <translation>Wählen Sie Flächen oder Kanten von Flächen, oder nichts</translation>
    </message>
    <message>
        <source>choose one edge of both faces, or nothing</source>
        <translation>wählen Sie eine Kante beider Flächen oder nichts</translation>
    </message>
    <message>
        <source>choose one face</source>
        <translation>wählen Sie eine Fläche</translation>
    </message>
    <message>
        <source>choose one vertex</source>
        <translation>wählen Sie einen Eckpunkt</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>konkav</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>konvex</translation>
    </message>
    <message>
        <source>curvature at most {figure} %</source>
        <translation>Krümmung höchstens {figure} %</translation>
    </message>
    <message>
        <source>curvature unknown</source>
        <translation>Krümmung unbekannt</translation>
    </message>
    <message>
        <source>curvature {figure}</source>
        <translation>Krümmung {figure}</translation>
    </message>
    <message>
        <source>curvature {figure} %</source>
        <translation>Krümmung {figure} %</translation>
    </message>
    <message>
        <source>curvature ≤ {curvature_rel:g} %</source>
        <translation>Krümmung ≤ {curvature_rel:g} %</translation>
    </message>
    <message>
        <source>defects before {before}, after {after}</source>
        <translation>Fehler vorher {before}, nachher {after}</translation>
    </message>
    <message>
        <source>drafts away from the pull</source>
        <translation>Schräge von der Entformungsrichtung weg</translation>
    </message>
    <message>
        <source>drafts towards the pull</source>
        <translation>Schräge zur Entformungsrichtung hin</translation>
    </message>
    <message>
        <source>edge {number}</source>
        <translation>Kante {number}</translation>
    </message>
    <message>
        <source>edge {number} does not belong to a hole: it is not free, or not part of a closed loop</source>
        <translation>Kante {number} gehört zu keinem Loch: Sie ist nicht frei, oder nicht Teil einer geschlossenen Schleife</translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary</source>
        <translation>Kante {number} des äußeren Rands</translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary does not lead from the end of an edge to that of its neighbour: it ends {distance} mm from the nearest end</source>
        <translation>Kante {number} des äußeren Rands führt nicht vom Ende einer Kante zu dem der benachbarten: Sie endet {distance} mm vom nächsten Ende</translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary leads from edge {first} to edge {second}: choose one or two edges for each two neighbours</source>
        <translation>Kante {number} des äußeren Rands führt von Kante {first} zu Kante {second}: Wählen Sie eine oder zwei Kanten für je zwei benachbarte</translation>
    </message>
    <message>
        <source>edges moved by at most {moved} mm, edge {number} most</source>
        <translation>Kanten um höchstens {moved} mm verschoben, Kante {number} am weitesten</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>equal change of curvature</source>
        <translation>gleiche Änderung der Krümmung</translation>
    </message>
    <message>
        <source>equal curvature</source>
        <translation>gleiche Krümmung</translation>
    </message>
    <message>
        <source>every seam is {order}</source>
        <translation>jede Naht ist {order}</translation>
    </message>
    <message>
        <source>exchange of surfaces between CAD systems</source>
        <translation>Austausch von Flächen zwischen CAD-Systemen</translation>
    </message>
    <message>
        <source>falls short of {level}</source>
        <translation>verfehlt {level}</translation>
    </message>
    <message>
        <source>fill, {face}</source>
        <translation>Füllung, {face}</translation>
    </message>
    <message>
        <source>fillet, face</source>
        <translation>Verrundung, Fläche</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>eben</translation>
    </message>
    <message>
        <source>flat, or a saddle</source>
        <translation>eben, oder ein Sattel</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>gap at most {figure} mm</source>
        <translation>Spalt höchstens {figure} mm</translation>
    </message>
    <message>
        <source>gap at most {gap_mm} mm, angle at most {angle_deg}°</source>
        <translation>Spalt höchstens {gap_mm} mm, Winkel höchstens {angle_deg}°</translation>
    </message>
    <message>
        <source>gap larger than the tolerance</source>
        <translation>Spalt größer als die Toleranz</translation>
    </message>
    <message>
        <source>gap unknown</source>
        <translation>Spalt unbekannt</translation>
    </message>
    <message>
        <source>gap {figure} mm</source>
        <translation>Spalt {figure} mm</translation>
    </message>
    <message>
        <source>gap ≤ {gap_mm:g} mm</source>
        <translation>Spalt ≤ {gap_mm:g} mm</translation>
    </message>
    <message>
        <source>has no points or edges</source>
        <translation>hat keine Punkte oder Kanten</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>inside a face</source>
        <translation>in einer Fläche</translation>
    </message>
    <message>
        <source>is a mesh</source>
        <translation>ist ein Netz</translation>
    </message>
    <message>
        <source>is chosen as a whole</source>
        <translation>ist als Ganzes gewählt</translation>
    </message>
    <message>
        <source>is not an edge or a face</source>
        <translation>ist weder Kante noch Fläche</translation>
    </message>
    <message>
        <source>lateral boundary</source>
        <translation>seitlicher Rand</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>line {number}</source>
        <translation>Linie {number}</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>zugeordnet</translation>
    </message>
    <message>
        <source>mechanical parts</source>
        <translation>mechanische Teile</translation>
    </message>
    <message>
        <source>meet with an angle</source>
        <translation>treffen sich unter einem Winkel</translation>
    </message>
    <message>
        <source>meet without a kink</source>
        <translation>treffen sich ohne Knick</translation>
    </message>
    <message>
        <source>meets {level}</source>
        <translation>erreicht {level}</translation>
    </message>
    <message>
        <source>meets {target}</source>
        <translation>erreicht {target}</translation>
    </message>
    <message>
        <source>middle of {edge}</source>
        <translation>Mitte von {edge}</translation>
    </message>
    <message>
        <source>misses {target}</source>
        <translation>verfehlt {target}</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation>muss endlich sein</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no arcs</source>
        <translation>keine Bögen</translation>
    </message>
    <message>
        <source>no chains</source>
        <translation>keine Kantenzüge</translation>
    </message>
    <message>
        <source>no conics</source>
        <translation>keine Kegelschnitte</translation>
    </message>
    <message>
        <source>no corner</source>
        <translation>keine Ecke</translation>
    </message>
    <message>
        <source>no creases</source>
        <translation>keine Knickkanten</translation>
    </message>
    <message>
        <source>no curves</source>
        <translation>keine Kurven</translation>
    </message>
    <message>
        <source>no defects</source>
        <translation>keine Fehler</translation>
    </message>
    <message>
        <source>no document is open: make or open one first</source>
        <translation>kein Dokument ist offen: zuerst eines anlegen oder öffnen</translation>
    </message>
    <message>
        <source>no edge is a polynomial spline of degree 2 or more: lines, arcs and rational splines stay as they are</source>
        <translation>keine Kante ist ein polynomialer Spline vom Grad 2 oder mehr: Strecken, Bögen und rationale Splines bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>no edge is chosen: choose the edges of a side</source>
        <translation>keine Kante ist gewählt: Wählen Sie die Kanten einer Seite</translation>
    </message>
    <message>
        <source>no edge moved</source>
        <translation>keine Kante verschoben</translation>
    </message>
    <message>
        <source>no edges</source>
        <translation>keine Kanten</translation>
    </message>
    <message>
        <source>no face could be divided into triangles: see Check geometry in the workbench Part</source>
        <translation>keine Fläche konnte in Dreiecke zerlegt werden: siehe Geometrie prüfen im Arbeitsbereich Part</translation>
    </message>
    <message>
        <source>no face moved</source>
        <translation>keine Fläche verschoben</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>keine Flächen</translation>
    </message>
    <message>
        <source>no features</source>
        <translation>keine Merkmale</translation>
    </message>
    <message>
        <source>no free edges</source>
        <translation>keine freien Kanten</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>keine Löcher</translation>
    </message>
    <message>
        <source>no inflections</source>
        <translation>keine Wendepunkte</translation>
    </message>
    <message>
        <source>no joints</source>
        <translation>keine Verbindungsstellen</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>no lines</source>
        <translation>keine Strecken</translation>
    </message>
    <message>
        <source>no lines of joints</source>
        <translation>keine Verbindungslinien</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>keine Zahlen</translation>
    </message>
    <message>
        <source>no objects</source>
        <translation>keine Objekte</translation>
    </message>
    <message>
        <source>no pieces</source>
        <translation>keine Stücke</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>no seams</source>
        <translation>keine Nähte</translation>
    </message>
    <message>
        <source>no sides</source>
        <translation>keine Seiten</translation>
    </message>
    <message>
        <source>no sources</source>
        <translation>keine Quellen</translation>
    </message>
    <message>
        <source>no splines within {tolerance:g} mm of the curves were found: take a larger tolerance</source>
        <translation>keine Splines innerhalb {tolerance:g} mm der Kurven wurden gefunden: Nehmen Sie eine größere Toleranz</translation>
    </message>
    <message>
        <source>no verdicts</source>
        <translation>keine Urteile</translation>
    </message>
    <message>
        <source>no vertex</source>
        <translation>kein Eckpunkt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>not every seam is certainly {order}</source>
        <translation>nicht jede Naht ist sicher {order}</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>nothing is chosen for “{title}”: {needs}</source>
        <translation>nichts ist gewählt für „{title}“: {needs}</translation>
    </message>
    <message>
        <source>nothing is selected: {needs}</source>
        <translation>nichts ist ausgewählt: {needs}</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>nichts verschoben</translation>
    </message>
    <message>
        <source>of the input too</source>
        <translation>auch der Eingabe</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on {edge}</source>
        <translation>auf {edge}</translation>
    </message>
    <message>
        <source>one for each processor</source>
        <translation>einer je Prozessor</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>patch, face</source>
        <translation>Flächenstück, Fläche</translation>
    </message>
    <message>
        <source>patch, fillet</source>
        <translation>Flächenstück, Verrundung</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>points and edges are chosen: choose either</source>
        <translation>Punkte und Kanten sind gewählt: Wählen Sie nur eines davon</translation>
    </message>
    <message>
        <source>points {first} and {second} are the same, ({point}): leave one of them out</source>
        <translation>die Punkte {first} und {second} sind gleich, ({point}): Lassen Sie einen weg</translation>
    </message>
    <message>
        <source>pole</source>
        <translation>Kontrollpunkt</translation>
    </message>
    <message>
        <source>poles moved by up to {largest_move_mm} mm</source>
        <translation>Kontrollpunkte um bis zu {largest_move_mm} mm verschoben</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>bewiesen</translation>
    </message>
    <message>
        <source>radius {radius} mm</source>
        <translation>Radius {radius} mm</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>repariert</translation>
    </message>
    <message>
        <source>sampled at the points of the mesh</source>
        <translation>gemessen an den Punkten des Netzes</translation>
    </message>
    <message>
        <source>seen from the side of the normals</source>
        <translation>von der Seite der Normalen aus gesehen</translation>
    </message>
    <message>
        <source>seen, without an upper bound</source>
        <translation>gesehen, ohne obere Schranke</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>select edges at which two faces meet, or edges that lie side by side</source>
        <translation>wählen Sie Kanten aus, an denen zwei Flächen sich treffen, oder Kanten, die nebeneinander liegen</translation>
    </message>
    <message>
        <source>select edges, a wire or a sketch with splines, or points that lie in a plane</source>
        <translation>wählen Sie Kanten, einen Draht oder eine Skizze mit Splines aus, oder Punkte, die in einer Ebene liegen</translation>
    </message>
    <message>
        <source>select edges, a wire, a sketch or points that lie in a plane</source>
        <translation>wählen Sie Kanten, einen Draht, eine Skizze oder Punkte aus, die in einer Ebene liegen</translation>
    </message>
    <message>
        <source>select edges, wires or faces</source>
        <translation>wählen Sie Kanten, Drähte oder Flächen aus</translation>
    </message>
    <message>
        <source>select objects with faces</source>
        <translation>wählen Sie Objekte mit Flächen aus</translation>
    </message>
    <message>
        <source>select others and press “Use selection” at “{title}” in the panel</source>
        <translation>Wählen Sie andere aus, und drücken Sie im Panel bei „{title}“ auf „Auswahl verwenden“</translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch</source>
        <translation>wählen Sie Punkte, Kanten, einen Draht oder eine Skizze aus</translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch that lie in a plane</source>
        <translation>wählen Sie Punkte, Kanten, einen Draht oder eine Skizze aus, die in einer Ebene liegen</translation>
    </message>
    <message>
        <source>select the edges of a side; where an edge lies between two faces, also the face to continue</source>
        <translation>wählen Sie die Kanten einer Seite aus; liegt eine Kante zwischen zwei Flächen, auch die fortzusetzende Fläche</translation>
    </message>
    <message>
        <source>select the edges of two sides; where an edge lies between two faces, also the face to continue</source>
        <translation>wählen Sie die Kanten zweier Seiten aus; liegt eine Kante zwischen zwei Flächen, auch die fortzusetzende Fläche</translation>
    </message>
    <message>
        <source>select three or more edges that end in one point</source>
        <translation>wählen Sie drei oder mehr Kanten aus, die in einem Punkt enden</translation>
    </message>
    <message>
        <source>select three points or more, a wire or a sketch, in a plane</source>
        <translation>wählen Sie drei oder mehr Punkte, einen Draht oder eine Skizze in einer Ebene aus</translation>
    </message>
    <message>
        <source>select three points, a wire or a sketch of two lines, or two edges, in a plane</source>
        <translation>wählen Sie drei Punkte, einen Draht oder eine Skizze aus zwei Strecken, oder zwei Kanten in einer Ebene aus</translation>
    </message>
    <message>
        <source>select two edges</source>
        <translation>wählen Sie zwei Kanten aus</translation>
    </message>
    <message>
        <source>select two objects with faces: first the one to colour</source>
        <translation>wählen Sie zwei Objekte mit Flächen aus: zuerst das zu färbende</translation>
    </message>
    <message>
        <source>select two or more edges, wires or sketches</source>
        <translation>wählen Sie zwei oder mehr Kanten, Drähte oder Skizzen aus</translation>
    </message>
    <message>
        <source>shared</source>
        <translation>gemeinsam</translation>
    </message>
    <message>
        <source>sharper than {crease_deg:g}°, taken as intended</source>
        <translation>schärfer als {crease_deg:g}°, gilt als gewollt</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>smallest radius {radius} mm</source>
        <translation>kleinster Radius {radius} mm</translation>
    </message>
    <message>
        <source>some curves are closed and some are open: choose curves of one kind</source>
        <translation>einige Kurven sind geschlossen und einige offen: Wählen Sie Kurven einer Art</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>such a spline</source>
        <translation>ein solcher Spline</translation>
    </message>
    <message>
        <source>such face</source>
        <translation>solche Fläche</translation>
    </message>
    <message>
        <source>tangents in one plane within</source>
        <translation>Tangenten in einer Ebene innerhalb</translation>
    </message>
    <message>
        <source>that all edges have the curvature of one surface at the point</source>
        <translation>dass alle Kanten im Punkt die Krümmung einer einzigen Fläche haben</translation>
    </message>
    <message>
        <source>that the faces close around the point</source>
        <translation>dass sich die Flächen um den Punkt schließen</translation>
    </message>
    <message>
        <source>the edges are {chains} separate curves: choose one</source>
        <translation>die Kanten sind {chains} getrennte Kurven: Wählen Sie eine</translation>
    </message>
    <message>
        <source>the edges cannot be joined so: {reason}</source>
        <translation>die Kanten können so nicht verbunden werden: {reason}</translation>
    </message>
    <message>
        <source>the edges lie side by side only in a short part</source>
        <translation>die Kanten liegen nur auf einem kurzen Stück nebeneinander</translation>
    </message>
    <message>
        <source>the edges meet where the curve would be: choose other ends, or other edges</source>
        <translation>die Kanten treffen sich dort, wo die Kurve wäre: andere Enden oder andere Kanten wählen</translation>
    </message>
    <message>
        <source>the edges of {name} were deleted: {advice}</source>
        <translation>die Kanten von {name} wurden gelöscht: {advice}</translation>
    </message>
    <message>
        <source>the fill itself</source>
        <translation>die Füllung selbst</translation>
    </message>
    <message>
        <source>the first {last:.3g}</source>
        <translation>das erste {last:.3g}</translation>
    </message>
    <message>
        <source>the last {first:.3g}</source>
        <translation>das letzte {first:.3g}</translation>
    </message>
    <message>
        <source>the lights run in the direction in which they lie: choose another one</source>
        <translation>die Lampen laufen in der Richtung, in der sie liegen: Wählen Sie eine andere</translation>
    </message>
    <message>
        <source>the outer boundary has edges in the sector that stays open: choose edges of the other sectors</source>
        <translation>der äußere Rand hat Kanten im Sektor, der offen bleibt: Wählen Sie Kanten der anderen Sektoren</translation>
    </message>
    <message>
        <source>the outer boundary has {count} edges between edges {first} and {second}: one or two are possible</source>
        <translation>der äußere Rand hat {count} Kanten zwischen den Kanten {first} und {second}: eine oder zwei sind möglich</translation>
    </message>
    <message>
        <source>the points or edges are not in one plane: they are up to {distance:.3g} mm off it, and {flatness_mm:g} mm are allowed</source>
        <translation>die Punkte oder Kanten liegen nicht in einer Ebene: Sie sind bis zu {distance:.3g} mm davon entfernt, und {flatness_mm:g} mm sind erlaubt</translation>
    </message>
    <message>
        <source>the range goes from {low:g} to {high:g}: give a larger upper end</source>
        <translation>der Bereich geht von {low:g} bis {high:g}: Geben Sie ein größeres oberes Ende an</translation>
    </message>
    <message>
        <source>the seam is exact up to rounding</source>
        <translation>die Naht ist bis auf Rundung exakt</translation>
    </message>
    <message>
        <source>the selection has {edges}, in {groups}: {needs}</source>
        <translation>die Auswahl hat {edges}, in {groups}: {needs}</translation>
    </message>
    <message>
        <source>the shape to compare with has no faces: choose another one</source>
        <translation>die Form, mit der verglichen wird, hat keine Flächen: Wählen Sie eine andere</translation>
    </message>
    <message>
        <source>the shape to compare with has no triangles</source>
        <translation>die Form, mit der verglichen wird, hat keine Dreiecke</translation>
    </message>
    <message>
        <source>the sources were deleted: {advice}</source>
        <translation>die Quellen wurden gelöscht: {advice}</translation>
    </message>
    <message>
        <source>the surface comes within {distance_mm:.3g} mm of the curves between, not within {tolerance_mm:g} mm: take a tolerance above {distance_mm:.3g} mm</source>
        <translation>die Fläche kommt den Kurven dazwischen auf {distance_mm:.3g} mm nahe, nicht auf {tolerance_mm:g} mm: eine Toleranz über {distance_mm:.3g} mm wählen</translation>
    </message>
    <message>
        <source>the surface folds {distance_mm} mm from the side</source>
        <translation>die Fläche faltet sich {distance_mm} mm von der Seite</translation>
    </message>
    <message>
        <source>the three points are on a line: move the corner off it</source>
        <translation>die drei Punkte liegen auf einer Geraden: Rücken Sie die Ecke davon weg</translation>
    </message>
    <message>
        <source>the tolerance</source>
        <translation>die Toleranz</translation>
    </message>
    <message>
        <source>the tolerance is 0: splines hold clothoids within a tolerance only</source>
        <translation>die Toleranz ist 0: Splines geben Klothoiden nur innerhalb einer Toleranz wieder</translation>
    </message>
    <message>
        <source>the {edges} edges do not end in one point: choose edges that meet in a vertex</source>
        <translation>die {edges} Kanten enden nicht in einem Punkt: Wählen Sie Kanten, die sich in einem Eckpunkt treffen</translation>
    </message>
    <message>
        <source>the {edges} edges do not join to one curve</source>
        <translation>die {edges} Kanten verbinden sich nicht zu einer Kurve</translation>
    </message>
    <message>
        <source>there are no curves: {needs}</source>
        <translation>es gibt keine Kurven: {needs}</translation>
    </message>
    <message>
        <source>there are no points</source>
        <translation>es gibt keine Punkte</translation>
    </message>
    <message>
        <source>there are no sources: {advice}</source>
        <translation>es gibt keine Quellen: {advice}</translation>
    </message>
    <message>
        <source>there are two points: a conic needs three or more</source>
        <translation>es gibt zwei Punkte: Ein Kegelschnitt braucht drei oder mehr</translation>
    </message>
    <message>
        <source>there are {points} points: a spiral has three, its start, the corner of its tangents and its end</source>
        <translation>es gibt {points} Punkte: Eine Spirale hat drei, ihren Anfang, die Ecke ihrer Tangenten und ihr Ende</translation>
    </message>
    <message>
        <source>there are {points} points: four or more can be made fair</source>
        <translation>es gibt {points} Punkte: Vier oder mehr können geglättet werden</translation>
    </message>
    <message>
        <source>there are {points} points: one conic has three, its start, the corner of its tangents and its end</source>
        <translation>es gibt {points} Punkte: Ein Kegelschnitt hat drei, seinen Anfang, die Ecke seiner Tangenten und sein Ende</translation>
    </message>
    <message>
        <source>there are {points} points: {what} needs {least} or more</source>
        <translation>es gibt {points} Punkte: {what} braucht {least} oder mehr</translation>
    </message>
    <message>
        <source>there is no face at which the surface ends: choose one</source>
        <translation>es gibt keine Fläche, an der die Fläche endet: Wählen Sie eine</translation>
    </message>
    <message>
        <source>there is only one curve: choose two or more</source>
        <translation>es gibt nur eine Kurve: Wählen Sie zwei oder mehr</translation>
    </message>
    <message>
        <source>there is only one point: choose two or more</source>
        <translation>es gibt nur einen Punkt: Wählen Sie zwei oder mehr</translation>
    </message>
    <message>
        <source>three-sided faces join with G1 only: choose four-sided faces, or G1</source>
        <translation>dreiseitige Flächen schließen nur mit G1 an: Wählen Sie vierseitige Flächen, oder G1</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>zu steil</translation>
    </message>
    <message>
        <source>two fillets</source>
        <translation>zwei Verrundungen</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>zwei Flächenstücke</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>unexpected error: {error}</source>
        <translation>unerwarteter Fehler: {error}</translation>
    </message>
    <message>
        <source>values beyond have the end colours</source>
        <translation>Werte darüber hinaus haben die Endfarben</translation>
    </message>
    <message>
        <source>visible surfaces, judged by their reflections</source>
        <translation>sichtbare Flächen, nach ihren Spiegelungen beurteilt</translation>
    </message>
    <message>
        <source>with G2 the outer boundary is found, and cannot be given: choose G1, or take the edges out of the outer boundary</source>
        <translation>mit G2 wird der äußere Rand bestimmt und kann nicht vorgegeben werden: Wählen Sie G1, oder nehmen Sie die Kanten aus dem äußeren Rand</translation>
    </message>
    <message>
        <source>within the tolerances</source>
        <translation>innerhalb der Toleranzen</translation>
    </message>
    <message>
        <source>within the tolerances; the shape changes up to {depth} mm away from the seam</source>
        <translation>innerhalb der Toleranzen; die Form ändert sich bis zu {depth} mm von der Naht entfernt</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{along} x {across} poles</source>
        <translation>{along} x {across} Kontrollpunkte</translation>
    </message>
    <message>
        <source>{arcs} and {lines}{chains}, {length_mm} mm long, at most {distance_mm} mm from the input</source>
        <translation>{arcs} und {lines}{chains}, {length_mm} mm lang, höchstens {distance_mm} mm von der Eingabe</translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no list</source>
        <translation>{argument} = {value!r} ist keine Liste</translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no number</source>
        <translation>{argument} = {value!r} ist keine Zahl</translation>
    </message>
    <message>
        <source>{argument} has {numbers} coordinates: give three</source>
        <translation>{argument} hat {numbers} Koordinaten: Geben Sie drei an</translation>
    </message>
    <message>
        <source>{certain} of {verdicts} certain</source>
        <translation>{verdicts}, davon {certain} sicher</translation>
    </message>
    <message>
        <source>{conics} of weights {least_weight} to {largest_weight}</source>
        <translation>{conics} mit Gewichten {least_weight} bis {largest_weight}</translation>
    </message>
    <message>
        <source>{conics}, {length_mm} mm long{jumps}{near}.</source>
        <translation>{conics}, {length_mm} mm lang{jumps}{near}.</translation>
    </message>
    <message>
        <source>{count} arc</source>
        <translation>{count} Bogen</translation>
    </message>
    <message>
        <source>{count} arcs</source>
        <translation>{count} Bögen</translation>
    </message>
    <message>
        <source>{count} chain</source>
        <translation>{count} Kantenzug</translation>
    </message>
    <message>
        <source>{count} chains</source>
        <translation>{count} Kantenzüge</translation>
    </message>
    <message>
        <source>{count} conic</source>
        <translation>{count} Kegelschnitt</translation>
    </message>
    <message>
        <source>{count} conics</source>
        <translation>{count} Kegelschnitte</translation>
    </message>
    <message>
        <source>{count} crease</source>
        <translation>{count} Knickkante</translation>
    </message>
    <message>
        <source>{count} creases</source>
        <translation>{count} Knickkanten</translation>
    </message>
    <message>
        <source>{count} curve</source>
        <translation>{count} Kurve</translation>
    </message>
    <message>
        <source>{count} curves</source>
        <translation>{count} Kurven</translation>
    </message>
    <message>
        <source>{count} defect</source>
        <translation>{count} Fehler</translation>
    </message>
    <message>
        <source>{count} defects</source>
        <translation>{count} Fehler</translation>
    </message>
    <message>
        <source>{count} edge</source>
        <translation>{count} Kante</translation>
    </message>
    <message>
        <source>{count} edges</source>
        <translation>{count} Kanten</translation>
    </message>
    <message>
        <source>{count} extrema</source>
        <translation>{count} Extrema</translation>
    </message>
    <message>
        <source>{count} extremum</source>
        <translation>{count} Extremum</translation>
    </message>
    <message>
        <source>{count} face</source>
        <translation>{count} Fläche</translation>
    </message>
    <message>
        <source>{count} faces</source>
        <translation>{count} Flächen</translation>
    </message>
    <message>
        <source>{count} feature</source>
        <translation>{count} Merkmal</translation>
    </message>
    <message>
        <source>{count} features</source>
        <translation>{count} Merkmale</translation>
    </message>
    <message>
        <source>{count} free edge</source>
        <translation>{count} freie Kante</translation>
    </message>
    <message>
        <source>{count} free edges</source>
        <translation>{count} freie Kanten</translation>
    </message>
    <message>
        <source>{count} hole</source>
        <translation>{count} Loch</translation>
    </message>
    <message>
        <source>{count} holes</source>
        <translation>{count} Löcher</translation>
    </message>
    <message>
        <source>{count} inflection</source>
        <translation>{count} Wendepunkt</translation>
    </message>
    <message>
        <source>{count} inflections</source>
        <translation>{count} Wendepunkte</translation>
    </message>
    <message>
        <source>{count} joint</source>
        <translation>{count} Verbindungsstelle</translation>
    </message>
    <message>
        <source>{count} joints</source>
        <translation>{count} Verbindungsstellen</translation>
    </message>
    <message>
        <source>{count} line</source>
        <translation>{count} Strecke</translation>
    </message>
    <message>
        <source>{count} line of joints</source>
        <translation>{count} Verbindungslinie</translation>
    </message>
    <message>
        <source>{count} lines</source>
        <translation>{count} Strecken</translation>
    </message>
    <message>
        <source>{count} lines of joints</source>
        <translation>{count} Verbindungslinien</translation>
    </message>
    <message>
        <source>{count} number</source>
        <translation>{count} Zahl</translation>
    </message>
    <message>
        <source>{count} numbers</source>
        <translation>{count} Zahlen</translation>
    </message>
    <message>
        <source>{count} object</source>
        <translation>{count} Objekt</translation>
    </message>
    <message>
        <source>{count} objects</source>
        <translation>{count} Objekte</translation>
    </message>
    <message>
        <source>{count} piece</source>
        <translation>{count} Stück</translation>
    </message>
    <message>
        <source>{count} pieces</source>
        <translation>{count} Stücke</translation>
    </message>
    <message>
        <source>{count} point</source>
        <translation>{count} Punkt</translation>
    </message>
    <message>
        <source>{count} points</source>
        <translation>{count} Punkte</translation>
    </message>
    <message>
        <source>{count} seam</source>
        <translation>{count} Naht</translation>
    </message>
    <message>
        <source>{count} seams</source>
        <translation>{count} Nähte</translation>
    </message>
    <message>
        <source>{count} side</source>
        <translation>{count} Seite</translation>
    </message>
    <message>
        <source>{count} sides</source>
        <translation>{count} Seiten</translation>
    </message>
    <message>
        <source>{count} source</source>
        <translation>{count} Quelle</translation>
    </message>
    <message>
        <source>{count} sources</source>
        <translation>{count} Quellen</translation>
    </message>
    <message>
        <source>{count} verdict</source>
        <translation>{count} Urteil</translation>
    </message>
    <message>
        <source>{count} verdicts</source>
        <translation>{count} Urteile</translation>
    </message>
    <message>
        <source>{count}; largest gap seen {gap_mm} mm, largest angle {angle_deg}°.</source>
        <translation>{count}; größter gesehener Spalt {gap_mm} mm, größter Winkel {angle_deg}°.</translation>
    </message>
    <message>
        <source>{defects} as sharp as a crease, but with a gap</source>
        <translation>{defects} so scharf wie eine Knickkante, aber mit Spalt</translation>
    </message>
    <message>
        <source>{done} of {fills} filled</source>
        <translation>{fills}, davon {done} gefüllt</translation>
    </message>
    <message>
        <source>{done} of {wanted} repaired to {target}</source>
        <translation>{wanted}, davon {done} auf {target} repariert</translation>
    </message>
    <message>
        <source>{edges_led} got new curves on their faces</source>
        <translation>{edges_led} mit neuen Kurven auf ihren Flächen</translation>
    </message>
    <message>
        <source>{edges} (model)</source>
        <translation>{edges} (Modell)</translation>
    </message>
    <message>
        <source>{edges} can be matched: see Tolerances.</source>
        <translation>{edges} können zugeordnet werden: siehe Toleranzen.</translation>
    </message>
    <message>
        <source>{edges} chosen: choose three or more</source>
        <translation>{edges} gewählt: Wählen Sie drei oder mehr</translation>
    </message>
    <message>
        <source>{edges} chosen: choose two</source>
        <translation>{edges} gewählt: Wählen Sie zwei</translation>
    </message>
    <message>
        <source>{edges} to round.</source>
        <translation>{edges} zu verrunden.</translation>
    </message>
    <message>
        <source>{edges}; edges lie side by side: match them within {proposed:g} mm.</source>
        <translation>{edges}; Kanten liegen nebeneinander: Ordnen Sie sie innerhalb {proposed:g} mm zu.</translation>
    </message>
    <message>
        <source>{edges}; none lie side by side within {tried:g} mm.</source>
        <translation>{edges}; keine liegen innerhalb {tried:g} mm nebeneinander.</translation>
    </message>
    <message>
        <source>{edge} bounds {faces}: {needs}</source>
        <translation>{edge} begrenzt {faces}: {needs}</translation>
    </message>
    <message>
        <source>{element} is not {what}: name one, such as {kind}1.</source>
        <translation>{element} ist nicht {what}: Nennen Sie das Richtige, etwa {kind}1.</translation>
    </message>
    <message>
        <source>{faces} faces are chosen: only one can be replaced at a time</source>
        <translation>{faces} Flächen sind gewählt: Nur eine kann auf einmal ersetzt werden</translation>
    </message>
    <message>
        <source>{faces} through {keys} curves, within {distance_mm} mm</source>
        <translation>{faces} durch {keys} Kurven, innerhalb {distance_mm} mm</translation>
    </message>
    <message>
        <source>{faces} to replace.</source>
        <translation>{faces} zu ersetzen.</translation>
    </message>
    <message>
        <source>{face} has {along} x {across} poles</source>
        <translation>{face} hat {along} x {across} Kontrollpunkte</translation>
    </message>
    <message>
        <source>{face} joins {others} to the tolerance; the shape changes up to {depth_mm} mm away from the seam</source>
        <translation>{face} schließt innerhalb der Toleranz an {others} an; die Form ändert sich bis {depth_mm} mm von der Naht entfernt</translation>
    </message>
    <message>
        <source>{face} will be replaced</source>
        <translation>{face} wird ersetzt</translation>
    </message>
    <message>
        <source>{fills} replaced</source>
        <translation>{fills} ersetzt</translation>
    </message>
    <message>
        <source>{first:.6g} to {last:.6g}</source>
        <translation>{first:.6g} bis {last:.6g}</translation>
    </message>
    <message>
        <source>{holes} to fill.</source>
        <translation>{holes} zu füllen.</translation>
    </message>
    <message>
        <source>{holes} with {faces}; {seams}; {verdict}.</source>
        <translation>{holes} mit {faces}; {seams}; {verdict}.</translation>
    </message>
    <message>
        <source>{label} contains nothing with a shape: choose another object.</source>
        <translation>{label} enthält nichts mit einer Form: Wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>{label} has faces: choose curves</source>
        <translation>{label} hat Flächen: Wählen Sie Kurven</translation>
    </message>
    <message>
        <source>{label} has no curve: {summary}</source>
        <translation>{label} hat keine Kurve: {summary}</translation>
    </message>
    <message>
        <source>{label} has no edges: choose edges of faces</source>
        <translation>{label} hat keine Kanten: Wählen Sie Kanten von Flächen</translation>
    </message>
    <message>
        <source>{label} has no edges: {needs}</source>
        <translation>{label} hat keine Kanten: {needs}</translation>
    </message>
    <message>
        <source>{label} has no faces: choose an object with faces.</source>
        <translation>{label} hat keine Flächen: Wählen Sie ein Objekt mit Flächen.</translation>
    </message>
    <message>
        <source>{label} has no faces: {needs}</source>
        <translation>{label} hat keine Flächen: {needs}</translation>
    </message>
    <message>
        <source>{label} has no hole: no free edges form a closed loop.</source>
        <translation>{label} hat kein Loch: Keine freien Kanten bilden eine geschlossene Schleife.</translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object</source>
        <translation>{label} hat keine Form: Wählen Sie ein anderes Objekt</translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object.</source>
        <translation>{label} hat keine Form: Wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>{label} has no shape: recompute it or choose another object.</source>
        <translation>{label} hat keine Form: Berechnen Sie es neu, oder wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>{label} has no shape: {needs}</source>
        <translation>{label} hat keine Form: {needs}</translation>
    </message>
    <message>
        <source>{label} has no {element}: choose another one.</source>
        <translation>{label} hat kein {element}: Wählen Sie etwas anderes.</translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one</source>
        <translation>{label} hat kein {name}: Wählen Sie etwas anderes</translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one.</source>
        <translation>{label} hat kein {name}: Wählen Sie etwas anderes.</translation>
    </message>
    <message>
        <source>{label} has {curves}</source>
        <translation>{label} hat {curves}</translation>
    </message>
    <message>
        <source>{label} has {faces} faces: choose some of its edges, or one face.</source>
        <translation>{label} hat {faces} Flächen: Wählen Sie einige ihrer Kanten, oder eine Fläche.</translation>
    </message>
    <message>
        <source>{label} has {numbers} numbers for {count} {what}: give one for each, or one for all</source>
        <translation>{label} hat {numbers} Zahlen für {count} {what}: Geben Sie für jedes eine an, oder eine für alle</translation>
    </message>
    <message>
        <source>{label} is a mesh: make a shape of it first, with Create shape from mesh of the workbench Part.</source>
        <translation>{label} ist ein Netz: Machen Sie erst eine Form daraus, mit Form aus Netz erzeugen des Arbeitsbereichs Part.</translation>
    </message>
    <message>
        <source>{label} is a sketch and has no faces: choose an object with faces.</source>
        <translation>{label} ist eine Skizze und hat keine Flächen: Wählen Sie ein Objekt mit Flächen.</translation>
    </message>
    <message>
        <source>{label} is in another document, {document}: select objects of one document.</source>
        <translation>{label} liegt in einem anderen Dokument, {document}: Objekte eines einzigen Dokuments auswählen.</translation>
    </message>
    <message>
        <source>{label} is made from this {group}: choose others</source>
        <translation>{label} ist aus diesem Objekt ({group}) erzeugt: Wählen Sie andere</translation>
    </message>
    <message>
        <source>{label} sketch</source>
        <translation>Skizze von {label}</translation>
    </message>
    <message>
        <source>{label} was deleted: {advice}</source>
        <translation>{label} wurde gelöscht: {advice}</translation>
    </message>
    <message>
        <source>{label} {what}: choose points, edges, wires or sketches.</source>
        <translation>{label} {what}: Wählen Sie Punkte, Kanten, Drähte oder Skizzen.</translation>
    </message>
    <message>
        <source>{label}.{element} is a point: {needs}</source>
        <translation>{label}.{element} ist ein Punkt: {needs}</translation>
    </message>
    <message>
        <source>{label}: Face{face} is not drawn correctly: {reason}</source>
        <translation>{label}: Face{face} ist nicht richtig gezeichnet: {reason}</translation>
    </message>
    <message>
        <source>{last:.3g} at {first:.6g}</source>
        <translation>{last:.3g} bei {first:.6g}</translation>
    </message>
    <message>
        <source>{least} to {largest} {unit}, the strongest {place}</source>
        <translation>{least} bis {largest} {unit}, am stärksten {place}</translation>
    </message>
    <message>
        <source>{least} {unit} everywhere</source>
        <translation>überall {least} {unit}</translation>
    </message>
    <message>
        <source>{length_mm} mm long, turns by {turn_deg}°, radius {first_radius_mm} to {last_radius_mm} mm{near}.</source>
        <translation>{length_mm} mm lang, dreht sich um {turn_deg}°, Radius {first_radius_mm} bis {last_radius_mm} mm{near}.</translation>
    </message>
    <message>
        <source>{length_mm} mm long; curvature: {extrema}, {inflections}</source>
        <translation>{length_mm} mm lang; Krümmung: {extrema}, {inflections}</translation>
    </message>
    <message>
        <source>{level} is met</source>
        <translation>{level} ist erreicht</translation>
    </message>
    <message>
        <source>{level} is not met</source>
        <translation>{level} ist nicht erreicht</translation>
    </message>
    <message>
        <source>{level} is not met, kept anyway</source>
        <translation>{level} ist nicht erreicht, trotzdem behalten</translation>
    </message>
    <message>
        <source>{lines}; all are straight.</source>
        <translation>{lines}; alle sind gerade.</translation>
    </message>
    <message>
        <source>{lines}; largest curvature {largest_per_mm} 1/mm, radius {radius} mm, {largest_at}. Sampled.</source>
        <translation>{lines}; größte Krümmung {largest_per_mm} 1/mm, Radius {radius} mm, {largest_at}. An Punkten gemessen.</translation>
    </message>
    <message>
        <source>{link} is chosen twice: choose two different faces</source>
        <translation>{link} ist zweimal gewählt: Wählen Sie zwei verschiedene Flächen</translation>
    </message>
    <message>
        <source>{link} is not an edge of the two faces</source>
        <translation>{link} ist keine Kante der beiden Flächen</translation>
    </message>
    <message>
        <source>{made} between {keys} curves, within {distance_mm} mm; joints keep up to G{order}, {features} paired.</source>
        <translation>{made} zwischen {keys} Kurven, innerhalb {distance_mm} mm; Verbindungsstellen behalten bis zu G{order}, {features} zugeordnet.</translation>
    </message>
    <message>
        <source>{members} around the point: {state}, {figures}; {followed}.</source>
        <translation>{members} um den Punkt: {state}, {figures}; {followed}.</translation>
    </message>
    <message>
        <source>{moved} moved, poles by up to {largest_move_mm} mm</source>
        <translation>{moved} verschoben, Kontrollpunkte um bis zu {largest_move_mm} mm</translation>
    </message>
    <message>
        <source>{moves} of {faces} faces moved, poles by up to {largest} mm</source>
        <translation>{moves} von {faces} Flächen verschoben, Kontrollpunkte um bis zu {largest} mm</translation>
    </message>
    <message>
        <source>{moves} points were moved, but the sources have {points}: empty the property Moves</source>
        <translation>{moves} Punkte wurden verschoben, aber die Quellen haben {points}: Leeren Sie die Eigenschaft Moves</translation>
    </message>
    <message>
        <source>{names} was deleted: choose others in the property Sources</source>
        <translation>{names} wurde gelöscht: andere in der Eigenschaft Sources wählen</translation>
    </message>
    <message>
        <source>{name} bends both ways, {times} times as strongly as the faces around it: look at its stripes for dents or waves.</source>
        <translation>{name} biegt sich nach beiden Seiten, {times} Mal so stark wie die Flächen ringsum: in den Streifen nach Dellen oder Wellen sehen.</translation>
    </message>
    <message>
        <source>{name} bounds no face: choose an edge of a face</source>
        <translation>{name} begrenzt keine Fläche: Wählen Sie eine Kante einer Fläche</translation>
    </message>
    <message>
        <source>{name} bounds none of the edges: leave it out</source>
        <translation>{name} begrenzt keine der Kanten: Lassen Sie sie weg</translation>
    </message>
    <message>
        <source>{name} cannot be {value!r}: choose True or False</source>
        <translation>{name} kann nicht {value!r} sein: wählen Sie True oder False</translation>
    </message>
    <message>
        <source>{name} cannot be {value}: choose from {least:g} to {largest:g}</source>
        <translation>{name} kann nicht {value} sein: wählen Sie {least:g} bis {largest:g}</translation>
    </message>
    <message>
        <source>{name} does not bound one face alone: select the face to join, too</source>
        <translation>{name} begrenzt nicht genau eine Fläche: Wählen Sie auch die Fläche aus, an die angeschlossen wird</translation>
    </message>
    <message>
        <source>{name} has no edge along {moving} within the match distance of {match_mm} mm (they are {distance} mm apart): allow a larger one, or leave it out</source>
        <translation>{name} hat keine Kante entlang {moving} innerhalb des Anpassungsabstands von {match_mm} mm (ihr Abstand ist {distance} mm): Erlauben Sie einen größeren, oder lassen Sie sie weg</translation>
    </message>
    <message>
        <source>{name} has no edge: {needs}</source>
        <translation>{name} hat keine Kante: {needs}</translation>
    </message>
    <message>
        <source>{name} has no other chosen edge beside it within {match_mm:g} mm</source>
        <translation>neben {name} liegt innerhalb von {match_mm:g} mm keine andere gewählte Kante</translation>
    </message>
    <message>
        <source>{name} has no {element}: choose another one</source>
        <translation>{name} hat kein {element}: Wählen Sie etwas anderes</translation>
    </message>
    <message>
        <source>{name} has {numbers} for the {edges} edges of the corner ({names}): give one for each, or one for all</source>
        <translation>{name} hat {numbers} für die {edges} Kanten der Ecke ({names}): Geben Sie für jede eine an, oder eine für alle</translation>
    </message>
    <message>
        <source>{name} is a vertex: select edges, or the whole object.</source>
        <translation>{name} ist ein Eckpunkt: Kanten oder das ganze Objekt wählen.</translation>
    </message>
    <message>
        <source>{name} is no edge: {needs}</source>
        <translation>{name} ist keine Kante: {needs}</translation>
    </message>
    <message>
        <source>{name} is no seam: its faces do not meet there</source>
        <translation>{name} ist keine Naht: Ihre Flächen treffen sich dort nicht</translation>
    </message>
    <message>
        <source>{name} lies between {faces}: select the face to continue, too</source>
        <translation>{name} liegt zwischen {faces}: Wählen Sie auch die fortzusetzende Fläche aus</translation>
    </message>
    <message>
        <source>{name} names {label}, which is not the source {source}</source>
        <translation>{name} nennt {label}, das nicht die Quelle {source} ist</translation>
    </message>
    <message>
        <source>{name} would join itself: choose other faces</source>
        <translation>{name} würde an sich selbst anschließen: Wählen Sie andere Flächen</translation>
    </message>
    <message>
        <source>{name} {what}: choose edges</source>
        <translation>{name} {what}: Wählen Sie Kanten</translation>
    </message>
    <message>
        <source>{name}, {length_mm} mm along: {figure}</source>
        <translation>{name}, bei {length_mm} mm: {figure}</translation>
    </message>
    <message>
        <source>{name}: not measured</source>
        <translation>{name}: nicht gemessen</translation>
    </message>
    <message>
        <source>{name}: not measured where the angle is that of a crease.</source>
        <translation>{name}: nicht gemessen, wo der Winkel der einer Knickkante ist.</translation>
    </message>
    <message>
        <source>{name}: the largest value is {seam}, {known}.</source>
        <translation>{name}: Der größte Wert ist {seam}, {known}.</translation>
    </message>
    <message>
        <source>{number} is kept.</source>
        <translation>{number} bleibt.</translation>
    </message>
    <message>
        <source>{objects} selected: {needs}</source>
        <translation>{objects} ausgewählt: {needs}</translation>
    </message>
    <message>
        <source>{order} needs {need}: poles would move by {moved} mm, edge {number} most, and {most} mm are allowed: change the edges, or allow more</source>
        <translation>{order} verlangt, {need}: Kontrollpunkte würden um {moved} mm verschoben, bei Kante {number} am weitesten, und {most} mm sind erlaubt: Ändern Sie die Kanten, oder erlauben Sie mehr</translation>
    </message>
    <message>
        <source>{parts}. Sampled at {points}: between them it may be larger.</source>
        <translation>{parts}. An Punkten gemessen ({points}): dazwischen kann es mehr sein.</translation>
    </message>
    <message>
        <source>{path} is not installed; the repository has it.</source>
        <translation>{path} ist nicht installiert; das Repository hat es.</translation>
    </message>
    <message>
        <source>{path}: cannot be written: {strerror}.</source>
        <translation>{path}: kann nicht geschrieben werden: {strerror}.</translation>
    </message>
    <message>
        <source>{path}: the folder {folder} does not exist; create it first.</source>
        <translation>{path}: Den Ordner {folder} gibt es nicht; legen Sie ihn erst an.</translation>
    </message>
    <message>
        <source>{path}: the name must end in .csv or .json.</source>
        <translation>{path}: Der Name muss auf .csv oder .json enden.</translation>
    </message>
    <message>
        <source>{pieces}, {length_mm} mm long, {sharpest}, at most {distance_mm} mm from the input.</source>
        <translation>{pieces}, {length_mm} mm lang, {sharpest}, höchstens {distance_mm} mm von der Eingabe.</translation>
    </message>
    <message>
        <source>{points}{place}. {how}</source>
        <translation>{points}{place}. {how}</translation>
    </message>
    <message>
        <source>{preview_tip}; nothing is kept until OK is pressed</source>
        <translation>{preview_tip}; nichts wird behalten, bis OK gedrückt wird</translation>
    </message>
    <message>
        <source>{purpose}: gap {gap_mm:g} mm, angle {angle_deg:g}°, curvature {curvature_rel:g} %</source>
        <translation>{purpose}: Spalt {gap_mm:g} mm, Winkel {angle_deg:g}°, Krümmung {curvature_rel:g} %</translation>
    </message>
    <message>
        <source>{quantity} curvature</source>
        <translation>{quantity} Krümmung</translation>
    </message>
    <message>
        <source>{quantity} curvature {range}. {mesh}.</source>
        <translation>{quantity} Krümmung {range}. {mesh}.</translation>
    </message>
    <message>
        <source>{reason}: allow a change over a larger Depth, or a larger Fairness</source>
        <translation>{reason}: Erlauben Sie eine Änderung über eine größere Tiefe (Depth), oder eine größere Glätte (Fairness)</translation>
    </message>
    <message>
        <source>{seams} seams are marked; only the edges of the first {selected} are selected.</source>
        <translation>{seams} Nähte sind markiert; nur die Kanten der ersten {selected} sind ausgewählt.</translation>
    </message>
    <message>
        <source>{sewn} sewn</source>
        <translation>{sewn} vernäht</translation>
    </message>
    <message>
        <source>{signs}
values beyond ±{limit_per_mm} 1/mm have the end colours</source>
        <translation>{signs}
Werte jenseits von ±{limit_per_mm} 1/mm haben die Endfarben</translation>
    </message>
    <message>
        <source>{step} is a step of {body}: later steps do not count. To follow all steps, select {body}.</source>
        <translation>{step} ist ein Schritt von {body}: Spätere Schritte zählen nicht. Damit alle Schritte zählen, {body} auswählen.</translation>
    </message>
    <message>
        <source>{summary} Not seen, since they are hidden: {labels}.</source>
        <translation>{summary} Nicht zu sehen, da ausgeblendet: {labels}.</translation>
    </message>
    <message>
        <source>{surface}; across {seams}: angle at most {angle_deg}°, curvature at most {curvature_rel} %.</source>
        <translation>{surface}; über {seams}: Winkel höchstens {angle_deg}°, Krümmung höchstens {curvature_rel} %.</translation>
    </message>
    <message>
        <source>{target} is met</source>
        <translation>{target} ist erreicht</translation>
    </message>
    <message>
        <source>{target} is not certain at {name}</source>
        <translation>{target} ist an {name} nicht sicher</translation>
    </message>
    <message>
        <source>{target} is uncertain</source>
        <translation>{target} ist unsicher</translation>
    </message>
    <message>
        <source>{target} uncertain</source>
        <translation>{target} unsicher</translation>
    </message>
    <message>
        <source>{total}: {defect}, {crease}, {smooth} smooth</source>
        <translation>{total}: {defect}, {crease}, {smooth} glatt</translation>
    </message>
    <message>
        <source>{wanted} to repair to {target}.</source>
        <translation>{wanted} auf {target} zu reparieren.</translation>
    </message>
    <message>
        <source>{what} = {direction}: three numbers are needed, not all zero</source>
        <translation>{what} = {direction}: Drei Zahlen sind nötig, nicht alle null</translation>
    </message>
    <message>
        <source>{what} would move by {moved_mm:.4g} mm, further than the {most_mm:g} mm that are allowed</source>
        <translation>{what} würde um {moved_mm:.4g} mm verschoben, weiter als die erlaubten {most_mm:g} mm</translation>
    </message>
    <message>
        <source>{why}; nothing was analysed.</source>
        <translation>{why}; nichts wurde analysiert.</translation>
    </message>
    <message>
        <source>{why}; press Preview to analyse and repair the seams.</source>
        <translation>{why}; drücken Sie Vorschau, um die Nähte zu analysieren und zu reparieren.</translation>
    </message>
    <message>
        <source>{written} of {every} seams ({show}) are written to {path}.</source>
        <translation>{written} von {every} Nähten ({show}) sind in {path} geschrieben.</translation>
    </message>
    <message>
        <source>{written} of {every} seams are written to {path}.</source>
        <translation>{written} von {every} Nähten sind in {path} geschrieben.</translation>
    </message>
    <message>
        <source>“{label}” is {angle:g}°: at most 90° is needed</source>
        <translation>„{label}“ ist {angle:g}°: höchstens 90° ist nötig</translation>
    </message>
    <message>
        <source>“{text}” is no such number: {kept} is kept.</source>
        <translation>„{text}“ ist keine solche Zahl: {kept} bleibt.</translation>
    </message>
    <message>
        <source>“{text}” is not a list of numbers: write them with blanks or semicolons, such as 0; 0; 50.</source>
        <translation>„{text}“ ist keine Liste von Zahlen: Schreiben Sie sie mit Leerzeichen oder Semikolons, etwa 0; 0; 50.</translation>
    </message>
</context>
<context>
    <name>Seamwright_AnalyzeSeams</name>
    <message>
        <source>Analyze Seams</source>
        <translation>Nähte analysieren</translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation>Misst Spalt, Winkel und Krümmung, wo Flächen der ausgewählten Objekte sich treffen, und färbt die Nähte nach dem Ergebnis. Ohne Auswahl werden alle Körper und Schalen des Dokuments analysiert, oder wenn es keine hat, alle Flächen.</translation>
    </message>
</context>
<context>
    <name>Seamwright_Arcs</name>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Make arcs and lines within a tolerance of the selected edges, wires, sketch or points of a plane. The distance is proven; few arcs are searched for.</source>
        <translation>Erzeugt Bögen und Strecken innerhalb einer Toleranz der ausgewählten Kanten, Drähte, Skizze oder Punkte einer Ebene. Der Abstand ist bewiesen; es werden wenige Bögen gesucht.</translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendCurves</name>
    <message>
        <source>Blend Curves</source>
        <translation>Zwischenkurven</translation>
    </message>
    <message>
        <source>Make curves between two or more selected curves, or the surface through them. Every joint of a curve between is as smooth as those of the selected ones.</source>
        <translation>Erzeugt Kurven zwischen zwei oder mehr ausgewählten Kurven, oder die Fläche durch sie. Jede Verbindungsstelle einer Kurve dazwischen ist so glatt wie die der ausgewählten.</translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendSurface</name>
    <message>
        <source>Blend Surface</source>
        <translation>Übergangsfläche</translation>
    </message>
    <message>
        <source>Make a surface between two sides, edges or chains of edges of faces. It joins each with its own order: position (G0), tangent planes (G1), curvature (G2) or its change (G3).</source>
        <translation>Erzeugt eine Fläche zwischen zwei Seiten, Kanten oder Kantenzügen von Flächen. An jede schließt sie mit deren eigener Ordnung an: Position (G0), Tangentialebenen (G1), Krümmung (G2) oder deren Änderung (G3).</translation>
    </message>
</context>
<context>
    <name>Seamwright_BridgeCurve</name>
    <message>
        <source>Bridge Curve</source>
        <translation>Brückenkurve</translation>
    </message>
    <message>
        <source>Make a curve from an end of one selected edge to an end of another one. It continues each with its own order: position (G0), tangent (G1), curvature (G2) or its change (G3).</source>
        <translation>Erzeugt eine Kurve von einem Ende einer ausgewählten Kante zu einem Ende einer anderen. Sie setzt jede mit eigener Ordnung fort: Lage (G0), Tangente (G1), Krümmung (G2) oder deren Änderung (G3).</translation>
    </message>
</context>
<context>
    <name>Seamwright_Clothoid</name>
    <message>
        <source>Clothoid</source>
        <translation>Klothoide</translation>
    </message>
    <message>
        <source>Lay clothoids through the selected points, or within a tolerance of the selected edges, wires or sketch of a plane: their curvature is continuous and linear in the length. Lines and arcs stay, with a clothoid between them.</source>
        <translation>Legt Klothoiden durch die ausgewählten Punkte, oder innerhalb einer Toleranz der ausgewählten Kanten, Drähte oder Skizze einer Ebene: Ihre Krümmung ist stetig und linear in der Länge. Strecken und Bögen bleiben, mit einer Klothoide dazwischen.</translation>
    </message>
</context>
<context>
    <name>Seamwright_Conic</name>
    <message>
        <source>Conic</source>
        <translation>Kegelschnitt</translation>
    </message>
    <message>
        <source>Make a conic from three selected points: start, corner of the tangents, end. Or lay a spline of conics with continuous curvature through points of a plane.</source>
        <translation>Erzeugt einen Kegelschnitt aus drei ausgewählten Punkten: Anfang, Ecke der Tangenten, Ende. Oder legt einen Spline aus Kegelschnitten mit stetiger Krümmung durch Punkte einer Ebene.</translation>
    </message>
</context>
<context>
    <name>Seamwright_CornerFillet</name>
    <message>
        <source>Corner Fillet</source>
        <translation>Eckverrundung</translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation>Verrundet die 3 bis 6 Kanten am ausgewählten Eckpunkt eines Körpers, jede mit eigenem Radius. Flächenstücke schließen die Ecke zwischen den Verrundungen ohne Knick.</translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureComb</name>
    <message>
        <source>Curvature Comb</source>
        <translation>Krümmungskamm</translation>
    </message>
    <message>
        <source>Draw a curvature comb on the selected edges and wires, and on iso-curves of the selected faces. The lines of the comb are as long as the curvature is large: a jump is a step of curvature, a kink of the comb a step of its change.</source>
        <translation>Zeichnet einen Krümmungskamm auf die ausgewählten Kanten und Drähte und auf Isolinien der ausgewählten Flächen. Die Linien des Kamms sind so lang, wie die Krümmung groß ist: Ein Sprung ist ein Sprung der Krümmung, ein Knick des Kamms ein Sprung ihrer Änderung.</translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureMap</name>
    <message>
        <source>Colour the faces of the selected objects by their curvature: mean, Gaussian or largest curvature, or smallest radius. With nothing selected, all visible objects are coloured.</source>
        <translation>Färbt die Flächen der ausgewählten Objekte nach ihrer Krümmung: mittlere, Gaußsche oder größte Krümmung, oder kleinster Radius. Ohne Auswahl werden alle sichtbaren Objekte gefärbt.</translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>Krümmungsbild</translation>
    </message>
</context>
<context>
    <name>Seamwright_Deviation</name>
    <message>
        <source>Colour the first of two selected objects by its distance from the second: blue inside, orange outside, with the largest value and its place. Sampled, so not a proven figure.</source>
        <translation>Färbt das erste von zwei ausgewählten Objekten nach seinem Abstand vom zweiten: blau innen, orange außen, mit dem größten Wert und seinem Ort. An Punkten gemessen, also kein bewiesener Wert.</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
</context>
<context>
    <name>Seamwright_DraftAngle</name>
    <message>
        <source>Colour the faces of the selected objects by their angle to a direction of pull: those that leave a mould, those that are too steep, and those of the other half of the mould.</source>
        <translation>Färbt die Flächen der ausgewählten Objekte nach ihrem Winkel zu einer Entformungsrichtung: die sich aus der Form lösen, die zu steilen, und die der anderen Hälfte der Form.</translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>Formschräge</translation>
    </message>
</context>
<context>
    <name>Seamwright_ExportReport</name>
    <message>
        <source>Export Seam Report…</source>
        <translation>Nahtbericht exportieren…</translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation>Schreibt die Ergebnisse der ausgewählten Nahtanalyse in eine Datei, als Tabelle (CSV) oder als Bericht (JSON). Ohne Auswahl wird die neueste Analyse geschrieben.</translation>
    </message>
</context>
<context>
    <name>Seamwright_ExtendSurface</name>
    <message>
        <source>Continue faces beyond an edge or a chain of edges, over a length or up to a face, with their tangent planes (G1), curvatures (G2) or the change of these (G3).</source>
        <translation>Setzt Flächen jenseits einer Kante oder eines Kantenzugs fort, über eine Länge oder bis zu einer Fläche, mit ihren Tangentialebenen (G1), Krümmungen (G2) oder deren Änderung (G3).</translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>Fläche verlängern</translation>
    </message>
</context>
<context>
    <name>Seamwright_FairCurve</name>
    <message>
        <source>Fair Curve</source>
        <translation>Kurve glätten</translation>
    </message>
    <message>
        <source>Make the selected edges fair: splines whose curvature has few extrema and that move by no more than a tolerance. Points of a plane are moved, and a smooth curve goes through them.</source>
        <translation>Glättet die ausgewählten Kanten: Splines, deren Krümmung wenige Extrema hat und die um höchstens eine Toleranz abweichen. Punkte einer Ebene werden verschoben, und eine glatte Kurve geht durch sie.</translation>
    </message>
</context>
<context>
    <name>Seamwright_FrameLoft</name>
    <message>
        <source>Loft through Frames</source>
        <translation>Fläche durch Zwischenkurven</translation>
    </message>
    <message>
        <source>Make the surface through two or more selected curves. Across the lines that join corresponding joints of the curves it is as smooth as the curves are: G1, G2 or more.</source>
        <translation>Erzeugt die Fläche durch zwei oder mehr ausgewählte Kurven. Quer zu den Linien, die einander entsprechende Verbindungsstellen der Kurven verbinden, ist sie so glatt wie die Kurven: G1, G2 oder mehr.</translation>
    </message>
</context>
<context>
    <name>Seamwright_Help</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation>Die Dokumentation von Seamwright öffnen. Ist ein Objekt von Seamwright ausgewählt, öffnet sie sich beim Abschnitt über dessen Befehl.</translation>
    </message>
</context>
<context>
    <name>Seamwright_JoinCurves</name>
    <message>
        <source>Join Curves</source>
        <translation>Kurven verbinden</translation>
    </message>
    <message>
        <source>Join two selected edges at their nearest ends with a common tangent (G1), curvature (G2) or change of the curvature (G3), by the smallest move of their poles there. Or let the second continue the first, which stays.</source>
        <translation>Verbindet zwei ausgewählte Kanten an ihren nächsten Enden mit gemeinsamer Tangente (G1), Krümmung (G2) oder Krümmungsänderung (G3), mit der kleinsten Verschiebung ihrer Kontrollpunkte dort. Oder die zweite setzt die erste fort, die bleibt.</translation>
    </message>
</context>
<context>
    <name>Seamwright_LogSpiral</name>
    <message>
        <source>Log Spiral</source>
        <translation>Logarithmische Spirale</translation>
    </message>
    <message>
        <source>Make a logarithmic spiral, whose radius grows by the same factor with each degree of turn, from three selected points: start, corner of the tangents, end. Or let it continue two edges of a plane from end to end.</source>
        <translation>Erzeugt eine logarithmische Spirale, deren Radius mit jedem Grad der Drehung um denselben Faktor wächst, aus drei ausgewählten Punkten: Anfang, Ecke der Tangenten, Ende. Oder lässt sie zwei Kanten einer Ebene von Ende zu Ende fortsetzen.</translation>
    </message>
</context>
<context>
    <name>Seamwright_MatchSurfaces</name>
    <message>
        <source>Match Surfaces</source>
        <translation>Flächen anpassen</translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation>Verschiebt die zweite von zwei ausgewählten Flächen, oder beide, bis sie ohne Knick (G1) oder mit gleicher Krümmung (G2) aneinanderschließen. Haben sie mehrere gemeinsame Kanten, auch die anzupassende Kante auswählen. Von mehr Flächen wird die letzte verschoben und schließt an alle anderen an; Kanten stehen für ihre Flächen.</translation>
    </message>
</context>
<context>
    <name>Seamwright_ReflectionLines</name>
    <message>
        <source>Draw lines on the faces of the selected objects that break where faces meet at an angle, and bend where the curvature jumps: zebra stripes with options, isophotes or highlight lines. With nothing selected, they are drawn on all visible objects.</source>
        <translation>Zeichnet Linien auf die Flächen der ausgewählten Objekte, die abbrechen, wo Flächen sich unter einem Winkel treffen, und knicken, wo die Krümmung springt: Zebrastreifen mit Optionen, Isophoten oder Glanzlinien. Ohne Auswahl werden sie auf alle sichtbaren Objekte gezeichnet.</translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>Reflexionslinien</translation>
    </message>
</context>
<context>
    <name>Seamwright_RepairSeams</name>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation>Verschiebt Flächen des ausgewählten Objekts so wenig wie möglich, bis seine Nähte glatt sind: ohne Knick (G1) oder mit gleicher Krümmung (G2). Um nur einige Nähte zu reparieren, deren Kanten oder Zeilen einer Analyse auswählen.</translation>
    </message>
    <message>
        <source>Repair Seams</source>
        <translation>Nähte reparieren</translation>
    </message>
</context>
<context>
    <name>Seamwright_SeamPlot</name>
    <message>
        <source>Plot gap, angle and curvature along the seams of the selected edges, with the proven bounds of the largest value. The mouse in the plot marks the point on the seam.</source>
        <translation>Trägt Spalt, Winkel und Krümmung entlang der Nähte der ausgewählten Kanten auf, mit den bewiesenen Schranken des größten Werts. Die Maus im Diagramm markiert den Punkt auf der Naht.</translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>Nahtdiagramm</translation>
    </message>
</context>
<context>
    <name>Seamwright_Spline</name>
    <message>
        <source>Make a spline with continuous curvature through the selected points or the points of a wire, a sketch or edges, or near the polygon of these points. Tension and bias shape it at each point.</source>
        <translation>Erzeugt einen Spline mit stetiger Krümmung durch die ausgewählten Punkte oder die Punkte eines Drahts, einer Skizze oder von Kanten, oder nahe dem Polygon dieser Punkte. Spannung und Bias formen ihn an jedem Punkt.</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
</context>
<context>
    <name>Seamwright_Umbrella</name>
    <message>
        <source>Make faces around a point from three or more selected edges that end there with tangents in one plane: a face between each two neighbouring edges. All of them have common tangent planes along the edges, or with G2 common curvature, too.</source>
        <translation>Erzeugt Flächen um einen Punkt aus drei oder mehr ausgewählten Kanten, die dort mit Tangenten in einer Ebene enden: eine Fläche zwischen je zwei benachbarten Kanten. Alle haben gemeinsame Tangentialebenen entlang der Kanten, mit G2 auch gemeinsame Krümmung.</translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>Schirm</translation>
    </message>
</context>
<context>
    <name>Seamwright_UmbrellaFill</name>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation>Schließt Löcher des ausgewählten Objekts mit Flächen, die tangential an ihre Nachbarn anschließen. Um nur einige Löcher zu füllen, je eine Kante auswählen. Um eine Fläche zu ersetzen, diese auswählen.</translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>Schirmfüllung</translation>
    </message>
</context>
<context>
    <name>Seamwright_ZebraStripes</name>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation>Zeigt, wie die Flächen der ausgewählten Objekte, oder aller sichtbaren Objekte, Streifen spiegeln. Die Streifen brechen ab, wo Flächen sich unter einem Winkel treffen, und knicken, wo die Krümmung springt. Ein erneuter Aufruf entfernt sie.</translation>
    </message>
    <message>
        <source>Zebra Stripes</source>
        <translation>Zebrastreifen</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Measure and repair the seams of CAD models: gap, angle and curvature where faces meet</source>
        <translation>Nähte von CAD-Modellen messen und reparieren: Spalt, Winkel und Krümmung, wo Flächen sich treffen</translation>
    </message>
    <message>
        <source>Seamwright Analysis</source>
        <translation>Seamwright Analyse</translation>
    </message>
    <message>
        <source>Seamwright Curves</source>
        <translation>Seamwright Kurven</translation>
    </message>
    <message>
        <source>Seamwright Surfaces</source>
        <translation>Seamwright Flächen</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
</context>
</TS>
