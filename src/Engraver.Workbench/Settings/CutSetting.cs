using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Construction that is cut: words at the console, the sum of their bits at the command and in files.</summary>
public sealed class CutSetting : Setting<CutChoice>
{
    private static readonly int s_every = Enum.GetValues<CutChoice>().Aggregate(0, (all, one) => all | (int)one);

    public CutSetting(string key, Func<DrawingSettings, CutChoice> get, Func<DrawingSettings, CutChoice, DrawingSettings> with)
        : base(key, get, with) => (Min, Max, Whole) = (0, s_every, true);

    public override string? Argument => string.Join(',', OptionWords);

    public override bool OptionMayBeEmpty => true;

    public override IReadOnlyList<string> OptionWords => [.. Enum.GetValues<CutChoice>().Where(choice => choice != CutChoice.None).Select(choice => choice.ToString().ToLowerInvariant())];

    public override ParsedInput<CutChoice> ReadOption(string typed)
    {
        var choice = CutChoice.None;
        foreach (var word in NamesSetting.Split(typed))
        {
            if (!char.IsAsciiLetter(word[0]) || !Enum.TryParse<CutChoice>(word, ignoreCase: true, out var one)) return new ParsedInput<CutChoice>.Invalid(Wording.Get("CutSetting.CannotBeCut", word, string.Join(", ", OptionWords)));
            choice |= one;
        }

        return new ParsedInput<CutChoice>.Value(choice);
    }

    protected override string WordOf(CutChoice value) => TypedNumber.Exact((int)value);

    protected override CutChoice ParseWord(string word) => TypedNumber.Parse(word) is var value && value >= 0.0 && value <= s_every && value == Math.Floor(value) ? (CutChoice)(int)value : throw new FormatException(word);
}
