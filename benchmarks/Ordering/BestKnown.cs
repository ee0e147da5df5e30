namespace Engraver.Benchmarks.Ordering;

/// <summary>The least travel that is known of each instance, there and back, in millimetres: of the reference solver, or of any other run.</summary>
internal static class BestKnown
{
    private static readonly Dictionary<string, double> s_travel = [];

    /// <summary>Infinite where none is known.</summary>
    public static double Of(string name) => s_travel.GetValueOrDefault(name, double.PositiveInfinity);
}
