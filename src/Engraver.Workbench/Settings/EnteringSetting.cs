using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Where cutting begins: an entity by its handle, or the point of the drawing; null for free choice.</summary>
public sealed class EnteringSetting(string key, Func<DrawingSettings, EntryPoint?> get, Func<DrawingSettings, EntryPoint?, DrawingSettings> with) : Setting<EntryPoint?>(key, get, with)
{
    private const int LongestHandle = 16;

    public override string? Argument => "HANDLE|X,Y";

    public override ParsedInput<EntryPoint?> ReadOption(string typed)
    {
        if (PointSetting.TryTyped(typed) is { } point) return new ParsedInput<EntryPoint?>.Value(new EntryPoint.ByPoint(point));
        return typed.Length <= LongestHandle && typed.All(char.IsAsciiHexDigit) ? new ParsedInput<EntryPoint?>.Value(new EntryPoint.ByHandle(typed)) : new ParsedInput<EntryPoint?>.Invalid(Wording.Get("EnteringSetting.NotAPlace", typed));
    }

    protected override string? WordOf(EntryPoint? value) => value switch
    {
        EntryPoint.ByPoint { Point: var point } => PointSetting.Exact(point),
        EntryPoint.ByHandle { Handle: var handle } => handle,
        _ => null,
    };

    protected override EntryPoint ParseWord(string word) => PointSetting.Parse(word) is { } point ? new EntryPoint.ByPoint(point) : new EntryPoint.ByHandle(word);
}
