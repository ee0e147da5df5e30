namespace Engraver.Core.Trajectories.Reading;

/// <summary>Format in which a controller reads a trajectory file.</summary>
public enum ControllerLanguage
{
    /// <summary>Points of the drawing.</summary>
    AbsoluteSpline,

    /// <summary>Points relative to the machine position.</summary>
    RelativeSpline,

    LineArc,

    Pvt,
}
