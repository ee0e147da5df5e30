namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Covers a run whose spans are nearly arcs (CAD writes a circle as a spline of four spans) with the fewest single arcs, each from one end or middle
/// of a span to another.</summary>
/// <remarks><see cref="BiarcSearch"/> ends its arcs at places from which no single arc can continue; the ends and middles of symmetric spans do not have that
/// problem. Within the run neighbours share their tangent exactly.</remarks>
/// <param name="run">The run to cover.</param>
/// <param name="tolerance">Largest distance between run and arcs, mm.</param>
/// <param name="endDirection">Sine of the largest angle between the last arc's end and the curve's.</param>
internal sealed class SpanArcs(SmoothRun run, double tolerance, double endDirection)
{
    /// <summary>End places in each span: its middle and its end.</summary>
    private const int PlacesPerSpan = 2;

    /// <summary>Maximum number of places that one arc may span. No arc sweeps a half turn, and a circle has at least four spans.</summary>
    private const int FarthestPlace = 16;

    /// <summary>Sine of the largest angle between an arc's end and the curve's, where another arc follows (it continues in the arc's direction): coordinates
    /// with four decimals turn a small circle by this much.</summary>
    private const double SameDirection = SmoothRun.CornerSine;

    private readonly BiarcChoice _choice = new(run, tolerance);

    /// <summary>Arcs from the run's start to its end, each leaving in the direction in which the one before arrives; null when there are none.</summary>
    public IReadOnlyList<TangentArc>? Cover()
    {
        if (_choice.Single(0.0, run.TangentAt(0.0), 1.0, SameDirection) is null) return null;
        var places = (int)run.End * PlacesPerSpan;
        var last = new (int Arcs, int From, TangentArc Arc)?[places + 1];
        for (var from = 0; from < places; from++)
        {
            if (from > 0 && last[from] is null) continue;
            var (arcs, leaving) = from == 0 ? (0, run.TangentAt(0.0)) : (last[from]!.Value.Arcs, last[from]!.Value.Arc.EndTangent);
            for (var to = from + 1; to <= Math.Min(places, from + FarthestPlace); to++)
            {
                if (last[to] is { } known && known.Arcs <= arcs + 1) continue;
                if (_choice.Single(Place(from), leaving, Place(to), to == places ? endDirection : SameDirection) is { } arc) last[to] = (arcs + 1, from, arc);
            }
        }

        return last[places] is null ? null : Chain(last, places);
    }

    private static double Place(int number) => (double)number / PlacesPerSpan;

    private static List<TangentArc> Chain((int Arcs, int From, TangentArc Arc)?[] last, int end)
    {
        var arcs = new List<TangentArc>();
        for (var at = end; at > 0; at = last[at]!.Value.From) arcs.Add(last[at]!.Value.Arc);
        arcs.Reverse();
        return arcs;
    }
}
