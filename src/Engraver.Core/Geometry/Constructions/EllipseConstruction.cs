namespace Engraver.Core.Geometry.Constructions;

/// <summary>Ellipses from their axes, at height 0. Angles are counted counter-clockwise from the end of the first axis.</summary>
public static class EllipseConstruction
{
    /// <summary>Smallest ratio of the shorter axis to the longer one: AutoCAD's limit.</summary>
    public const double Flattest = 1e-6;

    /// <param name="first">From the centre to an end of the first axis.</param>
    /// <param name="second">Half the length of the other axis.</param>
    /// <param name="start">Parameter of the start.</param>
    /// <param name="sweep">Counter-clockwise; a whole turn for the whole ellipse.</param>
    /// <returns>Null when an axis has no length or is too short compared with the other.</returns>
    public static EllipseArc? FromAxes(Point2D centre, Vector2D first, double second, Angle start, Angle sweep)
    {
        var (one, other) = (first.Length, Math.Abs(second));
        if (!double.IsFinite(one) || !double.IsFinite(other) || !(Math.Min(one, other) >= Flattest * Math.Max(one, other)) || one == 0.0) return null;
        if (sweep.Degrees == 0.0) return null;
        var across = new Vector2D(-first.Y, first.X) * (other / one);
        return new EllipseArc(new Vector3D(centre.X, centre.Y, 0.0), new Vector3D(first.X, first.Y, 0.0), new Vector3D(across.X, across.Y, 0.0), start, sweep);
    }

    /// <summary>The parameter of the point that is seen from the centre at an angle to the first axis: the two are equal only at the ends of the
    /// axes.</summary>
    /// <param name="first">Half the first axis.</param>
    /// <param name="second">Half the other axis.</param>
    /// <returns>In [0, 360).</returns>
    public static Angle ParameterAt(Angle angle, double first, double second) => Angle.Direction(second * angle.Cos(), first * angle.Sin()).Positive();

    /// <summary>Half the other axis of a circle that is rotated about its first axis out of the plane.</summary>
    public static double Turned(double first, Angle rotation) => first * Math.Abs(rotation.Cos());
}
