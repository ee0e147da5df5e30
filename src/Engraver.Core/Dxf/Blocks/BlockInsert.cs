using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>An INSERT as written: the block, its position and the number of copies. The block's base point is not yet subtracted.</summary>
internal readonly record struct BlockInsert
{
    private const int MaxCopies = short.MaxValue;

    public BlockInsert(EntityRecord record)
        : this(record, Placement.Identity)
    {
        Columns = Math.Clamp(record.Flags(70), 1, MaxCopies);
        Rows = Math.Clamp(record.Flags(71), 1, MaxCopies);
        var system = SystemOf(record);
        var rotation = Angle.FromDegrees(record.Number(50, 0.0));
        ZeroScaleCode = record.Number(41, 1.0) == 0.0 ? 41 : record.Number(42, 1.0) == 0.0 ? 42 : 0;
        var scale = new Vector3D(record.Number(41, 1.0), record.Number(42, 1.0), record.Number(43, 1.0));
        Placement = system.After(Placement.FromInsert(scale, rotation).MovedBy(record.Point(10)));
        ColumnStep = system.ApplyToDirection(new Vector3D(rotation.Cos(), rotation.Sin(), 0.0) * record.Number(44, 0.0));
        RowStep = system.ApplyToDirection(new Vector3D(-rotation.Sin(), rotation.Cos(), 0.0) * record.Number(45, 0.0));
    }

    /// <summary>One copy of the block at a placement.</summary>
    private BlockInsert(EntityRecord record, Placement placement)
    {
        Type = record.Type;
        Block = record.Name;
        Layer = record.Layer;
        Colour = record.Colour;
        Linetype = record.Linetype;
        Lineweight = record.Lineweight ?? Drawings.Lineweight.ByLayer;
        Handle = record.Handle;
        Line = record.Line;
        Invisible = record.Invisible;
        (Columns, Rows, Placement) = (1, 1, placement);
    }

    public string Type { get; }

    /// <summary>Group code of a scale factor of zero: 41 (no width remains) or 42 (no height); 0 when neither is zero.</summary>
    public int ZeroScaleCode { get; }

    /// <summary>Number of the block's name.</summary>
    public int Block { get; }

    public int Layer { get; }

    public DrawingColour Colour { get; }

    /// <summary>Number of its linetype, as stated.</summary>
    public int Linetype { get; }

    /// <summary>Its lineweight, as stated.</summary>
    public int Lineweight { get; }

    public ulong Handle { get; }

    public int Line { get; }

    public bool Invisible { get; }

    public int Columns { get; }

    public int Rows { get; }

    /// <summary>Scale, rotation, the insert's own system and insertion point.</summary>
    public Placement Placement { get; }

    /// <summary>From one copy of an array to the next column; rotated with the insert but not scaled.</summary>
    public Vector3D ColumnStep { get; }

    public Vector3D RowStep { get; }

    public long Copies => (long)Columns * Rows;

    /// <summary>Placement of one copy of the block, with the base point subtracted.</summary>
    public Placement Copy(int column, int row, Vector3D basePoint) =>
        Placement.MovedBy((ColumnStep * column) + (RowStep * row) - Placement.ApplyToDirection(basePoint));

    /// <summary>The block of a dimension, moved by group 12.</summary>
    public static BlockInsert OfDimension(EntityRecord record) => new(record, Placement.Identity.MovedBy(SystemOf(record).ApplyToDirection(record.PointOrOrigin(12))));

    private static Placement SystemOf(EntityRecord record) => record.Extrusion() is var direction && direction == default ? Placement.Identity : Placement.FromExtrusion(direction);

    public RecordIssue Finding(Diagnostics.DiagnosticRule rule, string block) => new(rule, Type, Handle, Line, block, Refused: true);
}

/// <summary>An INSERT inside a block.</summary>
internal sealed class NestedInsert(BlockInsert insert, int beforeCurve)
{
    public BlockInsert Insert { get; } = insert;

    /// <summary>Index of the block's curve before which it is drawn.</summary>
    public int BeforeCurve { get; } = beforeCurve;

    /// <summary>Why it is not expanded; null when it is. Set when the block's weight is computed.</summary>
    public DiagnosticRule? Obstacle { get; set; }
}
