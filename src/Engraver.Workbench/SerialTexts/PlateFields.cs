using System.Collections.Immutable;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The fields in the texts of a drawing.</summary>
public sealed class PlateFields
{
    private readonly IReadOnlyList<PlacedText> _texts;
    private readonly HashSet<string> _columns = new(StringComparer.OrdinalIgnoreCase);
    private readonly HashSet<string> _tags = new(StringComparer.OrdinalIgnoreCase);
    private readonly SortedDictionary<string, (long? Start, long? Increment)> _counters = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<Diagnostic> _findings = [];

    private PlateFields(IReadOnlyList<PlacedText> texts) => _texts = texts;

    /// <summary>The counters with their design, in the order of their names.</summary>
    public IReadOnlyList<CounterDesign> Counters => [.. _counters.Select(one => new CounterDesign(one.Key, one.Value.Start ?? CounterDesign.DefaultStart, one.Value.Increment ?? CounterDesign.DefaultIncrement))];

    /// <summary>The columns that fields name.</summary>
    public IReadOnlyCollection<string> Columns => _columns;

    public bool UsesDate { get; private set; }

    public bool UsesCopy { get; private set; }

    /// <summary>True if the drawing has a field. A tag that is the name of a column counts only with a CSV file (<see cref="UsesColumnOf"/>).</summary>
    public bool Any => UsesDate || UsesCopy || _columns.Count > 0 || _counters.Count > 0;

    /// <summary>Counters with two designs.</summary>
    public IReadOnlyList<Diagnostic> Findings => _findings;

    /// <param name="texts">The texts that are engraved.</param>
    public static PlateFields Of(IEnumerable<PlacedText> texts)
    {
        var fields = new PlateFields([.. texts]);
        foreach (var text in fields._texts) fields.Add(text);
        return fields;
    }

    /// <summary>Whether a text is filled from this CSV file.</summary>
    public bool UsesColumnOf(CsvTable table)
    {
        ArgumentNullException.ThrowIfNull(table);
        return table.Columns.Any(IsUsed);
    }

    /// <summary>The columns of a CSV file from which no text is filled.</summary>
    public IReadOnlyList<string> UnusedColumnsOf(CsvTable table)
    {
        ArgumentNullException.ThrowIfNull(table);
        return [.. table.Columns.Where(column => !IsUsed(column))];
    }

    /// <summary>The values of a row that the texts use; a record of the plate need not hold the others. A row without a column that a field names is returned
    /// whole: its plate cannot be engraved, and the finding about the field lists the columns.</summary>
    public CsvRow Used(CsvRow row)
    {
        ArgumentNullException.ThrowIfNull(row);
        return _columns.Any(column => row.Find(column) is null) ? row : row with { Columns = [.. row.Columns.Where(one => IsUsed(one.Column))] };
    }

    /// <summary>Fields that have no value on a plate, and brackets that are not fields, each with its place in the drawing.</summary>
    public IReadOnlyList<Diagnostic> Check(PlateValues values)
    {
        ArgumentNullException.ThrowIfNull(values);
        return [.. _findings, .. _texts.SelectMany(text => values.ProblemsIn(text.Written.Raw, text.Written.Tag).Select(problem => problem.At(text.Source)))];
    }

    /// <summary>The values of a plate, without those that the texts do not use.</summary>
    /// <param name="row">Null without a CSV file.</param>
    /// <param name="numbers">By counter.</param>
    public PlateValues ValuesOf(CsvRow? row, IReadOnlyDictionary<string, long> numbers, DateTimeOffset now, int copy) => new()
    {
        Counters = numbers.Where(one => _counters.ContainsKey(one.Key)).ToImmutableSortedDictionary(StringComparer.OrdinalIgnoreCase),
        Date = UsesDate ? now.AddTicks(-(now.Ticks % TimeSpan.TicksPerSecond)) : null,
        Row = row is null ? null : Used(row),
        Copy = UsesCopy ? copy : null,
    };

    private void Add(PlacedText text)
    {
        var fields = SerialFieldReader.In(text.Written.Raw);
        if (text.Written.Tag.Length > 0 && fields.All(field => field is SerialField.Brackets)) _tags.Add(text.Written.Tag);
        foreach (var field in fields)
        {
            UsesDate |= field is SerialField.Date;
            UsesCopy |= field is SerialField.Copy;
            if (field is SerialField.Column column) _columns.Add(column.Name);
            if (field is SerialField.Counter counter) Add(counter, text);
        }
    }

    private void Add(SerialField.Counter counter, PlacedText text)
    {
        var (start, step) = _counters.GetValueOrDefault(counter.Name);
        if (Differs(start, counter.Start) || Differs(step, counter.Increment)) _findings.Add(SerialRules.TwoDesigns.At(text.Source, counter.Name, counter.Written));
        _counters[counter.Name] = (start ?? counter.Start, step ?? counter.Increment);
    }

    private static bool Differs(long? one, long? other) => one is { } first && other is { } second && first != second;

    private bool IsUsed(string column) => _columns.Contains(column) || _tags.Contains(column);
}
