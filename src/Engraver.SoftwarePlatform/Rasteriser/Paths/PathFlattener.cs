using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Converts a path to polylines, without points that repeat their predecessor.</summary>
internal static class PathFlattener
{
    private const double SamePoint = 1e-12;

    public static List<Polyline> Flatten(VectorPath path, in Matrix transform, double tolerance)
    {
        var sink = new Collector([]);
        PathWalk.Walk(path, transform, tolerance, ref sink);
        return sink.Figures;
    }

    private struct Collector(List<Polyline> figures) : IPolylineSink
    {
        private Polyline? _open;
        private Vector _start;

        public readonly List<Polyline> Figures => figures;

        public void MoveTo(double x, double y)
        {
            _start = new Vector(x, y);
            Begin();
        }

        public void LineTo(double x, double y)
        {
            if (_open is null)
                Begin();
            var point = new Vector(x, y);
            if ((point - _open!.Points[^1]).SquaredLength > SamePoint)
                _open.Points.Add(point);
        }

        public void Close()
        {
            if (_open is null)
                return;
            _open.IsClosed = true;
            if (_open.Points.Count > 1 && (_open.Points[^1] - _open.Points[0]).SquaredLength <= SamePoint)
                _open.Points.RemoveAt(_open.Points.Count - 1);
            _open = null;
        }

        private void Begin()
        {
            _open = new Polyline();
            _open.Points.Add(_start);
            figures.Add(_open);
        }
    }
}
