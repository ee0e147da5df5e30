using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>A run of straight pieces of a contour, end to start: finds the arcs in it, each as long as possible.</summary>
internal static class ChordRun
{
    /// <summary>Fewest chords of an arc (five vertices): there is a circle through any three vertices, and four can be on a circle by chance.</summary>
    public const int MinChords = 4;

    /// <summary>Passes every arc found to <paramref name="take"/>, with its first chord and the number of its chords.</summary>
    /// <remarks>Finds the longest arc from each vertex by galloping search and bisection: the work is linear in the number of vertices except for a small
    /// factor.</remarks>
    public static void Recover(ReadOnlySpan<Point2D> vertices, in ChordTolerances tolerances, Action<int, int, RecoveredArc> take)
    {
        for (var from = 0; from + MinChords < vertices.Length;)
        {
            if (Longest(vertices[from..], tolerances) is { } found)
            {
                if (ArcFit.Rises(found.Arc, tolerances.MaxError)) take(from, found.Chords, found.Arc);
                from += found.Chords;
            }
            else
            {
                from++;
            }
        }
    }

    private static (int Chords, RecoveredArc Arc)? Longest(ReadOnlySpan<Point2D> vertices, in ChordTolerances tolerances)
    {
        if (ArcFit.Arc(vertices[..(MinChords + 1)], tolerances) is not { } best) return null;
        var (good, bad) = (MinChords, vertices.Length);
        for (var step = MinChords; good < bad - 1; step *= 2)
        {
            var chords = Math.Min(good + step, vertices.Length - 1);
            if (ArcFit.Arc(vertices[..(chords + 1)], tolerances) is { } longer) (good, best) = (chords, longer);
            else bad = chords;
            if (bad < vertices.Length) break;
        }

        while (bad - good > 1)
        {
            var chords = (good + bad) / 2;
            if (ArcFit.Arc(vertices[..(chords + 1)], tolerances) is { } longer) (good, best) = (chords, longer);
            else bad = chords;
        }

        return (good, best);
    }
}
