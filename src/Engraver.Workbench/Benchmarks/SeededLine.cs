namespace Engraver.Workbench.Benchmarks;

/// <summary>A line of a benchmark drawing, drawing units.</summary>
/// <param name="Layer">Index into <see cref="SeededPolygons.Layers"/>.</param>
internal readonly record struct SeededLine(int Layer, double FromX, double FromY, double ToX, double ToY)
{
    public SeededLine Reversed() => new(Layer, ToX, ToY, FromX, FromY);
}
