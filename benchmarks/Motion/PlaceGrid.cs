namespace Engraver.Benchmarks.Motion;

/// <summary>Places along a path from rest to rest, close to each other near the ends of its elements, and what bounds the speed there.</summary>
internal sealed class PlaceGrid
{
    /// <summary>Distance of places beside the ends of an element, mm.</summary>
    private const double Finest = 0.005;

    /// <summary>Ratio of the distances of neighbouring places.</summary>
    private const double Growth = 1.15;
    private const double CoarsestPart = 1.0 / 200.0;
    private const double FinestPart = 1.0 / 16.0;

    private readonly MotionBounds _bounds;
    private readonly List<double> _cells = [];

    /// <summary>Radius of the path in each cell; infinite on lines.</summary>
    private readonly List<double> _radii = [];

    /// <summary>Squares of the largest speeds at the places.</summary>
    private readonly List<double> _most = [0.0];
    private readonly double[] _forward;
    private readonly double[] _squares;

    public PlaceGrid(IReadOnlyList<PathPart> path, MotionBounds bounds)
    {
        _bounds = bounds;
        foreach (var part in path)
        {
            _most[^1] = Math.Min(_most[^1], Square(part.Through));
            Add(part.Length, part.Radius);
        }

        _most[^1] = 0.0;
        (_forward, _squares) = (new double[_most.Count], new double[_most.Count]);
    }

    /// <summary>Whether the best acceleration is a compromise.</summary>
    public bool HasArcs { get; private set; }

    /// <summary>Seconds with one acceleration along the path: this value, 0, or this value as deceleration.</summary>
    /// <param name="acceleration">mm/s2, up to the largest one of any direction.</param>
    public double SecondsWith(double acceleration)
    {
        var across = Math.Sqrt(Math.Max(0.0, Square(_bounds.Acceleration) - Square(acceleration)));
        Pass((square, cell) =>
        {
            var ramp = double.IsInfinity(_radii[cell]) ? double.PositiveInfinity : _radii[cell] * across;
            return square > ramp * (1.0 + 1e-12) ? square : Math.Min(ramp, square + (2.0 * acceleration * _cells[cell]));
        });
        return Seconds();
    }

    /// <summary>Seconds with any acceleration along the path that leaves the total one within its bound.</summary>
    public double SecondsUnrestricted()
    {
        Pass((square, cell) =>
        {
            var (radius, length) = (_radii[cell], _cells[cell]);
            if (double.IsInfinity(radius)) return square + (2.0 * _bounds.Acceleration * length);
            var most = _bounds.Acceleration * radius; // d(v2)/ds = 2 sqrt(A2 - (v2/r)2): a sine over the length
            return most * Math.Sin(Math.Min(Math.PI / 2.0, Math.Asin(Math.Min(1.0, square / most)) + (2.0 * length / radius)));
        });
        return Seconds();
    }

    private void Add(double length, double radius)
    {
        var most = Square(_bounds.OnArc(radius));
        _most[^1] = Math.Min(_most[^1], most);
        HasArcs |= !double.IsInfinity(radius);
        var (half, cell, sum) = (new List<double>(), Math.Min(Finest, length * FinestPart), 0.0);
        while (sum < length / 2.0)
        {
            half.Add(cell);
            sum += cell;
            cell = Math.Min(cell * Growth, Math.Max(cell, length * CoarsestPart));
        }

        var scale = length / 2.0 / sum;
        for (var i = 0; i < 2 * half.Count; i++)
        {
            _cells.Add(scale * half[i < half.Count ? i : (2 * half.Count) - 1 - i]);
            _radii.Add(radius);
            _most.Add(most);
        }
    }

    /// <param name="next">Largest square at the other end of a cell.</param>
    private void Pass(Func<double, int, double> next)
    {
        var square = 0.0;
        for (var i = 0; i < _cells.Count; i++) _forward[i + 1] = square = Math.Min(next(square, i), _most[i + 1]);
        _squares[^1] = square = 0.0;
        for (var i = _cells.Count - 1; i >= 0; i--) _squares[i] = square = Math.Min(next(square, i), _forward[i]);
    }

    private double Seconds()
    {
        var seconds = 0.0;
        for (var i = 0; i < _cells.Count; i++) seconds += 2.0 * _cells[i] / (Math.Sqrt(_squares[i]) + Math.Sqrt(_squares[i + 1]));
        return seconds;
    }

    private static double Square(double value) => value * value;
}
