using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>One curve of a picture.</summary>
/// <param name="Segments">At least one; each starts where the one before ends, or nearly.</param>
/// <param name="Closed">Decides the colour.</param>
/// <param name="Number">Place in the order of cutting as shown to people (1 is first); null where there is no order.</param>
public sealed record PlotStroke(IReadOnlyList<Segment> Segments, bool Closed, int? Number)
{
    public double Length => Segments.Sum(segment => segment.Length);
}
