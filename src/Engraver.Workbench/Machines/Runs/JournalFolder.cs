using System.Globalization;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The folder of the journals for which the operator names no file: in the user's data folder, one file for each run.</summary>
public static class JournalFolder
{
    /// <summary>A path for the journal of a run that starts now; the folder is made.</summary>
    public static string NewJournal(string drawing, TimeProvider time) => NewJournal(drawing, null, time);

    /// <summary>The same in a folder of the caller's; null for the usual one.</summary>
    public static string NewJournal(string drawing, string? folder, TimeProvider time)
    {
        folder ??= Path.Combine(UserFiles.Folder, "journals");
        Directory.CreateDirectory(folder);
        var name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(drawing)}-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}-{Environment.ProcessId}.jsonl");
        return Path.Combine(folder, name);
    }
}
