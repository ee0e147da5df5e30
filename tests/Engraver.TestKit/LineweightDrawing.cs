namespace Engraver.TestKit;

/// <summary>A drawing of lineweights and widths. Layer THICK has 0.5 mm, layer 0 the default. Block INNER has a line by block; block OUTER has one too, an
/// INNER by block and a line of 0.7 mm; block WIDE has a polyline 1.2 wide, block NAMED a text by block.</summary>
public static class LineweightDrawing
{
    public static DxfText Of((int Code, object Value)[] entities, int insUnits = 4, int? defaultWeight = null) => new DxfText()
        .Section("HEADER", [(9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, insUnits), .. defaultWeight is { } weight ? ((int, object)[])[(9, "$LWDEFAULT"), (70, weight)] : []])
        .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (70, 2), (0, "LAYER"), (2, "0"), (70, 0), (62, 7), (370, -3), (0, "LAYER"), (2, "THICK"), (70, 0), (62, 3), (370, 50), (0, "ENDTAB"))
        .Section("BLOCKS",
            (0, "BLOCK"), (8, "0"), (2, "INNER"), (70, 0), (10, 0.0), (20, 0.0), (0, "LINE"), (8, "0"), (370, -2), (10, 0.0), (20, 5.0), (11, 9.0), (21, 5.0), (0, "ENDBLK"),
            (0, "BLOCK"), (8, "0"), (2, "OUTER"), (70, 0), (10, 0.0), (20, 0.0), (0, "LINE"), (8, "0"), (370, -2), (10, 0.0), (20, 0.0), (11, 9.0), (21, 0.0),
            (0, "INSERT"), (8, "0"), (2, "INNER"), (370, -2), (10, 0.0), (20, 0.0), (0, "LINE"), (8, "0"), (370, 70), (10, 0.0), (20, 7.0), (11, 9.0), (21, 7.0), (0, "ENDBLK"),
            (0, "BLOCK"), (8, "0"), (2, "WIDE"), (70, 0), (10, 0.0), (20, 0.0), (0, "LWPOLYLINE"), (8, "0"), (90, 2), (43, 1.2), (10, 0.0), (20, 0.0), (10, 9.0), (20, 0.0), (0, "ENDBLK"),
            (0, "BLOCK"), (8, "0"), (2, "NAMED"), (70, 0), (10, 0.0), (20, 0.0), (0, "TEXT"), (8, "0"), (370, -2), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A"), (0, "ENDBLK"))
        .Section("ENTITIES", entities)
        .End();

    /// <summary>A line 9 long at a height.</summary>
    public static (int Code, object Value)[] Line(string layer, double y, params (int, object)[] more) => [(0, "LINE"), (8, layer), .. more, (10, 0.0), (20, y), (11, 9.0), (21, y)];

    public static (int Code, object Value)[] Polyline(params (int, object)[] content) => [(0, "LWPOLYLINE"), (8, "0"), .. content];

    public static (int Code, object Value)[] Insert(string block, string layer, params (int, object)[] more) => [(0, "INSERT"), (8, layer), (2, block), .. more, (10, 0.0), (20, 20.0)];
}
