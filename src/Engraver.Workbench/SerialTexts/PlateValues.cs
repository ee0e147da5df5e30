using System.Collections.Immutable;
using System.Globalization;
using System.Text;
using System.Text.Json;

namespace Engraver.Workbench.SerialTexts;

/// <summary>What the fields in the texts of a drawing stand for on one plate (docs/serial-text.md).</summary>
public sealed record PlateValues
{
    /// <summary>The words before the number of the row in <see cref="ToString"/>.</summary>
    internal const string RowWord = "csv row ";

    /// <summary>No values: strings remain as they are.</summary>
    public static PlateValues None { get; } = new();

    /// <summary>The number of each counter; upper and lower case of a name are the same.</summary>
    public ImmutableSortedDictionary<string, long> Counters { get; init; } = ImmutableSortedDictionary.Create<string, long>(StringComparer.OrdinalIgnoreCase);

    /// <summary>The date and time to engrave, local; null for none.</summary>
    public DateTimeOffset? Date { get; init; }

    /// <summary>Null without a CSV file.</summary>
    public CsvRow? Row { get; init; }

    /// <summary>The number of this plate in its run, from 1; null for none.</summary>
    public int? Copy { get; init; }

    /// <summary>True for <see cref="None"/>.</summary>
    public bool IsNone => Counters.IsEmpty && Date is null && Row is null && Copy is null;

    /// <summary>The string with its fields filled. The text of an attribute without fields is replaced by the column that has the name of its tag. A field
    /// without a value remains as written and is in <see cref="ProblemsIn"/>.</summary>
    /// <param name="raw">The string as written in the drawing, codes not resolved.</param>
    /// <param name="tag">The tag of an attribute; "" for other texts.</param>
    /// <returns>A string for the same reader of codes; values are characters in it, never codes.</returns>
    public string Fill(string raw, string tag)
    {
        ArgumentNullException.ThrowIfNull(tag);
        if (IsNone) return raw;
        var fields = SerialFieldReader.In(raw);
        var text = new StringBuilder();
        if (fields.All(field => field is SerialField.Brackets))
        {
            if (tag.Length == 0 || Row?.Find(tag) is not { Length: > 0 } column) return raw;
            LiteralText.Append(text, column);
            return text.ToString();
        }

        var done = 0;
        foreach (var field in fields)
        {
            if (ValueOf(field).Value is not { } value) continue;
            text.Append(raw, done, field.At - done);
            LiteralText.Append(text, value);
            done = field.End;
        }

        return text.Append(raw, done, raw.Length - done).ToString();
    }

    /// <summary>The fields of a string that have no value, and brackets that are not a field.</summary>
    /// <param name="raw">As for <see cref="Fill"/>.</param>
    /// <param name="tag">As for <see cref="Fill"/>.</param>
    public IReadOnlyList<FieldProblem> ProblemsIn(string raw, string tag)
    {
        ArgumentNullException.ThrowIfNull(tag);
        var fields = SerialFieldReader.In(raw);
        List<FieldProblem> problems = [.. fields.Select(field => (Field: field, Found: ValueOf(field))).Where(one => one.Found.Value is null).Select(one => new FieldProblem(one.Field, one.Found.Reason))];
        if (tag.Length > 0 && fields.All(field => field is SerialField.Brackets) && Row?.Find(tag) is { Length: 0 }) problems.Add(new FieldProblem(new SerialField.Column(0, tag, tag, false), EmptyValue(tag)));
        return problems;
    }

    public bool Equals(PlateValues? other) => other is not null && Date == other.Date && Copy == other.Copy && Row == other.Row && Counters.SequenceEqual(other.Counters);

    public override int GetHashCode() => HashCode.Combine(Date, Copy, Row, Counters.Count);

    /// <summary>One line for the journal, the history and the certificate, the same in every language: <c>n=42, csv row 3: NAME=Miller</c>. "" for
    /// none.</summary>
    public override string ToString()
    {
        List<string> parts = [.. Counters.Select(one => string.Create(CultureInfo.InvariantCulture, $"{one.Key}={one.Value}"))];
        if (Date is { } date) parts.Add(string.Create(CultureInfo.InvariantCulture, $"date={date:yyyy-MM-ddTHH:mm:sszzz}"));
        if (Copy is { } copy) parts.Add(string.Create(CultureInfo.InvariantCulture, $"copy={copy}"));
        if (Row is { } row) parts.Add(string.Create(CultureInfo.InvariantCulture, $"{RowWord}{row.Number}: {string.Join(", ", row.Columns.Select(column => $"{column.Column}={Quoted(column.Value)}"))}").TrimEnd(' ', ':'));
        return string.Join(", ", parts);
    }

    /// <summary>For the record of a run: <see cref="FromJson"/> returns the same values.</summary>
    public string ToJson() => JsonSerializer.Serialize(PlateValuesJson.From(this), SerialJsonContext.Default.PlateValuesJson);

    /// <exception cref="FormatException">The text is not such a record.</exception>
    public static PlateValues FromJson(string text)
    {
        try
        {
            return (JsonSerializer.Deserialize(text, SerialJsonContext.Default.PlateValuesJson) ?? throw new FormatException(Wording.Get("Serial.InvalidRecord"))).ToValues();
        }
        catch (Exception invalid) when (invalid is JsonException or ArgumentException)
        {
            throw new FormatException(Wording.Get("Serial.InvalidRecord"), invalid);
        }
    }

    /// <returns>The characters, or why there are none, without a full stop; neither for brackets that are not a field.</returns>
    private (string? Value, string Reason) ValueOf(SerialField field) => field switch
    {
        SerialField.Counter counter => Counters.TryGetValue(counter.Name, out var number) ? Number(number, counter.Digits) : (null, Wording.Get("Serial.NoCounter", counter.Name)),
        SerialField.Copy copy => Copy is { } number ? Number(number, copy.Digits) : (null, Wording.Get("Serial.NoCopy")),
        SerialField.Date date => Date is { } day ? (date.Format.Of(day), "") : (null, Wording.Get("Serial.NoDate")),
        SerialField.Column column => ValueOf(column),
        SerialField.Invalid invalid => (null, invalid.Reason),
        _ => (null, ""),
    };

    private (string? Value, string Reason) ValueOf(SerialField.Column column)
    {
        if (Row is null) return (null, Wording.Get("Serial.NoCsv"));
        if (Row.Find(column.Name) is not { } value) return (null, Wording.Get("Serial.NoColumn", column.Name, string.Join(", ", Row.Columns.Select(one => one.Column))));
        return value.Length > 0 || column.IsOptional ? (value, "") : (null, EmptyValue(column.Name));
    }

    private string EmptyValue(string column) => Wording.Get("Serial.EmptyValue", column, Row!.Number);

    /// <summary>A format of one digit has no limit; a longer one states the width of the place.</summary>
    private static (string? Value, string Reason) Number(long number, int digits)
    {
        var text = number.ToString(new string('0', digits), CultureInfo.InvariantCulture);
        return number < 0 || (digits > 1 && text.Length > digits) ? (null, Wording.Get("Serial.TooManyDigits", number, digits)) : (text, "");
    }

    private static string Quoted(string value) =>
        value.AsSpan().IndexOfAny(",\"\r\n\t") < 0 ? value : $"\"{value.Replace("\"", "\"\"", StringComparison.Ordinal).ReplaceLineEndings("\\n").Replace("\t", "\\t", StringComparison.Ordinal)}\"";
}
