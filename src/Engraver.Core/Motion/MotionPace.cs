using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The moves of a motion program one after the other, each with how long it takes and how long the machine waits before it for what was switched last; commands take no time here. For a tool that an output switches.</summary>
public static class MotionPace
{
    /// <param name="start">Where the machine stands before the first move, counts of the job frame.</param>
    /// <param name="commands">How fast the machine travels.</param>
    public static IReadOnlyList<PaceMove> Of(MotionProgram program, CountsPoint start, CommandTimes commands)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(commands);
        var (moves, at, wait) = (new List<PaceMove>(), start, 0.0);
        foreach (var stroke in program.Strokes)
        {
            Add(MotionTime.RapidTo(stroke.Start, at, program, commands).Rapid, stroke.Start);
            wait = program.Profile.ToolSettleSeconds; // from the last switch on, also where no rapid lies between two strokes
            foreach (var sequence in stroke.Sequences) Add(MotionTime.Cut(sequence, program, commands).Cutting, at = sequence.End, sequence.Segments.Count);
            wait += program.Profile.OffSettleSeconds;
        }

        return moves;

        void Add(double seconds, CountsPoint end, int segments = 0)
        {
            if (!(seconds > 0.0)) return;
            moves.Add(new PaceMove(seconds, wait, program.Profile.Scale.ToMillimetres(end.X, end.Y)) { Segments = segments });
            wait = 0.0;
        }
    }
}

/// <summary>A move from rest to rest.</summary>
/// <param name="Seconds">How long the machine moves.</param>
/// <param name="Wait">How long it stood before, seconds.</param>
/// <param name="End">Where it comes to rest, drawing millimetres.</param>
public readonly record struct PaceMove(double Seconds, double Wait, Geometry.Point2D End)
{
    /// <summary>How many segments are loaded for it; 0 for a rapid.</summary>
    public int Segments { get; init; }
}
