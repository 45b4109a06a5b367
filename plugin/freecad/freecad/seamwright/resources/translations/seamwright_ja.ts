<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A larger move is refused, in mm; 0: no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A seam counts as an intended crease if its angle is larger than this, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A side counts as flat if all its radii of curvature are larger than this, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A side of a hole ends where its tangent turns by more than this, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also measure points that lie beyond a free edge of the other shape: their distance is that to the edge, and has no sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle by which the stripes lean; 0: upright, 90: level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle from one isophote to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the seam after the match, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the seam before the match, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arcs and other rational edges stay as they are, and the faces are rational</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic: the colours cover all values but the outermost 2 % of the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin at the other end of the first edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin at the other end of the first of two edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below 1 an ellipse, 1 a parabola, above 1 a hyperbola</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much the points of the sources were moved, in mm; one for each, or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much the tangent turns, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour each point by how far it moved, with a legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction at the first point, against the first axis of the plane, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction at the last point, against the first axis of the plane, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from one lamp to the next; 0: 12 lamps over the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from the curves, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the ends before, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances from the vertex at which the fillets end, in mm, in the order of CornerEdges, or one distance for all edges; 0 or empty: automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divide the selected curves into corresponding pieces; otherwise, splines near them take their place, so that the curves between are fairer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the curvature comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges at which the faces end: one or two from the end of an edge to that of the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges at which two faces meet, or edges side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges between the ends of the sides, along which the lateral boundaries run, and the faces beside them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges of the first side, and faces to continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges of the second side, and faces to continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges of the side, and faces to continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges, wires or faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges, wires or sketches from which the surface is made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End at the other end of the second edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End at the other end of the second of two edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extrema of the curvature before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extrema of the curvature now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that must not move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the half that is pulled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the other half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor by which the variation of the curvature of a face may grow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four-sided faces, or three-sided ones, which are three faces each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free edges no further apart than this are a seam, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free edges no further apart than this are measured as seams too, in mm; 0: off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free edges no further apart than this are repaired as seams too, in mm; 0: off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free edges no further apart than this may be the common boundary, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the first point to the next pole, in mm; 0: the end is free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the last pole but one to the last point, in mm; 0: the end is free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the middle of the model; 0: half of the size of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further faces that the moving face joins as the other face, or edges of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap of the seam after the match, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap of the seam before the match, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the legend's letters, in pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far from the seam the moved face may change, in mm; 0: as little as needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the surface keeps its direction, by the distance of the sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How smoothly the curves between change at a selected curve that is neither the first nor the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the spline is made of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inflections of a planar curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iso-curves of a face in each direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join the last point to the first; wires that are closed always are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints at which the curvature jumps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep a fill even if it misses the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the two other boundaries that end at the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that is G1, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that meets G1, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam for G1 and G2, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle of a tangent with the plane of all tangents, in degrees; the edges are turned into that plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle seen after the repair, creases excluded, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle seen before the repair, creases excluded, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle that was seen, creases excluded, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle that was seen, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest curvature, in 1/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the sides of the patches and the fillets, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam that meets G0, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the two sides of each new seam, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the input, in both directions, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the clothoids from edges, in mm; points are passed through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the curves that take the place of edges which are no single polynomial curve, such as arcs, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the ends of the edges from their mean, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the splines from the spiral, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of these splines and of the surface, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest gap seen after the repair, creases excluded, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest gap seen before the repair, creases excluded, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest gap that was seen, creases excluded, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest gap that was seen, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm; no point of a face moved further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that is G2; 0.02 is 2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that meets G2; 0.02 is 2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of each new seam for G2; 0.02 is 2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the lines of the comb; 1: the longest is 15 % of the size of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the lines; 1: the longest is 15 % of the size of all curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the surface, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tangent at the first edge, by the distance of the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tangent at the second edge, by the distance of the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the end run in the other direction than that in which the surface is less twisted; lateral boundaries say the direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level of continuity after the match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level of continuity before the match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level of continuity to reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level that every new seam must meet; G0: position only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level that every seam should meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light stripes on a whole ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of the comb on each curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make no face in the largest sector between two edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean: half the sum of the principal curvatures. Gaussian: their product. Largest: the larger one without its sign. Smallest radius: 1 by the largest curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names of the Sources at the last analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point moved further, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point moves further than this, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point of a face may move further than this, in mm; 0: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pole may move further than this, in mm; 0: no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pole of an edge moved further, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pole, or no point of a continuation, moved further, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of arcs; 0: as few as possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of clothoids, arcs and lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of conics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of curves with a comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of curves, with the first and the last of the selected ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of defects after the repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of defects before the repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of edges that bound one face and are in no seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of faces of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of faces that moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of holes that were filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of holes that were to be filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of lines of the comb, on all edges together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of new faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of patches of the corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of points at which each seam is sampled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of points taken between the ends of each edge that is not straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams</source>
        <translation>継ぎ目の数</translation>
    </message>
    <message>
        <source>Number of seams of two free edges that lie side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams sharper than the crease angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams that fall short of the level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams that were repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams that were to be repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of seams whose verdict is not certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects with faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of all faces; 0: the lowest that suffices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One edge of each hole to fill; empty: all holes except outer boundaries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number above 0.5, up to 1, for each segment, or one for all: 1 is nearest to the polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number for each point, or one for all. It tightens the spline: the larger the number without bias, the more negative with bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number for each point, or one for all: the speed before the point by that after it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number for each segment, or one for all: 1 is the B-spline, smaller ones draw the curve to the polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points and edges may be off their common plane by no more, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the spline that belong to no other object, in mm; where there are any, the sources are not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points, edges, wires or sketches from which the curve is made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poles at the joint move as little as possible, or the second edge begins as the continuation of the first says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proven bound of the distance, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radii in mm, in the order of CornerEdges, or one radius for all edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of curvature at the end, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of curvature at the start, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative difference of curvature after the match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative difference of curvature before the match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its first inner pole lies; one number for each side, or one for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its second inner pole lies; one number for each side, or one for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the legend in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single curves, or a surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest radius, in mm; 0: straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Splines near the spiral, or tangent arcs of one sweep whose radii are a geometric progression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The common edge along which the faces are matched; empty: the longest one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity of the faces across the edges: tangent planes (G1) or curvature, too (G2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity of the joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity that every joint keeps: tangents (G1), curvature (G2) or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the faces beside the lateral boundaries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the faces of the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the faces of the side; G1 is ruled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the faces of the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the first edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The continuity with the second edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge that moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edges at the vertex, in the order of Radii and Setbacks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edges of the seams to repair; empty: all defects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face at which the surface ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face that moves; away from the seam it keeps its shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face to replace; empty: holes are filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest value at the points of the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least value at the points of the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object whose holes are filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object whose holes are filled, or one of its faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object whose seams are repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object with the corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The objects from which distances are measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The objects that were analysed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The objects to analyse; empty: all solids and shells of the document, or where it has none, all objects with faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The objects whose points are measured and coloured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report of the kernel, as JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result in one line, or why there is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seams that are shown in the view and in the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sources as they were chosen: property, object, name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface ends after a length, or at a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value that has the first colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value that has the last colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vertex whose edges are rounded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction from the model to the lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction in which the mould is pulled off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction of the parallel lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction to which angles are measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the angles of seams that are to be G1 or more, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the angles of the new seams, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the angles of the seams, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the gaps of the new seams, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the gaps, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature at the new seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of seams that are to be G2 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of the seams; 0 for G1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version of Seamwright that wrote the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is given at the ends of open points: the directions of the circles through the three outer points, the curvature 0, or directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is made least: the energy by the parameter, or the variation of the curvature by the length, which takes longer; of edges only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stays at both ends of a curve; where edges meet, the tangent stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the colours of the seams show: their class or their level of continuity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the points mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the parts lie that contain the sources, as JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether every new seam certainly meets the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether every seam certainly has its level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether no seam is a defect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether single points are samples of a smooth curve or corners of a polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the faces certainly meet the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the poles meet the target exactly up to rounding, not only within the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the shape changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the solid is valid and every new seam certainly meets the tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the verdict about the new seam is certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which iso-curves of a face have a comb, or its edges. Selected edges always have one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which points of the curves correspond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a light stripe, as a part of a light and a dark one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a line, as a part of the distance of two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zebra stripes: a mirror of light tubes, which moves with the view. Isophotes: lines of equal angle to a direction. Highlight lines: where the normals meet parallel lamps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright</name>
    <message>
        <source>
Shown: {show}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (proven).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (proven); no fewer than {least_arcs} will do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ({share} % less)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ({share} % more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Filled by OpenCASCADE; not by patches: {patches_reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> If all points are vertices, the spline follows them; else the points are its own, and it follows no sources.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The shape is not valid: it may cross itself; try smaller numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> There are {curves} separate curves: edges that do not touch are not joined; Bridge Curve does that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and {intervals} more intervals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and {more} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> for {curves} curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> instead of {along} x {across}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ concave, {minus} convex, seen from the side of the normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, as {arcs} of one sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, at most {distance_mm} mm from the spiral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, but the surface turns back {distance_mm} mm from the start; less tension may help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, curvature at most {curvature_rel} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, curves within {fit} mm of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, excluding {intervals} of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, largest at {at:.3g} of the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, on the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, or select nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, the longest loop: an outer boundary?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, variation of curvature {before} → {after} 1/mm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, {faults} not drawn correctly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, {matched} of them matched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 extrema</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: the points are samples of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; seen up to {distance_mm} mm from the edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the outer boundary stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the results are those of the last complete run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; there are no results yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {beyond} beyond the edges of the other shape left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {joints} with a jump of the curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {kept} kept as given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {least_mm} to {most_mm} mm long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click selects them in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hyperbola of weight {weight}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A parabola</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picked edge is not among the seams shown before: all are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a sketch of arcs and lines near the planar curve as it is now; the sketch does not follow the sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>選択を追加</translation>
    </message>
    <message>
        <source>Add the edges that go on with the tangent of those chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add what is selected in the view to the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation>後</translation>
    </message>
    <message>
        <source>After: each point coloured by how far it moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>目的</translation>
    </message>
    <message>
        <source>All defects. To choose, select rows or edges and add them:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All seams</source>
        <translation>すべての継ぎ目</translation>
    </message>
    <message>
        <source>Allow what the best fill needs, so that it can be kept as one that meets the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also draw the comb of the edges from which the curve is made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An ellipse of weight {weight}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysing seams…</source>
        <translation>継ぎ目を解析中…</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>解析中…</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>解析</translation>
    </message>
    <message>
        <source>Analyze seams</source>
        <translation>継ぎ目を解析</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angle between lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle tolerance</source>
        <translation>角度公差</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>角度 °</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>Arcs of one sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written. It is always written at the seams of the selected rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the ends keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Before and after: each point coloured by its mean curvature, both with the same scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before and after: stripes break where faces meet at an angle, and bend where the curvature jumps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beyond edges too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bind to an expression (=)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend Curves</source>
        <translation>中間曲線</translation>
    </message>
    <message>
        <source>Blend Surface</source>
        <translation>ブレンド曲面</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>Bridge Curve</source>
        <translation>ブリッジ曲線</translation>
    </message>
    <message>
        <source>By</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>キャンセルしました</translation>
    </message>
    <message>
        <source>Cancelled; the results are those of the last complete run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled; there are no results yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certain</source>
        <translation>確実</translation>
    </message>
    <message>
        <source>Change %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>Class A</source>
        <translation>クラス A</translation>
    </message>
    <message>
        <source>Click adds a point, at a vertex or on the grid; Ctrl: free. Backspace removes the last point, a click on the first one closes, Enter ends, Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Clothoid</source>
        <translation>クロソイド</translation>
    </message>
    <message>
        <source>Colour of {name}; click to choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coloured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Colours of seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common edge (may be empty)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute shortly after each change of a field; otherwise when Preview is pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute with the values of the fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing and drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing colours…</source>
        <translation>色を計算中…</translation>
    </message>
    <message>
        <source>Computing moves…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing zebra stripes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conic</source>
        <translation>円錐曲線</translation>
    </message>
    <message>
        <source>Continues with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>連続性</translation>
    </message>
    <message>
        <source>Coordinates, tension and bias of each point; a bad number is not taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>行をコピー</translation>
    </message>
    <message>
        <source>Corner Fillet</source>
        <translation>コーナーフィレット</translation>
    </message>
    <message>
        <source>Corner fillet</source>
        <translation>コーナーフィレット</translation>
    </message>
    <message>
        <source>Corner of a hole above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner of {rounded} rounded with radii {radii} mm; {seams}; {target} is met.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners and extrema</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>折れ目</translation>
    </message>
    <message>
        <source>Crease above</source>
        <translation>折れ目とみなす角度</translation>
    </message>
    <message>
        <source>Crease angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curv. %</source>
        <translation>曲率 %</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>Curvature %</source>
        <translation>曲率 %</translation>
    </message>
    <message>
        <source>Curvature (relative)</source>
        <translation>曲率 (相対)</translation>
    </message>
    <message>
        <source>Curvature Comb</source>
        <translation>曲率コーム</translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>曲率マップ</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>曲率コーム</translation>
    </message>
    <message>
        <source>Curvature extrema {extrema} → {extrema_after}, inflections {inflections} → {inflections_after}{variation}; moved at most {moved_mm} mm{kept}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature tolerance</source>
        <translation>曲率公差</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Curves within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>カスタム</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>既定</translation>
    </message>
    <message>
        <source>Defaults of this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Defect</source>
        <translation>欠陥</translation>
    </message>
    <message>
        <source>Defect, crease or smooth</source>
        <translation>欠陥、折れ目、滑らか</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Difference of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference of the change of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Direction of pull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard the changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from the vertex at which the fillet ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divide the selected curves only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do it again (Ctrl+Shift+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>抜き勾配</translation>
    </message>
    <message>
        <source>Draft angle</source>
        <translation>抜き勾配</translation>
    </message>
    <message>
        <source>Draw lines across the curve, as long as its curvature is large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw zebra stripes on the surface and on the faces beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>エッジ</translation>
    </message>
    <message>
        <source>Edge {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>エッジ</translation>
    </message>
    <message>
        <source>Edges lie side by side within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges meet within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit seam repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit {label}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End joins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End runs the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End tangent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every seam has its level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange the first and the second face, so that the other one moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV を書き出し…</translation>
    </message>
    <message>
        <source>Export JSON…</source>
        <translation>JSON を書き出し…</translation>
    </message>
    <message>
        <source>Export seam report</source>
        <translation>継ぎ目レポートを書き出し</translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>曲面を延長</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Faces join with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fair Curve</source>
        <translation>曲線をフェアリング</translation>
    </message>
    <message>
        <source>Fairness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill in the usual tolerances of one kind of work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill only the holes whose edges are selected in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill that is not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filling holes…</source>
        <translation>穴を埋めています…</translation>
    </message>
    <message>
        <source>First</source>
        <translation>第一</translation>
    </message>
    <message>
        <source>First direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First pole at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FirstFace and SecondFace must be faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed faces</source>
        <translation>固定する面</translation>
    </message>
    <message>
        <source>Flat above radius</source>
        <translation>平面とみなす半径</translation>
    </message>
    <message>
        <source>Flat within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four-sided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G0: position only; G1: without a kink; G2: with the same curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>隙間</translation>
    </message>
    <message>
        <source>Gap of patch to fillet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap tolerance</source>
        <translation>隙間公差</translation>
    </message>
    <message>
        <source>Gap {unit}</source>
        <translation>隙間 {unit}</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give all edges the radius of the first one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden: {objects}. Show what is to have stripes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest level of continuity the seam meets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>ハイライト線</translation>
    </message>
    <message>
        <source>Hold side boundaries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole {hole}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole {id}: {sides}, length {length}, centre ({centre})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>How dense the lines of new curvature combs are on each curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many light stripes zebra stripes have on a whole ball, in panels too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many threads a computation uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isophotes</source>
        <translation>アイソフォート</translation>
    </message>
    <message>
        <source>It was built for Python {python} and OpenCASCADE {occt}. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join Curves</source>
        <translation>曲線を接続</translation>
    </message>
    <message>
        <source>Joined G{order}; the ends were {gap_mm} mm apart, no {what} moved further than {moved_mm} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joins the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joins the first edge {first} and the second {second}, {figures}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joins the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep anyway</source>
        <translation>それでも残す</translation>
    </message>
    <message>
        <source>Keep arcs exactly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label the worst</source>
        <translation>最悪のものに表示</translation>
    </message>
    <message>
        <source>Lamps lie towards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, before and after, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation {furthest_mm} mm {furthest_at}; {least} to {largest} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the two sides, before and after, in {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between the two sides, in {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest move</source>
        <translation>最大移動量</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, before and after, in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest relative difference of the change of curvature, in % (measured for G3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lateral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lateral boundaries (may be empty)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lateral boundaries join</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least draft away from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least draft towards it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least variation of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the largest sector open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Length of the lines of the comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the seam, in {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length {unit}</source>
        <translation>長さ {unit}</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Level and tolerances</source>
        <translation>レベルと公差</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines inside the surface at which the curves have their joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of a comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loft through Frames</source>
        <translation>断面を通るロフト</translation>
    </message>
    <message>
        <source>Log Spiral</source>
        <translation>対数らせん</translation>
    </message>
    <message>
        <source>Look of seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest = {least:g}: a radius is larger than 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>作成元</translation>
    </message>
    <message>
        <source>Make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the curve from what is selected now: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make {label}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the surface…</source>
        <translation>曲面を作成中…</translation>
    </message>
    <message>
        <source>Making the {group}…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Match Surfaces</source>
        <translation>曲面をマッチング</translation>
    </message>
    <message>
        <source>Match by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Match free edges within</source>
        <translation>自由エッジを対応させる距離</translation>
    </message>
    <message>
        <source>Match free edges within {proposal:g} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Match surfaces</source>
        <translation>曲面をマッチング</translation>
    </message>
    <message>
        <source>Matched: {parts} ({reason}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matching surfaces…</source>
        <translation>曲面をマッチング中…</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>平均曲率</translation>
    </message>
    <message>
        <source>Measuring the seams…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More faces (may be empty)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move all points back to those of the sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the mouse: the point is marked on the seam in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Moves of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near the polygon of {points} points, {figures}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No deviation above rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No level</source>
        <translation>レベルなし</translation>
    </message>
    <message>
        <source>No point lies over the other shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point of a face may move further than this. By size of face: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No seams: no two faces share an edge.</source>
        <translation>継ぎ目なし:エッジを共有する面がありません。</translation>
    </message>
    <message>
        <source>No two faces share an edge: free edges are matched within {proposed:g} mm, as proposed. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No value is defined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No visible object has faces to draw zebra stripes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Not allowed: enter a number from {least} to {largest}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not analysed: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not filled: {reasons}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not filled: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not made: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not matched: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not reached ({missed})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not repaired: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not rounded: {error}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not rounded: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not smooth</source>
        <translation>滑らかでない</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to repair: no seam falls short of {target}; the model is unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to repair: no two faces share an edge, and none are matched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to repair: the chosen seams meet {target}; the model is unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of lines of the comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the seam in the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers of the two faces that meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects that exist keep theirs. The new faces of Umbrella Fill have tolerances of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the area, {towards} % drafts towards the pull, {away} % away, {steep} % is too steep. {mesh}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only selected</source>
        <translation>選択のみ</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>Other end of the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other end of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer boundary (may be empty)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points are of a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points on a seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points on curved edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points that are picked or dragged snap to a grid; Ctrl: free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon, alpha curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon, direct G2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon, gamma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Preview while fields are changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>再計算</translation>
    </message>
    <message>
        <source>Recompute (values were changed)</source>
        <translation>再計算 (値が変更されました)</translation>
    </message>
    <message>
        <source>Recompute and close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>反射線</translation>
    </message>
    <message>
        <source>Relative curvature</source>
        <translation>相対曲率</translation>
    </message>
    <message>
        <source>Relative difference of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative difference of the change of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove the selected names from the list, or all names if none is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the tangents that were given to the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修復</translation>
    </message>
    <message>
        <source>Repair seams</source>
        <translation>継ぎ目を修復</translation>
    </message>
    <message>
        <source>Repair the seams of the selected rows, or all defects if no row is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair the seams with these values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair these…</source>
        <translation>これらを修復…</translation>
    </message>
    <message>
        <source>Repaired, or why not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repairing seams…</source>
        <translation>継ぎ目を修復中…</translation>
    </message>
    <message>
        <source>Repair…</source>
        <translation>修復…</translation>
    </message>
    <message>
        <source>Report (*.json)</source>
        <translation>レポート (*.json)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Rounding the corner…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Same radius for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>継ぎ目</translation>
    </message>
    <message>
        <source>Seam Analysis</source>
        <translation>継ぎ目解析</translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>継ぎ目プロット</translation>
    </message>
    <message>
        <source>Seam Repair</source>
        <translation>継ぎ目修復</translation>
    </message>
    <message>
        <source>Seam tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam {id} ({kind})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>継ぎ目</translation>
    </message>
    <message>
        <source>Seamwright was built for OpenCASCADE {built}, but this FreeCAD runs OpenCASCADE {running}. Install the Seamwright that was built for this FreeCAD.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seamwright: help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seamwright: the colours are not shown: {error}
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seamwright: the moves of {names} are not shown: {error}
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second</source>
        <translation>第二</translation>
    </message>
    <message>
        <source>Second continues the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second pole at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Select edges</source>
        <translation>エッジを選択</translation>
    </message>
    <message>
        <source>Select either edges of holes or one face to replace. Selected: {faces}, {edges}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select one vertex of a solid at which 3 to 6 edges meet. Selected: {vertices}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select two faces: first the one that stays, then the one that moves. You may also select one common edge, or more faces that stay, or edges of them. Selected: {faces}, {edges}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set by the expression {expression}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Show handles in the view: circles are points, squares the tangents of the ends, diamonds the tensions. Drag them; Esc takes a drag back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the page before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the values that Seamwright has at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show which number of a list belongs to which point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側</translation>
    </message>
    <message>
        <source>Smallest move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>Smallest radius of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest radius {least} mm {least_at}. {mesh}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>滑らか</translation>
    </message>
    <message>
        <source>Smooth curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sort by class: defects by how much their figures exceed the tolerances, others by the figure of the level, such as the angle for G1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing of the lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>スプライン</translation>
    </message>
    <message>
        <source>Spline through points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start joins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start tangent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start, corner and end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop and keep the earlier results. Esc does the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Surface of {faces}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Take the last drag or change of a point back (Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take these tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>接線</translation>
    </message>
    <message>
        <source>Tangent chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tangents in one plane within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Target and limits</source>
        <translation>目標と制限</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>張力</translation>
    </message>
    <message>
        <source>Tension at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tension at the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tension at the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tension at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis is hidden: the view shows its colours and labels once it is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The best fill needs {tolerances}; Keep anyway keeps it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compiled part of Seamwright cannot be loaded ({reason}). {built}This FreeCAD runs Python {python} and OpenCASCADE {occt}: install the Seamwright that was built for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crease angle, {crease:g}°, must be larger than the angle tolerance, {angle:g}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the model, or the lines inside the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the seam in the result, or in the model where nothing was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge or edges of the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces are flat: they have no radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces as they look in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces that meet at the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first face was deleted: choose another one in the property FirstFace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest value on the whole seam, proven where an upper bound is known. The curve is sampled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model was changed during the computation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preferences are not stored: {error}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The property Vertex names {vertices} vertices: name exactly one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result itself is selected. Show Before, and select in the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seams at these edges:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seams in the table and in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second face was deleted: choose another one in the property SecondFace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The side of the surface, or inside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The source was deleted: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two faces that meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The verdict is certain: it is the same for every value within the bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The verdict is not certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {faces} faces of {label} share no edges, so that their outlines are no holes: sew them first, with Repair Seams for example, or select the edges of a hole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no points: pick some, or select points or edges and press Use selection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to analyse: the document has no faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three-sided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through inner curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through points, tension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through points, tension and bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through {points} points, {figures}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticked holes are filled. Click a hole to see it and to select its edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To Sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To fill holes, select one object or some of its edges. To replace a face, select it. Found: {chosen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To repair seams, select one object or some of its edges. Found: {objects}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Tolerances of new objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U and V lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>アンブレラ</translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>アンブレラフィル</translation>
    </message>
    <message>
        <source>Umbrella fill</source>
        <translation>アンブレラフィル</translation>
    </message>
    <message>
        <source>Uncertain</source>
        <translation>不確実</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Up to (may be empty)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update preview</source>
        <translation>プレビューを更新</translation>
    </message>
    <message>
        <source>Use selection</source>
        <translation>選択を使用</translation>
    </message>
    <message>
        <source>Use what is selected now instead: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use what is selected now instead: {tip}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values were changed, but the seams were not analysed with them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>What is plotted along the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the colours of the faces show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the colours of the seams in the view show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether class and level are the same for every value within the bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the seam certainly has its level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the seam certainly meets the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width = {width:g}: less than 1 is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst first</source>
        <translation>悪い順</translation>
    </message>
    <message>
        <source>Write a table with a line for each seam that is shown, in this order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the report of all seams as the command seamwright does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zebra stripes</source>
        <translation>ゼブラ縞</translation>
    </message>
    <message>
        <source>Zebra stripes on a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom to seam</source>
        <translation>継ぎ目へズーム</translation>
    </message>
    <message>
        <source>a closed spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a curvature tolerance of {figure} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a curve of degree {degree} is {distance:.3g} mm from {edge}, and {tolerance_mm:g} mm are allowed: divide the edge, or allow more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a face has no curve in its parameters along the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a gap tolerance of {figure} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point is ({point}): coordinates must be finite and below {most:g} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point is chosen: choose edges, wires or sketches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the seam, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an angle tolerance of {figure}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge has no tangent at its end: choose another end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge has no tangent at the point: choose other edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle at most {figure}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle {figure}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle ≤ {angle_deg:g}°</source>
        <translation>角度 ≤ {angle_deg:g}°</translation>
    </message>
    <message>
        <source>apart from creases, largest gap {gap} mm, largest angle {angle}°</source>
        <translation>折れ目を除く最大隙間 {gap} mm、最大角度 {angle}°</translation>
    </message>
    <message>
        <source>arcs and rational splines can only be divided for single curves: for a surface, let splines take their place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a bowl or a dome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a saddle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a sphere of radius {radius} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as little as needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at ({point})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least {least:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto: {setback:.4g} {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond the edges of the other shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by size of face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of curvature {figure}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose edges, or nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose faces or edges of faces, or nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose one edge of both faces, or nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose one face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose one vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>concave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>convex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature at most {figure} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature {figure}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature {figure} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature ≤ {curvature_rel:g} %</source>
        <translation>曲率 ≤ {curvature_rel:g} %</translation>
    </message>
    <message>
        <source>defects before {before}, after {after}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drafts away from the pull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drafts towards the pull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge {number} does not belong to a hole: it is not free, or not part of a closed loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary does not lead from the end of an edge to that of its neighbour: it ends {distance} mm from the nearest end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary leads from edge {first} to edge {second}: choose one or two edges for each two neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edges moved by at most {moved} mm, edge {number} most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equal change of curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equal curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every seam is {order}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exchange of surfaces between CAD systems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falls short of {level}</source>
        <translation>{level} に達しない</translation>
    </message>
    <message>
        <source>fill, {face}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fillet, face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat, or a saddle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap at most {figure} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap at most {gap_mm} mm, angle at most {angle_deg}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap larger than the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap {figure} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap ≤ {gap_mm:g} mm</source>
        <translation>隙間 ≤ {gap_mm:g} mm</translation>
    </message>
    <message>
        <source>has no points or edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is a mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is chosen as a whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not an edge or a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lateral boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>matched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mechanical parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>meet with an angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>meet without a kink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>meets {level}</source>
        <translation>{level} を満たす</translation>
    </message>
    <message>
        <source>meets {target}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle of {edge}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>misses {target}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>no arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no chains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no conics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no creases</source>
        <translation>折れ目なし</translation>
    </message>
    <message>
        <source>no curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no defects</source>
        <translation>欠陥なし</translation>
    </message>
    <message>
        <source>no document is open: make or open one first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edge is a polynomial spline of degree 2 or more: lines, arcs and rational splines stay as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edge is chosen: choose the edges of a side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edge moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edges</source>
        <translation>エッジなし</translation>
    </message>
    <message>
        <source>no face could be divided into triangles: see Check geometry in the workbench Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no face moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>面なし</translation>
    </message>
    <message>
        <source>no features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no free edges</source>
        <translation>自由エッジなし</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no inflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no lines of joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no seams</source>
        <translation>継ぎ目なし</translation>
    </message>
    <message>
        <source>no sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no splines within {tolerance:g} mm of the curves were found: take a larger tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no verdicts</source>
        <translation>判定なし</translation>
    </message>
    <message>
        <source>no vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not every seam is certainly {order}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is chosen for “{title}”: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is selected: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the input too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on {edge}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one for each processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>patch, face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>patch, fillet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points and edges are chosen: choose either</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points {first} and {second} are the same, ({point}): leave one of them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poles moved by up to {largest_move_mm} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proven</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius {radius} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sampled at the points of the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seen from the side of the normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seen, without an upper bound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select edges at which two faces meet, or edges that lie side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select edges, a wire or a sketch with splines, or points that lie in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select edges, a wire, a sketch or points that lie in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select edges, wires or faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select objects with faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select others and press “Use selection” at “{title}” in the panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch that lie in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select the edges of a side; where an edge lies between two faces, also the face to continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select the edges of two sides; where an edge lies between two faces, also the face to continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select three or more edges that end in one point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select three points or more, a wire or a sketch, in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select three points, a wire or a sketch of two lines, or two edges, in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select two edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select two objects with faces: first the one to colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select two or more edges, wires or sketches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sharper than {crease_deg:g}°, taken as intended</source>
        <translation>{crease_deg:g}° より鋭く、意図的とみなす</translation>
    </message>
    <message>
        <source>sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest radius {radius} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>some curves are closed and some are open: choose curves of one kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>such a spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>such face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tangents in one plane within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that all edges have the curvature of one surface at the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that the faces close around the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges are {chains} separate curves: choose one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges cannot be joined so: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges lie side by side only in a short part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges meet where the curve would be: choose other ends, or other edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges of {name} were deleted: {advice}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fill itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first {last:.3g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last {first:.3g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lights run in the direction in which they lie: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the outer boundary has edges in the sector that stays open: choose edges of the other sectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the outer boundary has {count} edges between edges {first} and {second}: one or two are possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points or edges are not in one plane: they are up to {distance:.3g} mm off it, and {flatness_mm:g} mm are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the range goes from {low:g} to {high:g}: give a larger upper end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the seam is exact up to rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the selection has {edges}, in {groups}: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shape to compare with has no faces: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shape to compare with has no triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sources were deleted: {advice}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface comes within {distance_mm:.3g} mm of the curves between, not within {tolerance_mm:g} mm: take a tolerance above {distance_mm:.3g} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface folds {distance_mm} mm from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the three points are on a line: move the corner off it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tolerance is 0: splines hold clothoids within a tolerance only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the {edges} edges do not end in one point: choose edges that meet in a vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the {edges} edges do not join to one curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no curves: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no sources: {advice}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are two points: a conic needs three or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are {points} points: a spiral has three, its start, the corner of its tangents and its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are {points} points: four or more can be made fair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are {points} points: one conic has three, its start, the corner of its tangents and its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are {points} points: {what} needs {least} or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no face at which the surface ends: choose one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is only one curve: choose two or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is only one point: choose two or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three-sided faces join with G1 only: choose four-sided faces, or G1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too steep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two fillets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two patches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undefined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unexpected error: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values beyond have the end colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visible surfaces, judged by their reflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with G2 the outer boundary is found, and cannot be given: choose G1, or take the edges out of the outer boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within the tolerances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within the tolerances; the shape changes up to {depth} mm away from the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>{along} x {across} poles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{arcs} and {lines}{chains}, {length_mm} mm long, at most {distance_mm} mm from the input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{argument} has {numbers} coordinates: give three</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{certain} of {verdicts} certain</source>
        <translation>{verdicts}のうち {certain} 件が確実</translation>
    </message>
    <message>
        <source>{conics} of weights {least_weight} to {largest_weight}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{conics}, {length_mm} mm long{jumps}{near}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} chains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} conic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} conics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} crease</source>
        <translation>折れ目 {count} 本</translation>
    </message>
    <message>
        <source>{count} creases</source>
        <translation>折れ目 {count} 本</translation>
    </message>
    <message>
        <source>{count} curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} defect</source>
        <translation>欠陥 {count} 個</translation>
    </message>
    <message>
        <source>{count} defects</source>
        <translation>欠陥 {count} 個</translation>
    </message>
    <message>
        <source>{count} edge</source>
        <translation>エッジ {count} 本</translation>
    </message>
    <message>
        <source>{count} edges</source>
        <translation>エッジ {count} 本</translation>
    </message>
    <message>
        <source>{count} extrema</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} extremum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} face</source>
        <translation>面 {count} 枚</translation>
    </message>
    <message>
        <source>{count} faces</source>
        <translation>面 {count} 枚</translation>
    </message>
    <message>
        <source>{count} feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} free edge</source>
        <translation>自由エッジ {count} 本</translation>
    </message>
    <message>
        <source>{count} free edges</source>
        <translation>自由エッジ {count} 本</translation>
    </message>
    <message>
        <source>{count} hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} inflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} inflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} line of joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} lines of joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} seam</source>
        <translation>継ぎ目 {count} 本</translation>
    </message>
    <message>
        <source>{count} seams</source>
        <translation>継ぎ目 {count} 本</translation>
    </message>
    <message>
        <source>{count} side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} verdict</source>
        <translation>判定 {count} 件</translation>
    </message>
    <message>
        <source>{count} verdicts</source>
        <translation>判定 {count} 件</translation>
    </message>
    <message>
        <source>{count}; largest gap seen {gap_mm} mm, largest angle {angle_deg}°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{defects} as sharp as a crease, but with a gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{done} of {fills} filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{done} of {wanted} repaired to {target}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges_led} got new curves on their faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} (model)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} can be matched: see Tolerances.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} chosen: choose three or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} chosen: choose two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} to round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges}; edges lie side by side: match them within {proposed:g} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges}; none lie side by side within {tried:g} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edge} bounds {faces}: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{element} is not {what}: name one, such as {kind}1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{faces} faces are chosen: only one can be replaced at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{faces} through {keys} curves, within {distance_mm} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{faces} to replace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{face} has {along} x {across} poles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{face} joins {others} to the tolerance; the shape changes up to {depth_mm} mm away from the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{face} will be replaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{fills} replaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first:.6g} to {last:.6g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{holes} to fill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{holes} with {faces}; {seams}; {verdict}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} contains nothing with a shape: choose another object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has faces: choose curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no curve: {summary}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no edges: choose edges of faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no edges: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no faces: choose an object with faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no faces: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no hole: no free edges form a closed loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no shape: recompute it or choose another object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no shape: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no {element}: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has {curves}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has {faces} faces: choose some of its edges, or one face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has {numbers} numbers for {count} {what}: give one for each, or one for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is a mesh: make a shape of it first, with Create shape from mesh of the workbench Part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is a sketch and has no faces: choose an object with faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is in another document, {document}: select objects of one document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is made from this {group}: choose others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} was deleted: {advice}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} {what}: choose points, edges, wires or sketches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label}.{element} is a point: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label}: Face{face} is not drawn correctly: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{last:.3g} at {first:.6g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{least} to {largest} {unit}, the strongest {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{least} {unit} everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length_mm} mm long, turns by {turn_deg}°, radius {first_radius_mm} to {last_radius_mm} mm{near}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length_mm} mm long; curvature: {extrema}, {inflections}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{level} is met</source>
        <translation>{level} を満たす</translation>
    </message>
    <message>
        <source>{level} is not met</source>
        <translation>{level} を満たさない</translation>
    </message>
    <message>
        <source>{level} is not met, kept anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{lines}; all are straight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{lines}; largest curvature {largest_per_mm} 1/mm, radius {radius} mm, {largest_at}. Sampled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{link} is chosen twice: choose two different faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{link} is not an edge of the two faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{made} between {keys} curves, within {distance_mm} mm; joints keep up to G{order}, {features} paired.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{members} around the point: {state}, {figures}; {followed}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{moved} moved, poles by up to {largest_move_mm} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{moves} of {faces} faces moved, poles by up to {largest} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{moves} points were moved, but the sources have {points}: empty the property Moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{names} was deleted: choose others in the property Sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} bends both ways, {times} times as strongly as the faces around it: look at its stripes for dents or waves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} bounds no face: choose an edge of a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} bounds none of the edges: leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} cannot be {value!r}: choose True or False</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} cannot be {value}: choose from {least:g} to {largest:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} does not bound one face alone: select the face to join, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has no edge along {moving} within the match distance of {match_mm} mm (they are {distance} mm apart): allow a larger one, or leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has no edge: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has no other chosen edge beside it within {match_mm:g} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has no {element}: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has {numbers} for the {edges} edges of the corner ({names}): give one for each, or one for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is a vertex: select edges, or the whole object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is no edge: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is no seam: its faces do not meet there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} lies between {faces}: select the face to continue, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} names {label}, which is not the source {source}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} would join itself: choose other faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {what}: choose edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}, {length_mm} mm along: {figure}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}: not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}: not measured where the angle is that of a crease.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}: the largest value is {seam}, {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{objects} selected: {needs}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{order} needs {need}: poles would move by {moved} mm, edge {number} most, and {most} mm are allowed: change the edges, or allow more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{parts}. Sampled at {points}: between them it may be larger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is not installed; the repository has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: cannot be written: {strerror}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the folder {folder} does not exist; create it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the name must end in .csv or .json.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{pieces}, {length_mm} mm long, {sharpest}, at most {distance_mm} mm from the input.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{points}{place}. {how}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{preview_tip}; nothing is kept until OK is pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{purpose}: gap {gap_mm:g} mm, angle {angle_deg:g}°, curvature {curvature_rel:g} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quantity} curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quantity} curvature {range}. {mesh}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{reason}: allow a change over a larger Depth, or a larger Fairness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{seams} seams are marked; only the edges of the first {selected} are selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sewn} sewn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{signs}
