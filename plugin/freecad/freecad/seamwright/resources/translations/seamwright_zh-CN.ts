<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A larger move is refused, in mm; 0: no limit</source>
        <translation>更大的移动将被拒绝，单位 mm；0：无限制</translation>
    </message>
    <message>
        <source>A seam counts as an intended crease if its angle is larger than this, in degrees</source>
        <translation>接缝的角度大于此值时视为有意的折痕，单位度</translation>
    </message>
    <message>
        <source>A side counts as flat if all its radii of curvature are larger than this, in mm</source>
        <translation>一侧的所有曲率半径都大于此值时视为平面，单位 mm</translation>
    </message>
    <message>
        <source>A side of a hole ends where its tangent turns by more than this, in degrees</source>
        <translation>孔的一条侧边在其切线转角大于此值处结束，单位度</translation>
    </message>
    <message>
        <source>Also measure points that lie beyond a free edge of the other shape: their distance is that to the edge, and has no sign</source>
        <translation>也测量超出另一形状自由边的点：其距离为到该边的距离，没有符号</translation>
    </message>
    <message>
        <source>Angle by which the stripes lean; 0: upright, 90: level</source>
        <translation>条纹倾斜的角度；0：竖直，90：水平</translation>
    </message>
    <message>
        <source>Angle from one isophote to the next</source>
        <translation>相邻两条等照度线之间的角度</translation>
    </message>
    <message>
        <source>Angle of the seam after the match, in degrees</source>
        <translation>匹配后接缝的角度，单位度</translation>
    </message>
    <message>
        <source>Angle of the seam before the match, in degrees</source>
        <translation>匹配前接缝的角度，单位度</translation>
    </message>
    <message>
        <source>Arcs and other rational edges stay as they are, and the faces are rational</source>
        <translation>圆弧和其他有理边保持不变，生成的面为有理面</translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written</source>
        <translation>在所显示的最差接缝中，有多少条标注最大值</translation>
    </message>
    <message>
        <source>Automatic: the colours cover all values but the outermost 2 % of the area</source>
        <translation>自动：颜色覆盖除面积最外侧 2 % 以外的所有值</translation>
    </message>
    <message>
        <source>Begin at the other end of the first edge</source>
        <translation>从第一条边的另一端开始</translation>
    </message>
    <message>
        <source>Begin at the other end of the first of two edges</source>
        <translation>从两条边中第一条的另一端开始</translation>
    </message>
    <message>
        <source>Below 1 an ellipse, 1 a parabola, above 1 a hyperbola</source>
        <translation>小于 1 为椭圆，1 为抛物线，大于 1 为双曲线</translation>
    </message>
    <message>
        <source>By how much the points of the sources were moved, in mm; one for each, or none</source>
        <translation>来源的点移动的量，单位 mm；每点一个，或没有</translation>
    </message>
    <message>
        <source>By how much the tangent turns, in degrees</source>
        <translation>切线转过的角度，单位度</translation>
    </message>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation>用与相邻面相切的面封闭所选对象的孔。只填充部分孔时，请选择每个孔的一条边。要替换一个面，请选择该面。</translation>
    </message>
    <message>
        <source>Colour each point by how far it moved, with a legend</source>
        <translation>按移动距离为每个点着色，并显示图例</translation>
    </message>
    <message>
        <source>Direction at the first point, against the first axis of the plane, in degrees</source>
        <translation>第一个点处的方向，相对于平面的第一轴，单位度</translation>
    </message>
    <message>
        <source>Direction at the last point, against the first axis of the plane, in degrees</source>
        <translation>最后一个点处的方向，相对于平面的第一轴，单位度</translation>
    </message>
    <message>
        <source>Distance from one lamp to the next; 0: 12 lamps over the model</source>
        <translation>相邻两盏灯之间的距离；0：模型上方共 12 盏灯</translation>
    </message>
    <message>
        <source>Distance from the curves, in mm</source>
        <translation>与曲线的距离，单位 mm</translation>
    </message>
    <message>
        <source>Distance of the ends before, in mm</source>
        <translation>之前两端的距离，单位 mm</translation>
    </message>
    <message>
        <source>Distances from the vertex at which the fillets end, in mm, in the order of CornerEdges, or one distance for all edges; 0 or empty: automatic</source>
        <translation>圆角结束处到顶点的距离，单位 mm，按 CornerEdges 的顺序，或所有边共用一个距离；0 或空：自动</translation>
    </message>
    <message>
        <source>Divide the selected curves into corresponding pieces; otherwise, splines near them take their place, so that the curves between are fairer</source>
        <translation>将所选曲线分割成相互对应的段；否则用其附近的样条代替，使中间的曲线更光顺</translation>
    </message>
    <message>
        <source>Draw the curvature comb</source>
        <translation>绘制曲率梳</translation>
    </message>
    <message>
        <source>Edges at which the faces end: one or two from the end of an edge to that of the next</source>
        <translation>面终止于这些边：从一条边的端点到下一条边的端点，一条或两条</translation>
    </message>
    <message>
        <source>Edges at which two faces meet, or edges side by side</source>
        <translation>两个面相接的边，或并排的边</translation>
    </message>
    <message>
        <source>Edges between the ends of the sides, along which the lateral boundaries run, and the faces beside them</source>
        <translation>两侧端点之间的边，侧边界沿其延伸，以及旁边的面</translation>
    </message>
    <message>
        <source>Edges of the first side, and faces to continue</source>
        <translation>第一侧的边，以及要延续的面</translation>
    </message>
    <message>
        <source>Edges of the second side, and faces to continue</source>
        <translation>第二侧的边，以及要延续的面</translation>
    </message>
    <message>
        <source>Edges of the side, and faces to continue</source>
        <translation>该侧的边，以及要延续的面</translation>
    </message>
    <message>
        <source>Edges, wires or faces</source>
        <translation>边、线或面</translation>
    </message>
    <message>
        <source>Edges, wires or sketches from which the surface is made</source>
        <translation>生成曲面的边、线或草图</translation>
    </message>
    <message>
        <source>End at the other end of the second edge</source>
        <translation>在第二条边的另一端结束</translation>
    </message>
    <message>
        <source>End at the other end of the second of two edges</source>
        <translation>在两条边中第二条的另一端结束</translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation>曲率极值数</translation>
    </message>
    <message>
        <source>Extrema of the curvature before</source>
        <translation>之前的曲率极值数</translation>
    </message>
    <message>
        <source>Extrema of the curvature now</source>
        <translation>现在的曲率极值数</translation>
    </message>
    <message>
        <source>Faces that must not move</source>
        <translation>不得移动的面</translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the half that is pulled</source>
        <translation>拔模角至少为此值的面可从被拔出的一半脱模</translation>
    </message>
    <message>
        <source>Faces with at least this draft angle leave the other half</source>
        <translation>拔模角至少为此值的面可从另一半脱模</translation>
    </message>
    <message>
        <source>Factor by which the variation of the curvature of a face may grow</source>
        <translation>面的曲率变化可增大的倍数</translation>
    </message>
    <message>
        <source>Four-sided faces, or three-sided ones, which are three faces each</source>
        <translation>四边面，或三边面(每个由三个面组成)</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are a seam, in mm</source>
        <translation>距离不超过此值的自由边构成接缝，单位 mm</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are measured as seams too, in mm; 0: off</source>
        <translation>距离不超过此值的自由边也作为接缝测量，单位 mm；0：关闭</translation>
    </message>
    <message>
        <source>Free edges no further apart than this are repaired as seams too, in mm; 0: off</source>
        <translation>距离不超过此值的自由边也作为接缝修复，单位 mm；0：关闭</translation>
    </message>
    <message>
        <source>Free edges no further apart than this may be the common boundary, in mm</source>
        <translation>距离不超过此值的自由边可作为公共边界，单位 mm</translation>
    </message>
    <message>
        <source>From the first point to the next pole, in mm; 0: the end is free</source>
        <translation>从第一个点到下一个控制点，单位 mm；0：该端自由</translation>
    </message>
    <message>
        <source>From the last pole but one to the last point, in mm; 0: the end is free</source>
        <translation>从倒数第二个控制点到最后一个点，单位 mm；0：该端自由</translation>
    </message>
    <message>
        <source>From the middle of the model; 0: half of the size of the model</source>
        <translation>从模型中心算起；0：模型尺寸的一半</translation>
    </message>
    <message>
        <source>Further faces that the moving face joins as the other face, or edges of them</source>
        <translation>移动的面像与另一个面那样与之相接的其他面，或这些面的边</translation>
    </message>
    <message>
        <source>Gap of the seam after the match, in mm</source>
        <translation>匹配后接缝的间隙，单位 mm</translation>
    </message>
    <message>
        <source>Gap of the seam before the match, in mm</source>
        <translation>匹配前接缝的间隙，单位 mm</translation>
    </message>
    <message>
        <source>Height of the legend's letters, in pixels</source>
        <translation>图例文字的高度，单位像素</translation>
    </message>
    <message>
        <source>How far from the seam the moved face may change, in mm; 0: as little as needed</source>
        <translation>移动的面可在距接缝多远的范围内改变，单位 mm；0：尽可能少</translation>
    </message>
    <message>
        <source>How far the surface keeps its direction, by the distance of the sides</source>
        <translation>曲面保持其方向的程度，相对于两侧的距离</translation>
    </message>
    <message>
        <source>How smoothly the curves between change at a selected curve that is neither the first nor the last</source>
        <translation>中间曲线在既非第一也非最后的所选曲线处变化的光滑程度</translation>
    </message>
    <message>
        <source>How the spline is made of the points</source>
        <translation>由点生成样条的方式</translation>
    </message>
    <message>
        <source>Inflections of a planar curve</source>
        <translation>平面曲线的拐点数</translation>
    </message>
    <message>
        <source>Iso-curves of a face in each direction</source>
        <translation>面在每个方向上的等参线数</translation>
    </message>
    <message>
        <source>Join the last point to the first; wires that are closed always are</source>
        <translation>将最后一个点与第一个点相连；闭合的线总是如此</translation>
    </message>
    <message>
        <source>Joints at which the curvature jumps</source>
        <translation>曲率跳变的连接点数</translation>
    </message>
    <message>
        <source>Keep a fill even if it misses the target</source>
        <translation>即使未达到目标也保留填充</translation>
    </message>
    <message>
        <source>Keep the two other boundaries that end at the seam</source>
        <translation>保持在接缝处结束的另外两条边界</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that is G1, in degrees</source>
        <translation>G1 接缝的切平面之间的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of a seam that meets G1, in degrees</source>
        <translation>达到 G1 的接缝的切平面之间的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam for G1 and G2, in degrees</source>
        <translation>对于 G1 和 G2，每条新接缝的切平面之间的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes of each new seam, in degrees</source>
        <translation>每条新接缝的切平面之间的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest angle of a tangent with the plane of all tangents, in degrees; the edges are turned into that plane</source>
        <translation>切线与所有切线所在平面的最大角度，单位度；边会被转到该平面内</translation>
    </message>
    <message>
        <source>Largest angle seen after the repair, creases excluded, in degrees</source>
        <translation>修复后观测到的最大角度，不含折痕，单位度</translation>
    </message>
    <message>
        <source>Largest angle seen before the repair, creases excluded, in degrees</source>
        <translation>修复前观测到的最大角度，不含折痕，单位度</translation>
    </message>
    <message>
        <source>Largest angle that was seen, creases excluded, in degrees</source>
        <translation>观测到的最大角度，不含折痕，单位度</translation>
    </message>
    <message>
        <source>Largest angle that was seen, in degrees</source>
        <translation>观测到的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest curvature, in 1/mm</source>
        <translation>最大曲率，单位 1/mm</translation>
    </message>
    <message>
        <source>Largest distance between the sides of the patches and the fillets, in mm</source>
        <translation>面片与圆角两侧之间的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam that meets G0, in mm</source>
        <translation>达到 G0 的接缝两侧之间的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of a seam, in mm</source>
        <translation>接缝两侧之间的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides of each new seam, in mm</source>
        <translation>每条新接缝两侧之间的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the input, in both directions, in mm</source>
        <translation>圆弧与输入的最大距离(双向)，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance of the clothoids from edges, in mm; points are passed through</source>
        <translation>回旋线与边的最大距离，单位 mm；点则精确通过</translation>
    </message>
    <message>
        <source>Largest distance of the curves that take the place of edges which are no single polynomial curve, such as arcs, in mm</source>
        <translation>代替非单一多项式曲线的边(如圆弧)的曲线的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance of the ends of the edges from their mean, in mm</source>
        <translation>边的端点与其平均位置的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance of the splines from the spiral, in mm</source>
        <translation>样条与螺旋线的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest distance of these splines and of the surface, in mm</source>
        <translation>这些样条及曲面的最大距离，单位 mm</translation>
    </message>
    <message>
        <source>Largest gap seen after the repair, creases excluded, in mm</source>
        <translation>修复后观测到的最大间隙，不含折痕，单位 mm</translation>
    </message>
    <message>
        <source>Largest gap seen before the repair, creases excluded, in mm</source>
        <translation>修复前观测到的最大间隙，不含折痕，单位 mm</translation>
    </message>
    <message>
        <source>Largest gap that was seen, creases excluded, in mm</source>
        <translation>观测到的最大间隙，不含折痕，单位 mm</translation>
    </message>
    <message>
        <source>Largest gap that was seen, in mm</source>
        <translation>观测到的最大间隙，单位 mm</translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm</source>
        <translation>控制点的最大移动，单位 mm</translation>
    </message>
    <message>
        <source>Largest move of a pole, in mm; no point of a face moved further</source>
        <translation>控制点的最大移动，单位 mm；面上没有点移动得更远</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that is G2; 0.02 is 2 %</source>
        <translation>G2 接缝的最大相对曲率差；0.02 即 2 %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of a seam that meets G2; 0.02 is 2 %</source>
        <translation>达到 G2 的接缝的最大相对曲率差；0.02 即 2 %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature of each new seam for G2; 0.02 is 2 %</source>
        <translation>对于 G2，每条新接缝的最大相对曲率差；0.02 即 2 %</translation>
    </message>
    <message>
        <source>Length of the lines of the comb; 1: the longest is 15 % of the size of the curve</source>
        <translation>梳齿的长度；1：最长的为曲线尺寸的 15 %</translation>
    </message>
    <message>
        <source>Length of the lines; 1: the longest is 15 % of the size of all curves</source>
        <translation>梳齿的长度；1：最长的为所有曲线尺寸的 15 %</translation>
    </message>
    <message>
        <source>Length of the surface, in mm</source>
        <translation>曲面的长度，单位 mm</translation>
    </message>
    <message>
        <source>Length of the tangent at the first edge, by the distance of the ends</source>
        <translation>第一条边处切线的长度，相对于两端的距离</translation>
    </message>
    <message>
        <source>Length of the tangent at the second edge, by the distance of the ends</source>
        <translation>第二条边处切线的长度，相对于两端的距离</translation>
    </message>
    <message>
        <source>Let the end run in the other direction than that in which the surface is less twisted; lateral boundaries say the direction</source>
        <translation>使终点沿着与曲面扭曲较小的方向相反的方向；侧边界决定该方向</translation>
    </message>
    <message>
        <source>Level of continuity after the match</source>
        <translation>匹配后的连续性等级</translation>
    </message>
    <message>
        <source>Level of continuity before the match</source>
        <translation>匹配前的连续性等级</translation>
    </message>
    <message>
        <source>Level of continuity to reach</source>
        <translation>要达到的连续性等级</translation>
    </message>
    <message>
        <source>Level that every new seam must meet; G0: position only</source>
        <translation>每条新接缝必须达到的等级；G0：仅位置</translation>
    </message>
    <message>
        <source>Level that every seam should meet</source>
        <translation>每条接缝应达到的等级</translation>
    </message>
    <message>
        <source>Light stripes on a whole ball</source>
        <translation>整个球面上的亮条纹数</translation>
    </message>
    <message>
        <source>Lines of the comb on each curve</source>
        <translation>每条曲线上的梳齿数</translation>
    </message>
    <message>
        <source>Make no face in the largest sector between two edges</source>
        <translation>在两条边之间最大的扇区内不生成面</translation>
    </message>
    <message>
        <source>Mean: half the sum of the principal curvatures. Gaussian: their product. Largest: the larger one without its sign. Smallest radius: 1 by the largest curvature</source>
        <translation>平均：主曲率之和的一半。高斯：主曲率之积。最大：绝对值较大者。最小半径：最大曲率的倒数</translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation>测量所选对象的面相接处的间隙、角度和曲率，并按结果为接缝着色。未选择任何对象时，分析文档中的所有实体和壳；若没有，则分析所有面。</translation>
    </message>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation>尽可能少地移动所选对象的面，直到其接缝光滑：无折角 (G1) 或曲率相同 (G2)。只修复部分接缝时，请选择其边或分析中的行。</translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation>移动两个所选面中的第二个或两者，直到它们以无折角 (G1) 或相同曲率 (G2) 相接。如果它们有多条公共边，还请选择要匹配的边。选择更多面时，移动最后一个面，使其与其他所有面相接；边代表其所在的面。</translation>
    </message>
    <message>
        <source>Names of the Sources at the last analysis</source>
        <translation>上次分析时 Sources 的名称</translation>
    </message>
    <message>
        <source>No point moved further, in mm</source>
        <translation>没有点移动得更远，单位 mm</translation>
    </message>
    <message>
        <source>No point moves further than this, in mm</source>
        <translation>任何点的移动都不超过此值，单位 mm</translation>
    </message>
    <message>
        <source>No point of a face may move further than this, in mm; 0: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation>面上任何点的移动都不得超过此值，单位 mm；0：面尺寸的百分之一加上其接缝最大间隙的两倍</translation>
    </message>
    <message>
        <source>No pole may move further than this, in mm; 0: no limit</source>
        <translation>任何控制点的移动都不得超过此值，单位 mm；0：无限制</translation>
    </message>
    <message>
        <source>No pole of an edge moved further, in mm</source>
        <translation>边的控制点移动都不超过此值，单位 mm</translation>
    </message>
    <message>
        <source>No pole, or no point of a continuation, moved further, in mm</source>
        <translation>控制点(或延续部分的点)移动都不超过此值，单位 mm</translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation>圆弧数</translation>
    </message>
    <message>
        <source>Number of arcs; 0: as few as possible</source>
        <translation>圆弧数；0：尽可能少</translation>
    </message>
    <message>
        <source>Number of clothoids, arcs and lines</source>
        <translation>回旋线、圆弧和直线的数目</translation>
    </message>
    <message>
        <source>Number of conics</source>
        <translation>圆锥曲线数</translation>
    </message>
    <message>
        <source>Number of curves with a comb</source>
        <translation>带曲率梳的曲线数</translation>
    </message>
    <message>
        <source>Number of curves, with the first and the last of the selected ones</source>
        <translation>曲线数，包括所选的第一条和最后一条</translation>
    </message>
    <message>
        <source>Number of defects after the repair</source>
        <translation>修复后的缺陷数</translation>
    </message>
    <message>
        <source>Number of defects before the repair</source>
        <translation>修复前的缺陷数</translation>
    </message>
    <message>
        <source>Number of edges that bound one face and are in no seam</source>
        <translation>只属于一个面且不在任何接缝中的边数</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>Number of faces of the surface</source>
        <translation>曲面的面数</translation>
    </message>
    <message>
        <source>Number of faces that moved</source>
        <translation>移动的面数</translation>
    </message>
    <message>
        <source>Number of holes that were filled</source>
        <translation>已填充的孔数</translation>
    </message>
    <message>
        <source>Number of holes that were to be filled</source>
        <translation>要填充的孔数</translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation>线数</translation>
    </message>
    <message>
        <source>Number of lines of the comb, on all edges together</source>
        <translation>所有边上梳齿的总数</translation>
    </message>
    <message>
        <source>Number of new faces</source>
        <translation>新面数</translation>
    </message>
    <message>
        <source>Number of patches of the corner</source>
        <translation>拐角的面片数</translation>
    </message>
    <message>
        <source>Number of points at which each seam is sampled</source>
        <translation>每条接缝的采样点数</translation>
    </message>
    <message>
        <source>Number of points taken between the ends of each edge that is not straight</source>
        <translation>每条非直边两端之间所取的点数</translation>
    </message>
    <message>
        <source>Number of seams</source>
        <translation>接缝数</translation>
    </message>
    <message>
        <source>Number of seams of two free edges that lie side by side</source>
        <translation>由两条并排自由边组成的接缝数</translation>
    </message>
    <message>
        <source>Number of seams sharper than the crease angle</source>
        <translation>比折痕角更尖锐的接缝数</translation>
    </message>
    <message>
        <source>Number of seams that fall short of the level</source>
        <translation>低于等级的接缝数</translation>
    </message>
    <message>
        <source>Number of seams that were repaired</source>
        <translation>已修复的接缝数</translation>
    </message>
    <message>
        <source>Number of seams that were to be repaired</source>
        <translation>要修复的接缝数</translation>
    </message>
    <message>
        <source>Number of seams whose verdict is not certain</source>
        <translation>判定不确定的接缝数</translation>
    </message>
    <message>
        <source>Objects with faces</source>
        <translation>带面的对象</translation>
    </message>
    <message>
        <source>Of all faces; 0: the lowest that suffices</source>
        <translation>所有面的次数；0：足够的最低次数</translation>
    </message>
    <message>
        <source>One edge of each hole to fill; empty: all holes except outer boundaries</source>
        <translation>每个要填充的孔的一条边；空：除外边界以外的所有孔</translation>
    </message>
    <message>
        <source>One number above 0.5, up to 1, for each segment, or one for all: 1 is nearest to the polygon</source>
        <translation>每段一个大于 0.5 且不超过 1 的数，或所有段共用一个：1 最接近多边形</translation>
    </message>
    <message>
        <source>One number for each point, or one for all. It tightens the spline: the larger the number without bias, the more negative with bias</source>
        <translation>每个点一个数，或所有点共用一个。它收紧样条：无偏斜时数越大越紧，有偏斜时越负越紧</translation>
    </message>
    <message>
        <source>One number for each point, or one for all: the speed before the point by that after it</source>
        <translation>每个点一个数，或所有点共用一个：该点之前的速度除以之后的速度</translation>
    </message>
    <message>
        <source>One number for each segment, or one for all: 1 is the B-spline, smaller ones draw the curve to the polygon</source>
        <translation>每段一个数，或所有段共用一个：1 为 B 样条，更小的值使曲线靠近多边形</translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation>打开 Seamwright 的文档。如果选择了 Seamwright 的对象，则打开关于其命令的章节。</translation>
    </message>
    <message>
        <source>Points and edges may be off their common plane by no more, in mm</source>
        <translation>点和边偏离其公共平面不得超过此值，单位 mm</translation>
    </message>
    <message>
        <source>Points of the spline that belong to no other object, in mm; where there are any, the sources are not used</source>
        <translation>不属于其他对象的样条点，单位 mm；有这些点时不使用来源</translation>
    </message>
    <message>
        <source>Points, edges, wires or sketches from which the curve is made</source>
        <translation>生成曲线的点、边、线或草图</translation>
    </message>
    <message>
        <source>Poles at the joint move as little as possible, or the second edge begins as the continuation of the first says</source>
        <translation>连接处的控制点移动尽可能小，或者第二条边按第一条的延续开始</translation>
    </message>
    <message>
        <source>Proven bound of the distance, in mm</source>
        <translation>距离的经证明的上界，单位 mm</translation>
    </message>
    <message>
        <source>Radii in mm, in the order of CornerEdges, or one radius for all edges</source>
        <translation>半径，单位 mm，按 CornerEdges 的顺序，或所有边共用一个半径</translation>
    </message>
    <message>
        <source>Radius of curvature at the end, in mm</source>
        <translation>终点处的曲率半径，单位 mm</translation>
    </message>
    <message>
        <source>Radius of curvature at the start, in mm</source>
        <translation>起点处的曲率半径，单位 mm</translation>
    </message>
    <message>
        <source>Relative difference of curvature after the match</source>
        <translation>匹配后的相对曲率差</translation>
    </message>
    <message>
        <source>Relative difference of curvature before the match</source>
        <translation>匹配前的相对曲率差</translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation>对实体上所选顶点处的 3 至 6 条边倒圆，每条边有各自的半径。圆角之间的拐角由面片无折角地封闭。</translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its first inner pole lies; one number for each side, or one for all</source>
        <translation>多边形每条边上第一个内部控制点所在的比例；每条边一个数，或所有边共用一个</translation>
    </message>
    <message>
        <source>Share of each side of the polygon at which its second inner pole lies; one number for each side, or one for all</source>
        <translation>多边形每条边上第二个内部控制点所在的比例；每条边一个数，或所有边共用一个</translation>
    </message>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation>显示所选对象或所有可见对象的面如何反射条纹。面以一定角度相接处条纹断开，曲率跳变处条纹折弯。再次使用该命令可将其移除。</translation>
    </message>
    <message>
        <source>Show the legend in the view</source>
        <translation>在视图中显示图例</translation>
    </message>
    <message>
        <source>Single curves, or a surface</source>
        <translation>单独的曲线，或一个曲面</translation>
    </message>
    <message>
        <source>Smallest radius, in mm; 0: straight</source>
        <translation>最小半径，单位 mm；0：直线</translation>
    </message>
    <message>
        <source>Splines near the spiral, or tangent arcs of one sweep whose radii are a geometric progression</source>
        <translation>贴近螺旋线的样条，或转角相同、半径成等比数列的相切圆弧</translation>
    </message>
    <message>
        <source>The common edge along which the faces are matched; empty: the longest one</source>
        <translation>匹配面所沿的公共边；空：最长的一条</translation>
    </message>
    <message>
        <source>The continuity of the faces across the edges: tangent planes (G1) or curvature, too (G2)</source>
        <translation>面跨过边的连续性：切平面 (G1)，或还有曲率 (G2)</translation>
    </message>
    <message>
        <source>The continuity of the joint</source>
        <translation>连接处的连续性</translation>
    </message>
    <message>
        <source>The continuity that every joint keeps: tangents (G1), curvature (G2) or more</source>
        <translation>每个连接点保持的连续性：切线 (G1)、曲率 (G2) 或更高</translation>
    </message>
    <message>
        <source>The continuity with the faces beside the lateral boundaries</source>
        <translation>与侧边界旁的面的连续性</translation>
    </message>
    <message>
        <source>The continuity with the faces of the end</source>
        <translation>与终点面的连续性</translation>
    </message>
    <message>
        <source>The continuity with the faces of the side; G1 is ruled</source>
        <translation>与该侧面的连续性；G1 为直纹面</translation>
    </message>
    <message>
        <source>The continuity with the faces of the start</source>
        <translation>与起点面的连续性</translation>
    </message>
    <message>
        <source>The continuity with the first edge</source>
        <translation>与第一条边的连续性</translation>
    </message>
    <message>
        <source>The continuity with the second edge</source>
        <translation>与第二条边的连续性</translation>
    </message>
    <message>
        <source>The edge that moves</source>
        <translation>移动的边</translation>
    </message>
    <message>
        <source>The edges at the vertex, in the order of Radii and Setbacks</source>
        <translation>顶点处的边，按 Radii 和 Setbacks 的顺序</translation>
    </message>
    <message>
        <source>The edges of the seams to repair; empty: all defects</source>
        <translation>要修复的接缝的边；空：所有缺陷</translation>
    </message>
    <message>
        <source>The face at which the surface ends</source>
        <translation>曲面结束处的面</translation>
    </message>
    <message>
        <source>The face that moves; away from the seam it keeps its shape</source>
        <translation>移动的面；远离接缝处保持其形状</translation>
    </message>
    <message>
        <source>The face to replace; empty: holes are filled</source>
        <translation>要替换的面；空：填充孔</translation>
    </message>
    <message>
        <source>The first face</source>
        <translation>第一个面</translation>
    </message>
    <message>
        <source>The largest value at the points of the mesh</source>
        <translation>网格点处的最大值</translation>
    </message>
    <message>
        <source>The least value at the points of the mesh</source>
        <translation>网格点处的最小值</translation>
    </message>
    <message>
        <source>The object whose holes are filled</source>
        <translation>要填充孔的对象</translation>
    </message>
    <message>
        <source>The object whose holes are filled, or one of its faces</source>
        <translation>要填充其孔的对象，或其中一个面</translation>
    </message>
    <message>
        <source>The object whose seams are repaired</source>
        <translation>要修复接缝的对象</translation>
    </message>
    <message>
        <source>The object with the corner</source>
        <translation>带拐角的对象</translation>
    </message>
    <message>
        <source>The objects from which distances are measured</source>
        <translation>作为距离测量基准的对象</translation>
    </message>
    <message>
        <source>The objects that were analysed</source>
        <translation>已分析的对象</translation>
    </message>
    <message>
        <source>The objects to analyse; empty: all solids and shells of the document, or where it has none, all objects with faces</source>
        <translation>要分析的对象；空：文档中的所有实体和壳，若没有，则为所有带面的对象</translation>
    </message>
    <message>
        <source>The objects whose points are measured and coloured</source>
        <translation>要测量并着色的对象</translation>
    </message>
    <message>
        <source>The report of the kernel, as JSON</source>
        <translation>内核的报告，JSON 格式</translation>
    </message>
    <message>
        <source>The result in one line, or why there is none</source>
        <translation>一行结果，或没有结果的原因</translation>
    </message>
    <message>
        <source>The seams that are shown in the view and in the table</source>
        <translation>在视图和表格中显示的接缝</translation>
    </message>
    <message>
        <source>The second face</source>
        <translation>第二个面</translation>
    </message>
    <message>
        <source>The sources as they were chosen: property, object, name</source>
        <translation>所选的来源：属性、对象、名称</translation>
    </message>
    <message>
        <source>The surface ends after a length, or at a face</source>
        <translation>曲面按长度结束，或在某个面处结束</translation>
    </message>
    <message>
        <source>The value that has the first colour</source>
        <translation>使用第一种颜色的值</translation>
    </message>
    <message>
        <source>The value that has the last colour</source>
        <translation>使用最后一种颜色的值</translation>
    </message>
    <message>
        <source>The vertex whose edges are rounded</source>
        <translation>要对其边倒圆的顶点</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction from the model to the lamps</source>
        <translation>三个数 x; y; z：从模型到灯的方向</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction in which the mould is pulled off</source>
        <translation>三个数 x; y; z：模具拔出的方向</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction of the parallel lamps</source>
        <translation>三个数 x; y; z：平行灯的方向</translation>
    </message>
    <message>
        <source>Three numbers x; y; z: the direction to which angles are measured</source>
        <translation>三个数 x; y; z：测量角度所用的方向</translation>
    </message>
    <message>
        <source>Upper bound of the angles of seams that are to be G1 or more, in degrees</source>
        <translation>应为 G1 或更高的接缝的角度上界，单位度</translation>
    </message>
    <message>
        <source>Upper bound of the angles of the new seams, in degrees</source>
        <translation>新接缝的角度上界，单位度</translation>
    </message>
    <message>
        <source>Upper bound of the angles of the seams, in degrees</source>
        <translation>接缝的角度上界，单位度</translation>
    </message>
    <message>
        <source>Upper bound of the gaps of the new seams, in mm</source>
        <translation>新接缝的间隙上界，单位 mm</translation>
    </message>
    <message>
        <source>Upper bound of the gaps, in mm</source>
        <translation>间隙上界，单位 mm</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature at the new seams</source>
        <translation>新接缝处相对曲率差的上界</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of seams that are to be G2 or more</source>
        <translation>应为 G2 或更高的接缝的相对曲率差上界</translation>
    </message>
    <message>
        <source>Upper bound of the relative differences of curvature of the seams; 0 for G1</source>
        <translation>接缝相对曲率差的上界；G1 时为 0</translation>
    </message>
    <message>
        <source>Version of Seamwright that wrote the results</source>
        <translation>写入结果的 Seamwright 版本</translation>
    </message>
    <message>
        <source>What is given at the ends of open points: the directions of the circles through the three outer points, the curvature 0, or directions</source>
        <translation>开放点列两端的给定条件：通过三个外侧点的圆的方向、曲率为 0，或给定方向</translation>
    </message>
    <message>
        <source>What is made least: the energy by the parameter, or the variation of the curvature by the length, which takes longer; of edges only</source>
        <translation>最小化的对象：按参数的能量，或按长度的曲率变化(耗时更长)；仅用于边</translation>
    </message>
    <message>
        <source>What stays at both ends of a curve; where edges meet, the tangent stays</source>
        <translation>曲线两端保持不变的内容；边相接处切线保持不变</translation>
    </message>
    <message>
        <source>What the colours of the seams show: their class or their level of continuity</source>
        <translation>接缝的颜色表示什么：其类别或连续性等级</translation>
    </message>
    <message>
        <source>What the points mean</source>
        <translation>点的含义</translation>
    </message>
    <message>
        <source>Where the parts lie that contain the sources, as JSON</source>
        <translation>包含源对象的零件的位置，JSON 格式</translation>
    </message>
    <message>
        <source>Whether every new seam certainly meets the target</source>
        <translation>每条新接缝是否确定达到目标</translation>
    </message>
    <message>
        <source>Whether every seam certainly has its level</source>
        <translation>每条接缝是否确定达到其等级</translation>
    </message>
    <message>
        <source>Whether no seam is a defect</source>
        <translation>是否没有缺陷接缝</translation>
    </message>
    <message>
        <source>Whether single points are samples of a smooth curve or corners of a polygon</source>
        <translation>单独的点是光滑曲线的采样点，还是多边形的顶点</translation>
    </message>
    <message>
        <source>Whether the faces certainly meet the target</source>
        <translation>面是否确定达到目标</translation>
    </message>
    <message>
        <source>Whether the poles meet the target exactly up to rounding, not only within the tolerance</source>
        <translation>控制点是否在舍入误差内精确达到目标，而不仅仅在公差内</translation>
    </message>
    <message>
        <source>Whether the shape changed</source>
        <translation>形状是否改变</translation>
    </message>
    <message>
        <source>Whether the solid is valid and every new seam certainly meets the tolerances</source>
        <translation>实体是否有效且每条新接缝确定满足公差</translation>
    </message>
    <message>
        <source>Whether the verdict about the new seam is certain</source>
        <translation>关于新接缝的判定是否确定</translation>
    </message>
    <message>
        <source>Which iso-curves of a face have a comb, or its edges. Selected edges always have one</source>
        <translation>面的哪些等参线或其边带有曲率梳。所选的边总是带有</translation>
    </message>
    <message>
        <source>Which points of the curves correspond</source>
        <translation>曲线上哪些点相互对应</translation>
    </message>
    <message>
        <source>Width of a light stripe, as a part of a light and a dark one</source>
        <translation>亮条纹的宽度，占一亮一暗条纹的比例</translation>
    </message>
    <message>
        <source>Width of a line, as a part of the distance of two</source>
        <translation>线的宽度，占两线间距的比例</translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation>将所选接缝分析的结果写入文件，作为表格 (CSV) 或报告 (JSON)。未选择时写入最新的分析。</translation>
    </message>
    <message>
        <source>Zebra stripes: a mirror of light tubes, which moves with the view. Isophotes: lines of equal angle to a direction. Highlight lines: where the normals meet parallel lamps</source>
        <translation>斑马纹：灯管的镜像，随视图移动。等照度线：与某方向成等角的线。高光线：法线与平行灯相交之处</translation>
    </message>
