using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;

namespace Engraver.Core.Sequencing;

/// <summary>Tolerances and requests of sequencing; lengths in millimetres. The caller states the tolerances and the order; any other request that is left out
/// is not made.</summary>
public sealed record SequencingOptions
{
    /// <summary>Distance within which ends are joined.</summary>
    public required double JoinTolerance { get; init; }

    /// <summary>Distance within which coinciding segments are duplicates; smaller than the join tolerance, because an omitted duplicate must count as
    /// cut.</summary>
    public required double DuplicateTolerance { get; init; }

    public bool KeepDuplicates { get; init; }

    /// <summary>Error within which lines that approximate an arc are replaced by it; null keeps the lines.</summary>
    public double? ArcTolerance { get; init; }

    /// <summary>True when the machine cuts at the drawn heights: segments that coincide only in plan are then not duplicates, and lines at several heights are
    /// not an arc.</summary>
    public bool CutsHeights { get; init; }

    /// <summary>Position of the tool when the job starts.</summary>
    public Point2D ToolStart { get; init; }

    public required StrokeOrder Order { get; init; }

    /// <summary>Cost and extent of the search for <see cref="StrokeOrder.Optimal"/>.</summary>
    public OrderSearch Search { get; init; } = OrderSearch.Default;

    /// <summary>Position that the tool moves to after the last stroke; <see cref="StrokeOrder.Optimal"/> includes this way. Null: it stays there.</summary>
    public Point2D? ToolEnd { get; init; }

    /// <summary>The stroke that must come first; null for no requirement.</summary>
    public EntryRequest? Entry { get; init; }
}
