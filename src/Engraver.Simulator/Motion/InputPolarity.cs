namespace Engraver.Simulator.Motion;

/// <summary>CN, five fields (galil-dmc.md C): limits, home, latch, selective abort, abort input.</summary>
internal sealed class InputPolarity
{
    public int[] Fields { get; } = [-1, -1, -1, 0, 0];

    /// <summary>First field 1: an open limit input is active.</summary>
    public bool LimitsActiveHigh => Fields[0] == 1;

    /// <summary>Second field 1: a grounded home input reads 1.</summary>
    public bool HomeReversed => Fields[1] == 1;

    /// <summary>Third field 1: latches trigger on the rising edge.</summary>
    public bool LatchOnRise => Fields[2] == 1;

    /// <summary>Fourth field 1: inputs 5 to 8 abort axes A to D.</summary>
    public bool SelectiveAbort => Fields[3] == 1;

    /// <summary>Fifth field 1: programs continue when the abort input stops the motion.</summary>
    public bool AbortKeepsPrograms => Fields[4] == 1;
}
