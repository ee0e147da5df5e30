namespace Engraver.Core.Pockets;

/// <summary>Entry of the tool to the depth of a stroke.</summary>
public enum PocketEntry
{
    /// <summary>Straight down.</summary>
    Plunge,

    /// <summary>Down along the first pass: around it when it is closed, back and forth when it is open.</summary>
    Ramp,

    /// <summary>Down on a helix next to the start of the first pass; without room for a helix, as <see cref="Ramp"/>.</summary>
    Helix,
}
