namespace Engraver.TestKit;

/// <summary>Small drawings that contain one of every supported kind, to be damaged or read in many forms.</summary>
public static class OddDrawings
{
    /// <summary>Every curve, blocks in blocks, an array, texts and every outline.</summary>
    public static DxfText OneOfEverything() => new DxfText()
        .Header("AC1021", 4)
        .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "CUT"), (70, 0), (62, 3), (0, "ENDTAB"), (0, "TABLE"), (2, "STYLE"), (0, "STYLE"), (2, "ROMAN"), (3, "romans.shx"), (0, "ENDTAB"))
        .Section("BLOCKS", [.. Block("A", [(0, "LINE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 4.0), (21, 3.0), .. Arc, .. Text]), .. Block("B", [.. Insert("A", 2.0), (50, 30.0), (70, 2), (71, 2), (44, 5.0), (45, 6.0), .. Circle])])
        .Section("ENTITIES", [.. Arc, .. Circle, .. Ellipse, .. Spline, .. FitSpline, .. LwPolyline, .. Polyline, .. Insert("B", -1.5), (66, 1), (0, "ATTRIB"), (8, "0"), (10, 1.0), (20, 1.0), (40, 2.5), (1, "%%c5"), (2, "TAG"), (0, "SEQEND"), .. Text, .. MText, .. Hatch, .. MLine, .. Leader, .. Solid, .. Face])
        .Section("OBJECTS", (0, "MLINESTYLE"), (2, "Standard"), (70, 272))
        .End();

    public static (int Code, object Value)[] Arc => [(0, "ARC"), (8, "CUT"), (10, 1.0), (20, 2.0), (40, 5.0), (50, 350.0), (51, 100.0)];

    public static (int Code, object Value)[] Circle => [(0, "CIRCLE"), (8, "CUT"), (10, -7.0), (20, 2.0), (40, 1.5), (210, 0.0), (220, 0.0), (230, -1.0)];

    public static (int Code, object Value)[] Ellipse => [(0, "ELLIPSE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 6.0), (21, 2.0), (40, 0.4), (41, 0.3), (42, 4.0)];

    public static (int Code, object Value)[] Spline =>
        [(0, "SPLINE"), (70, 4), (71, 3), (40, 0.0), (40, 0.0), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (40, 1.0), (40, 1.0), (41, 1.0), (41, 2.0), (41, 0.5), (41, 1.0),
         (10, 0.0), (20, 0.0), (10, 1.0), (20, 4.0), (10, 5.0), (20, 4.0), (10, 6.0), (20, 0.0)];

    public static (int Code, object Value)[] FitSpline => [(0, "SPLINE"), (70, 0), (71, 3), (11, 0.0), (21, 0.0), (11, 2.0), (21, 3.0), (11, 6.0), (21, 3.0), (11, 8.0), (21, -1.0)];

    public static (int Code, object Value)[] LwPolyline => [(0, "LWPOLYLINE"), (90, 3), (70, 1), (10, 0.0), (20, 0.0), (42, 0.5), (10, 10.0), (20, 0.0), (10, 10.0), (20, 8.0), (42, -1.25)];

    public static (int Code, object Value)[] Polyline =>
        [(0, "POLYLINE"), (66, 1), (70, 8), (0, "VERTEX"), (10, 0.0), (20, 0.0), (30, 1.0), (0, "VERTEX"), (10, 3.0), (20, 4.0), (30, 13.0), (0, "SEQEND")];

    public static (int Code, object Value)[] Text => [(0, "TEXT"), (8, "0"), (10, 3.0), (20, 4.0), (40, 2.5), (1, "M8 %%p0.1"), (50, 15.0), (7, "ROMAN"), (72, 1), (11, 5.0), (21, 4.0)];

    public static (int Code, object Value)[] MText => [(0, "MTEXT"), (8, "0"), (10, 30.0), (20, 4.0), (40, 3.5), (71, 5), (3, "{\\fArial|b1;First} line\\P"), (1, "1\\S1/2; \\U+2300")];

    public static (int Code, object Value)[] Hatch =>
        [(0, "HATCH"), (10, 0.0), (20, 0.0), (30, 0.0), (2, "SOLID"), (70, 1), (71, 0), (91, 2),
         (92, 3), (72, 1), (73, 1), (93, 3), (10, 0.0), (20, 0.0), (42, 1.0), (10, 8.0), (20, 0.0), (42, 0.0), (10, 4.0), (20, 9.0), (42, 0.0), (97, 0),
         (92, 1), (93, 4), (72, 1), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0), (72, 2), (10, 10.0), (20, 5.0), (40, 5.0), (50, 270.0), (51, 450.0), (73, 1),
         (72, 3), (10, 5.0), (20, 10.0), (11, 5.0), (21, 0.0), (40, 0.5), (50, 0.0), (51, 180.0), (73, 1),
         (72, 4), (94, 1), (73, 0), (74, 0), (95, 4), (96, 2), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (10, 0.0), (20, 10.0), (10, 0.0), (20, 0.0), (97, 0), (75, 0), (76, 1), (98, 1), (10, 1.0), (20, 1.0)];

    public static (int Code, object Value)[] MLine =>
        [(0, "MLINE"), (2, "Standard"), (40, 2.0), (70, 1), (71, 1), (72, 2), (73, 2), (10, 0.0), (20, 0.0),
         (11, 0.0), (21, 0.0), (12, 1.0), (22, 0.0), (13, 0.0), (23, 1.0), (74, 2), (41, 1.0), (41, 0.0), (75, 0), (74, 2), (41, -1.0), (41, 0.0), (75, 0),
         (11, 10.0), (21, 0.0), (12, 1.0), (22, 0.0), (13, 0.0), (23, 1.0), (74, 2), (41, 1.0), (41, 0.0), (75, 0), (74, 2), (41, -1.0), (41, 0.0), (75, 0)];

    public static (int Code, object Value)[] Leader => [(0, "LEADER"), (71, 1), (72, 0), (73, 3), (76, 3), (10, 0.0), (20, 0.0), (10, 3.0), (20, 4.0), (10, 8.0), (20, 4.0)];

    /// <summary>A square in the corner order of SOLID: 1-2-4-3.</summary>
    public static (int Code, object Value)[] Solid => [(0, "SOLID"), (10, 0.0), (20, 0.0), (11, 5.0), (21, 0.0), (12, 0.0), (22, 5.0), (13, 5.0), (23, 5.0)];

    /// <summary>A square whose second edge is invisible.</summary>
    public static (int Code, object Value)[] Face => [(0, "3DFACE"), (70, 2), (10, 0.0), (20, 0.0), (11, 5.0), (21, 0.0), (12, 5.0), (22, 5.0), (13, 0.0), (23, 5.0)];

    public static (int Code, object Value)[] Block(string name, params ReadOnlySpan<(int Code, object Value)> content) => [(0, "BLOCK"), (2, name), (10, 1.0), (20, 0.0), .. content, (0, "ENDBLK")];

    public static (int Code, object Value)[] Insert(string block, double scale) => [(0, "INSERT"), (8, "CUT"), (2, block), (10, 20.0), (20, 5.0), (41, scale), (42, 2.0)];
}
