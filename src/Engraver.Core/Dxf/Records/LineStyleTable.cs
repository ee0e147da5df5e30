using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Records;

/// <summary>Assigns small numbers to the line styles of the entities. Most entities of a drawing have one of a few.</summary>
internal sealed class LineStyleTable
{
    /// <summary>Flag of a polyline whose pattern runs through its vertices (PLINEGEN). DXF reference, "LWPOLYLINE", group 70.</summary>
    private const int RunsThrough = 128;

    private readonly List<LineStyle> _styles = [LineStyle.ByLayer];
    private readonly Dictionary<LineStyle, int> _numbers = new() { [LineStyle.ByLayer] = 0 };

    /// <summary>The number that was looked up last: most entities follow one of the same style.</summary>
    private int _last;

    public IReadOnlyList<LineStyle> Styles => _styles;

    /// <summary>The number of the style of a record.</summary>
    public int NumberOf(EntityRecord record)
    {
        var through = record.Kind is RecordKind.LwPolyline or RecordKind.Polyline && (record.Flags(70) & RunsThrough) != 0;
        return NumberOf(new LineStyle(record.Linetype, record.LinetypeScale, through) { Lineweight = record.Lineweight ?? Lineweight.ByLayer, Width = record.Width });
    }

    /// <summary>The style of a copy of a block: "by block" is resolved, and a width is scaled.</summary>
    /// <param name="linetype">Linetype of the insert.</param>
    /// <param name="lineweight">Lineweight of the insert.</param>
    /// <param name="at">Where the copy is.</param>
    public int Resolved(int number, int linetype, int lineweight, in Placement at)
    {
        var style = _styles[number];
        if (style.Linetype != Linetype.ByBlock && style.Lineweight != Lineweight.ByBlock && style.Width == 0.0) return number;
        return NumberOf(style with
        {
            Linetype = style.Linetype == Linetype.ByBlock ? linetype : style.Linetype,
            Lineweight = style.Lineweight == Lineweight.ByBlock ? lineweight : style.Lineweight,
            Width = style.Width == 0.0 ? 0.0 : style.Width * ScaleOf(at),
        });
    }

    /// <summary>The scale of a placement in plan; NaN where it is not the same in every direction.</summary>
    private static double ScaleOf(in Placement at)
    {
        const double rounding = 1e-9;
        var (x, y) = (at.ApplyToDirection(new Vector3D(1.0, 0.0, 0.0)), at.ApplyToDirection(new Vector3D(0.0, 1.0, 0.0)));
        var scale = x.Length;
        return Math.Abs(y.Length - scale) <= rounding * scale && Math.Abs(x.Dot(y)) <= rounding * scale * scale ? scale : double.NaN;
    }

    private int NumberOf(in LineStyle style)
    {
        if (_styles[_last] == style) return _last;
        if (_numbers.TryGetValue(style, out var number)) return _last = number;
        _styles.Add(style);
        return _last = _numbers[style] = _styles.Count - 1;
    }
}
