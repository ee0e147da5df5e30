using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>What the controller executes, in counts, before it is spelled as commands: the same value feeds the live stream, the calls and the posts.</summary>
/// <param name="Profile">The machine it was made for.</param>
/// <param name="Start">Where the machine is taken to stand when the job starts, job frame (the rounded drawing point of the start option).</param>
/// <param name="Strokes">In the order of cutting.</param>
public sealed record MotionProgram(MachineProfile Profile, CountsPoint Start, IReadOnlyList<MotionStroke> Strokes)
{
    /// <summary>How the segments were put into sequences; the calls way needs <see cref="MotionStyle.Calls"/>.</summary>
    public MotionStyle Style { get; init; }

    /// <summary>Where the machine goes behind the last stroke, tool off, job frame; null: it stays where it is. Posted programs end where their last stroke does.</summary>
    public CountsPoint? Finish { get; init; }

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

/// <summary>One VP or CR of a vector sequence, in counts of the job's frame.</summary>
/// <remarks>Line: only <see cref="End"/> counts. Arc: radius, theta and delta exactly as they will be sent (already rounded to what the controller keeps);
/// <see cref="End"/> is where the controller is predicted to stand after it, rounded to counts (galil-dmc.md B.3).</remarks>
/// <param name="Kind">VP or CR.</param>
/// <param name="End">End point, job frame.</param>
/// <param name="Radius">CR radius, whole counts; 0 for a line.</param>
/// <param name="ThetaDegrees">CR theta: direction from the centre to the current point.</param>
/// <param name="DeltaDegrees">CR delta: signed sweep, counter-clockwise positive.</param>
/// <param name="EntityIndex">The drawing entity this piece engraves.</param>
/// <param name="Length">Path length in counts.</param>
public readonly record struct VectorSegment(
    VectorSegmentKind Kind, CountsPoint End, int Radius, double ThetaDegrees, double DeltaDegrees, int EntityIndex, double Length);

public enum VectorSegmentKind : byte
{
    /// <summary>VP x,y.</summary>
    Line,

    /// <summary>CR radius,theta,delta.</summary>
    Arc,
}

/// <summary>How the segments of a stroke are put into sequences; what a sequence starts from decides how its arcs are aimed.</summary>
public enum MotionStyle : byte
{
    /// <summary>Sequences go on until a sharp corner (stream, program).</summary>
    Continuous,

    /// <summary>Every segment is a sequence of its own: the paper's calls of #LINEAR and #CIRC, with a standstill after each.</summary>
    Calls,
}

/// <summary>What came of a toolpath.</summary>
/// <param name="Program">Null when something cannot be cut at all; the errors among <paramref name="Diagnostics"/> say what.</param>
/// <param name="Diagnostics">Errors, warnings and notes, in the order of the strokes.</param>
public sealed record MotionGeneration(MotionProgram? Program, IReadOnlyList<Diagnostic> Diagnostics);

/// <summary>A motion program made fit to be streamed over a serial line: where the line is too slow for the feed, the feed is lowered and a warning says so.</summary>
/// <param name="Program">With the speeds of its sequences lowered where they had to be.</param>
/// <param name="Diagnostics">One warning, or none when the line carries the part.</param>
public sealed record LinkFeedFit(MotionProgram Program, IReadOnlyList<Diagnostic> Diagnostics);
