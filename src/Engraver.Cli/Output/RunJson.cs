namespace Engraver.Cli.Output;

/// <summary>What <c>engraver run --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="NotCut">What is seen on the layers that are cut and gives no cut, by DXF type; null when the job was not prepared.</param>
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
    string? Journal,
    RunJson.LeftOutJson? LeftOut,
    IReadOnlyDictionary<string, int>? NotCut,
    RunJson.OriginJson? Origin)
{
    internal sealed record ScaleJson(double X, double Y);

    /// <summary>Where the drawing's zero lay, millimetres by the controller's own zero.</summary>
    /// <param name="Source">work, here or given.</param>
    internal sealed record OriginJson(double X, double Y, string Source);

    /// <param name="Count">Entities of the drawing that gave no curve though they should have.</param>
    /// <param name="Length">Their length; null where nobody can know it.</param>
    internal sealed record LeftOutJson(int Count, double? Length);
}
