using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Answers whether the tool passed near a place while cutting. Only consecutive samples that are both cutting are joined; a lone one is a dot.</summary>
internal sealed class TraceIndex
{
    private readonly List<LineSegment> _edges = [];
    private readonly BoxTree _tree;
    private readonly BoxTree.Measure _measure;
    private int _last;

    public TraceIndex(IReadOnlyList<TraceSample> trace)
    {
        for (var i = 0; i < trace.Count; i++)
        {
            if (!trace[i].Cutting) continue;
            var isJoined = i > 0 && trace[i - 1].Cutting;
            var from = isJoined ? trace[i - 1].Place : trace[i].Place;
            if (!isJoined || from != trace[i].Place) _edges.Add(new LineSegment(from, trace[i].Place));
        }

        var boxes = new Bounds2D[_edges.Count];
        for (var i = 0; i < boxes.Length; i++) boxes[i] = _edges[i].Bounds;
        _tree = BoxTree.Of(boxes);
        _measure = (edge, place) => _edges[edge].DistanceTo(place);
    }

    /// <summary>True when a cut passed within <paramref name="tolerance"/>. Quick when questions follow a path: the edges after the last answer are tried first.</summary>
    public bool PassedNear(Point2D place, double tolerance)
    {
        for (var edge = _last; edge < Math.Min(_last + 4, _edges.Count); edge++)
        {
            if (_edges[edge].DistanceTo(place) > tolerance) continue;
            _last = edge;
            return true;
        }

        var nearest = _tree.Nearest(place, _measure, tolerance, out _);
        if (nearest < 0) return false;
        _last = nearest;
        return true;
    }
}
