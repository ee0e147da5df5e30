namespace Engraver.TestKit;

/// <summary>A drawing of linetypes and blocks. Linetype DASHED (5 on, 3 off) is that of layer HIDDEN, DOT has a dash of 2 and a dot. Block HOLE has a circle
/// of radius 1 at 1,0 from its base point 1,1 by block, a point and a line by layer; block BRACKET has a line and a HOLE at 10,0; block MARK has only a
/// point.</summary>
public static class LinetypeDrawing
{
    public static DxfText Of(params ReadOnlySpan<(int Code, object Value)> entities) => new DxfText()
        .Section("HEADER", (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, 4), (9, "$LTSCALE"), (40, 2.0))
        .Section("TABLES", (0, "TABLE"), (2, "LTYPE"), (70, 2),
            (0, "LTYPE"), (2, "DASHED"), (70, 0), (3, "dashed"), (72, 65), (73, 2), (40, 8.0), (49, 5.0), (74, 0), (49, -3.0), (74, 0),
            (0, "LTYPE"), (2, "DOT"), (70, 0), (3, "dots"), (72, 65), (73, 4), (40, 4.0), (49, 2.0), (49, -1.0), (49, 0.0), (49, -1.0),
            (0, "LTYPE"), (2, "GAS"), (70, 0), (3, "gas"), (72, 65), (73, 2), (40, 6.0), (49, 4.0), (74, 0), (49, -2.0), (74, 2), (75, 0), (9, "GAS"), (0, "ENDTAB"),
            (0, "TABLE"), (2, "LAYER"), (70, 2), (0, "LAYER"), (2, "0"), (70, 0), (62, 7), (6, "CONTINUOUS"), (0, "LAYER"), (2, "HIDDEN"), (70, 0), (62, 3), (6, "Dashed"), (0, "ENDTAB"))
        .Section("BLOCKS",
            (0, "BLOCK"), (8, "0"), (2, "HOLE"), (70, 0), (10, 1.0), (20, 1.0), (0, "CIRCLE"), (8, "0"), (6, "BYBLOCK"), (10, 2.0), (20, 1.0), (40, 1.0),
            (0, "POINT"), (8, "0"), (10, 1.0), (20, 1.0), (0, "LINE"), (8, "0"), (10, 0.0), (20, 3.0), (11, 4.0), (21, 3.0), (0, "ENDBLK"),
            (0, "BLOCK"), (8, "0"), (2, "BRACKET"), (70, 0), (10, 0.0), (20, 0.0), (0, "LINE"), (8, "0"), (6, "DOT"), (48, 0.5), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0),
            (0, "INSERT"), (8, "0"), (2, "HOLE"), (6, "DASHED"), (10, 10.0), (20, 0.0), (0, "ENDBLK"),
            (0, "BLOCK"), (8, "0"), (2, "MARK"), (70, 0), (10, 0.0), (20, 0.0), (0, "POINT"), (8, "0"), (10, 0.0), (20, 0.0), (0, "ENDBLK"))
        .Section("ENTITIES", entities)
        .End();

    public static (int Code, object Value)[] Insert(string block, double x, double y, string layer = "0", params (int, object)[] more) => [(0, "INSERT"), (8, layer), (2, block), (10, x), (20, y), .. more];

    public static (int Code, object Value)[] Line(string layer, double x1, double y1, double x2, double y2, params (int, object)[] more) => [(0, "LINE"), (8, layer), .. more, (10, x1), (20, y1), (11, x2), (21, y2)];
}
