using System.Globalization;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The folder of the journals for which the operator names no file: in the user's data folder, one file for each run.</summary>
public static class JournalFolder
{
    /// <summary>Where journals go for which nobody names a folder.</summary>
    internal static string Usual => Path.Combine(UserFiles.Folder, "journals");

    /// <summary>True for a file of a run of the drawing, and not of one whose name only begins the same: behind the name comes the day.</summary>
    internal static bool IsOf(string file, string drawing) => file.Length > drawing.Length + 9 && file.AsSpan(drawing.Length + 1, 8).IndexOfAnyExceptInRange('0', '9') < 0;

    /// <summary>A path for the journal of a run that starts now; the folder is made.</summary>
    public static string NewJournal(string drawing, TimeProvider time) => NewJournal(drawing, null, time);

    /// <summary>The same in a folder that the caller names; null for the usual one.</summary>
    public static string NewJournal(string drawing, string? folder, TimeProvider time)
    {
        folder ??= Usual;
        Directory.CreateDirectory(folder);
        RunBudget.MakeRoom(folder, RunBudget.Megabytes);
        var name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(drawing)}-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}-{Environment.ProcessId}.jsonl");
        return Path.Combine(folder, name);
    }
}