</context>
<context>
    <name>Seamwright</name>
    <message>
        <source>
Shown: {show}</source>
        <translation>
显示：{show}</translation>
    </message>
    <message>
        <source> (proven).</source>
        <translation>（已证明）。</translation>
    </message>
    <message>
        <source> (proven); no fewer than {least_arcs} will do.</source>
        <translation>（已证明）；不能少于 {least_arcs}。</translation>
    </message>
    <message>
        <source> ({share} % less)</source>
        <translation>（减少 {share} %）</translation>
    </message>
    <message>
        <source> ({share} % more)</source>
        <translation>（增加 {share} %）</translation>
    </message>
    <message>
        <source> Filled by OpenCASCADE; not by patches: {patches_reason}.</source>
        <translation>由 OpenCASCADE 填充；未用面片：{patches_reason}。</translation>
    </message>
    <message>
        <source> If all points are vertices, the spline follows them; else the points are its own, and it follows no sources.</source>
        <translation>如果所有点都是顶点，样条跟随它们；否则这些点属于样条自身，它不跟随任何来源。</translation>
    </message>
    <message>
        <source> The shape is not valid: it may cross itself; try smaller numbers.</source>
        <translation> 形状无效：可能自相交；请试用较小的数值。</translation>
    </message>
    <message>
        <source> There are {curves} separate curves: edges that do not touch are not joined; Bridge Curve does that.</source>
        <translation> 共有 {curves} 条分开的曲线：不相接的边不会连接；请用“桥接曲线”。</translation>
    </message>
    <message>
        <source> and </source>
        <translation>和</translation>
    </message>
    <message>
        <source> and {intervals} more intervals</source>
        <translation>以及另外 {intervals} 个区间</translation>
    </message>
    <message>
        <source> and {more} more</source>
        <translation>以及另外 {more} 个</translation>
    </message>
    <message>
        <source> for {curves} curves</source>
        <translation>(共 {curves} 条曲线)</translation>
    </message>
    <message>
        <source> instead of {along} x {across}</source>
        <translation>，原为 {along} x {across}</translation>
    </message>
    <message>
        <source>+ concave, {minus} convex, seen from the side of the normals</source>
        <translation>+ 为凹，{minus} 为凸，从法线一侧看</translation>
    </message>
    <message>
        <source>, as {arcs} of one sweep</source>
        <translation>，为 {arcs}，转角相同</translation>
    </message>
    <message>
        <source>, at most {distance_mm} mm from the spiral</source>
        <translation>，距螺旋线最多 {distance_mm} mm</translation>
    </message>
    <message>
        <source>, but the surface turns back {distance_mm} mm from the start; less tension may help</source>
        <translation>，但曲面在距起点 {distance_mm} mm 处折回；减小张力可能有帮助</translation>
    </message>
    <message>
        <source>, curvature at most {curvature_rel} %</source>
        <translation>，曲率最大 {curvature_rel} %</translation>
    </message>
    <message>
        <source>, curves within {fit} mm of them</source>
        <translation>，曲线与其相差不超过 {fit} mm</translation>
    </message>
    <message>
        <source>, excluding {intervals} of it</source>
        <translation>，不计其 {intervals}</translation>
    </message>
    <message>
        <source>, largest at {at:.3g} of the edge</source>
        <translation>，最大值位于边的 {at:.3g} 处</translation>
    </message>
    <message>
        <source>, on the grid</source>
        <translation>，在网格上</translation>
    </message>
    <message>
        <source>, or select nothing</source>
        <translation>，或不选择任何对象</translation>
    </message>
    <message>
        <source>, the longest loop: an outer boundary?</source>
        <translation>，最长的环：是外边界吗？</translation>
    </message>
    <message>
        <source>, variation of curvature {before} → {after} 1/mm³</source>
        <translation>，曲率变化 {before} → {after} 1/mm³</translation>
    </message>
    <message>
        <source>, {faults} not drawn correctly</source>
        <translation>，{faults}显示不正确</translation>
    </message>
    <message>
        <source>, {matched} of them matched</source>
        <translation>，其中 {matched} 个为配对</translation>
    </message>
    <message>
        <source>0 extrema</source>
        <translation>0 个极值</translation>
    </message>
    <message>
        <source>: the points are samples of these.</source>
        <translation>：这些点是它们的采样点。</translation>
    </message>
    <message>
        <source>; seen up to {distance_mm} mm from the edges</source>
        <translation>；在测量点处与边最多相距 {distance_mm} mm</translation>
    </message>
    <message>
        <source>; the outer boundary stays</source>
        <translation>；外边界保持不变</translation>
    </message>
    <message>
        <source>; the results are those of the last complete run.</source>
        <translation>；结果是上一次完整计算的结果。</translation>
    </message>
    <message>
        <source>; there are no results yet.</source>
        <translation>；还没有结果。</translation>
    </message>
    <message>
        <source>; {beyond} beyond the edges of the other shape left out</source>
        <translation>；已略去超出另一形状边缘的{beyond}</translation>
    </message>
    <message>
        <source>; {joints} with a jump of the curvature</source>
        <translation>；{joints}处曲率有跳变</translation>
    </message>
    <message>
        <source>; {kept} kept as given</source>
        <translation>；{kept}保持原样</translation>
    </message>
    <message>
        <source>; {least_mm} to {most_mm} mm long</source>
        <translation>；长度 {least_mm} 至 {most_mm} mm</translation>
    </message>
    <message>
        <source>A click selects them in the view</source>
        <translation>单击可在视图中选择它们</translation>
    </message>
    <message>
        <source>A hyperbola of weight {weight}</source>
        <translation>一条双曲线，权重 {weight}</translation>
    </message>
    <message>
        <source>A parabola</source>
        <translation>一条抛物线</translation>
    </message>
    <message>
        <source>A picked edge is not among the seams shown before: all are shown.</source>
        <translation>所选的边不在之前显示的接缝之中：现在显示全部接缝。</translation>
    </message>
    <message>
        <source>Add a sketch of arcs and lines near the planar curve as it is now; the sketch does not follow the sources</source>
        <translation>添加一个由圆弧和直线组成的草图，贴近当前的平面曲线；草图不跟随来源</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>添加所选</translation>
    </message>
    <message>
        <source>Add the edges that go on with the tangent of those chosen</source>
        <translation>添加与所选边相切连续的边</translation>
    </message>
    <message>
        <source>Add what is selected in the view to the list</source>
        <translation>将视图中所选内容添加到列表</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>After: each point coloured by how far it moved</source>
        <translation>之后：每个点按其移动距离着色</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>All defects. To choose, select rows or edges and add them:</source>
        <translation>所有缺陷。要指定，请选择行或边并添加：</translation>
    </message>
    <message>
        <source>All seams</source>
        <translation>所有接缝</translation>
    </message>
    <message>
        <source>Allow what the best fill needs, so that it can be kept as one that meets the target</source>
        <translation>允许最佳填充所需的公差，使它能作为达到目标的填充保留</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>沿</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Also draw the comb of the edges from which the curve is made</source>
        <translation>同时绘制生成曲线的边的曲率梳</translation>
    </message>
    <message>
        <source>An ellipse of weight {weight}</source>
        <translation>一条椭圆，权重 {weight}</translation>
    </message>
    <message>
        <source>Analysing seams…</source>
        <translation>正在分析接缝…</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>正在分析…</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Analyze seams</source>
        <translation>分析接缝</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angle between lines</source>
        <translation>线间角度</translation>
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
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Arcs of one sweep</source>
        <translation>转角相同的圆弧</translation>
    </message>
    <message>
        <source>As in sources</source>
        <translation>恢复为来源</translation>
    </message>
    <message>
        <source>At how many of the worst seams that are shown the largest figure is written. It is always written at the seams of the selected rows.</source>
        <translation>在所显示的最差接缝中，有多少条标注最大值。所选行的接缝总是标注。</translation>
    </message>
    <message>
        <source>At the ends keep</source>
        <translation>两端保持</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Before and after: each point coloured by its mean curvature, both with the same scale</source>
        <translation>之前和之后：每个点按其平均曲率着色，两者使用相同的标尺</translation>
    </message>
    <message>
        <source>Before and after: stripes break where faces meet at an angle, and bend where the curvature jumps</source>
        <translation>之前和之后：面以一定角度相接处条纹断开，曲率跳变处条纹折弯</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Beyond edges too</source>
        <translation>也包括边缘以外</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>偏斜</translation>
    </message>
    <message>
        <source>Bind to an expression (=)</source>
        <translation>绑定到表达式（=）</translation>
    </message>
    <message>
        <source>Blend Curves</source>
        <translation>混合曲线</translation>
    </message>
    <message>
        <source>Blend Surface</source>
        <translation>过渡曲面</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Bridge Curve</source>
        <translation>桥接曲线</translation>
    </message>
    <message>
        <source>By</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>By class</source>
        <translation>按类别</translation>
    </message>
    <message>
        <source>By level</source>
        <translation>按级别</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Cancelled; the results are those of the last complete run.</source>
        <translation>已取消；结果是上一次完整计算的结果。</translation>
    </message>
    <message>
        <source>Cancelled; there are no results yet.</source>
        <translation>已取消；还没有结果。</translation>
    </message>
    <message>
        <source>Certain</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Change %</source>
        <translation>变化 %</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Class A</source>
        <translation>A 级</translation>
    </message>
    <message>
        <source>Click adds a point, at a vertex or on the grid; Ctrl: free. Backspace removes the last point, a click on the first one closes, Enter ends, Esc cancels.</source>
        <translation>单击添加一个点，位于顶点或网格上；Ctrl：自由。退格键删除最后一个点，单击第一个点则闭合，回车结束，Esc 取消。</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>Clothoid</source>
        <translation>回旋线</translation>
    </message>
    <message>
        <source>Colour of {name}; click to choose another one</source>
        <translation>{name}的颜色；点击可选择其他颜色</translation>
    </message>
    <message>
        <source>Coloured</source>
        <translation>着色对象</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colours of seams</source>
        <translation>接缝的颜色</translation>
    </message>
    <message>
        <source>Common edge (may be empty)</source>
        <translation>公共边(可为空)</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>Compute shortly after each change of a field; otherwise when Preview is pressed</source>
        <translation>每次更改字段后不久即计算；否则在按下“预览”时计算</translation>
    </message>
    <message>
        <source>Compute with the values of the fields</source>
        <translation>用各字段的值计算</translation>
    </message>
    <message>
        <source>Computing and drawing</source>
        <translation>计算与绘制</translation>
    </message>
    <message>
        <source>Computing colours…</source>
        <translation>正在计算颜色…</translation>
    </message>
    <message>
        <source>Computing moves…</source>
        <translation>正在计算移动量…</translation>
    </message>
    <message>
        <source>Computing zebra stripes…</source>
        <translation>正在计算斑马纹…</translation>
    </message>
    <message>
        <source>Conic</source>
        <translation>圆锥曲线</translation>
    </message>
    <message>
        <source>Continues with</source>
        <translation>延续方式</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>连续性</translation>
    </message>
    <message>
        <source>Coordinates, tension and bias of each point; a bad number is not taken</source>
        <translation>每个点的坐标、张力和偏斜；无效的数不被接受</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>复制行</translation>
    </message>
    <message>
        <source>Corner Fillet</source>
        <translation>拐角圆角</translation>
    </message>
    <message>
        <source>Corner fillet</source>
        <translation>拐角圆角</translation>
    </message>
    <message>
        <source>Corner of a hole above</source>
        <translation>孔的拐角大于</translation>
    </message>
    <message>
        <source>Corner of {rounded} rounded with radii {radii} mm; {seams}; {target} is met.</source>
        <translation>由{rounded}构成的拐角已倒圆，半径 {radii} mm；{seams}；满足 {target}。</translation>
    </message>
    <message>
        <source>Corners and extrema</source>
        <translation>拐角和极值</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>折痕</translation>
    </message>
    <message>
        <source>Crease above</source>
        <translation>折痕大于</translation>
    </message>
    <message>
        <source>Crease angle</source>
        <translation>折痕角</translation>
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
        <translation>曲率(相对)</translation>
    </message>
    <message>
        <source>Curvature Comb</source>
        <translation>曲率梳</translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>曲率云图</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>曲率梳</translation>
    </message>
    <message>
        <source>Curvature extrema {extrema} → {extrema_after}, inflections {inflections} → {inflections_after}{variation}; moved at most {moved_mm} mm{kept}.</source>
        <translation>曲率极值 {extrema} → {extrema_after}，拐点 {inflections} → {inflections_after}{variation}；最多移动 {moved_mm} mm{kept}。</translation>
    </message>
    <message>
        <source>Curvature tolerance</source>
        <translation>曲率公差</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Curves within</source>
        <translation>曲线误差不超过</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Defaults of this page</source>
        <translation>本页的默认值</translation>
    </message>
    <message>
        <source>Defect</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>Defect, crease or smooth</source>
        <translation>缺陷、折痕或光滑</translation>
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
        <translation>深度</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Difference of curvature</source>
        <translation>曲率之差</translation>
    </message>
    <message>
        <source>Difference of the change of curvature</source>
        <translation>曲率变化之差</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Direction of pull</source>
        <translation>拔模方向</translation>
    </message>
    <message>
        <source>Direction of the lamps</source>
        <translation>灯的方向</translation>
    </message>
    <message>
        <source>Direction of the stripes</source>
        <translation>条纹方向</translation>
    </message>
    <message>
        <source>Discard the changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Distance from the vertex at which the fillet ends</source>
        <translation>圆角结束处到顶点的距离</translation>
    </message>
    <message>
        <source>Distance of the lamps</source>
        <translation>灯的距离</translation>
    </message>
    <message>
        <source>Divide the selected curves only</source>
        <translation>仅分割所选曲线</translation>
    </message>
    <message>
        <source>Do it again (Ctrl+Shift+Z)</source>
        <translation>重做 (Ctrl+Shift+Z)</translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>拔模角</translation>
    </message>
    <message>
        <source>Draft angle</source>
        <translation>拔模角</translation>
    </message>
    <message>
        <source>Draw lines across the curve, as long as its curvature is large</source>
        <translation>绘制与曲线垂直的线，长度随曲率增大</translation>
    </message>
    <message>
        <source>Draw zebra stripes on the surface and on the faces beside it</source>
        <translation>在曲面及其相邻的面上绘制斑马纹</translation>
    </message>
    <message>
        <source>Drawn on</source>
        <translation>绘制于</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Edge {number}</source>
        <translation>边 {number}</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Edges lie side by side within</source>
        <translation>并排边的最大距离</translation>
    </message>
    <message>
        <source>Edges meet within</source>
        <translation>边相交误差不超过</translation>
    </message>
    <message>
        <source>Edit seam repair</source>
        <translation>编辑接缝修复</translation>
    </message>
    <message>
        <source>Edit {label}</source>
        <translation>编辑{label}</translation>
    </message>
    <message>
        <source>End</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>End joins</source>
        <translation>终点连接方式</translation>
    </message>
    <message>
        <source>End runs the other way</source>
        <translation>终点反向</translation>
    </message>
    <message>
        <source>End tangent</source>
        <translation>终点切线</translation>
    </message>
    <message>
        <source>Ends by</source>
        <translation>结束于</translation>
    </message>
    <message>
        <source>Ends of points</source>
        <translation>点的两端</translation>
    </message>
    <message>
        <source>Equal lengths</source>
        <translation>等长</translation>
    </message>
    <message>
        <source>Every seam has its level</source>
        <translation>每条接缝都达到其等级</translation>
    </message>
    <message>
        <source>Exchange the first and the second face, so that the other one moves</source>
        <translation>交换第一个面和第二个面，使另一个面移动</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>导出 CSV…</translation>
    </message>
    <message>
        <source>Export JSON…</source>
        <translation>导出 JSON…</translation>
    </message>
    <message>
        <source>Export seam report</source>
        <translation>导出接缝报告</translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>延伸曲面</translation>
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
        <translation>面的连接方式</translation>
    </message>
    <message>
        <source>Failed: {error}</source>
        <translation>失败：{error}</translation>
    </message>
    <message>
        <source>Fair Curve</source>
        <translation>光顺曲线</translation>
    </message>
    <message>
        <source>Fairness</source>
        <translation>光顺性</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Fill in the usual tolerances of one kind of work</source>
        <translation>填入某类工作的常用公差</translation>
    </message>
    <message>
        <source>Fill only the holes whose edges are selected in the view</source>
        <translation>仅填充其边在视图中被选中的孔</translation>
    </message>
    <message>
        <source>Fill that is not kept</source>
        <translation>未保留的填充</translation>
    </message>
    <message>
        <source>Filling holes…</source>
        <translation>正在填充孔…</translation>
    </message>
    <message>
        <source>First</source>
        <translation>第一个</translation>
    </message>
    <message>
        <source>First direction</source>
        <translation>起始方向</translation>
    </message>
    <message>
        <source>First face</source>
        <translation>第一个面</translation>
    </message>
    <message>
        <source>First pole at</source>
        <translation>第一控制点位于</translation>
    </message>
    <message>
        <source>FirstFace and SecondFace must be faces</source>
        <translation>FirstFace 和 SecondFace 必须是面</translation>
    </message>
    <message>
        <source>Fixed faces</source>
        <translation>固定面</translation>
    </message>
    <message>
        <source>Flat above radius</source>
        <translation>半径大于此值视为平面</translation>
    </message>
    <message>
        <source>Flat within</source>
        <translation>平面误差不超过</translation>
    </message>
    <message>
        <source>Four-sided</source>
        <translation>四边</translation>
    </message>
    <message>
        <source>Free ends</source>
        <translation>自由端</translation>
    </message>
    <message>
        <source>G0: position only; G1: without a kink; G2: with the same curvature</source>
        <translation>G0：仅位置；G1：无折角；G2：曲率相同</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Gap of patch to fillet</source>
        <translation>面片与圆角的间隙</translation>
    </message>
    <message>
        <source>Gap tolerance</source>
        <translation>间隙公差</translation>
    </message>
    <message>
        <source>Gap {unit}</source>
        <translation>间隙 {unit}</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>高斯</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Give all edges the radius of the first one</source>
        <translation>所有边使用第一条边的半径</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>Given directions</source>
        <translation>给定方向</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>手柄</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Hidden: {objects}. Show what is to have stripes.</source>
        <translation>已隐藏：{objects}。请先显示要绘制条纹的对象。</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最高值</translation>
    </message>
    <message>
        <source>Highest level of continuity the seam meets</source>
        <translation>接缝达到的最高连续性等级</translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>高光线</translation>
    </message>
    <message>
        <source>Hold side boundaries</source>
        <translation>固定侧边界</translation>
    </message>
    <message>
        <source>Hole {hole}</source>
        <translation>孔 {hole}</translation>
    </message>
    <message>
        <source>Hole {id}: {sides}, length {length}, centre ({centre})</source>
        <translation>孔 {id}：{sides}，长度 {length}，中心 ({centre})</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>How dense the lines of new curvature combs are on each curve</source>
        <translation>新曲率梳的线在每条曲线上的密度</translation>
    </message>
    <message>
        <source>How many light stripes zebra stripes have on a whole ball, in panels too</source>
        <translation>斑马纹在整个球面上的亮条纹数，面板中也适用</translation>
    </message>
    <message>
        <source>How many threads a computation uses</source>
        <translation>一次计算使用的线程数</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>Isophotes</source>
        <translation>等照度线</translation>
    </message>
    <message>
        <source>It was built for Python {python} and OpenCASCADE {occt}. </source>
        <translation>它是为 Python {python} 和 OpenCASCADE {occt} 构建的。</translation>
    </message>
    <message>
        <source>Join Curves</source>
        <translation>连接曲线</translation>
    </message>
    <message>
        <source>Joined G{order}; the ends were {gap_mm} mm apart, no {what} moved further than {moved_mm} mm.</source>
        <translation>以 G{order} 连接；两端原相距 {gap_mm} mm，没有{what}移动超过 {moved_mm} mm。</translation>
    </message>
    <message>
        <source>Joins the first</source>
        <translation>连接第一条边</translation>
    </message>
    <message>
        <source>Joins the first edge {first} and the second {second}, {figures}.</source>
        <translation>以 {first} 连接第一条边，以 {second} 连接第二条边，{figures}。</translation>
    </message>
    <message>
        <source>Joins the second</source>
        <translation>连接第二条边</translation>
    </message>
    <message>
        <source>Joints keep</source>
        <translation>连接点保持</translation>
    </message>
    <message>
        <source>Keep anyway</source>
        <translation>仍然保留</translation>
    </message>
    <message>
        <source>Keep arcs exactly</source>
        <translation>精确保持圆弧</translation>
    </message>
    <message>
        <source>Label the worst</source>
        <translation>标注最差</translation>
    </message>
    <message>
        <source>Lamps lie towards</source>
        <translation>灯所在方向</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, before and after, in degrees</source>
        <translation>切平面之间的最大角度，之前和之后，单位度</translation>
    </message>
    <message>
        <source>Largest angle between the tangent planes, in degrees</source>
        <translation>切平面之间的最大角度，单位度</translation>
    </message>
    <message>
        <source>Largest deviation {furthest_mm} mm {furthest_at}; {least} to {largest} mm</source>
        <translation>最大偏差 {furthest_mm} mm，{furthest_at}；{least} 至 {largest} mm</translation>
    </message>
    <message>
        <source>Largest distance between the two sides, before and after, in {unit}</source>
        <translation>两侧之间的最大距离，之前和之后，单位 {unit}</translation>
    </message>
    <message>
        <source>Largest distance between the two sides, in {unit}</source>
        <translation>两侧之间的最大距离，单位 {unit}</translation>
    </message>
    <message>
        <source>Largest distance of the arcs from the curve</source>
        <translation>圆弧与曲线的最大距离</translation>
    </message>
    <message>
        <source>Largest move</source>
        <translation>最大移动</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, before and after, in %</source>
        <translation>最大相对曲率差，之前和之后，单位 %</translation>
    </message>
    <message>
        <source>Largest relative difference of curvature, in %</source>
        <translation>最大相对曲率差，单位 %</translation>
    </message>
    <message>
        <source>Largest relative difference of the change of curvature, in % (measured for G3)</source>
        <translation>曲率变化的最大相对差，单位 %(针对 G3 测量)</translation>
    </message>
    <message>
        <source>Last direction</source>
        <translation>终止方向</translation>
    </message>
    <message>
        <source>Lateral</source>
        <translation>侧边界</translation>
    </message>
    <message>
        <source>Lateral boundaries (may be empty)</source>
        <translation>侧边界(可为空)</translation>
    </message>
    <message>
        <source>Lateral boundaries join</source>
        <translation>侧边界连接方式</translation>
    </message>
    <message>
        <source>Least draft away from it</source>
        <translation>背离方向的最小拔模角</translation>
    </message>
    <message>
        <source>Least draft towards it</source>
        <translation>朝向方向的最小拔模角</translation>
    </message>
    <message>
        <source>Least energy</source>
        <translation>最小能量</translation>
    </message>
    <message>
        <source>Least variation of curvature</source>
        <translation>最小曲率变化</translation>
    </message>
    <message>
        <source>Leave the largest sector open</source>
        <translation>保留最大扇区为开放</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Length of the lines of the comb</source>
        <translation>梳齿的长度</translation>
    </message>
    <message>
        <source>Length of the seam, in {unit}</source>
        <translation>接缝的长度，单位 {unit}</translation>
    </message>
    <message>
        <source>Length {unit}</source>
        <translation>长度 {unit}</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>Level and tolerances</source>
        <translation>等级和公差</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Lines inside the surface at which the curves have their joints</source>
        <translation>曲面内部、曲线连接点所在的线</translation>
    </message>
    <message>
        <source>Lines of a comb</source>
        <translation>曲率梳的线数</translation>
    </message>
    <message>
        <source>Loft through Frames</source>
        <translation>过框架放样</translation>
    </message>
    <message>
        <source>Log Spiral</source>
        <translation>对数螺线</translation>
    </message>
    <message>
        <source>Look of seams</source>
        <translation>接缝外观</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>最低值</translation>
    </message>
    <message>
        <source>Lowest = {least:g}: a radius is larger than 0</source>
        <translation>最低值 = {least:g}：半径必须大于 0</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>生成</translation>
    </message>
    <message>
        <source>Make the curve from what is selected now: {needs}</source>
        <translation>由当前所选内容生成曲线：{needs}</translation>
    </message>
    <message>
        <source>Make {label}</source>
        <translation>生成{label}</translation>
    </message>
    <message>
        <source>Making the surface…</source>
        <translation>正在生成曲面…</translation>
    </message>
    <message>
        <source>Making the {group}…</source>
        <translation>正在生成{group}…</translation>
    </message>
    <message>
        <source>Match Surfaces</source>
        <translation>匹配曲面</translation>
    </message>
    <message>
        <source>Match by</source>
        <translation>对应方式</translation>
    </message>
    <message>
        <source>Match free edges within</source>
        <translation>自由边配对距离</translation>
    </message>
    <message>
        <source>Match free edges within {proposal:g} mm</source>
        <translation>在 {proposal:g} mm 内配对自由边</translation>
    </message>
    <message>
        <source>Match surfaces</source>
        <translation>匹配曲面</translation>
    </message>
    <message>
        <source>Matched: {parts} ({reason}).</source>
        <translation>已匹配：{parts}({reason})。</translation>
    </message>
    <message>
        <source>Matching surfaces…</source>
        <translation>正在匹配曲面…</translation>
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
        <translation>正在测量接缝…</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>More faces (may be empty)</source>
        <translation>更多面（可为空）</translation>
    </message>
    <message>
        <source>Move all points back to those of the sources</source>
        <translation>将所有点恢复到来源的点</translation>
    </message>
    <message>
        <source>Move the mouse: the point is marked on the seam in the view</source>
        <translation>移动鼠标：该点会在视图中的接缝上标出</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Moves of points</source>
        <translation>点的移动</translation>
    </message>
    <message>
        <source>Near the polygon of {points} points, {figures}.</source>
        <translation>贴近 {points} 个点的多边形，{figures}。</translation>
    </message>
    <message>
        <source>No curvature</source>
        <translation>曲率为零</translation>
    </message>
    <message>
        <source>No deviation above rounding</source>
        <translation>没有超过舍入误差的偏差</translation>
    </message>
    <message>
        <source>No level</source>
        <translation>未达等级</translation>
    </message>
    <message>
        <source>No point lies over the other shape</source>
        <translation>没有点位于另一形状上方</translation>
    </message>
    <message>
        <source>No point of a face may move further than this. By size of face: a hundredth of the size of the face plus twice the largest gap of its seams</source>
        <translation>面上任何点的移动都不得超过此值。按面的尺寸：面尺寸的百分之一加上其接缝最大间隙的两倍</translation>
    </message>
    <message>
        <source>No seams: no two faces share an edge.</source>
        <translation>没有接缝：没有两个面共用一条边。</translation>
    </message>
    <message>
        <source>No two faces share an edge: free edges are matched within {proposed:g} mm, as proposed. </source>
        <translation>没有两个面共用一条边：按建议在 {proposed:g} mm 内配对自由边。</translation>
    </message>
    <message>
        <source>No value is defined</source>
        <translation>没有有定义的值</translation>
    </message>
    <message>
        <source>No visible object has faces to draw zebra stripes on.</source>
        <translation>没有可见对象具有可绘制斑马纹的面。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Not allowed: enter a number from {least} to {largest}.</source>
        <translation>不允许：请输入 {least} 到 {largest} 之间的数。</translation>
    </message>
    <message>
        <source>Not analysed: {reason}</source>
        <translation>未分析：{reason}</translation>
    </message>
    <message>
        <source>Not filled: {reasons}</source>
        <translation>未填充：{reasons}</translation>
    </message>
    <message>
        <source>Not filled: {reason}</source>
        <translation>未填充：{reason}</translation>
    </message>
    <message>
        <source>Not made: {reason}.</source>
        <translation>未生成：{reason}。</translation>
    </message>
    <message>
        <source>Not matched: {reason}.</source>
        <translation>未匹配：{reason}。</translation>
    </message>
    <message>
        <source>Not reached ({missed})</source>
        <translation>未达到({missed})</translation>
    </message>
    <message>
        <source>Not repaired: {reason}</source>
        <translation>未修复：{reason}</translation>
    </message>
    <message>
        <source>Not rounded: {error}.</source>
        <translation>未倒圆：{error}。</translation>
    </message>
    <message>
        <source>Not rounded: {reason}.</source>
        <translation>未倒圆：{reason}。</translation>
    </message>
    <message>
        <source>Not smooth</source>
        <translation>不光滑</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Nothing to repair: no seam falls short of {target}; the model is unchanged.</source>
        <translation>无需修复：没有接缝低于 {target}；模型未改变。</translation>
    </message>
    <message>
        <source>Nothing to repair: no two faces share an edge, and none are matched.</source>
        <translation>无需修复：没有两个面共用一条边，也没有配对的边。</translation>
    </message>
    <message>
        <source>Nothing to repair: the chosen seams meet {target}; the model is unchanged.</source>
        <translation>无需修复：所选接缝满足 {target}；模型未改变。</translation>
    </message>
    <message>
        <source>Number of arcs</source>
        <translation>圆弧数</translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation>曲线数</translation>
    </message>
    <message>
        <source>Number of lines</source>
        <translation>线数</translation>
    </message>
    <message>
        <source>Number of lines of the comb</source>
        <translation>梳齿数</translation>
    </message>
    <message>
        <source>Number of stripes</source>
        <translation>条纹数</translation>
    </message>
    <message>
        <source>Number of the seam in the report</source>
        <translation>报告中接缝的编号</translation>
    </message>
    <message>
        <source>Number the points</source>
        <translation>为点编号</translation>
    </message>
    <message>
        <source>Numbers of the two faces that meet</source>
        <translation>相接的两个面的编号</translation>
    </message>
    <message>
        <source>Objects that exist keep theirs. The new faces of Umbrella Fill have tolerances of their own.</source>
        <translation>已有对象保留其公差。伞形填充的新面有自己的公差。</translation>
    </message>
    <message>
        <source>Of the area, {towards} % drafts towards the pull, {away} % away, {steep} % is too steep. {mesh}.</source>
        <translation>面积中 {towards} % 朝向拔模方向，{away} % 背离，{steep} % 过陡。{mesh}。</translation>
    </message>
    <message>
        <source>On faces</source>
        <translation>面上</translation>
    </message>
    <message>
        <source>Only selected</source>
        <translation>仅所选</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Other end of the first</source>
        <translation>第一条的另一端</translation>
    </message>
    <message>
        <source>Other end of the second</source>
        <translation>第二条的另一端</translation>
    </message>
    <message>
        <source>Outer boundary (may be empty)</source>
        <translation>外边界（可为空）</translation>
    </message>
    <message>
        <source>Own points</source>
        <translation>自有点</translation>
    </message>
    <message>
        <source>Pick points</source>
        <translation>拾取点</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>点的含义</translation>
    </message>
    <message>
        <source>Points are of a</source>
        <translation>点取自</translation>
    </message>
    <message>
        <source>Points on a seam</source>
        <translation>接缝上的点数</translation>
    </message>
    <message>
        <source>Points on curved edges</source>
        <translation>弯曲边上的点数</translation>
    </message>
    <message>
        <source>Points that are picked or dragged snap to a grid; Ctrl: free</source>
        <translation>拾取或拖动的点吸附到网格；Ctrl：自由</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Polygon, alpha curves</source>
        <translation>多边形，alpha 曲线</translation>
    </message>
    <message>
        <source>Polygon, direct G2</source>
        <translation>多边形，直接 G2</translation>
    </message>
    <message>
        <source>Polygon, gamma</source>
        <translation>多边形，gamma</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Preview while fields are changed</source>
        <translation>更改字段时预览</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>重新计算</translation>
    </message>
    <message>
        <source>Recompute (values were changed)</source>
        <translation>重新计算(值已更改)</translation>
    </message>
    <message>
        <source>Recompute and close</source>
        <translation>重新计算并关闭</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>反射线</translation>
    </message>
    <message>
        <source>Relative curvature</source>
        <translation>相对曲率</translation>
    </message>
    <message>
        <source>Relative difference of curvature</source>
        <translation>相对曲率差</translation>
    </message>
    <message>
        <source>Relative difference of the change of curvature</source>
        <translation>曲率变化的相对差</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the selected names from the list, or all names if none is selected</source>
        <translation>从列表中移除所选名称，未选择时移除全部</translation>
    </message>
    <message>
        <source>Remove the tangents that were given to the ends</source>
        <translation>移除给两端指定的切线</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>Repair seams</source>
        <translation>修复接缝</translation>
    </message>
    <message>
        <source>Repair the seams of the selected rows, or all defects if no row is selected</source>
        <translation>修复所选行的接缝，未选择行时修复所有缺陷</translation>
    </message>
    <message>
        <source>Repair the seams with these values</source>
        <translation>用这些值修复接缝</translation>
    </message>
    <message>
        <source>Repair these…</source>
        <translation>修复这些…</translation>
    </message>
    <message>
        <source>Repaired, or why not</source>
        <translation>已修复，或未修复的原因</translation>
    </message>
    <message>
        <source>Repairing seams…</source>
        <translation>正在修复接缝…</translation>
    </message>
    <message>
        <source>Repair…</source>
        <translation>修复…</translation>
    </message>
    <message>
        <source>Report (*.json)</source>
        <translation>报告 (*.json)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Rounding the corner…</source>
        <translation>正在对拐角倒圆…</translation>
    </message>
    <message>
        <source>Same radius for all</source>
        <translation>全部使用相同半径</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Seam Analysis</source>
        <translation>接缝分析</translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>接缝图</translation>
    </message>
    <message>
        <source>Seam Repair</source>
        <translation>接缝修复</translation>
    </message>
    <message>
        <source>Seam tolerances</source>
        <translation>接缝公差</translation>
    </message>
    <message>
        <source>Seam {id} ({kind})</source>
        <translation>接缝 {id}({kind})</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Seamwright was built for OpenCASCADE {built}, but this FreeCAD runs OpenCASCADE {running}. Install the Seamwright that was built for this FreeCAD.</source>
        <translation>Seamwright 是为 OpenCASCADE {built} 构建的，但此 FreeCAD 使用 OpenCASCADE {running}。请安装为此 FreeCAD 构建的 Seamwright。</translation>
    </message>
    <message>
        <source>Seamwright: help</source>
        <translation>Seamwright：帮助</translation>
    </message>
    <message>
        <source>Seamwright: the colours are not shown: {error}
