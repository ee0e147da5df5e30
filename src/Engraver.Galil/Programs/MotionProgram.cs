using Engraver.Galil.Language;
using Engraver.Galil.Profiles;
using Engraver.Galil.Programs.Generation;

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

/// <summary>One stroke: rapid to <see cref="Start"/> with the tool off, tool on, every sequence in order (a standstill between two of them), tool off.</summary>
public sealed record MotionStroke(int Index, CountsPoint Start, IReadOnlyList<VectorSequence> Sequences);

/// <summary>VM ... VE: a run of segments cut without a stop. Its first point is where the machine stands when it begins.</summary>
/// <param name="Start">Where the sequence begins, job frame.</param>
/// <param name="Speed">VS for this sequence, even counts/s.</param>
/// <param name="Segments">At least one.</param>
public sealed record VectorSequence(CountsPoint Start, int Speed, IReadOnlyList<VectorSegment> Segments)
{
    public CountsPoint End => Segments[^1].End;

    public double Length => Segments.Sum(segment => segment.Length);
}
