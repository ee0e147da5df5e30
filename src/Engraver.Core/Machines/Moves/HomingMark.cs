namespace Engraver.Core.Machines.Moves;

/// <summary>The mark that defines the home position of an axis.</summary>
public enum HomingMark
{
    /// <summary>The edge of the home switch.</summary>
    Switch,

    /// <summary>The edge of the limit switch in the direction of the search.</summary>
    Limit,

    /// <summary>The index pulse of the encoder, searched from the present position of the axis.</summary>
    Index,

    /// <summary>The first index pulse on the way back from the home switch.</summary>
    SwitchIndex,

    /// <summary>The first index pulse on the way back from the limit switch.</summary>
    LimitIndex,
}
