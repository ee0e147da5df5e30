namespace Engraver.Core.Verification;

/// <summary>What was measured of one pass, millimetres.</summary>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the path of this pass.</param>
/// <param name="MissingLength">Length of the path that was never cut.</param>
/// <param name="ExtraLength">Length that was cut beside the path.</param>
/// <param name="Depth">Deepest place below height 0; 0 on a machine without a tool axis.</param>
/// <param name="FeedMmPerMinute">The fastest cutting speed over a tenth of a second; null where no such piece was cut, and without times.</param>
public sealed record MeasuredPass(double MaxDeviation, double MissingLength, double ExtraLength, double Depth, double? FeedMmPerMinute)
{
    /// <summary>Largest distance from the path where a corner was rounded within the corner tolerance; null without a corner tolerance.</summary>
    public double? CornerDeviation { get; init; }

    /// <summary>Number of cutting samples with outputs other than those of the operation.</summary>
    public long OutputFaults { get; init; }
}
