namespace Engraver.Simulator.Motion;

/// <summary>The mode for which a plane was last set up.</summary>
internal enum PlaneMode
{
    None,
    Vector,
    Linear,
}