values beyond ±{limit_per_mm} 1/mm have the end colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{step} is a step of {body}: later steps do not count. To follow all steps, select {body}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{summary} Not seen, since they are hidden: {labels}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{surface}; across {seams}: angle at most {angle_deg}°, curvature at most {curvature_rel} %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{target} is met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{target} is not certain at {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{target} is uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{target} uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{total}: {defect}, {crease}, {smooth} smooth</source>
        <translation>{total}:{defect}、{crease}、滑らか {smooth} 本</translation>
    </message>
    <message>
        <source>{wanted} to repair to {target}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} = {direction}: three numbers are needed, not all zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} would move by {moved_mm:.4g} mm, further than the {most_mm:g} mm that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{why}; nothing was analysed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{why}; press Preview to analyse and repair the seams.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{written} of {every} seams ({show}) are written to {path}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{written} of {every} seams are written to {path}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{label}” is {angle:g}°: at most 90° is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{text}” is no such number: {kept} is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{text}” is not a list of numbers: write them with blanks or semicolons, such as 0; 0; 50.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_AnalyzeSeams</name>
    <message>
        <source>Analyze Seams</source>
        <translation>継ぎ目を解析</translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_Arcs</name>
    <message>
        <source>Arcs</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>Make arcs and lines within a tolerance of the selected edges, wires, sketch or points of a plane. The distance is proven; few arcs are searched for.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendCurves</name>
    <message>
        <source>Blend Curves</source>
        <translation>中間曲線</translation>
    </message>
    <message>
        <source>Make curves between two or more selected curves, or the surface through them. Every joint of a curve between is as smooth as those of the selected ones.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendSurface</name>
    <message>
        <source>Blend Surface</source>
        <translation>ブレンド曲面</translation>
    </message>
    <message>
        <source>Make a surface between two sides, edges or chains of edges of faces. It joins each with its own order: position (G0), tangent planes (G1), curvature (G2) or its change (G3).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_BridgeCurve</name>
    <message>
        <source>Bridge Curve</source>
        <translation>ブリッジ曲線</translation>
    </message>
    <message>
        <source>Make a curve from an end of one selected edge to an end of another one. It continues each with its own order: position (G0), tangent (G1), curvature (G2) or its change (G3).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_Clothoid</name>
    <message>
        <source>Clothoid</source>
        <translation>クロソイド</translation>
    </message>
    <message>
        <source>Lay clothoids through the selected points, or within a tolerance of the selected edges, wires or sketch of a plane: their curvature is continuous and linear in the length. Lines and arcs stay, with a clothoid between them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_Conic</name>
    <message>
        <source>Conic</source>
        <translation>円錐曲線</translation>
    </message>
    <message>
        <source>Make a conic from three selected points: start, corner of the tangents, end. Or lay a spline of conics with continuous curvature through points of a plane.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_CornerFillet</name>
    <message>
        <source>Corner Fillet</source>
        <translation>コーナーフィレット</translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureComb</name>
    <message>
        <source>Curvature Comb</source>
        <translation>曲率コーム</translation>
    </message>
    <message>
        <source>Draw a curvature comb on the selected edges and wires, and on iso-curves of the selected faces. The lines of the comb are as long as the curvature is large: a jump is a step of curvature, a kink of the comb a step of its change.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureMap</name>
    <message>
        <source>Colour the faces of the selected objects by their curvature: mean, Gaussian or largest curvature, or smallest radius. With nothing selected, all visible objects are coloured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>曲率マップ</translation>
    </message>
