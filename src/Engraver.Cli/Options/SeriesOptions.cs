using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Options;

/// <summary>The options of a run of several plates: <c>--csv</c>, <c>--rows</c>, <c>--copies</c>, <c>--grid</c>, <c>--pitch</c>, <c>--stagger</c>,
/// <c>--first-cell</c>, <c>--counter</c>.</summary>
internal sealed class SeriesOptions
{
    private readonly Option<string?> _csv = new("--csv") { HelpName = "FILE.csv", Description = Wording.Get("Series.Csv") };
    private readonly Option<string?> _rows = new("--rows") { HelpName = "3-7", Description = Wording.Get("Series.Rows") };
    private readonly Option<double?> _copies = new("--copies") { HelpName = "N", Description = Wording.Get("Series.Copies"), CustomParser = result => OptionValue.IntegerFromOne(result) };
    private readonly Option<(int Columns, int Rows)?> _grid = new("--grid") { HelpName = "COLUMNSxROWS", Description = Wording.Get("Series.Grid"), CustomParser = ParseGrid };
    private readonly Option<Point2D?> _pitch = new("--pitch") { HelpName = "DX,DY", Description = Wording.Get("Series.Pitch"), CustomParser = ParsePitch };
    private readonly Option<Point2D?> _stagger = new("--stagger") { HelpName = "DX,DY", Description = Wording.Get("Series.Stagger"), CustomParser = ParsePitch };
    private readonly Option<double?> _firstCell = new("--first-cell") { HelpName = "N", Description = Wording.Get("Series.FirstCell"), CustomParser = result => OptionValue.IntegerFromOne(result) };
    private readonly Option<CounterRequest> _counter = CounterRequest.NewOption();

    public void AddTo(Command command)
    {
        foreach (var option in (Option[])[_csv, _rows, _copies, _grid, _pitch, _stagger, _firstCell, _counter]) command.Options.Add(option);
    }

    public string? CsvFile(ParseResult parsed) => parsed.GetValue(_csv);

    /// <summary>The rows are stated.</summary>
    public bool HasRows(ParseResult parsed) => parsed.GetValue(_rows) is not null;

    public CounterRequest Counter(ParseResult parsed) => parsed.GetValue(_counter) ?? CounterRequest.None;

    /// <summary>The first option that requests several plates; null for none.</summary>
    public string? Requested(ParseResult parsed) => ((Option[])[_csv, _rows, _copies, _grid, _pitch, _stagger, _firstCell]).FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false })?.Name;

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
        var firstCell = FirstCell(parsed, grid);
        if (CsvFile(parsed) is not { } file) return (new PlateSeries(fields, new CsvRow?[(int)(parsed.GetValue(_copies) ?? grid?.Cells - firstCell ?? 1)], grid) { FirstCell = firstCell }, []);
        var (table, findings) = CsvTable.Read(file);
        if (table is null) return (null, findings);
        if (!fields.UsesColumnOf(table) && fields.Columns.Count == 0) return (null, [.. findings, SerialRules.CsvUnused.At(default, string.Join(", ", table.Columns))]);
        var taken = CsvRows.Read(parsed.GetValue(_rows) ?? "1-", table.Rows.Count);
        if (taken is null) return (null, [.. findings, SerialRules.CsvNoSuchRow.At(default, parsed.GetValue(_rows)!, FactText.Of(table.Rows.Count))]);
        if (fields.UsesColumnOf(table) && fields.UnusedColumnsOf(table) is { Count: > 0 } unused) findings = [.. findings, SerialRules.CsvColumnsUnused.At(default, string.Join(", ", unused))];
        return (new PlateSeries(fields, [.. taken.Select(number => table.Rows[number - 1])], grid) { FirstCell = firstCell }, findings);
    }

    /// <summary>The options that continue a series before a plate.</summary>
    public string Continuing(PlateSeries series, int index)
    {
        var plates = series.Rows[index] is null ? string.Create(CultureInfo.InvariantCulture, $"{_copies.Name} {series.Count - index}") : $"{_rows.Name} {string.Join(',', series.Rows.Skip(index).Select(row => row!.Number))}";
        return series.Grid is null ? plates : string.Create(CultureInfo.InvariantCulture, $"{plates} {_firstCell.Name} {series.CellOf(index) + 1}");
    }

    /// <returns>From 0.</returns>
    private int FirstCell(ParseResult parsed, PlateGrid? grid)
    {
        if (parsed.GetValue(_firstCell) is not { } first) return 0;
        if (grid is null) throw new UsageException(Wording.Get("Series.CellWithoutGrid"));
        return first <= grid.Cells ? (int)first - 1 : throw new UsageException(Wording.Get("Series.NoSuchCell", first, grid.Cells));
    }

    private static (int Columns, int Rows)? ParseGrid(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word.Split('x', 'X') is [var first, var second] && int.TryParse(first, NumberStyles.None, null, out var columns) && int.TryParse(second, NumberStyles.None, null, out var rows) && columns is >= 1 and <= PlateGrid.MaxCount && rows is >= 1 and <= PlateGrid.MaxCount) return (columns, rows);
        result.AddError(Wording.Get("Series.InvalidGrid", word, PlateGrid.MaxCount));
        return null;
    }

    private static Point2D? ParsePitch(ArgumentResult result)
    {
        if (PlacementOptions.TryParsePosition(result.Tokens[0].Value) is { } pitch) return pitch;
        result.AddError(Wording.Get("Series.InvalidPitch", result.Tokens[0].Value));
        return null;
    }
}
