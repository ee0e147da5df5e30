namespace Engraver.Core.Machines;

/// <summary>What the controller executes, in counts, before it is written as commands: stream, calls and posts are made from the same value.</summary>
/// <param name="Profile">The machine for which it was made.</param>
/// <param name="Start">Assumed position of the machine when the job starts, job frame (the rounded drawing point of the start option).</param>
/// <param name="Strokes">In the order of cutting.</param>
public sealed record MotionProgram(MachineProfile Profile, CountsPoint Start, IReadOnlyList<MotionStroke> Strokes)
{
    /// <summary>How the segments were grouped into sequences; job mode Calls needs <see cref="MotionStyle.Calls"/>.</summary>
    public MotionStyle Style { get; init; }

    /// <summary>Where the machine goes after the last stroke, tool off, job frame; null: it does not move. Posted programs end at the end of their last
    /// stroke.</summary>
    public CountsPoint? Finish { get; init; }

    /// <summary>The longest wait that an operation states, seconds; 0 for none.</summary>
    public double LongestWait => Strokes.Select(stroke => stroke.Terms?.LongestWait ?? 0.0).DefaultIfEmpty().Max();

    /// <summary>The smallest VA and VD of its sequences, counts/s2.</summary>
    public int LeastAcceleration => Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => sequence.AccelerationOn(Profile)).DefaultIfEmpty(Profile.AccelerationCounts).Min();

    public int SegmentCount => Strokes.Sum(stroke => stroke.SegmentCount);

    /// <summary>The segment after the given number in the order of cutting, with its start and the index of its stroke in <see cref="Strokes"/>; null after the
    /// last.</summary>
    public (CountsPoint Start, VectorSegment Segment, int Stroke)? SegmentAfter(int executed)
    {
        for (var stroke = 0; stroke < Strokes.Count; stroke++)
        {
            var of = Strokes[stroke];
            if (executed >= of.SegmentCount)
            {
                executed -= of.SegmentCount;
                continue;
            }

            foreach (var sequence in of.Sequences)
            {
                if (executed < sequence.Segments.Count) return (executed == 0 ? sequence.Start : sequence.Segments[executed - 1].End, sequence.Segments[executed], stroke);
                executed -= sequence.Segments.Count;
            }
        }

        return null;
    }

    /// <summary>The strokes that end within a number of segments.</summary>
    public MotionProgram Until(int segments) => this with { Strokes = [.. Strokes.TakeWhile(stroke => (segments -= stroke.SegmentCount) >= 0)] };

    /// <summary>VS of the segment that follows the given number of executed segments, counts/s; 0 after the last.</summary>
    public int SpeedAfter(int executed)
    {
        foreach (var sequence in Strokes.SelectMany(stroke => stroke.Sequences))
        {
            if (executed < sequence.Segments.Count) return sequence.Speed;
            executed -= sequence.Segments.Count;
        }

        return 0;
    }
}
