namespace Engraver.Core.Dxf;

/// <summary>What became of a placed part.</summary>
internal enum PlacementOutcome
{
    /// <summary>It is where it belongs, the same in space (a circle may have become an ellipse).</summary>
    Exact,

    /// <summary>It is where it belongs but does not lie level: the plan view is cut.</summary>
    Tilted,

    /// <summary>A coordinate is no longer a usable number.</summary>
    OutOfRange,
}
