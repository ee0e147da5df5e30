namespace Engraver.Core.Dxf;

/// <summary>Whether a placed part still is a line, an arc or a circle.</summary>
internal enum PlacementOutcome
{
    Exact,

    /// <summary>A circle or arc that does not lie level is an ellipse in plan.</summary>
    Tilted,

    /// <summary>A circle or arc under different scales in x and y is an ellipse.</summary>
    UnequallyScaled,

    /// <summary>A coordinate is no longer a usable number.</summary>
    OutOfRange,
}
