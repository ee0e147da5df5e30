namespace Engraver.Cli.Output;

/// <summary>What <c>engraver run --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record RunJson(
    string Outcome,
    int SegmentsSent,
    int SegmentsExecuted,
    double Seconds,
    double? PlannedSeconds,
    int Underruns,
    int Rejected,
    long? FinalX,
    long? FinalY,
    RunJson.ScaleJson CountsPerMillimetre,
    double? MaxDeviation,
    double? MissingLength,
    string DeviationSource,
    string? Journal)
{
    internal sealed record ScaleJson(double X, double Y);
}
