using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Cuts a stroke in two at a standstill, for a memory that cannot hold all of it.</summary>
internal static class StrokeCut
{
    /// <summary>Between two sequences nothing changes. Inside a sequence the cut looks back for a VP, after which the machine stands on whole counts,
    /// so that the arcs behind it are met exactly as they were aimed.</summary>
    /// <param name="stroke">A stroke of more than one segment.</param>
    /// <param name="segments">How many segments the first part may have, at least 1.</param>
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
        var head = stroke with { Sequences = [.. first] };
        return (head, new MotionStroke(stroke.Index, head.Sequences[^1].End, [.. rest]));
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
