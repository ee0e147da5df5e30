namespace Engraver.Benchmarks.Desktop;

/// <summary>The number of presses, the drawing and the thread of both benchmarks of the stop, in memory and on a display.</summary>
internal static class StopMeasurement
{
    /// <summary>Number of presses while the machine is at rest.</summary>
    public const int AtRest = 200;

    /// <summary>Number of jobs that are started and stopped.</summary>
    public const int Jobs = 100;

    /// <summary>Number of segments of the drawing that is redrawn.</summary>
    public const int Segments = 1_000_000;

    public const string Idle = "idle";
    public const string Redraws = "draws 1,000,000 segments again and again";
    public const string RunsJob = "runs a job";

    /// <summary>Runs the presses on a separate thread, because an operator presses independently of the window's thread.</summary>
    /// <param name="press">Presses once and returns the milliseconds until the stop was received.</param>
    public static Task<double[]> TimesAsync(int count, Func<double> press) =>
        Task.Factory.StartNew(() => Times(count, press), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    private static double[] Times(int count, Func<double> press)
    {
        var times = new double[count];
        for (var i = 0; i < count; i++) times[i] = press();
        return times;
    }
}
