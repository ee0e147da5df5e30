namespace Engraver.Simulator.Motion;

/// <summary>VP or LI: a straight line between two frame points over one to six axes.</summary>
internal sealed class StraightSegment : VectorSegment
{
    private readonly double[] _start;
    private readonly double[] _end;

    public StraightSegment(ReadOnlySpan<double> start, ReadOnlySpan<double> end)
    {
        _start = start.ToArray();
        _end = end.ToArray();
        double square = 0;
        for (var i = 0; i < _end.Length; i++)
        {
            square += (_end[i] - _start[i]) * (_end[i] - _start[i]);
        }

        Length = Math.Sqrt(square);
    }

    public override void PointAt(double distance, Span<double> point)
    {
        // The last point is the programmed one, not a sum with rounding errors (galil-dmc.md I, rounding rule).
        var part = distance >= Length ? 1 : distance / Length;
        for (var i = 0; i < _start.Length; i++)
        {
            point[i] = part >= 1 ? _end[i] : _start[i] + ((_end[i] - _start[i]) * part);
        }
    }

    /// <remarks>With a single axis (LM A) the direction is 0 or 180 degrees.</remarks>
    public override double TangentAt(double distance) => Math.Atan2(_end.Length > 1 ? _end[1] - _start[1] : 0, _end[0] - _start[0]) * (180 / Math.PI);
}
