using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Searches one contour for arcs: first the whole of a closed contour, then runs of level lines. A vertex where another contour ends is kept, because
/// otherwise the two would no longer meet.</summary>
internal sealed class ContourArcs(Contour contour, Segment[] segments, EntityTable table, HashSet<Point2D> junctions, double maxError)
{
    /// <summary>Cosine of the corner at which a closed contour is opened: no arc passes through it.</summary>
    private const double CornerCosine = 0.85;

    private readonly ContourPiece[] _pieces = contour.Closed ? FromCorner(contour.Pieces.Span, segments) : contour.Pieces.ToArray();

    public void FindInto(ArcReplacement replacement)
    {
        for (int first = 0, end; first < _pieces.Length; first = Math.Max(end, first + 1))
        {
            for (end = first; end < _pieces.Length && IsOfRun(first, end);) end++;
            if (end - first < ChordRun.MinChords) continue;
            Recover(_pieces.AsMemory(first, end - first), replacement);
        }
    }

    private void Recover(ReadOnlyMemory<ContourPiece> run, ArcReplacement replacement)
    {
        var vertices = Vertices(run.Span);
        var tolerances = ChordTolerances.For(vertices, maxError);
        var isWhole = contour.Closed && run.Length == _pieces.Length;
        if (isWhole && ArcFit.Circle(vertices.AsSpan(0, run.Length), tolerances) is { } circle) replacement.Add(run.Span, circle);
        else ChordRun.Recover(vertices, tolerances, (from, chords, arc) => replacement.Add(run.Span.Slice(from, chords), arc));
    }

    /// <summary>True for a line with a length, at the height of the run's first at both ends, with no other contour ending at its start.</summary>
    private bool IsOfRun(int first, int at)
    {
        if (at > first && junctions.Contains(_pieces[at].StartIn(segments))) return false;
        var row = table[_pieces[at].Row];
        var z = table[_pieces[first].Row][EntitySlot.StartZ];
        return row.Kind == SegmentKind.Line && row.StartPoint != row.EndPoint && row[EntitySlot.StartZ] == z && row[EntitySlot.EndZ] == z;
    }

    private Point2D[] Vertices(ReadOnlySpan<ContourPiece> pieces)
    {
        var vertices = new Point2D[pieces.Length + 1];
        for (var i = 0; i < pieces.Length; i++) vertices[i] = pieces[i].StartIn(segments);
        vertices[^1] = pieces[^1].EndIn(segments);
        return vertices;
    }

    /// <summary>A closed contour, rotated to start at a piece where no arc can be in progress; unchanged when there is no such piece.</summary>
    private static ContourPiece[] FromCorner(ReadOnlySpan<ContourPiece> pieces, Segment[] segments)
    {
        var start = 0;
        for (var before = pieces.Length - 1; start < pieces.Length && !IsCorner(pieces[before], pieces[start], segments); start++) before = start;
        if (start == pieces.Length) start = 0;
        return [.. pieces[start..], .. pieces[..start]];
    }

    private static bool IsCorner(ContourPiece before, ContourPiece after, Segment[] segments)
    {
        if (segments[before.Row].Kind != SegmentKind.Line || segments[after.Row].Kind != SegmentKind.Line) return true;
        var (arriving, leaving) = (before.EndIn(segments) - before.StartIn(segments), after.EndIn(segments) - after.StartIn(segments));
        return arriving.Dot(leaving) < CornerCosine * Math.Sqrt(arriving.LengthSquared * leaving.LengthSquared);
    }
}
