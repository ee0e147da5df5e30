namespace Engraver.Core.Motion;

/// <summary>How far the motion may be beside the toolpath, millimetres.</summary>
/// <param name="MaxErrorMm">Largest distance of chords from an arc that the controller cannot cut, above 0.</param>
/// <param name="CornerMm">Largest distance of a corner from the arc that rounds it; 0: the machine stops at corners.</param>
public readonly record struct MotionTolerances(double MaxErrorMm, double CornerMm);