</source>
        <translation>Seamwright：未显示颜色：{error}
</translation>
    </message>
    <message>
        <source>Seamwright: the moves of {names} are not shown: {error}
</source>
        <translation>Seamwright：未显示 {names} 的移动量：{error}
</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>第二个</translation>
    </message>
    <message>
        <source>Second continues the first</source>
        <translation>第二条延续第一条</translation>
    </message>
    <message>
        <source>Second face</source>
        <translation>第二个面</translation>
    </message>
    <message>
        <source>Second pole at</source>
        <translation>第二控制点位于</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Select edges</source>
        <translation>选择边</translation>
    </message>
    <message>
        <source>Select either edges of holes or one face to replace. Selected: {faces}, {edges}.</source>
        <translation>请选择孔的边，或一个要替换的面。已选择：{faces}，{edges}。</translation>
    </message>
    <message>
        <source>Select one vertex of a solid at which 3 to 6 edges meet. Selected: {vertices}.</source>
        <translation>请选择实体上一个由 3 至 6 条边相交的顶点。已选择：{vertices}。</translation>
    </message>
    <message>
        <source>Select two faces: first the one that stays, then the one that moves. You may also select one common edge, or more faces that stay, or edges of them. Selected: {faces}, {edges}.</source>
        <translation>请选择两个面：先选保持不动的，再选要移动的。还可以选择一条公共边，或更多保持不动的面，或这些面的边。已选择：{faces}，{edges}。</translation>
    </message>
    <message>
        <source>Set by the expression {expression}</source>
        <translation>由表达式 {expression} 设定</translation>
    </message>
    <message>
        <source>Setback</source>
        <translation>回退距离</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Show handles in the view: circles are points, squares the tangents of the ends, diamonds the tensions. Drag them; Esc takes a drag back.</source>
        <translation>在视图中显示手柄：圆形为点，方形为端点切线，菱形为张力。可拖动；Esc 撤回拖动。</translation>
    </message>
    <message>
        <source>Show the page before</source>
        <translation>显示上一页</translation>
    </message>
    <message>
        <source>Show the values that Seamwright has at first</source>
        <translation>显示 Seamwright 的初始值</translation>
    </message>
    <message>
        <source>Show which number of a list belongs to which point</source>
        <translation>显示列表中的哪个数属于哪个点</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>Smallest move</source>
        <translation>最小移动</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>Smallest radius of curvature</source>
        <translation>最小曲率半径</translation>
    </message>
    <message>
        <source>Smallest radius {least} mm {least_at}. {mesh}.</source>
        <translation>最小半径 {least} mm，{least_at}。{mesh}。</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>光滑</translation>
    </message>
    <message>
        <source>Smooth curve</source>
        <translation>光滑曲线</translation>
    </message>
    <message>
        <source>Sort by class: defects by how much their figures exceed the tolerances, others by the figure of the level, such as the angle for G1</source>
        <translation>按类别排序：缺陷按数值超出公差的程度，其余按该等级的数值，例如 G1 的角度</translation>
    </message>
    <message>
        <source>Spacing of the lamps</source>
        <translation>灯的间距</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>螺旋线</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>样条</translation>
    </message>
    <message>
        <source>Spline through points</source>
        <translation>通过点的样条</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Start joins</source>
        <translation>起点连接方式</translation>
    </message>
    <message>
        <source>Start tangent</source>
        <translation>起点切线</translation>
    </message>
    <message>
        <source>Start, corner and end</source>
        <translation>起点、拐角和终点</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop and keep the earlier results. Esc does the same.</source>
        <translation>停止并保留先前的结果。Esc 作用相同。</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Surface of {faces}</source>
        <translation>由{faces}组成的曲面</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>交换</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Take the last drag or change of a point back (Ctrl+Z)</source>
        <translation>撤回上一次对点的拖动或更改 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Take these tolerances</source>
        <translation>采用这些公差</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>切线</translation>
    </message>
    <message>
        <source>Tangent chain</source>
        <translation>相切链</translation>
    </message>
    <message>
        <source>Tangents in one plane within</source>
        <translation>切线共面误差不超过</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Target and limits</source>
        <translation>目标和限制</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Tension at the end</source>
        <translation>终点处的张力</translation>
    </message>
    <message>
        <source>Tension at the first</source>
        <translation>第一条处的张力</translation>
    </message>
    <message>
        <source>Tension at the second</source>
        <translation>第二条处的张力</translation>
    </message>
    <message>
        <source>Tension at the start</source>
        <translation>起点处的张力</translation>
    </message>
    <message>
        <source>The analysis is hidden: the view shows its colours and labels once it is shown.</source>
        <translation>分析已隐藏：显示后，视图才会显示其颜色和标签。</translation>
    </message>
    <message>
        <source>The best fill needs {tolerances}; Keep anyway keeps it.</source>
        <translation>最佳填充需要{tolerances}；“仍然保留”会保留它。</translation>
    </message>
    <message>
        <source>The compiled part of Seamwright cannot be loaded ({reason}). {built}This FreeCAD runs Python {python} and OpenCASCADE {occt}: install the Seamwright that was built for it.</source>
        <translation>无法加载 Seamwright 的编译部分({reason})。{built}此 FreeCAD 使用 Python {python} 和 OpenCASCADE {occt}：请安装为其构建的 Seamwright。</translation>
    </message>
    <message>
        <source>The crease angle, {crease:g}°, must be larger than the angle tolerance, {angle:g}°</source>
        <translation>折痕角 {crease:g}° 必须大于角度公差 {angle:g}°</translation>
    </message>
    <message>
        <source>The edge of the model, or the lines inside the surface</source>
        <translation>模型边，或曲面内部的线</translation>
    </message>
    <message>
        <source>The edge of the seam in the result, or in the model where nothing was kept</source>
        <translation>结果中接缝的边；未保留结果时为模型中的边</translation>
    </message>
    <message>
        <source>The edge or edges of the seam</source>
        <translation>接缝的一条或多条边</translation>
    </message>
    <message>
        <source>The faces are flat: they have no radius</source>
        <translation>这些面是平的：没有半径</translation>
    </message>
    <message>
        <source>The faces as they look in the document</source>
        <translation>面按其在文档中的样子显示</translation>
    </message>
    <message>
        <source>The faces that meet at the seam</source>
        <translation>在接缝处相接的面</translation>
    </message>
    <message>
        <source>The first face was deleted: choose another one in the property FirstFace</source>
        <translation>第一个面已被删除：请在属性 FirstFace 中另选一个</translation>
    </message>
    <message>
        <source>The largest value on the whole seam, proven where an upper bound is known. The curve is sampled.</source>
        <translation>整条接缝上的最大值，在已知上界处经过证明。曲线为采样所得。</translation>
    </message>
    <message>
        <source>The model was changed during the computation</source>
        <translation>计算期间模型已更改</translation>
    </message>
    <message>
        <source>The preferences are not stored: {error}.</source>
        <translation>首选项未保存：{error}。</translation>
    </message>
    <message>
        <source>The property Vertex names {vertices} vertices: name exactly one</source>
        <translation>属性 Vertex 指定了 {vertices} 个顶点：请恰好指定一个</translation>
    </message>
    <message>
        <source>The result itself is selected. Show Before, and select in the model.</source>
        <translation>所选的是结果本身。请显示“之前”，并在模型中选择。</translation>
    </message>
    <message>
        <source>The seams at these edges:</source>
        <translation>位于这些边的接缝：</translation>
    </message>
    <message>
        <source>The seams in the table and in the view</source>
        <translation>表格和视图中的接缝</translation>
    </message>
    <message>
        <source>The second face was deleted: choose another one in the property SecondFace</source>
        <translation>第二个面已被删除：请在属性 SecondFace 中另选一个</translation>
    </message>
    <message>
        <source>The side of the surface, or inside it</source>
        <translation>曲面的一侧或其内部</translation>
    </message>
    <message>
        <source>The source was deleted: choose another one</source>
        <translation>源对象已被删除：请选择另一个</translation>
    </message>
    <message>
        <source>The two faces that meet</source>
        <translation>相接的两个面</translation>
    </message>
    <message>
        <source>The verdict is certain: it is the same for every value within the bounds</source>
        <translation>判定是确定的：对界限内的每个值都相同</translation>
    </message>
    <message>
        <source>The verdict is not certain</source>
        <translation>判定不确定</translation>
    </message>
    <message>
        <source>The {faces} faces of {label} share no edges, so that their outlines are no holes: sew them first, with Repair Seams for example, or select the edges of a hole.</source>
        <translation>{label} 的 {faces} 个面没有公共边，因此它们的轮廓不是孔：请先缝合（例如用“修复接缝”），或选择某个孔的边。</translation>
    </message>
    <message>
        <source>There are no points: pick some, or select points or edges and press Use selection.</source>
        <translation>没有点：请拾取一些点，或选择点或边并按“使用所选”。</translation>
    </message>
    <message>
        <source>There is nothing to analyse: the document has no faces.</source>
        <translation>没有可分析的内容：文档没有面。</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>Three-sided</source>
        <translation>三边</translation>
    </message>
    <message>
        <source>Through inner curves</source>
        <translation>通过内部曲线</translation>
    </message>
    <message>
        <source>Through points, tension</source>
        <translation>通过点，张力</translation>
    </message>
    <message>
        <source>Through points, tension and bias</source>
        <translation>通过点，张力和偏斜</translation>
    </message>
    <message>
        <source>Through {points} points, {figures}.</source>
        <translation>通过 {points} 个点，{figures}。</translation>
    </message>
    <message>
        <source>Ticked holes are filled. Click a hole to see it and to select its edges.</source>
        <translation>勾选的孔将被填充。单击一个孔可查看它并选择其边。</translation>
    </message>
    <message>
        <source>To Sketch</source>
        <translation>转为草图</translation>
    </message>
    <message>
        <source>To fill holes, select one object or some of its edges. To replace a face, select it. Found: {chosen}.</source>
        <translation>要填充孔，请选择一个对象或其部分边。要替换一个面，请选择该面。找到：{chosen}。</translation>
    </message>
    <message>
        <source>To repair seams, select one object or some of its edges. Found: {objects}.</source>
        <translation>要修复接缝，请选择一个对象或其部分边。找到：{objects}。</translation>
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
        <translation>新对象的公差</translation>
    </message>
    <message>
        <source>U and V lines</source>
        <translation>U 线和 V 线</translation>
    </message>
    <message>
        <source>U lines</source>
        <translation>U 线</translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>伞形面</translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>伞形填充</translation>
    </message>
    <message>
        <source>Umbrella fill</source>
        <translation>伞形填充</translation>
    </message>
    <message>
        <source>Uncertain</source>
        <translation>不确定</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Up to (may be empty)</source>
        <translation>直到(可为空)</translation>
    </message>
    <message>
        <source>Update preview</source>
        <translation>更新预览</translation>
    </message>
    <message>
        <source>Use selection</source>
        <translation>使用所选</translation>
    </message>
    <message>
        <source>Use what is selected now instead: {needs}</source>
        <translation>改用当前所选内容：{needs}</translation>
    </message>
    <message>
        <source>Use what is selected now instead: {tip}</source>
        <translation>改用当前所选内容：{tip}</translation>
    </message>
    <message>
        <source>V lines</source>
        <translation>V 线</translation>
    </message>
    <message>
        <source>Values were changed, but the seams were not analysed with them.</source>
        <translation>数值已更改，但尚未用它们分析接缝。</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>What is plotted along the seam</source>
        <translation>沿接缝绘制的量</translation>
    </message>
    <message>
        <source>What the colours of the faces show</source>
        <translation>面的颜色表示什么</translation>
    </message>
    <message>
        <source>What the colours of the seams in the view show</source>
        <translation>视图中接缝的颜色表示什么</translation>
    </message>
    <message>
        <source>Whether class and level are the same for every value within the bounds</source>
        <translation>对界限内的每个值，类别和等级是否都相同</translation>
    </message>
    <message>
        <source>Whether the seam certainly has its level</source>
        <translation>接缝是否确定达到其等级</translation>
    </message>
    <message>
        <source>Whether the seam certainly meets the target</source>
        <translation>接缝是否确定达到目标</translation>
    </message>
    <message>
        <source>Width = {width:g}: less than 1 is needed</source>
        <translation>宽度 = {width:g}：必须小于 1</translation>
    </message>
    <message>
        <source>Width of the lines</source>
        <translation>线宽</translation>
    </message>
    <message>
        <source>Width of the stripes</source>
        <translation>条纹宽度</translation>
    </message>
    <message>
        <source>Worst first</source>
        <translation>最差优先</translation>
    </message>
    <message>
        <source>Write a table with a line for each seam that is shown, in this order</source>
        <translation>写入表格，所显示的每条接缝一行，按显示的顺序</translation>
    </message>
    <message>
        <source>Write the report of all seams as the command seamwright does</source>
        <translation>按命令 seamwright 的格式写入所有接缝的报告</translation>
    </message>
    <message>
        <source>Zebra stripes</source>
        <translation>斑马纹</translation>
    </message>
    <message>
        <source>Zebra stripes on a ball</source>
        <translation>球面上的斑马纹数</translation>
    </message>
    <message>
        <source>Zoom to seam</source>
        <translation>缩放到接缝</translation>
    </message>
    <message>
        <source>a closed spline</source>
        <translation>闭合样条</translation>
    </message>
    <message>
        <source>a curvature tolerance of {figure} %</source>
        <translation>曲率公差 {figure} %</translation>
    </message>
    <message>
        <source>a curve of degree {degree} is {distance:.3g} mm from {edge}, and {tolerance_mm:g} mm are allowed: divide the edge, or allow more</source>
        <translation>{degree} 次曲线与{edge}相距 {distance:.3g} mm，允许值为 {tolerance_mm:g} mm：请分割该边，或放宽允许值</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>a face has no curve in its parameters along the seam</source>
        <translation>某个面沿接缝没有参数曲线</translation>
    </message>
    <message>
        <source>a gap tolerance of {figure} mm</source>
        <translation>间隙公差 {figure} mm</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>一个点</translation>
    </message>
    <message>
        <source>a point is ({point}): coordinates must be finite and below {most:g} mm</source>
        <translation>有一个点是 ({point})：坐标必须有限且小于 {most:g} mm</translation>
    </message>
    <message>
        <source>a point is chosen: choose edges, wires or sketches</source>
        <translation>选择了一个点：请选择边、线或草图</translation>
    </message>
    <message>
        <source>a pole</source>
        <translation>一个控制点</translation>
    </message>
    <message>
        <source>a vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>along the seam, mm</source>
        <translation>沿接缝，mm</translation>
    </message>
    <message>
        <source>an angle tolerance of {figure}°</source>
        <translation>角度公差 {figure}°</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>an edge has no tangent at its end: choose another end</source>
        <translation>一条边在其端点没有切线：请选择另一端</translation>
    </message>
    <message>
        <source>an edge has no tangent at the point: choose other edges</source>
        <translation>一条边在该点没有切线：请选择其他边</translation>
    </message>
    <message>
        <source>angle at most {figure}°</source>
        <translation>角度最大 {figure}°</translation>
    </message>
    <message>
        <source>angle unknown</source>
        <translation>角度未知</translation>
    </message>
    <message>
        <source>angle {figure}°</source>
        <translation>角度 {figure}°</translation>
    </message>
    <message>
        <source>angle ≤ {angle_deg:g}°</source>
        <translation>角度 ≤ {angle_deg:g}°</translation>
    </message>
    <message>
        <source>apart from creases, largest gap {gap} mm, largest angle {angle}°</source>
        <translation>除折痕外，最大间隙 {gap} mm，最大角度 {angle}°</translation>
    </message>
    <message>
        <source>arcs and rational splines can only be divided for single curves: for a surface, let splines take their place</source>
        <translation>圆弧和有理样条只能在生成单独曲线时分割：生成曲面时请用样条代替</translation>
    </message>
    <message>
        <source>as a bowl or a dome</source>
        <translation>如碗形或穹顶</translation>
    </message>
    <message>
        <source>as a saddle</source>
        <translation>如马鞍形</translation>
    </message>
    <message>
        <source>as a sphere of radius {radius} mm</source>
        <translation>如半径 {radius} mm 的球面</translation>
    </message>
    <message>
        <source>as little as needed</source>
        <translation>尽可能少</translation>
    </message>
    <message>
        <source>at ({point})</source>
        <translation>位于 ({point})</translation>
    </message>
    <message>
        <source>at least {least:g}</source>
        <translation>至少 {least:g}</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>最多 {most}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>auto: {setback:.4g} {unit}</source>
        <translation>自动：{setback:.4g} {unit}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>between</source>
        <translation>之间</translation>
    </message>
    <message>
        <source>beyond the edges of the other shape</source>
        <translation>超出另一形状的边缘</translation>
    </message>
    <message>
        <source>by size of face</source>
        <translation>按面的尺寸</translation>
    </message>
    <message>
        <source>change of curvature {figure}</source>
        <translation>曲率变化 {figure}</translation>
    </message>
    <message>
        <source>choose edges, or nothing</source>
        <translation>请选择边，或不选择</translation>
    </message>
    <message>
        <source>choose faces or edges of faces, or nothing</source>
        <translation>请选择面或面的边，或不选择</translation>
    </message>
    <message>
        <source>choose one edge of both faces, or nothing</source>
        <translation>请选择两个面的一条公共边，或不选</translation>
    </message>
    <message>
        <source>choose one face</source>
        <translation>请选择一个面</translation>
    </message>
    <message>
        <source>choose one vertex</source>
        <translation>请选择一个顶点</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>凹</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>凸</translation>
    </message>
    <message>
        <source>curvature at most {figure} %</source>
        <translation>曲率最大 {figure} %</translation>
    </message>
    <message>
        <source>curvature unknown</source>
        <translation>曲率未知</translation>
    </message>
    <message>
        <source>curvature {figure}</source>
        <translation>曲率 {figure}</translation>
    </message>
    <message>
        <source>curvature {figure} %</source>
        <translation>曲率 {figure} %</translation>
    </message>
    <message>
        <source>curvature ≤ {curvature_rel:g} %</source>
        <translation>曲率 ≤ {curvature_rel:g} %</translation>
    </message>
    <message>
        <source>defects before {before}, after {after}</source>
        <translation>缺陷：之前 {before} 个，之后 {after} 个</translation>
    </message>
    <message>
        <source>drafts away from the pull</source>
        <translation>背离拔模方向</translation>
    </message>
    <message>
        <source>drafts towards the pull</source>
        <translation>朝向拔模方向</translation>
    </message>
    <message>
        <source>edge {number}</source>
        <translation>边 {number} </translation>
    </message>
    <message>
        <source>edge {number} does not belong to a hole: it is not free, or not part of a closed loop</source>
        <translation>边 {number} 不属于孔：它不是自由边，或不在闭合环中</translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary</source>
        <translation>外边界的边 {number} </translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary does not lead from the end of an edge to that of its neighbour: it ends {distance} mm from the nearest end</source>
        <translation>外边界的边 {number} 未从一条边的端点通到相邻边的端点：它的末端距最近的端点 {distance} mm</translation>
    </message>
    <message>
        <source>edge {number} of the outer boundary leads from edge {first} to edge {second}: choose one or two edges for each two neighbours</source>
        <translation>外边界的边 {number} 从边 {first} 通到边 {second}：请为每两条相邻边选择一条或两条边</translation>
    </message>
    <message>
        <source>edges moved by at most {moved} mm, edge {number} most</source>
        <translation>边最多移动 {moved} mm，其中边 {number} 移动最多</translation>
    </message>
    <message>
        <source>end</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>equal change of curvature</source>
        <translation>曲率变化相同</translation>
    </message>
    <message>
        <source>equal curvature</source>
        <translation>曲率相同</translation>
    </message>
    <message>
        <source>every seam is {order}</source>
        <translation>每条接缝均为 {order}</translation>
    </message>
    <message>
        <source>exchange of surfaces between CAD systems</source>
        <translation>CAD 系统之间的曲面交换</translation>
    </message>
    <message>
        <source>falls short of {level}</source>
        <translation>低于 {level}</translation>
    </message>
    <message>
        <source>fill, {face}</source>
        <translation>填充，{face}</translation>
    </message>
    <message>
        <source>fillet, face</source>
        <translation>圆角，面</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平</translation>
    </message>
    <message>
        <source>flat, or a saddle</source>
        <translation>平，或鞍形</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>gap at most {figure} mm</source>
        <translation>间隙最大 {figure} mm</translation>
    </message>
    <message>
        <source>gap at most {gap_mm} mm, angle at most {angle_deg}°</source>
        <translation>间隙最大 {gap_mm} mm，角度最大 {angle_deg}°</translation>
    </message>
    <message>
        <source>gap larger than the tolerance</source>
        <translation>间隙大于公差</translation>
    </message>
    <message>
        <source>gap unknown</source>
        <translation>间隙未知</translation>
    </message>
    <message>
        <source>gap {figure} mm</source>
        <translation>间隙 {figure} mm</translation>
    </message>
    <message>
        <source>gap ≤ {gap_mm:g} mm</source>
        <translation>间隙 ≤ {gap_mm:g} mm</translation>
    </message>
    <message>
        <source>has no points or edges</source>
        <translation>没有点或边</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内侧</translation>
    </message>
    <message>
        <source>inside a face</source>
        <translation>面的内部</translation>
    </message>
    <message>
        <source>is a mesh</source>
        <translation>是网格</translation>
    </message>
    <message>
        <source>is chosen as a whole</source>
        <translation>被整体选择</translation>
    </message>
    <message>
        <source>is not an edge or a face</source>
        <translation>不是边或面</translation>
    </message>
    <message>
        <source>lateral boundary</source>
        <translation>侧边界</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已略去</translation>
    </message>
    <message>
        <source>line {number}</source>
        <translation>线 {number}</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>条线</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>配对</translation>
    </message>
    <message>
        <source>mechanical parts</source>
        <translation>机械零件</translation>
    </message>
    <message>
        <source>meet with an angle</source>
        <translation>以一定角度相接</translation>
    </message>
    <message>
        <source>meet without a kink</source>
        <translation>无折角相接</translation>
    </message>
    <message>
        <source>meets {level}</source>
        <translation>满足 {level}</translation>
    </message>
    <message>
        <source>meets {target}</source>
        <translation>满足 {target}</translation>
    </message>
    <message>
        <source>middle of {edge}</source>
        <translation>{edge} 的中点</translation>
    </message>
    <message>
        <source>misses {target}</source>
        <translation>未满足 {target}</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>必须是整数</translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation>必须是有限值</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>no arcs</source>
        <translation>无圆弧</translation>
    </message>
    <message>
        <source>no chains</source>
        <translation>无链</translation>
    </message>
    <message>
        <source>no conics</source>
        <translation>无圆锥曲线</translation>
    </message>
    <message>
        <source>no corner</source>
        <translation>无拐角</translation>
    </message>
    <message>
        <source>no creases</source>
        <translation>无折痕</translation>
    </message>
    <message>
        <source>no curves</source>
        <translation>无曲线</translation>
    </message>
    <message>
        <source>no defects</source>
        <translation>无缺陷</translation>
    </message>
    <message>
        <source>no document is open: make or open one first</source>
        <translation>没有打开的文档：请先新建或打开一个</translation>
    </message>
    <message>
        <source>no edge is a polynomial spline of degree 2 or more: lines, arcs and rational splines stay as they are</source>
        <translation>没有边是 2 次或更高次的多项式样条：直线、圆弧和有理样条保持不变</translation>
    </message>
    <message>
        <source>no edge is chosen: choose the edges of a side</source>
        <translation>未选择边：请选择一侧的边</translation>
    </message>
    <message>
        <source>no edge moved</source>
        <translation>没有边移动</translation>
    </message>
    <message>
        <source>no edges</source>
        <translation>无边</translation>
    </message>
    <message>
        <source>no face could be divided into triangles: see Check geometry in the workbench Part</source>
        <translation>没有面能划分成三角形：请用零件工作台的“检查几何体”</translation>
    </message>
    <message>
        <source>no face moved</source>
        <translation>没有面移动</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>无面</translation>
    </message>
    <message>
        <source>no features</source>
        <translation>无特征</translation>
    </message>
    <message>
        <source>no free edges</source>
        <translation>无自由边</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>无孔</translation>
    </message>
    <message>
        <source>no inflections</source>
        <translation>无拐点</translation>
    </message>
    <message>
        <source>no joints</source>
        <translation>无连接点</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限制</translation>
    </message>
    <message>
        <source>no lines</source>
        <translation>无直线</translation>
    </message>
    <message>
        <source>no lines of joints</source>
        <translation>无连接线</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>无数值</translation>
    </message>
    <message>
        <source>no objects</source>
        <translation>无对象</translation>
    </message>
    <message>
        <source>no pieces</source>
        <translation>无段</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>无点</translation>
    </message>
    <message>
        <source>no seams</source>
        <translation>无接缝</translation>
    </message>
    <message>
        <source>no sides</source>
        <translation>无侧边</translation>
    </message>
    <message>
        <source>no sources</source>
        <translation>无来源</translation>
    </message>
    <message>
        <source>no splines within {tolerance:g} mm of the curves were found: take a larger tolerance</source>
        <translation>在 {tolerance:g} mm 内没有找到贴近曲线的样条：请取更大的公差</translation>
    </message>
    <message>
        <source>no verdicts</source>
        <translation>无判定</translation>
    </message>
    <message>
        <source>no vertex</source>
        <translation>无顶点</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>not every seam is certainly {order}</source>
        <translation>并非每条接缝都确定为 {order}</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>nothing is chosen for “{title}”: {needs}</source>
        <translation>没有为“{title}”选择任何内容：{needs}</translation>
    </message>
    <message>
        <source>nothing is selected: {needs}</source>
        <translation>未选择任何内容：{needs}</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>没有移动</translation>
    </message>
    <message>
        <source>of the input too</source>
        <translation>也包括输入</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>on {edge}</source>
        <translation>{edge} 上</translation>
    </message>
    <message>
        <source>one for each processor</source>
        <translation>每个处理器一个</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外侧</translation>
    </message>
    <message>
        <source>patch, face</source>
        <translation>面片，面</translation>
    </message>
    <message>
        <source>patch, fillet</source>
        <translation>面片，圆角</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>points and edges are chosen: choose either</source>
        <translation>同时选择了点和边：请只选其一</translation>
    </message>
    <message>
        <source>points {first} and {second} are the same, ({point}): leave one of them out</source>
        <translation>点 {first} 和点 {second} 相同，({point})：请去掉其中一个</translation>
    </message>
    <message>
        <source>pole</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>poles moved by up to {largest_move_mm} mm</source>
        <translation>控制点最多移动 {largest_move_mm} mm</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>已证明</translation>
    </message>
    <message>
        <source>radius {radius} mm</source>
        <translation>半径 {radius} mm</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>sampled at the points of the mesh</source>
        <translation>在网格点处采样</translation>
    </message>
    <message>
        <source>seen from the side of the normals</source>
        <translation>从法线一侧看</translation>
    </message>
    <message>
        <source>seen, without an upper bound</source>
        <translation>观测值，无上界</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>段</translation>
    </message>
    <message>
        <source>select edges at which two faces meet, or edges that lie side by side</source>
        <translation>请选择两个面相接的边，或并排的边</translation>
    </message>
    <message>
        <source>select edges, a wire or a sketch with splines, or points that lie in a plane</source>
        <translation>请选择边、线或含样条的草图，或位于同一平面内的点</translation>
    </message>
    <message>
        <source>select edges, a wire, a sketch or points that lie in a plane</source>
        <translation>请选择位于同一平面内的边、线、草图或点</translation>
    </message>
    <message>
        <source>select edges, wires or faces</source>
        <translation>请选择边、线或面</translation>
    </message>
    <message>
        <source>select objects with faces</source>
        <translation>请选择带面的对象</translation>
    </message>
    <message>
        <source>select others and press “Use selection” at “{title}” in the panel</source>
        <translation>请选择其他对象，并在面板的“{title}”处按“使用所选”</translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch</source>
        <translation>请选择点、边、线或草图</translation>
    </message>
    <message>
        <source>select points, edges, a wire or a sketch that lie in a plane</source>
        <translation>请选择位于同一平面内的点、边、线或草图</translation>
    </message>
    <message>
        <source>select the edges of a side; where an edge lies between two faces, also the face to continue</source>
        <translation>请选择一侧的边；若边位于两个面之间，还请选择要延续的面</translation>
    </message>
    <message>
        <source>select the edges of two sides; where an edge lies between two faces, also the face to continue</source>
        <translation>请选择两侧的边；若边位于两个面之间，还请选择要延续的面</translation>
    </message>
    <message>
        <source>select three or more edges that end in one point</source>
        <translation>请选择三条或更多在一点结束的边</translation>
    </message>
    <message>
        <source>select three points or more, a wire or a sketch, in a plane</source>
        <translation>请选择同一平面内的三个或更多点、线或草图</translation>
    </message>
    <message>
        <source>select three points, a wire or a sketch of two lines, or two edges, in a plane</source>
        <translation>请选择同一平面内的三个点、由两条直线组成的线或草图，或两条边</translation>
    </message>
    <message>
        <source>select two edges</source>
        <translation>请选择两条边</translation>
    </message>
    <message>
        <source>select two objects with faces: first the one to colour</source>
        <translation>请选择两个带面的对象：先选要着色的</translation>
    </message>
    <message>
        <source>select two or more edges, wires or sketches</source>
        <translation>请选择两条或更多的边、线或草图</translation>
    </message>
    <message>
        <source>shared</source>
        <translation>共用</translation>
    </message>
    <message>
        <source>sharper than {crease_deg:g}°, taken as intended</source>
        <translation>比 {crease_deg:g}° 更尖锐，视为有意</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>边</translation>
    </message>
    <message>
        <source>smallest radius {radius} mm</source>
        <translation>最小半径 {radius} mm</translation>
    </message>
    <message>
        <source>some curves are closed and some are open: choose curves of one kind</source>
        <translation>有的曲线闭合，有的开放：请选择同一类曲线</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>such a spline</source>
        <translation>这种样条</translation>
    </message>
    <message>
        <source>such face</source>
        <translation>此面</translation>
    </message>
    <message>
        <source>tangents in one plane within</source>
        <translation>切线共面误差不超过</translation>
    </message>
    <message>
        <source>that all edges have the curvature of one surface at the point</source>
        <translation>所有边在该点具有同一曲面的曲率</translation>
    </message>
    <message>
        <source>that the faces close around the point</source>
        <translation>各面围绕该点闭合</translation>
    </message>
    <message>
        <source>the edges are {chains} separate curves: choose one</source>
        <translation>这些边是 {chains} 条分离的曲线：请选择一条</translation>
    </message>
    <message>
        <source>the edges cannot be joined so: {reason}</source>
        <translation>这些边无法如此连接：{reason}</translation>
    </message>
    <message>
        <source>the edges lie side by side only in a short part</source>
        <translation>这些边只有很短一段并排</translation>
    </message>
    <message>
        <source>the edges meet where the curve would be: choose other ends, or other edges</source>
        <translation>两条边在曲线所在处相交：请选择其他端点或其他边</translation>
    </message>
    <message>
        <source>the edges of {name} were deleted: {advice}</source>
        <translation>{name} 的边已被删除：{advice}</translation>
    </message>
    <message>
        <source>the fill itself</source>
        <translation>填充自身</translation>
    </message>
    <message>
        <source>the first {last:.3g}</source>
        <translation>前 {last:.3g}</translation>
    </message>
    <message>
        <source>the last {first:.3g}</source>
        <translation>后 {first:.3g}</translation>
    </message>
    <message>
        <source>the lights run in the direction in which they lie: choose another one</source>
        <translation>灯的方向与其所在方向相同：请另选</translation>
    </message>
    <message>
        <source>the outer boundary has edges in the sector that stays open: choose edges of the other sectors</source>
        <translation>外边界在保持开放的扇区中有边：请选择其他扇区的边</translation>
    </message>
    <message>
        <source>the outer boundary has {count} edges between edges {first} and {second}: one or two are possible</source>
        <translation>外边界在边 {first} 和边 {second} 之间有 {count} 条边：只能有一条或两条</translation>
    </message>
    <message>
        <source>the points or edges are not in one plane: they are up to {distance:.3g} mm off it, and {flatness_mm:g} mm are allowed</source>
        <translation>点或边不在同一平面内：偏离最多 {distance:.3g} mm，允许值为 {flatness_mm:g} mm</translation>
    </message>
    <message>
        <source>the range goes from {low:g} to {high:g}: give a larger upper end</source>
        <translation>范围从 {low:g} 到 {high:g}：请给出更大的上限</translation>
    </message>
    <message>
        <source>the seam is exact up to rounding</source>
        <translation>接缝精确，仅有舍入误差</translation>
    </message>
    <message>
        <source>the selection has {edges}, in {groups}: {needs}</source>
        <translation>所选内容有{edges}，分为{groups}：{needs}</translation>
    </message>
    <message>
        <source>the shape to compare with has no faces: choose another one</source>
        <translation>用于比较的形状没有面：请另选</translation>
    </message>
    <message>
        <source>the shape to compare with has no triangles</source>
        <translation>用于比较的形状没有三角形</translation>
    </message>
    <message>
        <source>the sources were deleted: {advice}</source>
        <translation>来源已被删除：{advice}</translation>
    </message>
    <message>
        <source>the surface comes within {distance_mm:.3g} mm of the curves between, not within {tolerance_mm:g} mm: take a tolerance above {distance_mm:.3g} mm</source>
        <translation>曲面与中间曲线的距离为 {distance_mm:.3g} mm，未达到 {tolerance_mm:g} mm：请取大于 {distance_mm:.3g} mm 的公差</translation>
    </message>
    <message>
        <source>the surface folds {distance_mm} mm from the side</source>
        <translation>曲面在距该侧 {distance_mm} mm 处折叠</translation>
    </message>
    <message>
        <source>the three points are on a line: move the corner off it</source>
        <translation>三个点在一条直线上：请将拐角移开</translation>
    </message>
    <message>
        <source>the tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>the tolerance is 0: splines hold clothoids within a tolerance only</source>
        <translation>公差为 0：样条只能在公差内表示回旋线</translation>
    </message>
    <message>
        <source>the {edges} edges do not end in one point: choose edges that meet in a vertex</source>
        <translation>这 {edges} 条边不在一点结束：请选择在一个顶点相交的边</translation>
    </message>
    <message>
        <source>the {edges} edges do not join to one curve</source>
        <translation>这 {edges} 条边不能连成一条曲线</translation>
    </message>
    <message>
        <source>there are no curves: {needs}</source>
        <translation>没有曲线：{needs}</translation>
    </message>
    <message>
        <source>there are no points</source>
        <translation>没有点</translation>
    </message>
    <message>
        <source>there are no sources: {advice}</source>
        <translation>没有来源：{advice}</translation>
    </message>
    <message>
        <source>there are two points: a conic needs three or more</source>
        <translation>有两个点：圆锥曲线需要三个或更多</translation>
    </message>
    <message>
        <source>there are {points} points: a spiral has three, its start, the corner of its tangents and its end</source>
        <translation>有 {points} 个点：螺线需要三个，即起点、切线交点和终点</translation>
    </message>
    <message>
        <source>there are {points} points: four or more can be made fair</source>
        <translation>有 {points} 个点：四个或更多才能光顺</translation>
    </message>
    <message>
        <source>there are {points} points: one conic has three, its start, the corner of its tangents and its end</source>
        <translation>有 {points} 个点：一条圆锥曲线需要三个，即起点、切线交点和终点</translation>
    </message>
    <message>
        <source>there are {points} points: {what} needs {least} or more</source>
        <translation>有 {points} 个点：{what}需要 {least} 个或更多</translation>
    </message>
    <message>
        <source>there is no face at which the surface ends: choose one</source>
        <translation>没有曲面结束处的面：请选择一个</translation>
    </message>
    <message>
        <source>there is only one curve: choose two or more</source>
        <translation>只有一条曲线：请选择两条或更多</translation>
    </message>
    <message>
        <source>there is only one point: choose two or more</source>
        <translation>只有一个点：请选择两个或更多</translation>
    </message>
    <message>
        <source>three-sided faces join with G1 only: choose four-sided faces, or G1</source>
        <translation>三边面只能以 G1 连接：请选择四边面，或 G1</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>过陡</translation>
    </message>
    <message>
        <source>two fillets</source>
        <translation>两个圆角</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>两个面片</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>未定义</translation>
    </message>
    <message>
        <source>unexpected error: {error}</source>
        <translation>意外错误：{error}</translation>
    </message>
    <message>
        <source>values beyond have the end colours</source>
        <translation>超出范围的值使用两端的颜色</translation>
    </message>
    <message>
        <source>visible surfaces, judged by their reflections</source>
        <translation>可见曲面，按反射评判</translation>
    </message>
    <message>
        <source>with G2 the outer boundary is found, and cannot be given: choose G1, or take the edges out of the outer boundary</source>
        <translation>G2 时外边界由计算得出，不能给定：请选择 G1，或从外边界中去掉这些边</translation>
    </message>
    <message>
        <source>within the tolerances</source>
        <translation>在公差之内</translation>
    </message>
    <message>
        <source>within the tolerances; the shape changes up to {depth} mm away from the seam</source>
        <translation>在公差内；形状的变化延伸到距接缝 {depth} mm 处</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>{along} x {across} poles</source>
        <translation>{along} x {across} 个控制点</translation>
    </message>
    <message>
        <source>{arcs} and {lines}{chains}, {length_mm} mm long, at most {distance_mm} mm from the input</source>
        <translation>{arcs}和{lines}{chains}，长 {length_mm} mm，与输入相距最多 {distance_mm} mm</translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no list</source>
        <translation>{argument} = {value!r} 不是列表</translation>
    </message>
    <message>
        <source>{argument} = {value!r} is no number</source>
        <translation>{argument} = {value!r} 不是数</translation>
    </message>
    <message>
        <source>{argument} has {numbers} coordinates: give three</source>
        <translation>{argument} 有 {numbers} 个坐标：请给出三个</translation>
    </message>
    <message>
        <source>{certain} of {verdicts} certain</source>
        <translation>{verdicts}中 {certain} 个确定</translation>
    </message>
    <message>
        <source>{conics} of weights {least_weight} to {largest_weight}</source>
        <translation>{conics}，权重 {least_weight} 至 {largest_weight}</translation>
    </message>
    <message>
        <source>{conics}, {length_mm} mm long{jumps}{near}.</source>
        <translation>{conics}，长 {length_mm} mm{jumps}{near}。</translation>
    </message>
    <message>
        <source>{count} arc</source>
        <translation>{count} 段圆弧</translation>
    </message>
    <message>
        <source>{count} arcs</source>
        <translation>{count} 段圆弧</translation>
    </message>
    <message>
        <source>{count} chain</source>
        <translation>{count} 条链</translation>
    </message>
    <message>
        <source>{count} chains</source>
        <translation>{count} 条链</translation>
    </message>
    <message>
        <source>{count} conic</source>
        <translation>{count} 条圆锥曲线</translation>
    </message>
    <message>
        <source>{count} conics</source>
        <translation>{count} 条圆锥曲线</translation>
    </message>
    <message>
        <source>{count} crease</source>
        <translation>{count} 条折痕</translation>
    </message>
    <message>
        <source>{count} creases</source>
        <translation>{count} 条折痕</translation>
    </message>
    <message>
        <source>{count} curve</source>
        <translation>{count} 条曲线</translation>
    </message>
    <message>
        <source>{count} curves</source>
        <translation>{count} 条曲线</translation>
    </message>
    <message>
        <source>{count} defect</source>
        <translation>{count} 个缺陷</translation>
    </message>
    <message>
        <source>{count} defects</source>
        <translation>{count} 个缺陷</translation>
    </message>
    <message>
        <source>{count} edge</source>
        <translation>{count} 条边</translation>
    </message>
    <message>
        <source>{count} edges</source>
        <translation>{count} 条边</translation>
    </message>
    <message>
        <source>{count} extrema</source>
        <translation>{count} 个极值</translation>
    </message>
    <message>
        <source>{count} extremum</source>
        <translation>{count} 个极值</translation>
    </message>
    <message>
        <source>{count} face</source>
        <translation>{count} 个面</translation>
    </message>
    <message>
        <source>{count} faces</source>
        <translation>{count} 个面</translation>
    </message>
    <message>
        <source>{count} feature</source>
        <translation>{count} 个特征</translation>
    </message>
    <message>
        <source>{count} features</source>
        <translation>{count} 个特征</translation>
    </message>
    <message>
        <source>{count} free edge</source>
        <translation>{count} 条自由边</translation>
    </message>
    <message>
        <source>{count} free edges</source>
        <translation>{count} 条自由边</translation>
    </message>
    <message>
        <source>{count} hole</source>
        <translation>{count} 个孔</translation>
    </message>
    <message>
        <source>{count} holes</source>
        <translation>{count} 个孔</translation>
    </message>
    <message>
        <source>{count} inflection</source>
        <translation>{count} 个拐点</translation>
    </message>
    <message>
        <source>{count} inflections</source>
        <translation>{count} 个拐点</translation>
    </message>
    <message>
        <source>{count} joint</source>
        <translation>{count} 个连接点</translation>
    </message>
    <message>
        <source>{count} joints</source>
        <translation>{count} 个连接点</translation>
    </message>
    <message>
        <source>{count} line</source>
        <translation>{count} 条直线</translation>
    </message>
    <message>
        <source>{count} line of joints</source>
        <translation>{count} 条连接线</translation>
    </message>
    <message>
        <source>{count} lines</source>
        <translation>{count} 条直线</translation>
    </message>
    <message>
        <source>{count} lines of joints</source>
        <translation>{count} 条连接线</translation>
    </message>
    <message>
        <source>{count} number</source>
        <translation>{count} 个数</translation>
    </message>
    <message>
        <source>{count} numbers</source>
        <translation>{count} 个数</translation>
    </message>
    <message>
        <source>{count} object</source>
        <translation>{count} 个对象</translation>
    </message>
    <message>
        <source>{count} objects</source>
        <translation>{count} 个对象</translation>
    </message>
    <message>
        <source>{count} piece</source>
        <translation>{count} 段</translation>
    </message>
    <message>
        <source>{count} pieces</source>
        <translation>{count} 段</translation>
    </message>
    <message>
        <source>{count} point</source>
        <translation>{count} 个点</translation>
    </message>
    <message>
        <source>{count} points</source>
        <translation>{count} 个点</translation>
    </message>
    <message>
        <source>{count} seam</source>
        <translation>{count} 条接缝</translation>
    </message>
    <message>
        <source>{count} seams</source>
        <translation>{count} 条接缝</translation>
    </message>
    <message>
        <source>{count} side</source>
        <translation>{count} 条侧边</translation>
    </message>
    <message>
        <source>{count} sides</source>
        <translation>{count} 条侧边</translation>
    </message>
    <message>
        <source>{count} source</source>
        <translation>{count} 个来源</translation>
    </message>
    <message>
        <source>{count} sources</source>
        <translation>{count} 个来源</translation>
    </message>
    <message>
        <source>{count} verdict</source>
        <translation>{count} 个判定</translation>
    </message>
    <message>
        <source>{count} verdicts</source>
        <translation>{count} 个判定</translation>
    </message>
    <message>
        <source>{count}; largest gap seen {gap_mm} mm, largest angle {angle_deg}°.</source>
        <translation>{count}；观测到的最大间隙 {gap_mm} mm，最大角度 {angle_deg}°。</translation>
    </message>
    <message>
        <source>{defects} as sharp as a crease, but with a gap</source>
        <translation>{defects}像折痕一样尖锐，但有间隙</translation>
    </message>
    <message>
        <source>{done} of {fills} filled</source>
        <translation>{fills}中 {done} 个已填充</translation>
    </message>
    <message>
        <source>{done} of {wanted} repaired to {target}</source>
        <translation>{wanted}中 {done} 条已修复到 {target}</translation>
    </message>
    <message>
        <source>{edges_led} got new curves on their faces</source>
        <translation>{edges_led}在其面上得到新的曲线</translation>
    </message>
    <message>
        <source>{edges} (model)</source>
        <translation>{edges}（模型）</translation>
    </message>
    <message>
        <source>{edges} can be matched: see Tolerances.</source>
        <translation>{edges}可以配对：见公差。</translation>
    </message>
    <message>
        <source>{edges} chosen: choose three or more</source>
        <translation>已选择 {edges}：请选择三条或更多</translation>
    </message>
    <message>
        <source>{edges} chosen: choose two</source>
        <translation>已选择 {edges}：请选择两条</translation>
    </message>
    <message>
        <source>{edges} to round.</source>
        <translation>{edges}待倒圆。</translation>
    </message>
    <message>
        <source>{edges}; edges lie side by side: match them within {proposed:g} mm.</source>
        <translation>{edges}；有并排的边：请在 {proposed:g} mm 内配对。</translation>
    </message>
    <message>
        <source>{edges}; none lie side by side within {tried:g} mm.</source>
        <translation>{edges}；在 {tried:g} mm 内没有并排的边。</translation>
    </message>
    <message>
        <source>{edge} bounds {faces}: {needs}</source>
        <translation>{edge} 是{faces}的边界：{needs}</translation>
    </message>
    <message>
        <source>{element} is not {what}: name one, such as {kind}1.</source>
        <translation>{element} 不是{what}：请指定一个，如 {kind}1。</translation>
    </message>
    <message>
        <source>{faces} faces are chosen: only one can be replaced at a time</source>
        <translation>选择了 {faces} 个面：一次只能替换一个</translation>
    </message>
    <message>
        <source>{faces} through {keys} curves, within {distance_mm} mm</source>
        <translation>{faces}通过 {keys} 条曲线，误差不超过 {distance_mm} mm</translation>
    </message>
    <message>
        <source>{faces} to replace.</source>
        <translation>{faces} 待替换。</translation>
    </message>
    <message>
        <source>{face} has {along} x {across} poles</source>
        <translation>{face} 有 {along} x {across} 个控制点</translation>
    </message>
    <message>
        <source>{face} joins {others} to the tolerance; the shape changes up to {depth_mm} mm away from the seam</source>
        <translation>{face} 在公差内与 {others} 相接；形状变化到离接缝 {depth_mm} mm 处为止</translation>
    </message>
    <message>
        <source>{face} will be replaced</source>
        <translation>{face} 将被替换</translation>
    </message>
    <message>
        <source>{fills} replaced</source>
        <translation>{fills} 已替换</translation>
    </message>
    <message>
        <source>{first:.6g} to {last:.6g}</source>
        <translation>{first:.6g} 至 {last:.6g}</translation>
    </message>
    <message>
        <source>{holes} to fill.</source>
        <translation>{holes}待填充。</translation>
    </message>
    <message>
        <source>{holes} with {faces}; {seams}; {verdict}.</source>
        <translation>{holes}，用{faces}；{seams}；{verdict}。</translation>
    </message>
    <message>
        <source>{label} contains nothing with a shape: choose another object.</source>
        <translation>{label} 中没有带形状的对象：请选择其他对象。</translation>
    </message>
    <message>
        <source>{label} has faces: choose curves</source>
        <translation>{label} 有面：请选择曲线</translation>
    </message>
    <message>
        <source>{label} has no curve: {summary}</source>
        <translation>{label} 没有曲线：{summary}</translation>
    </message>
    <message>
        <source>{label} has no edges: choose edges of faces</source>
        <translation>{label} 没有边：请选择面的边</translation>
    </message>
    <message>
        <source>{label} has no edges: {needs}</source>
        <translation>{label} 没有边：{needs}</translation>
    </message>
    <message>
        <source>{label} has no faces: choose an object with faces.</source>
        <translation>{label} 没有面：请选择带面的对象。</translation>
    </message>
    <message>
        <source>{label} has no faces: {needs}</source>
        <translation>{label} 没有面：{needs}</translation>
    </message>
    <message>
        <source>{label} has no hole: no free edges form a closed loop.</source>
        <translation>{label} 没有孔：没有自由边构成闭合环。</translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object</source>
        <translation>{label} 没有形状：请选择其他对象</translation>
    </message>
    <message>
        <source>{label} has no shape: choose another object.</source>
        <translation>{label} 没有形状：请选择其他对象。</translation>
    </message>
    <message>
        <source>{label} has no shape: recompute it or choose another object.</source>
        <translation>{label} 没有形状：请重新计算或选择其他对象。</translation>
    </message>
    <message>
        <source>{label} has no shape: {needs}</source>
        <translation>{label} 没有形状：{needs}</translation>
    </message>
    <message>
        <source>{label} has no {element}: choose another one.</source>
        <translation>{label} 没有 {element}：请另选一个。</translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one</source>
        <translation>{label} 没有 {name}：请另选一个</translation>
    </message>
    <message>
        <source>{label} has no {name}: choose another one.</source>
        <translation>{label} 没有 {name}：请另选一个。</translation>
    </message>
    <message>
        <source>{label} has {curves}</source>
        <translation>{label} 有{curves}</translation>
    </message>
    <message>
        <source>{label} has {faces} faces: choose some of its edges, or one face.</source>
        <translation>{label} 有 {faces} 个面：请选择其部分边，或一个面。</translation>
    </message>
    <message>
        <source>{label} has {numbers} numbers for {count} {what}: give one for each, or one for all</source>
        <translation>{label}有 {numbers} 个数，对应 {count} 个{what}：请为每个给出一个，或所有共用一个</translation>
    </message>
    <message>
        <source>{label} is a mesh: make a shape of it first, with Create shape from mesh of the workbench Part.</source>
        <translation>{label} 是网格：请先用 Part 工作台的“从网格创建形状”将其转换为形状。</translation>
    </message>
    <message>
        <source>{label} is a sketch and has no faces: choose an object with faces.</source>
        <translation>{label} 是草图，没有面：请选择带面的对象。</translation>
    </message>
    <message>
        <source>{label} is in another document, {document}: select objects of one document.</source>
        <translation>{label} 位于另一个文档 {document} 中：请选择同一文档中的对象。</translation>
    </message>
    <message>
        <source>{label} is made from this {group}: choose others</source>
        <translation>{label} 由此{group}生成：请另选</translation>
    </message>
    <message>
        <source>{label} sketch</source>
        <translation>{label} 的草图</translation>
    </message>
    <message>
        <source>{label} was deleted: {advice}</source>
        <translation>{label} 已被删除：{advice}</translation>
    </message>
    <message>
        <source>{label} {what}: choose points, edges, wires or sketches.</source>
        <translation>{label} {what}：请选择点、边、线或草图。</translation>
    </message>
    <message>
        <source>{label}.{element} is a point: {needs}</source>
        <translation>{label}.{element} 是一个点：{needs}</translation>
    </message>
    <message>
        <source>{label}: Face{face} is not drawn correctly: {reason}</source>
        <translation>{label}：Face{face} 显示不正确：{reason}</translation>
    </message>
    <message>
        <source>{last:.3g} at {first:.6g}</source>
        <translation>{first:.6g} 处 {last:.3g}</translation>
    </message>
    <message>
        <source>{least} to {largest} {unit}, the strongest {place}</source>
        <translation>{least} 至 {largest} {unit}，最强处{place}</translation>
    </message>
    <message>
        <source>{least} {unit} everywhere</source>
        <translation>处处为 {least} {unit}</translation>
    </message>
    <message>
        <source>{length_mm} mm long, turns by {turn_deg}°, radius {first_radius_mm} to {last_radius_mm} mm{near}.</source>
        <translation>长 {length_mm} mm，转过 {turn_deg}°，半径 {first_radius_mm} 至 {last_radius_mm} mm{near}。</translation>
    </message>
    <message>
        <source>{length_mm} mm long; curvature: {extrema}, {inflections}</source>
        <translation>长 {length_mm} mm；曲率：{extrema}，{inflections}</translation>
    </message>
    <message>
        <source>{level} is met</source>
        <translation>满足 {level}</translation>
    </message>
    <message>
        <source>{level} is not met</source>
        <translation>未满足 {level}</translation>
    </message>
    <message>
        <source>{level} is not met, kept anyway</source>
        <translation>未满足 {level}，仍然保留</translation>
    </message>
    <message>
        <source>{lines}; all are straight.</source>
        <translation>{lines}；全部为直线。</translation>
    </message>
    <message>
        <source>{lines}; largest curvature {largest_per_mm} 1/mm, radius {radius} mm, {largest_at}. Sampled.</source>
        <translation>{lines}；最大曲率 {largest_per_mm} 1/mm，半径 {radius} mm，{largest_at}。采样值。</translation>
    </message>
    <message>
        <source>{link} is chosen twice: choose two different faces</source>
        <translation>{link} 被选择了两次：请选择两个不同的面</translation>
    </message>
    <message>
        <source>{link} is not an edge of the two faces</source>
        <translation>{link} 不是这两个面的边</translation>
    </message>
    <message>
        <source>{made} between {keys} curves, within {distance_mm} mm; joints keep up to G{order}, {features} paired.</source>
        <translation>{keys} 条曲线之间的{made}，误差不超过 {distance_mm} mm；连接点保持至 G{order}，{features}已配对。</translation>
    </message>
    <message>
        <source>{members} around the point: {state}, {figures}; {followed}.</source>
        <translation>围绕该点的{members}：{state}，{figures}；{followed}。</translation>
    </message>
    <message>
        <source>{moved} moved, poles by up to {largest_move_mm} mm</source>
        <translation>{moved}移动，控制点最多移动 {largest_move_mm} mm</translation>
    </message>
    <message>
        <source>{moves} of {faces} faces moved, poles by up to {largest} mm</source>
        <translation>{faces} 个面中 {moves} 个移动，控制点最多移动 {largest} mm</translation>
    </message>
    <message>
        <source>{moves} points were moved, but the sources have {points}: empty the property Moves</source>
        <translation>移动了 {moves} 个点，但来源有 {points} 个：请清空属性 Moves</translation>
    </message>
    <message>
        <source>{names} was deleted: choose others in the property Sources</source>
        <translation>{names} 已被删除：请在属性 Sources 中选择其他对象</translation>
    </message>
    <message>
        <source>{name} bends both ways, {times} times as strongly as the faces around it: look at its stripes for dents or waves.</source>
        <translation>{name} 向两侧弯曲，程度是周围面的 {times} 倍：请查看其条纹是否有凹陷或波纹。</translation>
    </message>
    <message>
        <source>{name} bounds no face: choose an edge of a face</source>
        <translation>{name} 不是任何面的边界：请选择面的边</translation>
    </message>
    <message>
        <source>{name} bounds none of the edges: leave it out</source>
        <translation>{name} 不以这些边为边界：请去掉它</translation>
    </message>
    <message>
        <source>{name} cannot be {value!r}: choose True or False</source>
        <translation>{name}不能是 {value!r}：请选择 True 或 False</translation>
    </message>
    <message>
        <source>{name} cannot be {value}: choose from {least:g} to {largest:g}</source>
        <translation>{name}不能是 {value}：请选择 {least:g} 到 {largest:g}</translation>
    </message>
    <message>
        <source>{name} does not bound one face alone: select the face to join, too</source>
        <translation>{name} 不是只属于一个面的边：请同时选择要相接的面</translation>
    </message>
    <message>
        <source>{name} has no edge along {moving} within the match distance of {match_mm} mm (they are {distance} mm apart): allow a larger one, or leave it out</source>
        <translation>{name} 在匹配距离 {match_mm} mm 内没有沿 {moving} 的边（两者相距 {distance} mm）：请允许更大的距离，或去掉它</translation>
    </message>
    <message>
        <source>{name} has no edge: {needs}</source>
        <translation>{name} 没有边：{needs}</translation>
    </message>
    <message>
        <source>{name} has no other chosen edge beside it within {match_mm:g} mm</source>
        <translation>{name} 旁 {match_mm:g} mm 内没有其他所选的边</translation>
    </message>
    <message>
        <source>{name} has no {element}: choose another one</source>
        <translation>{name} 没有 {element}：请另选一个</translation>
    </message>
    <message>
        <source>{name} has {numbers} for the {edges} edges of the corner ({names}): give one for each, or one for all</source>
        <translation>{name} 有{numbers}，拐角有 {edges} 条边({names})：请为每条给出一个，或所有共用一个</translation>
    </message>
    <message>
        <source>{name} is a vertex: select edges, or the whole object.</source>
        <translation>{name} 是顶点：请选择边或整个对象。</translation>
    </message>
    <message>
        <source>{name} is no edge: {needs}</source>
        <translation>{name} 不是边：{needs}</translation>
    </message>
    <message>
        <source>{name} is no seam: its faces do not meet there</source>
        <translation>{name} 不是接缝：其面在该处不相接</translation>
    </message>
    <message>
        <source>{name} lies between {faces}: select the face to continue, too</source>
        <translation>{name} 位于 {faces} 之间：还请选择要延续的面</translation>
    </message>
    <message>
        <source>{name} names {label}, which is not the source {source}</source>
        <translation>{name} 指定了 {label}，它不是来源 {source}</translation>
    </message>
    <message>
        <source>{name} would join itself: choose other faces</source>
        <translation>{name} 会与自身相接：请选择其他面</translation>
    </message>
    <message>
        <source>{name} {what}: choose edges</source>
        <translation>{name} {what}：请选择边</translation>
    </message>
    <message>
        <source>{name}, {length_mm} mm along: {figure}</source>
        <translation>{name}，{length_mm} mm 处：{figure}</translation>
    </message>
    <message>
        <source>{name}: not measured</source>
        <translation>{name}：未测量</translation>
    </message>
    <message>
        <source>{name}: not measured where the angle is that of a crease.</source>
        <translation>{name}：角度达到折痕处未测量。</translation>
    </message>
    <message>
        <source>{name}: the largest value is {seam}, {known}.</source>
        <translation>{name}：最大值为 {seam}，{known}。</translation>
    </message>
    <message>
        <source>{number} is kept.</source>
        <translation>保留 {number}。</translation>
    </message>
    <message>
        <source>{objects} selected: {needs}</source>
        <translation>选择了{objects}：{needs}</translation>
    </message>
    <message>
        <source>{order} needs {need}: poles would move by {moved} mm, edge {number} most, and {most} mm are allowed: change the edges, or allow more</source>
        <translation>{order} 要求{need}：控制点将移动 {moved} mm，边 {number} 移动最多，而允许值为 {most} mm：请修改边，或允许更大的值</translation>
    </message>
    <message>
        <source>{parts}. Sampled at {points}: between them it may be larger.</source>
        <translation>{parts}。在{points}处采样：其间可能更大。</translation>
    </message>
    <message>
        <source>{path} is not installed; the repository has it.</source>
        <translation>{path} 未安装；代码仓库中有。</translation>
    </message>
    <message>
        <source>{path}: cannot be written: {strerror}.</source>
        <translation>{path}：无法写入：{strerror}。</translation>
    </message>
    <message>
        <source>{path}: the folder {folder} does not exist; create it first.</source>
        <translation>{path}：文件夹 {folder} 不存在；请先创建。</translation>
    </message>
    <message>
        <source>{path}: the name must end in .csv or .json.</source>
        <translation>{path}：文件名必须以 .csv 或 .json 结尾。</translation>
    </message>
    <message>
        <source>{pieces}, {length_mm} mm long, {sharpest}, at most {distance_mm} mm from the input.</source>
        <translation>{pieces}，长 {length_mm} mm，{sharpest}，与输入相距最多 {distance_mm} mm。</translation>
    </message>
    <message>
        <source>{points}{place}. {how}</source>
        <translation>{points}{place}。{how}</translation>
    </message>
    <message>
        <source>{preview_tip}; nothing is kept until OK is pressed</source>
        <translation>{preview_tip}；按“确定”之前不保留任何内容</translation>
    </message>
    <message>
        <source>{purpose}: gap {gap_mm:g} mm, angle {angle_deg:g}°, curvature {curvature_rel:g} %</source>
        <translation>{purpose}：间隙 {gap_mm:g} mm，角度 {angle_deg:g}°，曲率 {curvature_rel:g} %</translation>
    </message>
    <message>
        <source>{quantity} curvature</source>
        <translation>{quantity}曲率</translation>
    </message>
    <message>
        <source>{quantity} curvature {range}. {mesh}.</source>
        <translation>{quantity}曲率 {range}。{mesh}。</translation>
    </message>
    <message>
        <source>{reason}: allow a change over a larger Depth, or a larger Fairness</source>
        <translation>{reason}：请允许更大的深度 (Depth)，或更大的光顺性系数 (Fairness)</translation>
    </message>
    <message>
        <source>{seams} seams are marked; only the edges of the first {selected} are selected.</source>
        <translation>标记了 {seams} 条接缝；仅选择了前 {selected} 条边。</translation>
    </message>
    <message>
        <source>{sewn} sewn</source>
        <translation>{sewn}已缝合</translation>
    </message>
    <message>
        <source>{signs}
