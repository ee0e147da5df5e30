namespace Engraver.Simulator;

/// <summary>The reason why a fault cannot occur.</summary>
public enum FaultErrorReason
{
    /// <summary>The fault has no trigger, or more than one.</summary>
    Moments,

    /// <summary>A number is below 0, or too large.</summary>
    BelowZero,

    /// <summary>A time is not above 0, or too large.</summary>
    NotAboveZero,

    /// <summary>A number is below 1.</summary>
    BelowOne,

    /// <summary>This kind of fault needs an axis.</summary>
    NoAxis,

    /// <summary>This kind of fault takes no axis.</summary>
    HasNoAxis,

    /// <summary>The axis is not A, B, C or D.</summary>
    OtherAxis,

    /// <summary>This kind of fault has no duration.</summary>
    NeverEnds,
}
