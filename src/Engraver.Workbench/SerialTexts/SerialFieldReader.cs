using System.Globalization;
using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.SerialTexts;

/// <summary>Finds the fields in the string of a text (docs/serial-text.md).</summary>
public static class SerialFieldReader
{
    /// <summary>Name of the counter of <c>[[n:0000]]</c>.</summary>
    public const string DefaultCounter = "n";

    /// <summary>Largest number of a counter or a copy.</summary>
    public const long MaxNumber = 999_999_999_999_999;

    private const string Open = "[[";
    private const string Close = "]]";
    private const int MaxDigits = 15;

    /// <summary>Everything that begins with two brackets, in the order of the string.</summary>
    /// <param name="raw">As written in the drawing: codes are not resolved.</param>
    public static IReadOnlyList<SerialField> In(string raw)
    {
        ArgumentNullException.ThrowIfNull(raw);
        var fields = new List<SerialField>();
        for (var at = raw.IndexOf(Open, StringComparison.Ordinal); at >= 0; at = raw.IndexOf(Open, fields[^1].End, StringComparison.Ordinal)) fields.Add(FieldAt(raw, at));
        return fields;
    }

    /// <summary>True for the name of a counter: a letter, then letters, digits, '-' and '_'.</summary>
    public static bool IsCounterName(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        return name.Length > 0 && char.IsLetter(name[0]) && name.All(letter => char.IsLetterOrDigit(letter) || letter is '-' or '_');
    }

    private static SerialField FieldAt(string raw, int at)
    {
        var close = raw.IndexOf(Close, at + Open.Length, StringComparison.Ordinal);
        var inner = raw.LastIndexOf(Open, Math.Max(close - 1, at), StringComparison.Ordinal);
        if (close < 0) return new SerialField.Brackets(at, raw[at..]);
        if (inner > at) return new SerialField.Brackets(at, raw[at..inner]); // the brackets before the last pair do not belong to it
        var written = raw[at..(close + Close.Length)];
        var content = CharacterEscapes.Resolved(raw[(at + Open.Length)..close]);
        var colon = content.IndexOf(':', StringComparison.Ordinal);
        var head = (colon < 0 ? content : content[..colon]).Split(' ', 2, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (head.Length == 0 || !head[0].All(char.IsLetter)) return new SerialField.Brackets(at, written);
        var (name, format) = (head.Length > 1 ? head[1] : null, colon < 0 ? null : content[(colon + 1)..]);
        return (head[0].ToUpperInvariant(), name) switch
        {
            ("N", _) => Counter(at, written, name ?? DefaultCounter, format),
            ("COPY", null) => Copy(at, written, format),
            ("DATE", null) => Date(at, written, format),
            ("CSV", null) => Column(at, written, format),
            _ => new SerialField.Invalid(at, written, Wording.Get("Serial.UnknownField", content)),
        };
    }

    private static SerialField Counter(int at, string written, string name, string? format)
    {
        if (!IsCounterName(name)) return new SerialField.Invalid(at, written, Wording.Get("Serial.InvalidCounterName", name));
        var (start, step) = (default(long?), default(long?));
        var parts = (format ?? "0").Split(';', StringSplitOptions.TrimEntries);
        if (DigitsOf(parts[0]) is not { } digits) return InvalidDigits(at, written, parts[0]);
        foreach (var part in parts.Skip(1))
        {
            var equals = part.IndexOf('=', StringComparison.Ordinal);
            var key = equals < 0 ? part : part[..equals].TrimEnd();
            var isNumber = long.TryParse(equals < 0 ? "" : part[(equals + 1)..].Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var value);
            if (key.Equals("start", StringComparison.OrdinalIgnoreCase) && isNumber && value is >= 0 and <= MaxNumber) start = value;
            else if (key.Equals("step", StringComparison.OrdinalIgnoreCase) && isNumber && value is not 0 and >= -MaxNumber and <= MaxNumber) step = value;
            else return new SerialField.Invalid(at, written, Wording.Get("Serial.InvalidCounterOption", part, MaxNumber));
        }

        return new SerialField.Counter(at, written, name, digits, start, step);
    }

    private static SerialField Copy(int at, string written, string? format) =>
        DigitsOf(format ?? "0") is { } digits ? new SerialField.Copy(at, written, digits) : InvalidDigits(at, written, format!);

    private static SerialField Date(int at, string written, string? format)
    {
        var (read, reason) = DateFormat.Read(format ?? DateFormat.Default);
        return read is null ? new SerialField.Invalid(at, written, reason) : new SerialField.Date(at, written, read);
    }

    private static SerialField Column(int at, string written, string? format)
    {
        var name = (format ?? "").Trim();
        var isOptional = name.EndsWith('?');
        if (isOptional) name = name[..^1].TrimEnd();
        return name.Length == 0 ? new SerialField.Invalid(at, written, Wording.Get("Serial.NoColumnName")) : new SerialField.Column(at, written, name, isOptional);
    }

    private static SerialField.Invalid InvalidDigits(int at, string written, string format) => new(at, written, Wording.Get("Serial.InvalidDigits", format.Trim(), MaxDigits));

    /// <summary>The number of zeros; null for another format.</summary>
    private static int? DigitsOf(string format) => format.Trim() is { Length: > 0 and <= MaxDigits } zeros && zeros.All(letter => letter == '0') ? zeros.Length : null;
}
