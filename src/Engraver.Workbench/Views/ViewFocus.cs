using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Views;

/// <summary>A point that the canvas marks until REGEN, until another point is marked, or until its finding is resolved.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="Finding">The finding at the point; null for a point alone.</param>
public sealed record ViewFocus(Point2D Place, Diagnostic? Finding)
{
    /// <summary>Millimetres.</summary>
    private const double SamePlace = 1e-6;

    /// <summary>Whether the finding still exists: compared by rule and position, or by entity if it has none, because its message may contain other
    /// data.</summary>
    public bool IsAmong(IEnumerable<Diagnostic> findings)
    {
        return Finding is not { } found || findings.Any(IsSame);

        bool IsSame(Diagnostic now) => now.Id == found.Id && (found.Place is { } at ? now.Place?.DistanceTo(at) < SamePlace : now.Source.Handle == found.Source.Handle);
    }
}
