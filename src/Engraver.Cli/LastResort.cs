using Engraver.Cli.Output;

namespace Engraver.Cli;

/// <summary>Ends the program for an exception on a thread that nobody waits for (a timer's, a pool's), which the runtime would end with a signal (exit 134)
/// and without a report.</summary>
internal sealed class LastResort(string[] args, TextWriter error, Action<int> exit)
{
    private int _ended;

    public static void Install(string[] args)
    {
        var resort = new LastResort(args, Console.Error, Environment.Exit);
        AppDomain.CurrentDomain.UnhandledException += (_, failure) => resort.End(failure.ExceptionObject as Exception ?? new InvalidOperationException(failure.ExceptionObject.ToString()));
    }

    /// <summary>Writes what happened and where the report is, and ends the program. Only the first call does anything.</summary>
    public void End(Exception bug)
    {
        if (Interlocked.Exchange(ref _ended, 1) != 0) return;
        error.WriteLine($"engraver: {CrashReport.Write(bug, args)}");
        exit(ExitCode.InternalError);
    }
}
