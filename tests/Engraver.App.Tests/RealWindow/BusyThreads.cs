namespace Engraver.App.Tests.RealWindow;

/// <summary>Detects whether a program has work to do, however busy the computer is: Linux reports for each thread whether it runs or would run if a
/// processor were free (proc(5), state R).</summary>
/// <remarks>A thread that wakes up briefly now and then is found running by chance; one that is found twice in a row is working, or waits for a
/// processor.</remarks>
/// <param name="process">The process id of the program.</param>
internal sealed class BusyThreads(int process)
{
    private HashSet<string> _before = [];

    /// <summary>Samples the threads again.</summary>
    /// <returns>True if a thread that was running at the previous sample is running again.</returns>
    public bool StillBusy()
    {
        var now = FindBusy();
        var goesOn = now.Overlaps(_before);
        _before = now;
        return goesOn;
    }

    private HashSet<string> FindBusy()
    {
        var folder = new DirectoryInfo($"/proc/{process}/task");
        return folder.Exists ? [.. folder.EnumerateDirectories().Select(thread => thread.FullName).Where(IsBusy)] : [];
    }

    private static bool IsBusy(string thread)
    {
        try
        {
            var told = File.ReadAllText(Path.Combine(thread, "stat"));
            return told.AsSpan(told.LastIndexOf(')') + 2) is ['R', ..]; // the name of the thread, in brackets, may contain anything
        }
        catch (IOException)
        {
            return false; // the thread has ended since
        }
    }
}
