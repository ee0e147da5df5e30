using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>One curve of a picture.</summary>
/// <param name="Segments">Segments, at least one; each starts at or near the end of the previous one.</param>
/// <param name="Closed">Determines the colour.</param>
/// <param name="Number">Place in the order of cutting as shown to people (1 is first); null where there is no order.</param>
public sealed record PlotStroke(IReadOnlyList<Segment> Segments, bool Closed, int? Number)
{
    public double Length => Segments.Sum(segment => segment.Length);

    /// <summary>Step of the colours of a run, or <see cref="RunPlot.DrawingBelow"/>; null where the colour shows closed or open.</summary>
    public int? Heat { get; init; }
}
