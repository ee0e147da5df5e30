using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Two different points, mm; null for none, which is not kept.</summary>
public sealed class PointPairSetting(string key, Func<DrawingSettings, PointPair?> get, Func<DrawingSettings, PointPair?, DrawingSettings> with) : Setting<PointPair?>(key, get, with)
{
    public override ParsedInput<PointPair?> ReadOption(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed.Split(':') is [var one, var other] && PointSetting.TryTyped(one) is { } first && PointSetting.TryTyped(other) is { } second && first != second
            ? new ParsedInput<PointPair?>.Value(new PointPair(first, second))
            : new ParsedInput<PointPair?>.Invalid(Wording.Get("Setting.align.Invalid", typed));
    }

    protected override string? WordOf(PointPair? value) => value is { } pair ? $"{PointSetting.Exact(pair.First)}:{PointSetting.Exact(pair.Second)}" : null;

    protected override PointPair? ParseWord(string word) => ReadOption(word) is ParsedInput<PointPair?>.Value { Result: var pair } ? pair : throw new FormatException(word);
}
