using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Output;

/// <summary>A plate in the objects of <c>run --json</c> and <c>plan --json</c>.</summary>
/// <param name="Number">In its run, from 1.</param>
/// <param name="Text">Its values in one line.</param>
/// <param name="X">Of its cell on the blank, mm.</param>
/// <param name="Y">As X.</param>
internal sealed record PlateReportJson(int Number, string Text, double X, double Y, PlateValuesJson Values)
{
    /// <summary>The work origin of its fixture; null: the active one.</summary>
    public string? Fixture { get; init; }

    /// <summary>How its run ended; null if it was not run.</summary>
    public string? Outcome { get; init; }

    /// <summary>The journal of its run; null if it was not run.</summary>
    public string? Journal { get; init; }

    public double? Seconds { get; init; }

    public double? MaxDeviation { get; init; }

    /// <summary>Where corners were rounded, mm; null when unknown or without a corner tolerance.</summary>
    public double? CornerDeviation { get; init; }

    public double? MissingLength { get; init; }

    public static PlateReportJson From(Plate plate) => new(plate.Number, plate.Values.ToString(), plate.Offset.X, plate.Offset.Y, PlateValuesJson.From(plate.Values)) { Fixture = plate.Fixture };

    /// <summary>A plate that was run.</summary>
    public static PlateReportJson From(Plate plate, RunJson run) => From(plate) with { Outcome = run.Outcome, Journal = run.Journal, Seconds = run.Seconds, MaxDeviation = run.MaxDeviation, CornerDeviation = run.CornerDeviation, MissingLength = run.MissingLength };
}
