using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>A displacement, mm. Not kept where it is 0.</summary>
public class MoveSetting(string key, Func<DrawingSettings, Vector2D> get, Func<DrawingSettings, Vector2D, DrawingSettings> with) : Setting<Vector2D>(key, get, with)
{
    public override string? Argument => "X,Y";

    protected override string DefaultText => PointSetting.Exact(Point2D.Origin);

    public override ParsedInput<Vector2D> ReadOption(string typed) => PointSetting.TryTyped(typed) is { } point
        ? new ParsedInput<Vector2D>.Value(point - Point2D.Origin)
        : new ParsedInput<Vector2D>.Invalid(Wording.Get("PointSetting.NotAPoint", typed));

    protected override string? WordOf(Vector2D value) => value == default ? null : PointSetting.Exact(Point2D.Origin + value);

    protected override Vector2D ParseWord(string word) => (PointSetting.Parse(word) ?? throw new FormatException(word)) - Point2D.Origin;
}
