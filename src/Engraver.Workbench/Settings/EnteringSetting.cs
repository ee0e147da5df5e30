using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Where cutting begins: an entity by its handle, or the point of the drawing; null for free choice.</summary>
public sealed class EnteringSetting(string key, Func<DrawingSettings, EnteringPlace?> get, Func<DrawingSettings, EnteringPlace?, DrawingSettings> with) : Setting<EnteringPlace?>(key, get, with)
{
    private const int LongestHandle = 16;

    public override string? Argument => "HANDLE|X,Y";

    public override Reading<EnteringPlace?> ReadOption(string typed)
    {
        if (PointSetting.TryTyped(typed) is { } point) return new Reading<EnteringPlace?>.Value(new EnteringPlace.ByPoint(point));
        return typed.Length <= LongestHandle && typed.All(char.IsAsciiHexDigit) ? new Reading<EnteringPlace?>.Value(new EnteringPlace.ByHandle(typed)) : new Reading<EnteringPlace?>.Wrong(Wording.Get("EnteringSetting.NotAPlace", typed));
    }

    protected override string? WordOf(EnteringPlace? value) => value switch
    {
        EnteringPlace.ByPoint { Point: var point } => PointSetting.Exact(point),
        EnteringPlace.ByHandle { Handle: var handle } => handle,
        _ => null,
    };

    protected override EnteringPlace ParseWord(string word) => PointSetting.Parse(word) is { } point ? new EnteringPlace.ByPoint(point) : new EnteringPlace.ByHandle(word);
}
