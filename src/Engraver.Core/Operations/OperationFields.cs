using System.Globalization;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Reads the fields of one JSON object of an operations file or a tool library, and reports those that are unknown, missing or invalid, each with its
/// line.</summary>
internal sealed class OperationFields
{
    private const double LargestCoordinate = 1e6;

    private readonly JsonElement _object;
    private readonly string _path;
    private readonly JsonFields _lines;
    private readonly List<Diagnostic> _findings;

    /// <param name="path">Path of the object in the file; empty for the file itself.</param>
    /// <param name="known">The names that are allowed in it.</param>
    public OperationFields(JsonElement value, string path, JsonFields lines, IReadOnlyList<string> known, List<Diagnostic> findings)
    {
        (_object, _path, _lines, _findings) = (value, path, lines, findings);
        if (value.ValueKind != JsonValueKind.Object)
        {
            Invalid(_path, Shown(value), Wording.Get("OperationFile.Object"));
            return;
        }

        foreach (var field in value.EnumerateObject().Where(field => !known.Contains(field.Name))) findings.Add(OperationRules.FieldUnknown.At(SourceOf(PathOf(field.Name)), PathOf(field.Name), JsonFields.Nearest(field.Name, known)));
    }

    public bool Has(string name) => Find(name) is not null;

    /// <summary>The value of a field; null when it is missing or JSON null.</summary>
    public JsonElement? Find(string name) => _object.ValueKind == JsonValueKind.Object && _object.TryGetProperty(name, out var value) && value.ValueKind != JsonValueKind.Null ? value : null;

    public JsonElement? Required(string name)
    {
        if (Find(name) is { } value) return value;
        if (_object.ValueKind == JsonValueKind.Object) _findings.Add(OperationRules.FieldMissing.At(SourceOf(_path), PathOf(name)));
        return null;
    }

    /// <summary>A number in a range; null when the field is missing or invalid.</summary>
    public double? Number(string name, double above, double most, bool includesLowest)
    {
        if (Find(name) is not { } value) return null;
        if (value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out var number) && number <= most && (includesLowest ? number >= above : number > above)) return number;
        Invalid(PathOf(name), Shown(value), Wording.Get(includesLowest ? "OperationFile.NumberFrom" : "OperationFile.NumberAbove", above, most));
        return null;
    }

    /// <summary>A whole number in a range; null when the field is missing or invalid.</summary>
    public int? Whole(string name, int least, int most)
    {
        if (Find(name) is not { } value) return null;
        if (value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out var number) && number >= least && number <= most) return number;
        Invalid(PathOf(name), Shown(value), Wording.Get("OperationFile.Whole", least, most));
        return null;
    }

    public bool Switch(string name, bool otherwise)
    {
        if (Find(name) is not { } value) return otherwise;
        if (value.ValueKind is JsonValueKind.True or JsonValueKind.False) return value.GetBoolean();
        Invalid(PathOf(name), Shown(value), Wording.Get("OperationFile.Switch"));
        return otherwise;
    }

    public string? Text(string name)
    {
        if (Find(name) is not { } value) return null;
        if (value.ValueKind == JsonValueKind.String) return value.GetString();
        Invalid(PathOf(name), Shown(value), Wording.Get("OperationFile.Text"));
        return null;
    }

    /// <summary>One of the names of an enumeration, in camel case.</summary>
    public T? Choice<T>(string name)
        where T : struct, Enum
    {
        if (Find(name) is not { } value) return null;
        var words = Enum.GetValues<T>().ToDictionary(WordOf);
        if (value.ValueKind == JsonValueKind.String && words.TryGetValue(value.GetString()!, out var choice)) return choice;
        Invalid(PathOf(name), Shown(value), string.Join(", ", words.Keys));
        return null;
    }

    /// <summary>A list of texts or numbers, as texts; empty when the field is missing.</summary>
    public IReadOnlyList<string> Texts(string name, Func<string, bool> isValid, string allowed)
    {
        if (Find(name) is not { } value) return [];
        if (value.ValueKind != JsonValueKind.Array)
        {
            Invalid(PathOf(name), Shown(value), Wording.Get("OperationFile.List"));
            return [];
        }

        List<string> texts = [.. value.EnumerateArray().Select(item => item.ValueKind == JsonValueKind.String ? item.GetString()! : item.GetRawText())];
        foreach (var text in texts.Where(text => !isValid(text))) Invalid(PathOf(name), text, allowed);
        return texts;
    }

    /// <summary>A list of places, each a list of two numbers, millimetres; empty when the field is missing.</summary>
    public IReadOnlyList<Point2D> Places(string name)
    {
        if (Find(name) is not { } value) return [];
        if (value.ValueKind != JsonValueKind.Array)
        {
            Invalid(PathOf(name), Shown(value), Wording.Get("OperationFile.List"));
            return [];
        }

        var places = new List<Point2D>();
        foreach (var item in value.EnumerateArray())
        {
            if (item.ValueKind == JsonValueKind.Array && item.GetArrayLength() == 2 && Coordinate(item[0]) is { } x && Coordinate(item[1]) is { } y) places.Add(new Point2D(x, y));
            else Invalid(PathOf(name), Shown(item), Wording.Get("OperationFile.Place", LargestCoordinate));
        }

        return places;
    }

    public void Invalid(string field, string value, string allowed) => _findings.Add(OperationRules.ValueInvalid.At(SourceOf(field), field, value, allowed));

    public string PathOf(string name) => _path.Length == 0 ? name : $"{_path}.{name}";

    internal static IReadOnlyList<string> WordsOf<T>()
        where T : struct, Enum => [.. Enum.GetValues<T>().Select(WordOf)];

    internal static string WordOf<T>(T value)
        where T : struct, Enum => char.ToLowerInvariant(value.ToString()[0]) + value.ToString()[1..];

    /// <summary>A value as messages show it, shortened.</summary>
    internal static string Shown(JsonElement value)
    {
        var text = value.ValueKind == JsonValueKind.String ? value.GetString()! : value.GetRawText();
        return text.Length <= 40 ? text : string.Create(CultureInfo.InvariantCulture, $"{text.AsSpan(0, 40)}...");
    }

    private static double? Coordinate(JsonElement value) => value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out var number) && Math.Abs(number) <= LargestCoordinate ? number : null;

    private SourceRef SourceOf(string path) => new(path.Length == 0 ? 1 : _lines.LineOf(path));
}
