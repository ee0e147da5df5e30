using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Result of the comparison of a run with its drawing, lengths in millimetres.</summary>
/// <param name="CuttingSamples">Number of samples with the tool on; when 0, the deviation is unknown.</param>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the drawing, or from the region in which a corner may be rounded if that is nearer; 0
/// without cutting samples, infinite when the drawing is empty but a cut was made.</param>
/// <param name="DeviationAt">The sample that deviates most; null without cutting samples.</param>
/// <param name="MissingLength">Length of the drawing that was never cut.</param>
/// <param name="MissingAt">A place in the first gap of the drawing; null when the whole drawing was cut.</param>
/// <param name="ExtraLength">Length that was cut outside the drawing: between consecutive cutting samples of which one is farther from it than the coverage
/// tolerance.</param>
public sealed record TraceVerdict(
    long CuttingSamples, double MaxDeviation, TraceSample? DeviationAt, double MissingLength, Point2D? MissingAt, double ExtraLength)
{
    /// <summary>Largest distance of a cutting sample from the drawing where it rounded a corner within the corner tolerance; such samples do not count for
    /// <see cref="MaxDeviation"/>. Null without a corner tolerance.</summary>
    public double? CornerDeviation { get; init; }
}
