using Engraver.Core.Diagnostics;

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

    public int SegmentCount => Strokes.Sum(stroke => stroke.SegmentCount);

    /// <summary>The segment after the given number in the order of cutting, with its start and the index of its stroke in <see cref="Strokes"/>; null after the
    /// last.</summary>
    public (CountsPoint Start, VectorSegment Segment, int Stroke)? SegmentBehind(int executed)
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

    /// <summary>VS of the segment that follows the given number of executed segments, counts/s; 0 after the last.</summary>
    public int SpeedBehind(int executed)
    {
        foreach (var sequence in Strokes.SelectMany(stroke => stroke.Sequences))
        {
            if (executed < sequence.Segments.Count) return sequence.Speed;
            executed -= sequence.Segments.Count;
        }

        return 0;
    }
}

/// <summary>One stroke: rapid to <see cref="Start"/> with the tool off, tool on, every sequence in order (at rest between two of them), tool off. Where an axis
/// is the tool drive, "on" is at the height of the start and "off" at clearance height; each pass is a stroke with the same index.</summary>
public sealed record MotionStroke(int Index, CountsPoint Start, IReadOnlyList<VectorSequence> Sequences)
{
    public int SegmentCount => Sequences is StrokeSequences columns ? columns.SegmentCount : Sequences.Sum(sequence => sequence.Segments.Count);
}

/// <summary>VM ... VE: segments that are cut without a stop. It begins at the present position of the machine.</summary>
/// <param name="Start">Where the sequence begins, job frame.</param>
/// <param name="Speed">VS for this sequence, even counts/s.</param>
/// <param name="Segments">At least one.</param>
public sealed record VectorSequence(CountsPoint Start, int Speed, IReadOnlyList<VectorSegment> Segments)
{
    /// <summary>Lines that rise or fall: the sequence is run in three axes (LM) instead of two (VM). It has no arcs.</summary>
    public bool ChangesHeight { get; init; }

    public CountsPoint End => Segments[^1].End;

    public double Length => Segments is SequenceSegments columns ? columns.Length : Segments.Sum(segment => segment.Length);
}

/// <summary>One VP or CR of a vector sequence, in counts of the job's frame.</summary>
/// <remarks>Line: only <see cref="End"/> matters. Arc: radius, theta and delta exactly as they will be sent (already rounded to the controller's resolution);
/// <see cref="End"/> is the predicted position after it, rounded to counts (galil-dmc.md B.3).</remarks>
/// <param name="Kind">VP or CR.</param>
/// <param name="End">End point, job frame.</param>
/// <param name="Radius">CR radius, whole counts; 0 for a line.</param>
/// <param name="ThetaDegrees">CR theta: direction from the centre to the current point.</param>
/// <param name="DeltaDegrees">CR delta: signed sweep, counter-clockwise positive.</param>
/// <param name="EntityIndex">The drawing entity of this segment.</param>
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

/// <summary>How the segments of a stroke are grouped into sequences; it decides from which point the arcs of a sequence are computed.</summary>
public enum MotionStyle : byte
{
    /// <summary>A sequence continues up to a sharp corner (stream, program).</summary>
    Continuous,

    /// <summary>Every segment is a separate sequence: the paper's calls of #LINEAR and #CIRC, with a standstill after each.</summary>
    Calls,
}

/// <summary>The result of motion generation.</summary>
/// <param name="Program">Null when something cannot be cut; the errors among <paramref name="Diagnostics"/> state what.</param>
/// <param name="Diagnostics">Errors, warnings and notes, in the order of the strokes.</param>
public sealed record MotionGeneration(MotionProgram? Program, IReadOnlyList<Diagnostic> Diagnostics);

/// <summary>A motion program adapted to a serial line: where the line is too slow for the feed, the feed is reduced and a warning reports it.</summary>
/// <param name="Program">With reduced speeds in the sequences that need it.</param>
/// <param name="Diagnostics">One warning, or none when the line is fast enough.</param>
public sealed record LinkFeedFit(MotionProgram Program, IReadOnlyList<Diagnostic> Diagnostics);
