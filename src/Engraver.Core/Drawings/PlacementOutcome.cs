namespace Engraver.Core.Drawings;

/// <summary>Result of transforming a part.</summary>
public enum PlacementOutcome
{
    /// <summary>Transformed exactly (a circle may have become an ellipse).</summary>
    Exact,

    /// <summary>Transformed exactly but not level: its plan view is cut.</summary>
    Tilted,

    /// <summary>A coordinate is no longer a usable number.</summary>
    OutOfRange,
}
