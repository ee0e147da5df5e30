using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Divides a figure into its dashes.</summary>
internal sealed class DashCutter
{
    private const double MinPatternLength = 1e-6;

    /// <summary>A pattern with more dashes over the whole figure is drawn solid.</summary>
    private const int MaxDashes = 100_000;

    private readonly double[] _lengths;
    private readonly double _offset;
    private readonly double _total;

    public DashCutter(StrokeStyle style)
    {
        var dashes = style.Dashes ?? [];
        var isOdd = dashes.Count % 2 != 0;
        _lengths = [.. (isOdd ? dashes.Concat(dashes) : dashes).Select(dash => Math.Max(0, dash) * style.Width)];
        _total = _lengths.Sum();
        _offset = _total > MinPatternLength ? style.DashOffset * style.Width % _total : 0;
        if (_offset < 0)
            _offset += _total;
    }

    public IEnumerable<Polyline> Cut(Polyline figure)
    {
        var length = Enumerable.Range(0, figure.SegmentCount).Sum(i => Length(figure.Segment(i)));
        if (_total <= MinPatternLength || length / _total * _lengths.Length > MaxDashes)
            return [figure];
        return CutAll(figure);
    }

    private IEnumerable<Polyline> CutAll(Polyline figure)
    {
        var (phase, left) = Start();
        var dash = phase % 2 == 0 ? NewDash(figure.Points[0]) : null;
        for (var i = 0; i < figure.SegmentCount; i++)
        {
            var (start, end) = figure.Segment(i);
            var length = Length((start, end));
            var at = 0.0;
            while (length - at > left)
            {
                at += left;
                var point = start + (end - start) * (at / length);
                if (dash is not null)
                {
                    dash.Points.Add(point);
                    yield return dash;
                }
                phase = (phase + 1) % _lengths.Length;
                dash = phase % 2 == 0 ? NewDash(point) : null;
                left = _lengths[phase];
            }
            left -= length - at;
            dash?.Points.Add(end);
        }
        if (dash is { Points.Count: > 1 })
            yield return dash;
    }

    private (int Phase, double Left) Start()
    {
        var phase = 0;
        var into = _offset;
        while (into >= _lengths[phase])
        {
            into -= _lengths[phase];
            phase = (phase + 1) % _lengths.Length;
        }
        return (phase, _lengths[phase] - into);
    }

    private static Polyline NewDash(Vector point)
    {
        var dash = new Polyline();
        dash.Points.Add(point);
        return dash;
    }

    private static double Length((Vector Start, Vector End) segment) => (segment.End - segment.Start).Length;
}
