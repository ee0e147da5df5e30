namespace Engraver.Benchmarks.Ordering;

/// <summary>The least travel of all runs of each instance, there and back, in millimetres. All are runs of the optimiser itself; the reference solver,
/// which was run on four, found longer ones.</summary>
internal static class BestKnown
{
    private static readonly Dictionary<string, double> s_travel = new()
    {
        ["random-20"] = 251.556,
        ["random-200"] = 2054.416,
        ["clustered-200"] = 772.264,
        ["nested-200"] = 1001.608,
        ["plates-200"] = 1810.368,
        ["open-200"] = 2039.213,
        ["text-200"] = 475.993,
        ["random-500"] = 5060.086,
        ["nested-500"] = 2727.728,
        ["random-2000"] = 20256.918,
        ["clustered-2000"] = 12476.046,
        ["nested-2000"] = 10513.732,
        ["plates-2000"] = 18962.547,
        ["open-2000"] = 20148.455,
        ["text-2000"] = 4800.209,
        ["random-10000"] = 100743.556,
        ["nested-10000"] = 54649.196,
        ["random-50000"] = 502700.764,
        ["plates-200b"] = 1867.080,
        ["random-500b"] = 5123.479,
        ["clustered-500b"] = 2644.363,
        ["nested-500b"] = 2320.509,
        ["random-2000b"] = 20251.014,
        ["nested-2000b"] = 10725.668,
    };

    /// <summary>Infinite where none is known.</summary>
    public static double Of(string name) => s_travel.GetValueOrDefault(name, double.PositiveInfinity);
}
