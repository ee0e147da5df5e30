using System.Runtime.InteropServices;

namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>The points of a TrueType glyph with its components: points on the curve and control points between them.</summary>
internal sealed class GlyphPoints
{
    /// <summary>More than any glyph has; fonts that refer to their components in vast numbers end here.</summary>
    private const int MaxPoints = 1 << 17;

    private readonly List<FontPoint> _points = [];
    private readonly List<bool> _isOnCurve = [];
    private readonly List<int> _ends = [];

    public int Count => _points.Count;

    /// <exception cref="BrokenFontException">There is no such point.</exception>
    public FontPoint this[int index] =>
        index >= 0 && index < _points.Count ? _points[index] : throw new BrokenFontException("A glyph refers to a point that it does not have.");

    public void Add(FontPoint point, bool isOnCurve)
    {
        if (_points.Count == MaxPoints)
            throw new BrokenFontException("A glyph has too many points.");
        _points.Add(point);
        _isOnCurve.Add(isOnCurve);
    }

    public void EndContour() => _ends.Add(_points.Count);

    /// <summary>Replaces each point from <paramref name="first"/> on.</summary>
    public void Change(int first, Func<FontPoint, FontPoint> change)
    {
        foreach (ref var point in CollectionsMarshal.AsSpan(_points)[first..])
            point = change(point);
    }

    public void Draw(IOutlineSink sink)
    {
        var first = 0;
        foreach (var end in _ends)
        {
            DrawContour(sink, CollectionsMarshal.AsSpan(_points)[first..end], CollectionsMarshal.AsSpan(_isOnCurve)[first..end]);
            first = end;
        }
    }

    /// <summary>A point on the curve is implied halfway between two consecutive control points.</summary>
    private static void DrawContour(IOutlineSink sink, ReadOnlySpan<FontPoint> points, ReadOnlySpan<bool> isOnCurve)
    {
        if (points.Length < 2)
            return;
        var count = points.Length;
        var first = isOnCurve.IndexOf(true);
        var start = first >= 0 ? points[first] : Middle(points[0], points[count - 1]);
        sink.MoveTo(start);
        var after = first + 1;
        var remaining = first >= 0 ? count - 1 : count;
        for (var i = 0; i < remaining; i++)
        {
            var current = (after + i) % count;
            if (isOnCurve[current])
            {
                sink.LineTo(points[current]);
                continue;
            }
            var next = (current + 1) % count;
            var isLast = i == remaining - 1;
            var nextIsOn = !isLast && isOnCurve[next];
            sink.QuadraticTo(points[current], isLast ? start : nextIsOn ? points[next] : Middle(points[current], points[next]));
            if (nextIsOn)
                i++;
        }
        sink.Close();
    }

    private static FontPoint Middle(FontPoint a, FontPoint b) => new((a.X + b.X) / 2, (a.Y + b.Y) / 2);
}
