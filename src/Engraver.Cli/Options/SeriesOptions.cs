using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>The options of a run of several plates: <c>--csv</c>, <c>--rows</c>, <c>--copies</c>, <c>--grid</c>, <c>--pitch</c>, <c>--stagger</c>,
/// <c>--fixtures</c>, <c>--first-cell</c>, <c>--counter</c>.</summary>
internal sealed class SeriesOptions
{
    private readonly Option<string?> _csv = new("--csv") { HelpName = "FILE.csv", Description = Wording.Get("Series.Csv") };
    private readonly Option<string?> _rows = new("--rows") { HelpName = "3-7", Description = Wording.Get("Series.Rows") };
    private readonly Option<double?> _copies = new("--copies") { HelpName = "N", Description = Wording.Get("Series.Copies"), CustomParser = result => OptionValue.IntegerFromOne(result) };
    private readonly Option<(int Columns, int Rows)?> _grid = new("--grid") { HelpName = "COLUMNSxROWS", Description = Wording.Get("Series.Grid"), CustomParser = ParseGrid };
    private readonly Option<Point2D?> _pitch = new("--pitch") { HelpName = "DX,DY", Description = Wording.Get("Series.Pitch"), CustomParser = ParsePitch };
    private readonly Option<Point2D?> _stagger = new("--stagger") { HelpName = "DX,DY", Description = Wording.Get("Series.Stagger"), CustomParser = ParsePitch };
    private readonly Option<double?> _firstCell = new("--first-cell") { HelpName = "N", Description = Wording.Get("Series.FirstCell"), CustomParser = result => OptionValue.IntegerFromOne(result) };
    private readonly Option<IReadOnlyList<string>?> _fixtures = new("--fixtures") { HelpName = "G54,G55", Description = Wording.Get("Series.Fixtures"), CustomParser = ParseFixtures };
    private readonly Option<CounterRequest> _counter = CounterRequest.NewOption();

    /// <param name="withFixtures">The verb knows of work origins.</param>
    public void AddTo(Command command, bool withFixtures = true)
    {
        foreach (var option in (Option[])[_csv, _rows, _copies, _grid, _pitch, _stagger, _firstCell, _counter]) command.Options.Add(option);
        if (withFixtures) command.Options.Add(_fixtures);
    }

    public string? CsvFile(ParseResult parsed) => parsed.GetValue(_csv);

    /// <summary>The rows are stated.</summary>
    public bool HasRows(ParseResult parsed) => parsed.GetValue(_rows) is not null;

    public CounterRequest Counter(ParseResult parsed) => parsed.GetValue(_counter) ?? CounterRequest.None;

