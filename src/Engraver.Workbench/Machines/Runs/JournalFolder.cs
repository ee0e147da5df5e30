using System.Globalization;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The folder of journals without an explicit path: in the user's data folder, one file for each run.</summary>
public static class JournalFolder
{
    /// <summary>The default folder of journals.</summary>
    internal static string Default => Path.Combine(UserFiles.Folder, "journals");

    /// <summary>True for a file of a run of the drawing, but not of a drawing whose name only starts the same: the name is followed by the date.</summary>
    internal static bool IsOf(string file, string drawing) => file.Length > drawing.Length + 9 && file.AsSpan(drawing.Length + 1, 8).IndexOfAnyExceptInRange('0', '9') < 0;

    /// <summary>A path for the journal of a run that starts now; creates the folder.</summary>
    public static string NewJournal(string drawing, TimeProvider time) => NewJournal(drawing, null, time);

    /// <summary>The same in a given folder; null for the default.</summary>
    public static string NewJournal(string drawing, string? folder, TimeProvider time)
    {
        folder ??= Default;
        Directory.CreateDirectory(folder);
        RunBudget.MakeRoom(folder, RunBudget.Megabytes);
        var name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(drawing)}-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}-{Environment.ProcessId}.jsonl");
        return Path.Combine(folder, name);
    }

    /// <summary>The journal, or another file, of a later section of a job of several tools: a-2.jsonl for a.jsonl.</summary>
    /// <param name="path">That of the first section.</param>
    /// <param name="run">Number of the section among those of the run, from 2.</param>
    internal static string OfSection(string path, int run) =>
        Path.Combine(Path.GetDirectoryName(path) ?? "", string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(path)}-{run}{Path.GetExtension(path)}"));
}
