using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>One of the values of an enumeration: its names in lower case at the console and in files, as they are at the command.</summary>
public class ChoiceSetting<T>(string key, Func<DrawingSettings, T> get, Func<DrawingSettings, T, DrawingSettings> with) : Setting<T>(key, get, with)
    where T : struct, Enum
{
    public override string? Argument => string.Join('|', OptionNames);

    public override IReadOnlyList<string> OptionWords => OptionNames;

    public override bool IsOneWord => true;

    public override string? OptionDefault => DefaultText;

    public override IReadOnlyList<string> Choices => [.. Enum.GetNames<T>().Select(InputName)];

    private static IReadOnlyList<string> OptionNames => [.. Enum.GetValues<T>().Select(Lower)];

    public override ParsedInput<T> ReadOption(string typed) => OptionNames.Contains(typed) ? new ParsedInput<T>.Value(Enum.Parse<T>(typed, ignoreCase: true)) : new ParsedInput<T>.Invalid(Wording.Get("ChoiceSetting.NotAChoice", typed, string.Join(", ", OptionNames)));

    public override string ToInput(DrawingSettings settings) => InputName(Get(settings).ToString());

    /// <summary>The value of one of <see cref="Setting.Choices"/>.</summary>
    public T ParseInput(string choice) => ParseWord(choice);

    /// <summary>A value as the command offers it: the capitals are the short form.</summary>
    protected virtual string InputName(string name) => name;

    protected override string? WordOf(T value) => Lower(value);

    protected override T ParseWord(string word) => Enum.TryParse<T>(word, ignoreCase: true, out var choice) && Enum.IsDefined(choice) ? choice : throw new FormatException(word);

    private static string Lower(T value) => value.ToString().ToLowerInvariant();
}
