using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Sequencing;

/// <summary>Tolerances and requests of sequencing; lengths in millimetres. The defaults are those of the command line.</summary>
public sealed record SequencingOptions
{
    public static SequencingOptions Default { get; } = new();

    /// <summary>Distance within which ends are joined.</summary>
    public double JoinTolerance { get; init; } = 0.01;

    /// <summary>Distance within which coinciding segments are duplicates; smaller than the join tolerance, because an omitted duplicate must count as
    /// cut.</summary>
    public double DuplicateTolerance { get; init; } = 0.001;

    public bool KeepDuplicates { get; init; }

    /// <summary>Error within which lines that approximate an arc are replaced by it; null keeps the lines.</summary>
    public double? ArcTolerance { get; init; }

    /// <summary>True when the machine cuts at the drawn heights: segments that coincide only in plan are then not duplicates, and lines at several heights are
    /// not an arc.</summary>
    public bool CutsHeights { get; init; }

    /// <summary>Distance within which two open ends are reported as a probable drawing error.</summary>
    public double SuspiciousGap { get; init; } = ContourEnds.WidestGap;

    /// <summary>Position of the tool when the job starts.</summary>
    public Point2D ToolStart { get; init; }

    public StrokeOrder Order { get; init; } = StrokeOrder.Nearest;

    /// <summary>The stroke that must come first; null for no requirement.</summary>
    public EnterAt? Enter { get; init; }
}
