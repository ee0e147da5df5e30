namespace Engraver.Core.Trajectories;

/// <summary>Treatment of corners (sharper than 0.05 degrees).</summary>
public enum CornerMode
{
    /// <summary>A trajectory ends at a corner and another starts: the corner stays sharp, the machine stops.</summary>
    Stop,

    /// <summary>One trajectory runs through the corner, with points so close to it that the rounding stays within the error.</summary>
    Continuous,
}
