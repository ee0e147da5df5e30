using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Where cutting begins: an entity by its handle, or the point of the drawing; null for free choice.</summary>
public sealed class EnteringSetting(string key, Func<DrawingSettings, ContourEntry?> get, Func<DrawingSettings, ContourEntry?, DrawingSettings> with) : Setting<ContourEntry?>(key, get, with)
{
    private const int LongestHandle = 16;

    public override string? Argument => "HANDLE|X,Y";

    public override ParsedInput<ContourEntry?> ReadOption(string typed)
    {
        if (PointSetting.TryTyped(typed) is { } point) return new ParsedInput<ContourEntry?>.Value(new ContourEntry.ByPoint(point));
        return typed.Length <= LongestHandle && typed.All(char.IsAsciiHexDigit) ? new ParsedInput<ContourEntry?>.Value(new ContourEntry.ByHandle(typed)) : new ParsedInput<ContourEntry?>.Invalid(Wording.Get("EnteringSetting.NotAPlace", typed));
    }

    protected override string? WordOf(ContourEntry? value) => value switch
    {
        ContourEntry.ByPoint { Point: var point } => PointSetting.Exact(point),
        ContourEntry.ByHandle { Handle: var handle } => handle,
        _ => null,
    };

    protected override ContourEntry ParseWord(string word) => PointSetting.Parse(word) is { } point ? new ContourEntry.ByPoint(point) : new ContourEntry.ByHandle(word);
}
