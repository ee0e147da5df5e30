using System.Diagnostics;
using System.Globalization;
using System.Text.Json;

namespace Engraver.Benchmarks.Motion;

/// <summary>The console runner that is measured: it is started, as a user would.</summary>
internal sealed class EngraverProgram(string name)
{
    private const double DefaultFeed = 1200.0;
    private const double DefaultAcceleration = 256000.0;
    private const double DefaultCounts = 1000.0;

    /// <summary>The toolpath of a drawing in the order in which it is cut, with the bounds of the machine.</summary>
    /// <param name="tolerance">Of corners, mm.</param>
    public PathFile PathOf(string drawing, string machine, double tolerance)
    {
        using var profile = JsonDocument.Parse(File.ReadAllBytes(machine));
        double Value(string key, double standard) => profile.RootElement.TryGetProperty(key, out var value) ? value.GetDouble() : standard;
        var counts = Math.Abs(Value("countsPerMillimetreX", DefaultCounts));
        var (feed, acceleration) = (Value("feedMmPerMinute", DefaultFeed) / 60.0, Value("accelerationCounts", DefaultAcceleration) / counts);
        var bounds = new MotionBounds(feed, acceleration, tolerance, counts);
        return new PathFile(bounds, GcodePath.Read(Run("post", drawing, "--target", "gcode", "--machine", machine)));
    }

    /// <summary>Planned seconds of cutting.</summary>
    public double CuttingSeconds(string drawing, string machine, double tolerance)
    {
        var corners = tolerance.ToString(CultureInfo.InvariantCulture);
        using var plan = JsonDocument.Parse(Run("plan", drawing, "--json", "--machine", machine, "--corner-tolerance", corners));
        return plan.RootElement.GetProperty("seconds").GetProperty("cutting").GetDouble();
    }

    private string Run(params string[] arguments)
    {
        using var process = Process.Start(new ProcessStartInfo(name, [.. arguments, "--quiet"]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        var text = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        var exit = process.ExitCode.ToString(CultureInfo.InvariantCulture);
        if (exit != "0") Console.Error.WriteLine($"exit {exit}: {name} {string.Join(' ', arguments)}");
        return text;
    }
}
