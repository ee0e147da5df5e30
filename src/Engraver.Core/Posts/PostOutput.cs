using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts;

/// <summary>A job as text: one or more parts that are loaded and run one after the other without moving the machine in between.</summary>
/// <param name="Chunks">Each ends with a line end (LF); empty when the job cannot be written, and the diagnostics state why.</param>
/// <param name="Diagnostics">Deviations from the requested output.</param>
public sealed record PostOutput(IReadOnlyList<string> Chunks, IReadOnlyList<Diagnostic> Diagnostics)
{
    public string Text => string.Concat(Chunks);

    /// <summary>The line of the whole text, from 1, that commands each segment of the motion program; empty when not requested.</summary>
    public IReadOnlyList<int> SegmentLines { get; init; } = [];

    /// <summary>Predicted machine position after each block; null for a format without significant rounding.</summary>
    public PostForecast? Forecast { get; init; }
}
