namespace Engraver.Simulator.Motion.Following;

/// <summary>The axis that VM keeps along the tangent of the path (galil-dmc.md B.6): position = zero + counts per degree x angle.</summary>
/// <remarks>The angle continues beyond 180 degrees, so that the axis never turns back by a full turn.</remarks>
internal sealed class TangentFollower
{
    private double? _angle;

    /// <summary>Null when no tangent axis was named.</summary>
    public Axis? Axis { get; set; }

    /// <summary>TN, first field: counts per degree, a multiple of 1/256.</summary>
    public double CountsPerDegree { get; set; }

    /// <summary>TN, second field: the position for zero degrees.</summary>
    public double Zero { get; set; }

    /// <summary>Required position at the start of a path: <c>_TNS</c>.</summary>
    public double StartFor(VectorSegment? first) => first is null ? Zero : Zero + (CountsPerDegree * Unwound(first.TangentAt(0), 0));

    public void Restart() => _angle = null;

    public void Follow(double tangent)
    {
        if (Axis is null) return;

        _angle = Unwound(tangent, _angle ?? 0);
        Axis.SetPosition(Math.Round(Zero + (CountsPerDegree * _angle.Value), MidpointRounding.AwayFromZero));
    }

    private static double Unwound(double _angle, double near) => near + Math.IEEERemainder(_angle - near, 360);
}