values beyond ±{limit_per_mm} 1/mm have the end colours</source>
        <translation>{signs}
超出 ±{limit_per_mm} 1/mm 的值使用两端的颜色</translation>
    </message>
    <message>
        <source>{step} is a step of {body}: later steps do not count. To follow all steps, select {body}.</source>
        <translation>{step} 是 {body} 的一个步骤：之后的步骤不计入。要跟随所有步骤，请选择 {body}。</translation>
    </message>
    <message>
        <source>{summary} Not seen, since they are hidden: {labels}.</source>
        <translation>{summary} 由于已隐藏而看不到：{labels}。</translation>
    </message>
    <message>
        <source>{surface}; across {seams}: angle at most {angle_deg}°, curvature at most {curvature_rel} %.</source>
        <translation>{surface}；在{seams}两侧：角度最大 {angle_deg}°，曲率最大 {curvature_rel} %。</translation>
    </message>
    <message>
        <source>{target} is met</source>
        <translation>满足 {target}</translation>
    </message>
    <message>
        <source>{target} is not certain at {name}</source>
        <translation>{name} 处不确定是否满足 {target}</translation>
    </message>
    <message>
        <source>{target} is uncertain</source>
        <translation>{target} 不确定</translation>
    </message>
    <message>
        <source>{target} uncertain</source>
        <translation>{target} 不确定</translation>
    </message>
    <message>
        <source>{total}: {defect}, {crease}, {smooth} smooth</source>
        <translation>{total}：{defect}，{crease}，{smooth} 条光滑</translation>
    </message>
    <message>
        <source>{wanted} to repair to {target}.</source>
        <translation>{wanted}待修复到 {target}。</translation>
    </message>
    <message>
        <source>{what} = {direction}: three numbers are needed, not all zero</source>
        <translation>{what} = {direction}：需要三个不全为零的数</translation>
    </message>
    <message>
        <source>{what} would move by {moved_mm:.4g} mm, further than the {most_mm:g} mm that are allowed</source>
        <translation>{what}将移动 {moved_mm:.4g} mm，超过允许的 {most_mm:g} mm</translation>
    </message>
    <message>
        <source>{why}; nothing was analysed.</source>
        <translation>{why}；未作任何分析。</translation>
    </message>
    <message>
        <source>{why}; press Preview to analyse and repair the seams.</source>
        <translation>{why}；按“预览”以分析并修复接缝。</translation>
    </message>
    <message>
        <source>{written} of {every} seams ({show}) are written to {path}.</source>
        <translation>{every} 条接缝中的 {written} 条（{show}）已写入 {path}。</translation>
    </message>
    <message>
        <source>{written} of {every} seams are written to {path}.</source>
        <translation>{every} 条接缝中的 {written} 条已写入 {path}。</translation>
    </message>
    <message>
        <source>“{label}” is {angle:g}°: at most 90° is needed</source>
        <translation>“{label}”为 {angle:g}°：最多 90°</translation>
    </message>
    <message>
        <source>“{text}” is no such number: {kept} is kept.</source>
        <translation>“{text}”不是有效的数值：保留 {kept}。</translation>
    </message>
    <message>
        <source>“{text}” is not a list of numbers: write them with blanks or semicolons, such as 0; 0; 50.</source>
        <translation>“{text}”不是数列：请用空格或分号分隔，例如 0; 0; 50。</translation>
    </message>
