using System.Globalization;

namespace Engraver.Benchmarks.Stops;

/// <summary>One row of the table: durations of the stops under one fault.</summary>
/// <param name="Milliseconds">From STOP to the wire, ascending.</param>
/// <param name="Braked">Stops of jobs that were already braking, because the fault had ended them.</param>
/// <param name="Lost">Stops that did not reach the wire because the link was lost.</param>
internal sealed record FaultStopFigure(string Fault, IReadOnlyList<double> Milliseconds, int Braked, int Lost)
{
    /// <summary>The longest garbage collection between a press and the wire, milliseconds.</summary>
    public double LongestPause { get; init; }

    /// <summary>On a serial line: from the end of the bytes in transmission, ascending; null for TCP, where a stop does not wait for them.</summary>
    public IReadOnlyList<double>? Behind { get; init; }

    /// <summary>The head of the table for a serial line.</summary>
    public const string SerialHead = "| Fault | presses | already braking | link cut | p50 ms | p99 ms | max. ms | GC pause ms | after the line in progress: p50 ms | p99 ms | max. ms |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|";

    public const string MarkdownHead = "| Fault | presses | already braking | link cut | p50 ms | p99 ms | max. ms | GC pause ms |\n|---|---:|---:|---:|---:|---:|---:|---:|";

    public string ToMarkdown() => string.Create(CultureInfo.InvariantCulture, $"| {Fault} | {Milliseconds.Count + Braked + Lost} | {Braked} | {Lost} | {At(Milliseconds, 0.5)} | {At(Milliseconds, 0.99)} | {At(Milliseconds, 1.0)} | {LongestPause:0.00} |{(Behind is null ? "" : $" {At(Behind, 0.5)} | {At(Behind, 0.99)} | {At(Behind, 1.0)} |")}");

    private static string At(IReadOnlyList<double> times, double part) => times.Count == 0 ? "" : times[Math.Min(times.Count - 1, (int)(times.Count * part))].ToString("0.00", CultureInfo.InvariantCulture);
}
