namespace Engraver.Simulator.Motion;

/// <summary>What a plane was last set up for.</summary>
internal enum PlaneMode
{
    None,
    Vector,
    Linear,
}
