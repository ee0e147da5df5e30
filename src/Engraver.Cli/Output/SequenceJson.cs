using System.Text.Json.Serialization;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver sequence --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record SequenceJson(
    int Contours,
    int Closed,
    int Open,
    int Segments,
    int Reversed,
    int DuplicatesRemoved,
    double PathLength,
    double Travel,
    double TravelAndBack,
    double TravelAsDrawn,
    IReadOnlyList<SequenceJson.StrokeJson> Strokes,
    IReadOnlyList<SequenceJson.DiscontinuityJson> Discontinuities,
    SequenceJson.SecondsJson Seconds)
{
    internal sealed record StrokeJson(
        int Index, bool Closed, int Segments, double Length, double StartX, double StartY, double EndX, double EndY, int Inside)
    {
        /// <summary>Id of its operation; not written for a job without operations, like the next two.</summary>
        [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
        public string? Operation { get; init; }

        /// <summary>0 is the first pass of the stroke.</summary>
        [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
        public int? Pass { get; init; }

        /// <summary>Depth below the top of the work, mm.</summary>
        [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
        public double? Depth { get; init; }
    }

    internal sealed record DiscontinuityJson(double X, double Y, double? Gap, string? NearestHandle, string Id);

    /// <summary>Wall-clock times of the stages of this run, seconds; analysis is included in chaining.</summary>
    internal sealed record SecondsJson(double Read, double Chain, double Order);
}
