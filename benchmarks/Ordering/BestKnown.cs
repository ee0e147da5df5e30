namespace Engraver.Benchmarks.Ordering;

/// <summary>The least travel that is known of each instance, there and back, in millimetres: of the reference solver, or of any other run.</summary>
internal static class BestKnown
{
    private static readonly Dictionary<string, double> s_travel = new()
    {
        ["random-500"] = 5060.086, ["nested-500"] = 2727.728, ["random-2000"] = 20256.918, ["nested-2000"] = 10513.732, ["plates-200"] = 1815.508, ["random-10000"] = 100762.628,
    };

    /// <summary>Infinite where none is known.</summary>
    public static double Of(string name) => s_travel.GetValueOrDefault(name, double.PositiveInfinity);
}
