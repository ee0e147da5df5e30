using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Moves that fall or rise along a path, as chords: machines cut arcs at one height only.</summary>
internal static class ChordPath
{
    /// <summary>The path as lines, in plan.</summary>
    /// <param name="path">Lines, arcs and curves that follow each other.</param>
    /// <param name="maxErrorMm">Largest distance of a chord from its arc or curve, above 0.</param>
    public static IReadOnlyList<StrokeMove> Of(IEnumerable<StrokeMove> path, double maxErrorMm)
    {
        var chords = new List<StrokeMove>();
        foreach (var move in path)
        {
            if (!move.Segment.IsFreeCurve) Add(move, move.Segment, maxErrorMm);
            else foreach (var piece in BiarcFit.Fit(move.Segment.Curve, maxErrorMm / 2.0)) Add(move, piece, maxErrorMm / 2.0);
        }

        return chords;

        void Add(in StrokeMove move, in Segment segment, double error)
        {
            var count = segment.Kind == SegmentKind.Line ? 1 : Math.Max(2, (int)Math.Ceiling(Math.Abs(segment.Arc.Sweep.Radians) / (2.0 * Math.Acos(Math.Max(0.5, 1.0 - (error / segment.Arc.Radius))))));
            for (var i = 0; i < count; i++) chords.Add(Line(move, i == 0 ? segment.Start : segment.PointAt((double)i / count), i + 1 == count ? segment.End : segment.PointAt((i + 1.0) / count)));
        }
    }

    /// <summary>The first chords, up to a length; all of them if they are shorter.</summary>
    public static IReadOnlyList<StrokeMove> First(IReadOnlyList<StrokeMove> chords, double length)
    {
        var first = new List<StrokeMove>();
        foreach (var chord in chords)
        {
            if (length <= 0.0) break;
            first.Add(chord.Segment.Length <= length ? chord : Line(chord, chord.Segment.Start, chord.Segment.PointAt(length / chord.Segment.Length)));
            length -= chord.Segment.Length;
        }

        return first;
    }

    /// <summary>The last chords, up to a length.</summary>
    public static IReadOnlyList<StrokeMove> Last(IReadOnlyList<StrokeMove> chords, double length) => Reversed(First(Reversed(chords), length));

    public static IReadOnlyList<StrokeMove> Reversed(IReadOnlyList<StrokeMove> chords) => [.. chords.Reverse().Select(chord => Line(chord, chord.Segment.End, chord.Segment.Start))];

    /// <summary>The chords with heights that change evenly along them.</summary>
    public static IEnumerable<StrokeMove> Sloped(IReadOnlyList<StrokeMove> chords, double startZ, double endZ, StrokeRole role)
    {
        var (whole, along) = (chords.Sum(chord => chord.Segment.Length), 0.0);
        for (var index = 0; index < chords.Count; index++)
        {
            var from = startZ + ((endZ - startZ) * along / whole);
            along += chords[index].Segment.Length;
            yield return chords[index] with { StartZ = from, EndZ = index + 1 == chords.Count ? endZ : startZ + ((endZ - startZ) * along / whole), Role = role };
        }
    }

    private static StrokeMove Line(in StrokeMove of, Point2D from, Point2D to) => of with { Segment = Segment.FromLine(from, to) };
}
