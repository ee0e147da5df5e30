namespace Engraver.Core.Motion;

/// <summary>The parts of a motion program's time by its strokes.</summary>
/// <param name="Strokes">Of each stroke of the program: the rapid to it, the tool to the work, its cut, and the tool away from the work.</param>
/// <param name="Around">Of no stroke: loading, the start of the spindle, the tool raised before the first rapid, and the move to the finish.</param>
public sealed record StrokeTimes(IReadOnlyList<MotionTimes> Strokes, MotionTimes Around)
{
    /// <summary>The whole program.</summary>
    public MotionTimes Total => Strokes.Aggregate(Around, (sum, one) => sum + one);
}