</context>
<context>
    <name>Seamwright_AnalyzeSeams</name>
    <message>
        <source>Analyze Seams</source>
        <translation>分析接缝</translation>
    </message>
    <message>
        <source>Measure gap, angle and curvature where faces of the selected objects meet, and colour the seams by the result. With nothing selected, all solids and shells of the document are analysed, or where it has none, all faces.</source>
        <translation>测量所选对象的面相接处的间隙、角度和曲率，并按结果为接缝着色。未选择任何对象时，分析文档中的所有实体和壳；若没有，则分析所有面。</translation>
    </message>
</context>
<context>
    <name>Seamwright_Arcs</name>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Make arcs and lines within a tolerance of the selected edges, wires, sketch or points of a plane. The distance is proven; few arcs are searched for.</source>
        <translation>在公差内由所选的边、线、草图或平面内的点生成圆弧和直线。距离经过证明；并尽量减少圆弧数。</translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendCurves</name>
    <message>
        <source>Blend Curves</source>
        <translation>混合曲线</translation>
    </message>
    <message>
        <source>Make curves between two or more selected curves, or the surface through them. Every joint of a curve between is as smooth as those of the selected ones.</source>
        <translation>在两条或更多所选曲线之间生成曲线，或生成通过它们的曲面。中间曲线的每个连接点与所选曲线的连接点同样光滑。</translation>
    </message>
