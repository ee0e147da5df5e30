namespace Engraver.Simulator.Motion;

/// <summary>VP or LI: a straight line between two frame points over two to four axes.</summary>
internal sealed class StraightSegment : VectorSegment
{
    private readonly double[] start;
    private readonly double[] end;

    public StraightSegment(ReadOnlySpan<double> start, ReadOnlySpan<double> end)
    {
        this.start = start.ToArray();
        this.end = end.ToArray();
        double square = 0;
        for (int i = 0; i < end.Length; i++)
        {
            square += (end[i] - start[i]) * (end[i] - start[i]);
        }

        Length = Math.Sqrt(square);
    }

    public override void PointAt(double distance, Span<double> point)
    {
        // The last point is the programmed one, not a sum that may round beside it (galil-dmc.md I, rounding rule).
        double part = distance >= Length ? 1 : distance / Length;
        for (int i = 0; i < start.Length; i++)
        {
            point[i] = part >= 1 ? end[i] : start[i] + ((end[i] - start[i]) * part);
        }
    }

    public override double TangentAt(double distance) => Math.Atan2(end[1] - start[1], end[0] - start[0]) * (180 / Math.PI);
}
