namespace Engraver.Benchmarks.Desktop;

/// <summary>What both benchmarks of the stop do alike, in memory and on a display: how often, beside what, and from which thread.</summary>
internal static class StopPresses
{
    /// <summary>Presses at a machine at rest.</summary>
    public const int AtRest = 200;

    /// <summary>Jobs that are started and stopped.</summary>
    public const int Jobs = 100;

    /// <summary>Size of the drawing that is drawn again and again.</summary>
    public const int Segments = 1_000_000;

    public const string Idle = "idle";
    public const string Redraws = "draws 1,000,000 segments again and again";
    public const string RunsJob = "runs a job";

    /// <summary>Presses on a thread of their own, as the hand is no part of the window.</summary>
    /// <param name="press">Gives the milliseconds of one.</param>
    public static Task<double[]> TimesAsync(int count, Func<double> press) =>
        Task.Factory.StartNew(() => Times(count, press), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    private static double[] Times(int count, Func<double> press)
    {
        var times = new double[count];
        for (var i = 0; i < count; i++) times[i] = press();
        return times;
    }
}
