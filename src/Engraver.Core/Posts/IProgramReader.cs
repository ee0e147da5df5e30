using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Reads a posted text back and runs it in an interpreter that shares no code with the post.</summary>
public interface IProgramReader
{
    /// <summary>False for a format without heights: its cuts are compared in plan, independent of the tool drive of the machine.</summary>
    bool TellsHeights => true;

    /// <summary>True when the reported times are those of the machine and not only an order.</summary>
    bool TellsTimes => false;

    /// <summary>Largest rounding of a position in the format, millimetres; it is added to the allowed deviation.</summary>
    double Rounding => 0.0;

    /// <summary>Passes every motion from the first command to the end of the program to the judges. The text is read once, and only one command, line or part
    /// that is loaded at once is in memory: memory does not grow with the length of the text.</summary>
    /// <returns>The reasons, with lines, why the text is not a program or did not run to its end; empty on success.</returns>
    /// <exception cref="OperationCanceledException">The operation was cancelled.</exception>
    /// <exception cref="IOException">Reading the text fails.</exception>
    /// <exception cref="InvalidDataException">The text has a line that is too long for any program.</exception>
    Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation);
}

/// <summary>Settings for reading a program back.</summary>
/// <param name="Machine">Machine that defines counts per millimetre and the tool output.</param>
/// <param name="Start">Machine position when the program starts, counts of the drawing's frame.</param>
/// <param name="Expected">Expected machine time, for the progress.</param>
/// <param name="Longest">Maximum machine time.</param>
/// <param name="Judges">Judges of the motion, in millimetres of the drawing.</param>
public sealed record ReplayRequest(MachineProfile Machine, CountsPoint Start, TimeSpan Expected, TimeSpan Longest, IReadOnlyList<ITraceJudge> Judges)
{
    /// <summary>Machine position for a program that counts from it, drawing millimetres: the position stored with the program, otherwise the start of the first
    /// stroke. Null when nothing is cut.</summary>
    public Point2D? Entry { get; init; }

    /// <summary>Receives the feeds of the program from a reader whose format contains them; null when not requested.</summary>
    public FeedJudge? Feeds { get; init; }

    /// <summary>Receives the distance by which the controller may leave the path from a reader of a language with path control; null when not
    /// requested.</summary>
    public BlendJudge? Blends { get; init; }

    /// <summary>Requirements of the job in addition to the path, with the receiver of differences; null when not requested.</summary>
    public TermsJudge? Terms { get; init; }

    /// <summary>Called at the start of each further part of the program by a reader whose programs are loaded in parts; null when not requested.</summary>
    public PaceJudge? Pace { get; init; }

    /// <summary>Largest allowed distance from the end of a move to the start of the next cut, millimetres: the widest gap that a stroke of the job crosses,
    /// with rounding. A reader whose format states both ends of each move reports larger distances.</summary>
    public double LongestJump { get; init; } = double.PositiveInfinity;

    /// <summary>All cuts are at one height, which a format with a third coordinate must keep.</summary>
    public bool IsLevel { get; init; }
}

/// <summary>Progress of a replay.</summary>
/// <param name="Chunk">Number of the current chunk, from 1.</param>
/// <param name="Chunks">Number of chunks.</param>
/// <param name="MachineTime">Controller time so far.</param>
/// <param name="Expected">Controller time that the whole is expected to take; zero when no motion is expected.</param>
public readonly record struct ReplayProgress(int Chunk, int Chunks, TimeSpan MachineTime, TimeSpan Expected)
{
    /// <summary>0 to 1, never decreasing: the larger of the fraction of completed programs and the fraction of the time.</summary>
    public double Fraction => Math.Max((Chunk - 1.0) / Chunks, Expected > TimeSpan.Zero ? Math.Min(1.0, MachineTime / Expected) : 0.0);
}
