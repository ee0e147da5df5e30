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

    /// <summary>The drawing is walked in steps no longer than this.</summary>
    public double LargestStep { get; init; } = 0.05;

    /// <summary>And in no fewer steps for each segment than this.</summary>
    public int FewestSteps { get; init; } = 16;

    /// <summary>But never in more: a line of a thousand kilometres must not keep the judge busy for hours.</summary>
    public int MostSteps { get; init; } = 1_000_000;

    /// <summary>Into how many steps a segment of this length is divided.</summary>
    public int StepsFor(double length) => (int)Math.Clamp(Math.Ceiling(length / LargestStep), FewestSteps, MostSteps);
}
