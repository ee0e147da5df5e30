namespace Engraver.Core.Motion;

/// <summary>How far the motion may be beside the toolpath, millimetres.</summary>
/// <param name="MaxErrorMm">Largest distance between chords and arcs, where one replaces the other, above 0.</param>
/// <param name="CornerMm">Largest distance of a corner from the arc that rounds it; 0: the machine stops at corners.</param>
public readonly record struct MotionTolerances(double MaxErrorMm, double CornerMm)
{
    /// <summary>Moves that continue each other are merged, and chords that draw a curve become arcs, at most <see cref="MaxErrorMm"/> beside them.</summary>
    public bool FitsArcs { get; init; }
}
