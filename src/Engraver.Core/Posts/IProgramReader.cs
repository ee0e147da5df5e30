using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Reads a posted text back and does what it says, by an interpreter that shares no code with what wrote it.</summary>
public interface IProgramReader
{
    /// <summary>False for a form without heights: what it cuts is compared in plan, whatever drives the tool of the machine.</summary>
    bool TellsHeights => true;

    /// <summary>The times that are told are those of the machine, not only an order.</summary>
    bool TellsTimes => false;

    /// <summary>How far the form itself may move a place by rounding it, millimetres: what is allowed grows by it.</summary>
    double Rounding => 0.0;

    /// <summary>Tells the judges every motion from the first command to the end of the program. The text is read once, and no more of it is held than a command, a line or a part that is loaded at once: memory does not grow with its length.</summary>
    /// <returns>Why the text is no program or did not run to its end, with its lines; empty when it did.</returns>
    /// <exception cref="OperationCanceledException">It is not wanted any more.</exception>
    /// <exception cref="IOException">The text cannot be read on.</exception>
    /// <exception cref="InvalidDataException">It has a line that is too long for any program.</exception>
    Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation);
}

/// <summary>How a program is read back.</summary>
/// <param name="Machine">By which counts become millimetres and the tool's output is known.</param>
/// <param name="Start">Where the machine stands when the program starts, counts of the drawing's frame.</param>
/// <param name="Expected">Machine time that it probably takes, for the progress.</param>
/// <param name="Longest">Machine time that it may take.</param>
/// <param name="Judges">Told in millimetres of the drawing.</param>
public sealed record ReplayRequest(MachineProfile Machine, CountsPoint Start, TimeSpan Expected, TimeSpan Longest, IReadOnlyList<ITraceJudge> Judges)
{
    /// <summary>Where the machine stands for a program that counts from there, drawing millimetres: as it was kept with the program, else where the first stroke begins. Null: nothing is cut.</summary>
    public Point2D? Entry { get; init; }

    /// <summary>Told how fast the program cuts, by a reader whose form says so; null: nobody asks.</summary>
    public FeedJudge? Feeds { get; init; }

    /// <summary>Told how far the controller itself may leave the path, by a reader of a language with path control; null: nobody asks.</summary>
    public BlendJudge? Blends { get; init; }

    /// <summary>What the job asks for beside the way, and where what the program does otherwise is told; null: nobody asks.</summary>
    public TermsJudge? Terms { get; init; }

    /// <summary>Told where a further part of the program begins, by a reader whose programs are loaded in parts; null: nobody asks.</summary>
    public PaceJudge? Pace { get; init; }

    /// <summary>A cut may begin as far from the end of the move before it, millimetres: the widest gap that a stroke of the job runs across, with rounding. A reader whose form tells each move by both of its ends finds what is farther.</summary>
    public double LongestJump { get; init; } = double.PositiveInfinity;

    /// <summary>Everything that is cut lies at one height: a form with a third coordinate must not leave it.</summary>
    public bool IsLevel { get; init; }
}

/// <summary>How far a replay has come.</summary>
/// <param name="Chunk">From 1.</param>
/// <param name="Chunks">All of them.</param>
/// <param name="MachineTime">Controller time so far.</param>
/// <param name="Expected">Controller time that the whole is expected to take; zero when nothing is expected to move.</param>
public readonly record struct ReplayProgress(int Chunk, int Chunks, TimeSpan MachineTime, TimeSpan Expected)
{
    /// <summary>0 to 1, never less than before: by the programs that are done, and by the time, whichever is more.</summary>
    public double Fraction => Math.Max((Chunk - 1.0) / Chunks, Expected > TimeSpan.Zero ? Math.Min(1.0, MachineTime / Expected) : 0.0);
}
