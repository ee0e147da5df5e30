using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Recognises arcs and circles that a drawing contains as many short lines (flattened by an export) and replaces the lines by true arcs.</summary>
public static class ArcRecoverer
{
    /// <summary>Fraction of the error by which lines of one run may be apart: separate LINE entities meet only within rounding.</summary>
    private const double GapShare = 0.05;

    /// <summary>A table in which lines that approximate an arc within <paramref name="maxError"/> (mm, in both directions, proved at every chord) are one row.
    /// All other rows are unchanged.</summary>
    /// <param name="analysed">Rows as drawn; lines of polylines and separate lines are joined end to end before the search for arcs.</param>
    /// <param name="maxError">Largest error, above 0.</param>
    /// <returns>The rows in their original order, each arc at its lowest row and with that row's entity; and the replacements.</returns>
    public static ArcRecoveryResult Recover(EntityTable analysed, double maxError)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxError);
        return Recover(analysed, analysed.ToSegments(), maxError);
    }

    /// <param name="segments">The segments of the table.</param>
    internal static ArcRecoveryResult Recover(EntityTable analysed, Segment[] segments, double maxError)
    {
        var replacement = new ArcReplacement(analysed);
        var contours = Contours(segments, maxError);
        var junctions = contours.Where(contour => !contour.Closed).SelectMany(contour => new[] { contour.StartIn(segments), contour.EndIn(segments) }).ToHashSet();
        foreach (var contour in contours)
        {
            if (contour.Pieces.Length >= ChordRun.MinChords) new ContourArcs(contour, segments, analysed, junctions, (1.0 - GapShare) * maxError).FindInto(replacement);
        }

        return replacement.ToResult();
    }

    /// <summary>The contours that can contain an arc.</summary>
    private static List<Contour> Contours(Segment[] segments, double maxError)
    {
        if (ChordJoints.RowsOf(segments, GapShare * maxError, maxError) is not { } rows || rows.Length == segments.Length) return new ContourWalker(segments, GapShare * maxError, EndHeights.Flat).WalkAll();
        var contours = new ContourWalker([.. rows.Select(row => segments[row])], GapShare * maxError, EndHeights.Flat).WalkAll();
        return contours.ConvertAll(contour => contour with { Pieces = contour.Pieces.ToArray().Select(piece => piece with { Row = rows[piece.Row] }).ToArray() });
    }
}