</context>
<context>
    <name>Seamwright_BlendSurface</name>
    <message>
        <source>Blend Surface</source>
        <translation>过渡曲面</translation>
    </message>
    <message>
        <source>Make a surface between two sides, edges or chains of edges of faces. It joins each with its own order: position (G0), tangent planes (G1), curvature (G2) or its change (G3).</source>
        <translation>在两侧(面的边或一串边)之间生成曲面。与每一侧按各自的阶数连接：位置 (G0)、切平面 (G1)、曲率 (G2) 或其变化 (G3)。</translation>
    </message>
</context>
<context>
    <name>Seamwright_BridgeCurve</name>
    <message>
        <source>Bridge Curve</source>
        <translation>桥接曲线</translation>
    </message>
    <message>
        <source>Make a curve from an end of one selected edge to an end of another one. It continues each with its own order: position (G0), tangent (G1), curvature (G2) or its change (G3).</source>
        <translation>从一条所选边的一端到另一条边的一端生成曲线，以各自的阶数延续每条边：位置 (G0)、切线 (G1)、曲率 (G2) 或其变化 (G3)。</translation>
    </message>
</context>
<context>
    <name>Seamwright_Clothoid</name>
    <message>
        <source>Clothoid</source>
        <translation>回旋线</translation>
    </message>
    <message>
        <source>Lay clothoids through the selected points, or within a tolerance of the selected edges, wires or sketch of a plane: their curvature is continuous and linear in the length. Lines and arcs stay, with a clothoid between them.</source>
        <translation>使回旋线通过所选点，或在公差内贴近平面内的所选边、线或草图：其曲率连续并随长度线性变化。直线和圆弧保持不变，其间以回旋线过渡。</translation>
    </message>
