using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>What a trace says about a run, lengths in millimetres.</summary>
/// <param name="CuttingSamples">Samples with the tool on; with none, nothing is known of the deviation.</param>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the drawing; 0 without cutting samples, infinite when something was cut and the drawing is empty.</param>
/// <param name="DeviationAt">The sample that deviates most; null without cutting samples.</param>
/// <param name="MissingLength">Length of the drawing that was never cut.</param>
/// <param name="MissingAt">A place in the first gap of the drawing; null when nothing is missing.</param>
/// <param name="ExtraLength">Length that was cut beside the drawing: between consecutive cutting samples of which one lies off it by more than the coverage tolerance.</param>
public sealed record TraceVerdict(
    long CuttingSamples, double MaxDeviation, TraceSample? DeviationAt, double MissingLength, Point2D? MissingAt, double ExtraLength);
