namespace Engraver.Simulator.Motion;

/// <summary>AL and RL (galil-dmc.md C): the position at an edge of the axis' input, 1 to 4 for A to D, or at the index pulse.</summary>
internal sealed class Latch
{
    public bool IsArmed { get; private set; }

    /// <summary>ALT: the index pulse triggers the latch, not the input.</summary>
    public bool WaitsForIndex { get; private set; }

    public int Position { get; private set; }

    public void Arm(bool waitsForIndex)
    {
        IsArmed = true;
        WaitsForIndex = waitsForIndex;
    }

    public void Catch(double position)
    {
        Position = (int)Math.Round(position, MidpointRounding.AwayFromZero);
        IsArmed = false;
    }
}
