namespace Engraver.Samples.Geometry;

/// <summary>A corner of a polygon before it is rounded by a tangent arc of <paramref name="Radius"/>; radius 0 leaves it sharp.</summary>
internal readonly record struct Corner(double X, double Y, double Radius)
{
    public Point At => new(X, Y);
}
