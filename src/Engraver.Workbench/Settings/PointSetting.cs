using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>A point of the drawing, mm.</summary>
public sealed class PointSetting(string key, Func<DrawingSettings, Point2D> get, Func<DrawingSettings, Point2D, DrawingSettings> with) : Setting<Point2D>(key, get, with)
{
    public override string? Argument => "X,Y";

    public override ParsedInput<Point2D> ReadOption(string typed) => TryTyped(typed) is { } point ? new ParsedInput<Point2D>.Value(point) : new ParsedInput<Point2D>.Invalid(Wording.Get("PointSetting.NotAPoint", typed));

    /// <summary>A point typed as X,Y; null for another text.</summary>
    public static Point2D? TryTyped(string typed) =>
        typed.Split(',') is [var first, var second] && NumberPrompt.TryParse(first, out var x) && NumberPrompt.TryParse(second, out var y) ? new Point2D(x, y) : null;

    /// <summary>The point exactly.</summary>
    public static string Exact(Point2D point) => $"{TypedNumber.Exact(point.X)},{TypedNumber.Exact(point.Y)}";

    /// <summary>The point of two numbers that <see cref="Exact"/> wrote; null for a text that does not have two parts.</summary>
    /// <exception cref="FormatException">A part is not a number.</exception>
    public static Point2D? Parse(string word) => word.Split(',') is [var x, var y] ? new Point2D(TypedNumber.Parse(x), TypedNumber.Parse(y)) : null;

    protected override string WordOf(Point2D value) => Exact(value);

    protected override Point2D ParseWord(string word) => Parse(word) ?? throw new FormatException(word);
}
