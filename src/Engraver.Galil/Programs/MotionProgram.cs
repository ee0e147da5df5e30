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
}
