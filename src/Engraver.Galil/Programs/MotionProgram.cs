using Engraver.Galil.Profiles;

namespace Engraver.Galil.Programs;

/// <summary>What the controller executes, in counts, before it is spelled as commands: the same value feeds the live stream, the calls and the posts.</summary>
/// <param name="Profile">The machine it was made for.</param>
/// <param name="Start">Where the machine is taken to stand when the job starts, job frame (the rounded drawing point of the start option).</param>
/// <param name="Strokes">In the order of cutting.</param>
public sealed record MotionProgram(MachineProfile Profile, CountsPoint Start, IReadOnlyList<MotionStroke> Strokes)
{
    /// <summary>How the segments were put into sequences; the calls way needs <see cref="MotionStyle.Calls"/>.</summary>
    public MotionStyle Style { get; init; }

    public int SegmentCount => Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Segments.Count));

    /// <summary>The segment behind so many in the order of cutting, where it starts and its stroke; null behind the last.</summary>
    public (CountsPoint Start, VectorSegment Segment, MotionStroke Stroke)? SegmentBehind(int executed)
    {
        foreach (var stroke in Strokes)
        {
            foreach (var sequence in stroke.Sequences)
            {
                if (executed < sequence.Segments.Count) return (executed == 0 ? sequence.Start : sequence.Segments[executed - 1].End, sequence.Segments[executed], stroke);
                executed -= sequence.Segments.Count;
            }
        }

        return null;
    }
}
