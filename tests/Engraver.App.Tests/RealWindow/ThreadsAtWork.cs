namespace Engraver.App.Tests.RealWindow;

/// <summary>Whether a program has something to do, however busy the computer is: Linux tells of each thread whether it runs or would run if a processor
/// were free (proc(5), state R).</summary>
/// <remarks>A thread that is woken for a moment now and then is met at work by chance; one that is met so twice in a row works on, or waits for its
/// turn.</remarks>
/// <param name="process">The number of the program.</param>
internal sealed class ThreadsAtWork(int process)
{
    private HashSet<string> _before = [];

    /// <summary>Looks once more.</summary>
    /// <returns>True when a thread that was at work at the look before is so again.</returns>
    public bool GoOn()
    {
        var now = AtWork();
        var goesOn = now.Overlaps(_before);
        _before = now;
        return goesOn;
    }

    private HashSet<string> AtWork()
    {
        var folder = new DirectoryInfo($"/proc/{process}/task");
        return folder.Exists ? [.. folder.EnumerateDirectories().Select(thread => thread.FullName).Where(IsAtWork)] : [];
    }

    private static bool IsAtWork(string thread)
    {
        try
        {
            var told = File.ReadAllText(Path.Combine(thread, "stat"));
            return told.AsSpan(told.LastIndexOf(')') + 2) is ['R', ..]; // the name of the thread, in brackets, may hold anything
        }
        catch (IOException)
        {
            return false; // the thread has ended since
        }
    }
}
