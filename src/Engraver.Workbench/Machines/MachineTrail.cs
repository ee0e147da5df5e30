using Engraver.Core.Geometry;

namespace Engraver.Workbench.Machines;

/// <summary>The recent path of the machine: its last positions relative to the controller's zero, millimetres, the latest last. Any thread.</summary>
public sealed class MachineTrail
{
    private const int MaxPlaces = 400;

    /// <summary>Minimum distance between recorded positions, millimetres.</summary>
    private const double MinStep = 0.005;

    private readonly Lock _guard = new();
    private readonly Queue<Point2D> _places = new();
    private Point2D[] _shown = [];
    private Point2D? _last;
    private bool _isHoming;

    /// <summary>Returns the same list until the machine moves.</summary>
    public IReadOnlyList<Point2D> Places
    {
        get
        {
            lock (_guard) return _last is null || _shown.Length > 0 ? _shown : _shown = [.. _places];
        }
    }

    /// <summary>True during homing: the zero changes, so positions before and after it are not connected.</summary>
    internal bool IsHoming
    {
        set
        {
            lock (_guard) _isHoming = value;
            Clear();
        }
    }

    internal void Clear()
    {
        lock (_guard)
        {
            _places.Clear();
            (_shown, _last) = ([], null);
        }
    }

    internal void Add(Point2D place)
    {
        lock (_guard)
        {
            if (_isHoming || (_last is { } last && last.DistanceTo(place) < MinStep)) return;
            if (_places.Count == MaxPlaces) _places.Dequeue();
            _places.Enqueue(place);
            (_shown, _last) = ([], place);
        }
    }
}