</context>
<context>
    <name>Seamwright_Conic</name>
    <message>
        <source>Conic</source>
        <translation>圆锥曲线</translation>
    </message>
    <message>
        <source>Make a conic from three selected points: start, corner of the tangents, end. Or lay a spline of conics with continuous curvature through points of a plane.</source>
        <translation>由三个所选点生成圆锥曲线：起点、切线交点、终点。或者用曲率连续的圆锥曲线样条通过平面内的点。</translation>
    </message>
</context>
<context>
    <name>Seamwright_CornerFillet</name>
    <message>
        <source>Corner Fillet</source>
        <translation>拐角圆角</translation>
    </message>
    <message>
        <source>Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. Patches close the corner between the fillets without a kink.</source>
        <translation>对实体上所选顶点处的 3 至 6 条边倒圆，每条边有各自的半径。圆角之间的拐角由面片无折角地封闭。</translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureComb</name>
    <message>
        <source>Curvature Comb</source>
        <translation>曲率梳</translation>
    </message>
    <message>
        <source>Draw a curvature comb on the selected edges and wires, and on iso-curves of the selected faces. The lines of the comb are as long as the curvature is large: a jump is a step of curvature, a kink of the comb a step of its change.</source>
        <translation>在所选的边和线上以及所选面的等参线上绘制曲率梳。梳齿的长度随曲率增大：跳变表示曲率突变，梳的折点表示曲率变化的突变。</translation>
    </message>
