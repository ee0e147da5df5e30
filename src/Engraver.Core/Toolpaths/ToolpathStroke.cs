using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>One contour as it is cut: consecutive moves, with the tool on from the first to the last.</summary>
/// <param name="Index">Index in the order of cutting, 0 is first.</param>
/// <param name="Closed">True when the stroke ends where it starts.</param>
/// <param name="Moves">At least one move; each starts within the join tolerance of the end of the previous one.</param>
public sealed record ToolpathStroke(int Index, bool Closed, IReadOnlyList<StrokeMove> Moves)
{
    /// <summary>Number of moves of each row of the sequenced table: several for an ellipse or spline that was converted to arcs and lines. Null when every row
    /// is one move.</summary>
    public IReadOnlyList<int>? RowMoves { get; init; }

    /// <summary>Cutting speed along the path, mm/min; null: that of the machine.</summary>
    public double? FeedMmPerMinute { get; init; }

    /// <summary>Speed straight down, mm/min; null: that of the machine.</summary>
    public double? PlungeMmPerMinute { get; init; }

    /// <summary>Time between the tool at work and the first move, after the settle time of the machine, seconds.</summary>
    public double PierceSeconds { get; init; }

    /// <summary>Time at the end of the last move before the tool is taken away, seconds.</summary>
    public double DwellSeconds { get; init; }

    /// <summary>Outputs that are on while it is cut, besides tool and spindle; bit 0 is output 1.</summary>
    public int Outputs { get; init; }

    /// <summary>Speed of the spindle or power of the beam, as a part of the full value of the machine's analog output; null: as the profile states.</summary>
    public double? AnalogPart { get; init; }

    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;

    public double Length => Moves.Sum(move => move.Segment.Length);
}
