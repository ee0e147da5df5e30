namespace Engraver.Core.Plots;

/// <summary>The quantity that a picture of a run shows as colour.</summary>
public enum RunMeasure
{
    /// <summary>Distance from the drawing.</summary>
    Deviation,

    /// <summary>Following error: distance of the motors from their commanded positions.</summary>
    Following,

    /// <summary>Speed along the path.</summary>
    Speed,
}
