namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Covers a run whose spans are as good as arcs (CAD writes a circle as a spline of four) with the fewest single arcs from one end or middle of a span to another.</summary>
/// <remarks>The search that goes as far as it can puts its ends where they cannot be met again; by the symmetry of such spans their ends and middles can. Within the run neighbours share their tangent exactly.</remarks>
/// <param name="run">What is to be covered.</param>
/// <param name="tolerance">Distance, mm.</param>
/// <param name="endDirection">Sine by which the last arc may arrive off the curve's direction.</param>
internal sealed class SpanArcs(SmoothRun run, double tolerance, double endDirection)
{
    /// <summary>Places of each span.</summary>
    private const int PlacesPerSpan = 2;

    /// <summary>No arc sweeps a half turn, and a circle has four spans or more.</summary>
    private const int FarthestPlace = 16;

    /// <summary>Between arcs, which share their direction whatever the curve's is: numbers written with four decimals spoil the symmetry of a small circle by that much.</summary>
    private const double SameDirection = SmoothRun.CornerSine;

    private readonly BiarcChoice _choice = new(run, tolerance);

    /// <summary>Arcs from the run's start to its end, each leaving as the one before arrives; null when arcs alone do not get there.</summary>
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
