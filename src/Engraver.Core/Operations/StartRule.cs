namespace Engraver.Core.Operations;

/// <summary>Where a closed profile starts.</summary>
public enum StartRule
{
    /// <summary>At the joint that is nearest to the tool.</summary>
    Nearest,

    /// <summary>In the middle of the longest side.</summary>
    Longest,

    /// <summary>In the middle of the highest side, or at the highest point of an arc.</summary>
    Top,

    /// <summary>At the sharpest corner.</summary>
    Corner,
}
