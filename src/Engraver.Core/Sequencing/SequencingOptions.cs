using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Sequencing;

/// <summary>The named tolerances and requests of sequencing; lengths in millimetres. Defaults are the runner's.</summary>
public sealed record SequencingOptions
{
    public static SequencingOptions Default { get; } = new();

    /// <summary>Ends this near to each other are joined.</summary>
    public double JoinTolerance { get; init; } = 0.01;

    /// <summary>Segments that coincide within this are one; smaller than the join tolerance, because what is left out must count as cut.</summary>
    public double DuplicateTolerance { get; init; } = 0.001;

    public bool KeepDuplicates { get; init; }

    /// <summary>Lines that approximate an arc within this are replaced by it; null leaves them as they are.</summary>
    public double? ArcTolerance { get; init; }

    /// <summary>The machine cuts at the drawn heights: what coincides in plan alone is drawn twice, and lines at several heights are no arc.</summary>
    public bool CutsHeights { get; init; }

    /// <summary>Two open ends nearer to each other than this are reported as a probable drawing mistake.</summary>
    public double SuspiciousGap { get; init; } = ContourEnds.WidestGap;

    /// <summary>Position of the tool when the job starts.</summary>
    public Point2D ToolStart { get; init; }

    public StrokeOrder Order { get; init; } = StrokeOrder.Nearest;

    /// <summary>The stroke that must come first; null leaves it to the order.</summary>
    public EnterAt? Enter { get; init; }
}