    /// <summary>The first option that requests several plates; null for none.</summary>
    public string? Requested(ParseResult parsed) => ((Option[])[_csv, _rows, _copies, _grid, _pitch, _stagger, _fixtures, _firstCell]).FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false })?.Name;

    /// <summary>Rejects a job of several tools in several fixtures: the heights of all work origins are those of one tool.</summary>
    /// <exception cref="UsageException">It is one.</exception>
    public void RejectSeveralTools(ParseResult parsed, DrawingSettings settings)
    {
        if (parsed.GetValue(_fixtures) is null || settings.Operations is not { } plan) return;
        int[] tools = [.. plan.Active(settings.Tool).Select(operation => operation.Tool).Distinct()];
        if (tools.Length > 1) throw new UsageException(Wording.Get("Series.FixturesOneTool", string.Join(", ", tools)));
    }

    /// <summary>The plates, as the drawing and the options state them.</summary>
    /// <param name="fields">The fields in the texts that are cut.</param>
    /// <param name="placement">Of the drawing.</param>
    /// <returns>Null where a finding about the CSV file is an error.</returns>
    /// <exception cref="UsageException">Options that cannot be used together.</exception>
    public (PlateSeries? Series, IReadOnlyList<Diagnostic> Findings) Read(ParseResult parsed, PlateFields fields, DrawingPlacement placement)
    {
        if (CsvFile(parsed) is null && parsed.GetValue(_rows) is not null) throw new UsageException(Wording.Get("Series.RowsWithoutCsv"));
        if (CsvFile(parsed) is not null && parsed.GetValue(_copies) is not null) throw new UsageException(Wording.Get("Series.CopiesWithCsv"));
        if (parsed.GetValue(_grid) is null != parsed.GetValue(_pitch) is null) throw new UsageException(Wording.Get("Series.GridAndPitch"));
        var grid = parsed.GetValue(_grid) is var (columns, rows) && parsed.GetValue(_pitch) is { } pitch ? new PlateGrid(columns, rows, pitch - Point2D.Origin) { Stagger = (parsed.GetValue(_stagger) ?? Point2D.Origin) - Point2D.Origin, Placement = placement } : null;
        if (grid is null && parsed.GetValue(_stagger) is not null) throw new UsageException(Wording.Get("Series.StaggerWithoutGrid"));
        var fixtures = parsed.GetValue(_fixtures) ?? [];
        var cells = (grid?.Cells ?? 1) * Math.Max(1, fixtures.Count);
        var firstCell = FirstCell(parsed, cells, hasCells: grid is not null || fixtures.Count > 0);
        if (CsvFile(parsed) is not { } file) return (new PlateSeries(fields, new CsvRow?[(int)(parsed.GetValue(_copies) ?? cells - firstCell)], grid) { FirstCell = firstCell, Fixtures = fixtures }, []);
        var (table, findings) = CsvTable.Read(file);
        if (table is null) return (null, findings);
        if (!fields.UsesColumnOf(table) && fields.Columns.Count == 0) return (null, [.. findings, SerialRules.CsvUnused.At(default, string.Join(", ", table.Columns))]);
        var taken = CsvRows.Read(parsed.GetValue(_rows) ?? "1-", table.Rows.Count);
        if (taken is null) return (null, [.. findings, SerialRules.CsvNoSuchRow.At(default, parsed.GetValue(_rows)!, FactText.Of(table.Rows.Count))]);
        if (fields.UsesColumnOf(table) && fields.UnusedColumnsOf(table) is { Count: > 0 } unused) findings = [.. findings, SerialRules.CsvColumnsUnused.At(default, string.Join(", ", unused))];
        return (new PlateSeries(fields, [.. taken.Select(number => table.Rows[number - 1])], grid) { FirstCell = firstCell, Fixtures = fixtures }, findings);
    }

    /// <summary>The options that continue a series before a plate.</summary>
    public string Continuing(PlateSeries series, int index)
    {
        var plates = series.Rows[index] is null ? string.Create(CultureInfo.InvariantCulture, $"{_copies.Name} {series.Count - index}") : $"{_rows.Name} {string.Join(',', series.Rows.Skip(index).Select(row => row!.Number))}";
        return series.Cells == 1 ? plates : string.Create(CultureInfo.InvariantCulture, $"{plates} {_firstCell.Name} {series.CellOf(index) + 1}");
    }

    /// <returns>From 0.</returns>
    private int FirstCell(ParseResult parsed, int cells, bool hasCells)
    {
        if (parsed.GetValue(_firstCell) is not { } first) return 0;
        if (!hasCells) throw new UsageException(Wording.Get("Series.CellWithoutGrid"));
        return first <= cells ? (int)first - 1 : throw new UsageException(Wording.Get("Series.NoSuchCell", first, cells));
    }

    private static (int Columns, int Rows)? ParseGrid(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word.Split('x', 'X') is [var first, var second] && int.TryParse(first, NumberStyles.None, null, out var columns) && int.TryParse(second, NumberStyles.None, null, out var rows) && columns is >= 1 and <= PlateGrid.MaxCount && rows is >= 1 and <= PlateGrid.MaxCount) return (columns, rows);
        result.AddError(Wording.Get("Series.InvalidGrid", word, PlateGrid.MaxCount));
        return null;
    }

    private static IReadOnlyList<string>? ParseFixtures(ArgumentResult result)
    {
        var names = new List<string>();
        foreach (var word in result.Tokens[0].Value.Split(','))
        {
            if (WorkOriginNames.Find(word) is not { } name) result.AddError(Wording.Get("Series.InvalidFixture", word, string.Join(", ", WorkOriginNames.All)));
            else if (names.Contains(name)) result.AddError(Wording.Get("Series.FixtureTwice", name));
            else names.Add(name);
        }

        return names;
    }

    private static Point2D? ParsePitch(ArgumentResult result)
    {
        if (PlacementOptions.TryParsePosition(result.Tokens[0].Value) is { } pitch) return pitch;
        result.AddError(Wording.Get("Series.InvalidPitch", result.Tokens[0].Value));
        return null;
    }
}
