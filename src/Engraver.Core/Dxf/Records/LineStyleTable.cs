using Engraver.Core.Drawings;

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
        return record.Linetype == Linetype.ByLayer && record.LinetypeScale == 1.0 && !through ? 0 : NumberOf(new LineStyle(record.Linetype, record.LinetypeScale, through));
    }

    /// <summary>The style with a linetype instead of "by block".</summary>
    /// <param name="linetype">Linetype of the insert.</param>
    public int Resolved(int style, int linetype) => style == 0 || _styles[style].Linetype != Linetype.ByBlock ? style : NumberOf(_styles[style] with { Linetype = linetype });

    private int NumberOf(in LineStyle style)
    {
        if (_styles[_last] == style) return _last;
        if (_numbers.TryGetValue(style, out var number)) return _last = number;
        _styles.Add(style);
        return _last = _numbers[style] = _styles.Count - 1;
    }
}
