using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Divides a stroke in two at a standstill, for a memory that cannot hold the whole stroke.</summary>
internal static class StrokeCut
{
    /// <summary>Nothing changes between two sequences: the tool is taken away and brought back, with its wait before it moves. Inside a sequence the cut is
    /// moved back to a VP, after which the machine is on whole counts, so that the following arcs start exactly where they were computed.</summary>
    /// <param name="stroke">A stroke of more than one segment.</param>
    /// <param name="segments">Maximum number of segments of the first part, at least 1.</param>
    public static (MotionStroke First, MotionStroke Tail) Before(MotionStroke stroke, int segments)
    {
        var whole = 0;
        var room = segments;
        while (stroke.Sequences[whole].Segments.Count <= room) room -= stroke.Sequences[whole++].Segments.Count;
        if (whole > 0) return Between(stroke, stroke.Sequences.Take(whole), stroke.Sequences.Skip(whole));
        var (head, tail) = Inside(stroke.Sequences[0], room);
        return Between(stroke, [head], stroke.Sequences.Skip(1).Prepend(tail));
    }

    private static (MotionStroke First, MotionStroke Tail) Between(MotionStroke stroke, IEnumerable<VectorSequence> first, IEnumerable<VectorSequence> rest)
    {
        var head = stroke with { Sequences = [.. first], Terms = stroke.Terms is { } terms ? terms with { DwellSeconds = 0.0 } : null };
        return (head, stroke with { Start = head.Sequences[^1].End, Sequences = [.. rest], Terms = stroke.Terms is { } tail ? tail with { ReadySeconds = 0.0 } : null });
    }

    private static (VectorSequence Head, VectorSequence Tail) Inside(VectorSequence sequence, int room)
    {
        var cut = room;
        while (cut > 1 && sequence.Segments[cut - 1].Kind != VectorSegmentKind.Line) cut--;
        if (sequence.Segments[cut - 1].Kind != VectorSegmentKind.Line) cut = room;
        var head = sequence with { Segments = [.. sequence.Segments.Take(cut)] };
        return (head, sequence with { Start = head.End, Segments = [.. sequence.Segments.Skip(cut)] });
    }
}