</context>
<context>
    <name>Seamwright_CurvatureMap</name>
    <message>
        <source>Colour the faces of the selected objects by their curvature: mean, Gaussian or largest curvature, or smallest radius. With nothing selected, all visible objects are coloured.</source>
        <translation>按曲率为所选对象的面着色：平均、高斯或最大曲率，或最小半径。未选择任何对象时，为所有可见对象着色。</translation>
    </message>
    <message>
        <source>Curvature Map</source>
        <translation>曲率云图</translation>
    </message>
</context>
<context>
    <name>Seamwright_Deviation</name>
    <message>
        <source>Colour the first of two selected objects by its distance from the second: blue inside, orange outside, with the largest value and its place. Sampled, so not a proven figure.</source>
        <translation>按与第二个对象的距离为所选两个对象中的第一个着色：内侧蓝色，外侧橙色，并给出最大值及其位置。此为采样值，并非经证明的数值。</translation>
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
        <translation>按与拔模方向的夹角为所选对象的面着色：可脱模的面、过陡的面，以及属于模具另一半的面。</translation>
    </message>
    <message>
        <source>Draft Angle</source>
        <translation>拔模角</translation>
    </message>
</context>
<context>
    <name>Seamwright_ExportReport</name>
    <message>
        <source>Export Seam Report…</source>
        <translation>导出接缝报告…</translation>
    </message>
    <message>
        <source>Write the results of the selected seam analysis to a file, as a table (CSV) or as a report (JSON). With nothing selected, the newest analysis is written.</source>
        <translation>将所选接缝分析的结果写入文件，作为表格 (CSV) 或报告 (JSON)。未选择时写入最新的分析。</translation>
    </message>
</context>
<context>
    <name>Seamwright_ExtendSurface</name>
    <message>
        <source>Continue faces beyond an edge or a chain of edges, over a length or up to a face, with their tangent planes (G1), curvatures (G2) or the change of these (G3).</source>
        <translation>将面延续到一条边或一串边之外，按给定长度或直到某个面，保持切平面 (G1)、曲率 (G2) 或曲率变化 (G3) 连续。</translation>
    </message>
    <message>
        <source>Extend Surface</source>
        <translation>延伸曲面</translation>
    </message>
</context>
<context>
    <name>Seamwright_FairCurve</name>
    <message>
        <source>Fair Curve</source>
        <translation>光顺曲线</translation>
    </message>
    <message>
        <source>Make the selected edges fair: splines whose curvature has few extrema and that move by no more than a tolerance. Points of a plane are moved, and a smooth curve goes through them.</source>
        <translation>光顺所选的边：得到曲率极值少、移动不超过公差的样条。平面内的点会被移动，并由一条光滑曲线通过。</translation>
    </message>
</context>
<context>
    <name>Seamwright_FrameLoft</name>
    <message>
        <source>Loft through Frames</source>
        <translation>过框架放样</translation>
    </message>
    <message>
        <source>Make the surface through two or more selected curves. Across the lines that join corresponding joints of the curves it is as smooth as the curves are: G1, G2 or more.</source>
        <translation>通过两条或更多所选曲线生成曲面。在连接各曲线对应连接点的线两侧，曲面与曲线同样光滑：G1、G2 或更高。</translation>
    </message>
</context>
<context>
    <name>Seamwright_Help</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Open the documentation of Seamwright. With an object of Seamwright selected, it opens at the section about its command.</source>
        <translation>打开 Seamwright 的文档。如果选择了 Seamwright 的对象，则打开关于其命令的章节。</translation>
    </message>
</context>
<context>
    <name>Seamwright_JoinCurves</name>
    <message>
        <source>Join Curves</source>
        <translation>连接曲线</translation>
    </message>
    <message>
        <source>Join two selected edges at their nearest ends with a common tangent (G1), curvature (G2) or change of the curvature (G3), by the smallest move of their poles there. Or let the second continue the first, which stays.</source>
        <translation>在最近的端点处连接两条所选边，使切线 (G1)、曲率 (G2) 或曲率变化 (G3) 相同，控制点的移动最小。或者让第二条延续保持不动的第一条。</translation>
    </message>
</context>
<context>
    <name>Seamwright_LogSpiral</name>
    <message>
        <source>Log Spiral</source>
        <translation>对数螺线</translation>
    </message>
    <message>
        <source>Make a logarithmic spiral, whose radius grows by the same factor with each degree of turn, from three selected points: start, corner of the tangents, end. Or let it continue two edges of a plane from end to end.</source>
        <translation>由三个所选点生成对数螺线(每转一度半径按同一比例增大)：起点、切线交点、终点。或者让它从端到端延续平面内的两条边。</translation>
    </message>
</context>
<context>
    <name>Seamwright_MatchSurfaces</name>
    <message>
        <source>Match Surfaces</source>
        <translation>匹配曲面</translation>
    </message>
    <message>
        <source>Move the second of two selected faces, or both, until they join without a kink (G1) or with equal curvature (G2). If they share several edges, also select the edge to match. Of more faces, the last one moves and joins all others; edges stand for their faces.</source>
        <translation>移动两个所选面中的第二个或两者，直到它们以无折角 (G1) 或相同曲率 (G2) 相接。如果它们有多条公共边，还请选择要匹配的边。选择更多面时，移动最后一个面，使其与其他所有面相接；边代表其所在的面。</translation>
    </message>
</context>
<context>
    <name>Seamwright_ReflectionLines</name>
    <message>
        <source>Draw lines on the faces of the selected objects that break where faces meet at an angle, and bend where the curvature jumps: zebra stripes with options, isophotes or highlight lines. With nothing selected, they are drawn on all visible objects.</source>
        <translation>在所选对象的面上绘制线条，面以一定角度相接处断开，曲率跳变处折弯：带选项的斑马纹、等照度线或高光线。未选择任何对象时，绘制在所有可见对象上。</translation>
    </message>
    <message>
        <source>Reflection Lines</source>
        <translation>反射线</translation>
    </message>
</context>
<context>
    <name>Seamwright_RepairSeams</name>
    <message>
        <source>Move faces of the selected object as little as possible until its seams are smooth: without a kink (G1) or with equal curvature (G2). To repair only some seams, select their edges, or rows of an analysis.</source>
        <translation>尽可能少地移动所选对象的面，直到其接缝光滑：无折角 (G1) 或曲率相同 (G2)。只修复部分接缝时，请选择其边或分析中的行。</translation>
    </message>
    <message>
        <source>Repair Seams</source>
        <translation>修复接缝</translation>
    </message>
</context>
<context>
    <name>Seamwright_SeamPlot</name>
    <message>
        <source>Plot gap, angle and curvature along the seams of the selected edges, with the proven bounds of the largest value. The mouse in the plot marks the point on the seam.</source>
        <translation>沿所选边的接缝绘制间隙、角度和曲率的图，并给出最大值的经证明的界限。图中的鼠标位置会在接缝上标出。</translation>
    </message>
    <message>
        <source>Seam Plot</source>
        <translation>接缝图</translation>
    </message>
</context>
<context>
    <name>Seamwright_Spline</name>
    <message>
        <source>Make a spline with continuous curvature through the selected points or the points of a wire, a sketch or edges, or near the polygon of these points. Tension and bias shape it at each point.</source>
        <translation>生成曲率连续的样条，通过所选点或线、草图、边的点，或贴近这些点的多边形。每个点处的张力和偏斜决定其形状。</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>样条</translation>
    </message>
</context>
<context>
    <name>Seamwright_Umbrella</name>
    <message>
        <source>Make faces around a point from three or more selected edges that end there with tangents in one plane: a face between each two neighbouring edges. All of them have common tangent planes along the edges, or with G2 common curvature, too.</source>
        <translation>由三条或更多在一点结束且切线共面的所选边，围绕该点生成面：每两条相邻边之间一个面。所有面沿这些边具有共同的切平面，G2 时还具有共同的曲率。</translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>伞形面</translation>
    </message>
</context>
<context>
    <name>Seamwright_UmbrellaFill</name>
    <message>
        <source>Close holes of the selected object with faces that are tangent to their neighbours. To fill only some holes, select an edge of each. To replace a face, select it.</source>
        <translation>用与相邻面相切的面封闭所选对象的孔。只填充部分孔时，请选择每个孔的一条边。要替换一个面，请选择该面。</translation>
    </message>
    <message>
        <source>Umbrella Fill</source>
        <translation>伞形填充</translation>
    </message>
</context>
<context>
    <name>Seamwright_ZebraStripes</name>
    <message>
        <source>Show how the faces of the selected objects, or of all visible objects, reflect stripes. The stripes break where faces meet at an angle, and bend where the curvature jumps. Use the command again to remove them.</source>
        <translation>显示所选对象或所有可见对象的面如何反射条纹。面以一定角度相接处条纹断开，曲率跳变处条纹折弯。再次使用该命令可将其移除。</translation>
    </message>
    <message>
        <source>Zebra Stripes</source>
        <translation>斑马纹</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Measure and repair the seams of CAD models: gap, angle and curvature where faces meet</source>
        <translation>测量并修复 CAD 模型的接缝：面相接处的间隙、角度和曲率</translation>
    </message>
    <message>
        <source>Seamwright Analysis</source>
        <translation>Seamwright 分析</translation>
    </message>
    <message>
        <source>Seamwright Curves</source>
        <translation>Seamwright 曲线</translation>
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
