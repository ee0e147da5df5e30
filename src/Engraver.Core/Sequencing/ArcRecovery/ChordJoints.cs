using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Quickly finds the segments that can be part of an arc made of chords, so that the others need not be joined to contours first.</summary>
/// <remarks>Two lines are chords of one circle only when they meet at a corner that fits their lengths: chords within the error e of a circle are at most 4
/// sqrt(r e) long, and the corner bounds the radius r from above (see <see cref="ChordProof"/>). Where enough of them are consecutive, all segments connected
/// to them are kept, so that the contours are the same as from the whole drawing.</remarks>
internal sealed class ChordJoints(Segment[] segments, double maxError)
{
    /// <summary>Arcs are recovered from coordinates with three decimals or more; this is the rounding of three.</summary>
    private const double CoarsestRounding = 1e-3;

    /// <summary>The rows that can be part of an arc, ascending; null when all rows can.</summary>
    public static int[]? RowsOf(Segment[] segments, double gap, double maxError)
    {
        var ends = new NearEndPairs(segments, gap);
        return ends.IsCrowded ? null : new ChordJoints(segments, maxError).Rows(ends);
    }

    private int[] Rows(NearEndPairs ends)
    {
        var chords = new RowGroups(segments.Length);
        ends.Visit((one, other) =>
        {
            if (MayBeOfArc(one, other)) chords.Join(one / 2, other / 2);
        });
        if (chords.Largest < ChordRun.MinChords) return [];
        var touching = new RowGroups(segments.Length);
        ends.Visit((one, other) => touching.Join(one / 2, other / 2));
        var wanted = new bool[segments.Length];
        for (var row = 0; row < wanted.Length; row++) wanted[touching.Of(row)] |= chords.SizeOf(row) >= ChordRun.MinChords;
        return [.. Enumerable.Range(0, segments.Length).Where(row => wanted[touching.Of(row)])];
    }

    private bool MayBeOfArc(int one, int other)
    {
        if (segments[one / 2].Kind != SegmentKind.Line || segments[other / 2].Kind != SegmentKind.Line) return false;
        var (arriving, leaving) = (-Away(one), Away(other));
        var (first, second) = (Math.Sqrt(arriving.LengthSquared), Math.Sqrt(leaving.LengthSquared));
        var corner = Math.Abs(arriving.Cross(leaving)) / (first * second);
        return arriving.Dot(leaving) > 0.0 && corner <= ChordProof.LargestCorner && Fits(first, second, corner, CoarsestRounding) && Fits(first, second, corner, RoundingAt(one, other));
    }

    private bool Fits(double first, double second, double corner, double rounding)
    {
        var (longest, turn) = (Math.Max(first, second), corner - (4.0 * rounding / Math.Min(first, second)));
        return turn <= 0.0 || longest * longest / (16.0 * maxError) <= (1.0 + ChordProof.UnevenTurn) * (first + second) / (2.0 * turn);
    }

    /// <summary>Rounding of the vertices at a joint. Never finer than that of a longer run of chords, because more vertices never have fewer decimals in
    /// common.</summary>
    private double RoundingAt(int one, int other) => ChordTolerances.For([Place(one), Place(one ^ 1), Place(other ^ 1)], maxError).Rounding;

    /// <summary>From an end of a line to its other end.</summary>
    private Vector2D Away(int end) => Place(end ^ 1) - Place(end);

    private Point2D Place(int end) => (end & 1) == 0 ? segments[end / 2].Start : segments[end / 2].End;
}
