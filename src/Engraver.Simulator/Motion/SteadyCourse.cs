namespace Engraver.Simulator.Motion;

/// <summary>Positions of axes at constant speed, by number of samples since the creation of this object.</summary>
internal abstract class SteadyCourse
{
    /// <summary>Writes the commanded positions, counts, of the axes that it moves; the others stay unchanged.</summary>
    /// <param name="positions">One number for each axis letter.</param>
    public abstract void At(long sample, Span<int> positions);

    /// <summary>As <see cref="At"/>, before rounding to counts.</summary>
    public abstract void Exactly(long sample, Span<double> positions);

    /// <summary>The arc that two axes follow between two samples; null when they move on a straight line or are at rest.</summary>
    public virtual ArcCourse? ArcBetween(long from, long to, int x, int y) => null;
}

/// <summary>An independent move.</summary>
internal sealed class AxisCourse(int axis, double from, double step, long passed) : SteadyCourse
{
    public override void At(long sample, Span<int> positions) => positions[axis] = (int)Math.Round(Place(sample), MidpointRounding.AwayFromZero);

    public override void Exactly(long sample, Span<double> positions) => positions[axis] = Place(sample);

    private double Place(long sample) => from + ((passed + sample) * step);
}

/// <summary>A segment of a vector sequence.</summary>
internal sealed class PathCourse : SteadyCourse
{
    private readonly VectorSegment _segment;
    private readonly int[] _axes;
    private readonly int[] _origin;
    private readonly double _firstScale;
    private readonly double _secondScale;
    private readonly double _step;
    private readonly double _from;
    private readonly long _passed;

    public PathCourse(VectorSegment segment, PathProfile profile, ReadOnlySpan<Axis> axes, ReadOnlySpan<int> origin, double firstScale, double secondScale)
    {
        _segment = segment;
        _axes = new int[axes.Length];
        for (var i = 0; i < _axes.Length; i++) _axes[i] = axes[i].Index;
        _origin = origin[.._axes.Length].ToArray();
        (_firstScale, _secondScale) = (firstScale, secondScale);
        (_from, _passed, _step) = profile.SteadyState;
    }

    public override void At(long sample, Span<int> positions)
    {
        Span<double> point = stackalloc double[Axis.Letters.Length];
        _segment.PointAt(Distance(sample), point);
        for (var i = 0; i < _axes.Length; i++) positions[_axes[i]] = _origin[i] + VectorPlane.Rounded(point[i] * Scale(i));
    }

    public override void Exactly(long sample, Span<double> positions)
    {
        Span<double> point = stackalloc double[Axis.Letters.Length];
        _segment.PointAt(Distance(sample), point);
        for (var i = 0; i < _axes.Length; i++) positions[_axes[i]] = _origin[i] + (point[i] * Scale(i));
    }

    /// <summary>With the axes exchanged, the angle is counted from the other axis, in the opposite direction.</summary>
    public override ArcCourse? ArcBetween(long from, long to, int x, int y)
    {
        if (_segment is not CircularSegment circular) return null;
        var isSwapped = (_axes[0], _axes[1]) == (y, x);
        if (!isSwapped && (_axes[0], _axes[1]) != (x, y)) return null;
        var arc = circular.Course(Distance(from), Distance(to), _firstScale, _secondScale);
        arc = arc with { CentreX = arc.CentreX + _origin[0], CentreY = arc.CentreY + _origin[1] };
        return !isSwapped ? arc : new ArcCourse(arc.CentreY, arc.CentreX, arc.RadiusY, arc.RadiusX, 90 - arc.StartDegrees, -arc.SweepDegrees);
    }

    private double Distance(long sample) => _from + ((_passed + sample) * _step) - _segment.StartLength;

    private double Scale(int slot) => slot == 0 ? _firstScale : slot == 1 ? _secondScale : 1;
}
