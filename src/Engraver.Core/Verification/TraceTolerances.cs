namespace Engraver.Core.Verification;

/// <summary>What a faithful run may differ by, millimetres.</summary>
public sealed record TraceTolerances
{
    public static TraceTolerances Default { get; } = new();

    /// <summary>One count of the coarser axis. Rounding both axes and the radius of an arc moves a point by less than 2.5 counts (galil-dmc.md B.3).</summary>
    public double Count { get; init; } = 0.001;

    /// <summary>How far the drawing's curves themselves may be approximated.</summary>
    public double MaxError { get; init; } = 0.001;

    /// <summary>How far a cutting sample may lie off the drawing.</summary>
    public double Deviation => (2.5 * Count) + MaxError;

    /// <summary>By how much a chord between two samples may cut a corner: chord squared / (8 x radius), here 20 mm/s at 1 ms on a radius of 0.1 mm.</summary>
    public double ChordSagitta { get; init; } = 0.0005;

    /// <summary>A place of the drawing counts as cut when the trace passes this near.</summary>
    public double Coverage => Deviation + ChordSagitta;

    /// <summary>A gap shorter than this is none: where chords between samples cut a corner, a little of the drawing lies beside them.</summary>
    public double LargestStep { get; init; } = 0.05;

    /// <summary>And in a short segment one shorter than its length divided by this.</summary>
    public int FewestSteps { get; init; } = 16;

    /// <summary>How many of the longest gaps that are none a segment of this length holds.</summary>
    public double StepsFor(double length) => Math.Max(Math.Ceiling(length / LargestStep), FewestSteps);
}
