using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Divides a stroke in two at a standstill, for a memory that cannot hold the whole stroke.</summary>
internal static class StrokeCut
{
    /// <summary>Within a sequence it is cut at one of the last segments that fit: this part of them.</summary>
    private const double SearchedPart = 0.25;

    /// <summary>Nothing changes between two sequences: the tool is taken away and brought back, with its wait before it moves. Inside a sequence the cut is
    /// after a VP, after which the machine is on whole counts, so that the following arcs start exactly where they were computed; of these the one at which
    /// the path is slowest.</summary>
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

    private static int SlowestAfterLine(VectorSequence sequence, int room)
    {
        var first = Math.Max(1, (int)(room * (1.0 - SearchedPart)));
        var ends = Enumerable.Range(first, room - first + 1).Where(count => sequence.Segments[count - 1].Kind == VectorSegmentKind.Line).ToList();
        if (ends.Count == 0) ends = [.. Enumerable.Range(1, room).Reverse().Where(count => sequence.Segments[count - 1].Kind == VectorSegmentKind.Line).Take(1)];
        if (ends.Count == 0) return room;
        if (sequence.Acceleration is not { } acceleration) return ends[^1];
        var (planned, path) = (SequenceProfile.Of(sequence, acceleration), new double[room + 1]);
        for (var i = 0; i < room; i++) path[i + 1] = path[i] + sequence.Segments[i].Length;
        return ends.AsEnumerable().Reverse().MinBy(count => Math.Round(planned.SpeedAt(path[count])));
    }

    private static (VectorSequence Head, VectorSequence Tail) Inside(VectorSequence sequence, int room)
    {
        var cut = SlowestAfterLine(sequence, room);
        var head = sequence with { Segments = [.. sequence.Segments.Take(cut)] };
        return (head, sequence with { Start = head.End, Segments = [.. sequence.Segments.Skip(cut)] });
    }
}
