namespace Engraver.Core.Drawings;

/// <summary>Group 71 of TEXT and STYLE: how the letters are generated.</summary>
[Flags]
public enum TextGeneration : byte
{
    None = 0,

    /// <summary>Mirrored in the direction of the line.</summary>
    Backwards = 2,

    /// <summary>Mirrored across the line.</summary>
    UpsideDown = 4,
}
