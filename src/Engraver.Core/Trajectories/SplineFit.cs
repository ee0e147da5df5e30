using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>Points of a spline for given knots: on the chain first, then moved along its normals so that the error of each step is on both sides of it
/// (sace-xps-agie.md 3.5 steps 3 and 4).</summary>
internal sealed class SplineFit
{
    /// <summary>Decimals of every coordinate, millimetres: the proof applies to the numbers in the file.</summary>
    public const int Decimals = 9;

    /// <summary>Number of samples; an odd number includes the middle of a step, where the error of fourth order is greatest.</summary>
    private const int Samples = 9;

    /// <summary>Accuracy of a foot point as a fraction of its piece, sufficient for moving the points.</summary>
    private const double FootShare = 1e-5;

    private const int Sweeps = 10;

    private const double Relaxation = 0.6;

    private readonly SmoothChain _chain;
    private readonly List<double> _knots;
    private readonly ChainPoint[] _places;
    private readonly double[] _shifts;
    private readonly bool[] _fixed;
    private readonly (double Min, double Max)[] _errors;

    public SplineFit(SmoothChain chain, List<double> knots)
    {
        (_chain, _knots) = (chain, knots);
        _places = [.. knots.Select(chain.At)];
        _shifts = new double[knots.Count];
        _fixed = new bool[knots.Count];
        _errors = new (double, double)[knots.Count - 1];
        if (chain.Closed) _places[^1] = _places[0];
        else (_fixed[0], _fixed[^1], _places[0], _places[^1]) = (true, true, _places[0] with { Point = chain.Pieces[0].StartPoint }, EndOf(chain));
        MarkCorners();
        Spline = Build(rounded: true);
    }

    public CatmullRomSpline Spline { get; private set; }

    /// <summary>True when the spline runs backwards along the chain somewhere.</summary>
    public bool HasReversal { get; private set; }

    public double ErrorOf(int segment) => Math.Max(Math.Abs(_errors[segment].Min), Math.Abs(_errors[segment].Max));

    /// <summary>Largest distance at the samples.</summary>
    public double LargestError => Enumerable.Range(0, _errors.Length).Max(ErrorOf);

    /// <summary>Measures the error and moves the points until there is no further improvement, the error is small enough, or it is too large for moving to
    /// help.</summary>
    public void Centre(double enough, double hopeless)
    {
        Measure();
        var (best, kept, rest) = (LargestError, (double[])_shifts.Clone(), 2);
        for (var sweep = 0; sweep < Sweeps && best > enough && best < hopeless && rest > 0; sweep++)
        {
            Shift();
            Spline = Build(rounded: false);
            Measure();
            if (LargestError < best * 0.99) (best, kept, rest) = (LargestError, (double[])_shifts.Clone(), 2);
            else rest--;
        }

        kept.CopyTo(_shifts, 0);
        Spline = Build(rounded: true);
        Measure();
    }

    /// <summary>Number of steps measured so far: the work of the fit.</summary>
    public int Measured { get; private set; }

    /// <summary>Measures the points without moving them.</summary>
    public void Measure()
    {
        Measured += _errors.Length;
        HasReversal = false;
        for (var segment = 0; segment < _errors.Length; segment++)
        {
            var (cubic, least, most) = (Spline[segment], 0.0, 0.0);
            var (from, to) = (_knots[segment], _knots[segment + 1]);
            for (var i = 0; i < Samples; i++)
            {
                var at = (i + 0.5) / Samples;
                var (distance, tangent) = _chain.Beside(cubic.At(at), from + (at * (to - from)), FootShare);
                (least, most) = (Math.Min(least, distance), Math.Max(most, distance));
                HasReversal |= cubic.SlopeAt(at).Dot(tangent) < 0.0;
            }

            _errors[segment] = (least, most);
        }
    }

    private static ChainPoint EndOf(SmoothChain chain) => chain.Pieces[^1].At(1.0) with { Point = chain.Pieces[^1].EndPoint };

    private void MarkCorners()
    {
        foreach (var joint in _chain.Joints.Where(joint => joint.IsCorner))
        {
            var at = _knots.BinarySearch(joint.At);
            for (var i = Math.Max(0, (at < 0 ? ~at : at) - 1); i < _knots.Count && _knots[i] <= joint.At + (1e-9 * _chain.Length); i++) _fixed[i] |= Math.Abs(_knots[i] - joint.At) <= 1e-9 * _chain.Length;
        }

        if (_chain.Closed) _fixed[0] = _fixed[^1] |= _fixed[0];
    }

    private void Shift()
    {
        var last = _shifts.Length - 1;
        for (var i = 0; i < (_chain.Closed ? last : _shifts.Length); i++)
        {
            if (_fixed[i]) continue;
            var (before, after) = (_errors[i == 0 ? _errors.Length - 1 : i - 1], _errors[i]);
            _shifts[i] -= Relaxation * (Math.Max(before.Max, after.Max) + Math.Min(before.Min, after.Min)) / 2.0;
        }

        if (_chain.Closed) _shifts[last] = _shifts[0];
    }

    private CatmullRomSpline Build(bool rounded)
    {
        var count = _places.Length;
        var lines = new Point2D[count + 2];
        for (var i = 0; i < count; i++) lines[i + 1] = _places[i].Point + (_places[i].Normal * _shifts[i]);
        if (rounded) for (var i = 1; i <= count; i++) lines[i] = Rounded(lines[i]);
        lines[0] = _chain.Closed ? lines[count - 1] : lines[2] - (_places[0].Tangent * (2.0 * (_knots[1] - _knots[0])));
        lines[^1] = _chain.Closed ? lines[2] : lines[^3] + (_places[^1].Tangent * (2.0 * (_knots[^1] - _knots[^2])));
        if (rounded) (lines[0], lines[^1]) = (Rounded(lines[0]), Rounded(lines[^1]));
        return new CatmullRomSpline(lines);
    }

    private static Point2D Rounded(Point2D point) => new(Math.Round(point.X, Decimals), Math.Round(point.Y, Decimals));
}
