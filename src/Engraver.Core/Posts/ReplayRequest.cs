using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

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
    public RequirementsJudge? Requirements { get; init; }

    /// <summary>What the operations of the strokes require; null for a job without operations.</summary>
    public StrokeRequirements? Strokes { get; init; }

    /// <summary>Called at the start of each further part of the program by a reader whose programs are loaded in parts; null when not requested.</summary>
    public ScheduleJudge? Schedule { get; init; }

    /// <summary>Largest allowed distance from the end of a move to the start of the next cut, millimetres: the widest gap that a stroke of the job crosses,
    /// with rounding. A reader whose format states both ends of each move reports larger distances.</summary>
    public double LongestJump { get; init; } = double.PositiveInfinity;

    /// <summary>All cuts are at one height, which a format with a third coordinate must keep.</summary>
    public bool IsLevel { get; init; }
}
