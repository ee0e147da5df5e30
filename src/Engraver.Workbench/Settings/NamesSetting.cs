using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Names of layers; null where the drawing decides. The option has them separated by commas. Files keep a JSON list, because a name may contain any
/// letter.</summary>
public sealed partial class NamesSetting(string key, Func<DrawingSettings, IReadOnlyList<string>?> get, Func<DrawingSettings, IReadOnlyList<string>?, DrawingSettings> with)
    : Setting<IReadOnlyList<string>?>(key, get, with)
{
    /// <summary>Letters are not escaped: pages that show them escape them in their own way.</summary>
    private static readonly NamesJson s_json = new(new JsonSerializerOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });

    public override string? Argument => "A,B";

    public override bool OptionMayBeEmpty => true;

    public override ParsedInput<IReadOnlyList<string>?> ReadOption(string typed) => new ParsedInput<IReadOnlyList<string>?>.Value(Split(typed));

    /// <summary>Names separated by commas. A name that contains a comma is in double quotes, in which a double quote is written twice.</summary>
    public static IReadOnlyList<string> Split(string typed) =>
        [.. QuotedName().Matches(typed).Select(found => found.Groups["quoted"] is { Success: true, Value: var quoted } ? quoted.Replace("\"\"", "\"", StringComparison.Ordinal) : found.Groups["plain"].Value.Trim()).Where(name => name.Length > 0)];

    protected override string? WordOf(IReadOnlyList<string>? value) => value is null ? null : JsonSerializer.Serialize(value, s_json.IReadOnlyListString);

    protected override IReadOnlyList<string> ParseWord(string word)
    {
        try
        {
            return JsonSerializer.Deserialize(word, s_json.IReadOnlyListString) ?? throw new FormatException(word);
        }
        catch (JsonException broken)
        {
            throw new FormatException(word, broken);
        }
    }

    [GeneratedRegex("(?:^|,)\\s*(?:\"(?<quoted>(?:[^\"]|\"\")*)\"\\s*(?=,|$)|(?<plain>[^,]*))", RegexOptions.CultureInvariant)]
    private static partial Regex QuotedName();
}

[JsonSerializable(typeof(IReadOnlyList<string>))]
internal sealed partial class NamesJson : JsonSerializerContext;