</context>
<context>
    <name>Seamwright_Deviation</name>
    <message>
        <source>Colour the first of two selected objects by its distance from the second: blue inside, orange outside, with the largest value and its place. Sampled, so not a proven figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
</context>
<context>
    <name>Seamwright_DraftAngle</name>
    <message>
        <source>Colour the faces of the selected objects by their angle to a direction of pull: those that leave a mould, those that are too steep, and those of the other half of the mould.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>抜き勾配</translation>
    </message>
</context>
<context>
    <name>Seamwright_ExportReport</name>
    <message>
        <source>Export Seam Report…</source>
        <translation>継ぎ目レポートを書き出し…</translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_ExtendSurface</name>
    <message>
        <source>Continue faces beyond an edge or a chain of edges, over a length or up to a face, with their tangent planes (G1), curvatures (G2) or the change of these (G3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>曲面を延長</translation>
    </message>
</context>
<context>
    <name>Seamwright_FairCurve</name>
    <message>
        <source>Fair Curve</source>
        <translation>曲線をフェアリング</translation>
    </message>
    <message>
        <source>Make the selected edges fair: splines whose curvature has few extrema and that move by no more than a tolerance. Points of a plane are moved, and a smooth curve goes through them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_FrameLoft</name>
    <message>
        <source>Loft through Frames</source>
        <translation>断面を通るロフト</translation>
    </message>
    <message>
        <source>Make the surface through two or more selected curves. Across the lines that join corresponding joints of the curves it is as smooth as the curves are: G1, G2 or more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_Help</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_JoinCurves</name>
    <message>
        <source>Join Curves</source>
        <translation>曲線を接続</translation>
    </message>
    <message>
        <source>Join two selected edges at their nearest ends with a common tangent (G1), curvature (G2) or change of the curvature (G3), by the smallest move of their poles there. Or let the second continue the first, which stays.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_LogSpiral</name>
    <message>
        <source>Log Spiral</source>
        <translation>対数らせん</translation>
    </message>
    <message>
        <source>Make a logarithmic spiral, whose radius grows by the same factor with each degree of turn, from three selected points: start, corner of the tangents, end. Or let it continue two edges of a plane from end to end.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_MatchSurfaces</name>
    <message>
        <source>Match Surfaces</source>
        <translation>曲面をマッチング</translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Seamwright_ReflectionLines</name>
    <message>
        <source>Draw lines on the faces of the selected objects that break where faces meet at an angle, and bend where the curvature jumps: zebra stripes with options, isophotes or highlight lines. With nothing selected, they are drawn on all visible objects.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>反射線</translation>
    </message>
</context>
<context>
    <name>Seamwright_RepairSeams</name>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair Seams</source>
        <translation>継ぎ目を修復</translation>
    </message>
</context>
<context>
    <name>Seamwright_SeamPlot</name>
    <message>
        <source>Plot gap, angle and curvature along the seams of the selected edges, with the proven bounds of the largest value. The mouse in the plot marks the point on the seam.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>継ぎ目プロット</translation>
    </message>
</context>
<context>
    <name>Seamwright_Spline</name>
    <message>
        <source>Make a spline with continuous curvature through the selected points or the points of a wire, a sketch or edges, or near the polygon of these points. Tension and bias shape it at each point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>スプライン</translation>
    </message>
</context>
<context>
    <name>Seamwright_Umbrella</name>
    <message>
        <source>Make faces around a point from three or more selected edges that end there with tangents in one plane: a face between each two neighbouring edges. All of them have common tangent planes along the edges, or with G2 common curvature, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>アンブレラ</translation>
    </message>
</context>
<context>
    <name>Seamwright_UmbrellaFill</name>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>アンブレラフィル</translation>
    </message>
</context>
<context>
    <name>Seamwright_ZebraStripes</name>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zebra Stripes</source>
        <translation>ゼブラ縞</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Analysis</source>
        <translation>解析</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Measure and repair the seams of CAD models: gap, angle and curvature where faces meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seamwright Analysis</source>
        <translation>Seamwright 解析</translation>
    </message>
    <message>
        <source>Seamwright Curves</source>
        <translation>Seamwright 曲線</translation>
    </message>
    <message>
        <source>Seamwright Surfaces</source>
        <translation>Seamwright 曲面</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>曲面</translation>
    </message>
</context>
</TS>
