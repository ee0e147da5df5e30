using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>One cutting move in millimetres with the drawing entity it came from.</summary>
/// <param name="Segment">Segment in plan.</param>
/// <param name="StartZ">Drawn height at its start; a line rises evenly to its end, an arc is level.</param>
/// <param name="EndZ">Drawn height at its end. Both heights are NaN when the height along the move is unknown: a piece of an ellipse or spline that
/// rises.</param>
public readonly record struct StrokeMove(Segment Segment, int EntityIndex, double StartZ = 0.0, double EndZ = 0.0)
{
    /// <summary>What it is for.</summary>
    public StrokeRole Role { get; init; }

    /// <summary>Every row of an analysed table.</summary>
    public static StrokeMove[] AllOf(EntityTable table)
    {
        ArgumentNullException.ThrowIfNull(table);
        var moves = new StrokeMove[table.Count];
        for (var row = 0; row < moves.Length; row++) moves[row] = From(table[row]);
        return moves;
    }

    internal static StrokeMove From(in EntityRow row)
    {
        var isLevel = row.Curve?.IsLevel ?? true;
        return new StrokeMove(row.ToSegment(), row.EntityIndex, isLevel ? row[EntitySlot.StartZ] : double.NaN, isLevel ? row[EntitySlot.EndZ] : double.NaN) { Role = (StrokeRole)(int)row[EntitySlot.Role] };
    }
}
