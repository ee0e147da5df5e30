namespace Engraver.Benchmarks.Motion;

/// <summary>Compares the planned time of drawings with the limits.</summary>
internal static class MotionTable
{
    /// <summary>Writes the toolpaths beside the drawings, and the table on standard output.</summary>
    public static void Write(EngraverProgram engraver, double tolerance, string folder, IReadOnlyList<string> machines)
    {
        Console.WriteLine("| Part | Machine | Limit, s | Unrestricted limit, s | Stop at every corner, s | Planned cutting, s | Planned / limit |");
        Console.WriteLine("|---|---|---:|---:|---:|---:|---:|");
        foreach (var drawing in Directory.GetFiles(folder, "*.dxf").Order(StringComparer.Ordinal))
        {
            foreach (var machine in machines) Console.WriteLine(Row(engraver, drawing, machine, tolerance));
        }
    }

    private static string Row(EngraverProgram engraver, string drawing, string machine, double tolerance)
    {
        var (part, profile) = (Path.GetFileNameWithoutExtension(drawing), Path.GetFileNameWithoutExtension(machine));
        var name = Path.ChangeExtension(drawing, profile + ".json");
        engraver.PathOf(drawing, machine, tolerance).Write(name);
        var path = PathFile.Read(name);
        var (limit, unrestricted, stopping) = (0.0, 0.0, 0.0);
        foreach (var stroke in path.Strokes)
        {
            var limits = StrokeLimits.Of(stroke, path.Bounds);
            (limit, unrestricted, stopping) = (limit + limits.Limit, unrestricted + limits.Unrestricted, stopping + limits.Stopping);
        }

        var planned = engraver.CuttingSeconds(drawing, machine, tolerance);
        return $"| {part} | {profile} | {limit:0.000} | {unrestricted:0.000} | {stopping:0.000} | {planned:0.000} | {planned / limit:0.0000} |";
    }
}
