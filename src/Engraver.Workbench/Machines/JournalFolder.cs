using System.Globalization;

namespace Engraver.Workbench.Machines;

/// <summary>Where journals go when the operator names no file: the user's own data folder, one file for each run.</summary>
public static class JournalFolder
{
    /// <summary>A path for the journal of a run that starts now; the folder is made.</summary>
    public static string NewJournal(string drawing, TimeProvider time)
    {
        var data = Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData, Environment.SpecialFolderOption.DoNotVerify);
        var folder = Path.Combine(data.Length > 0 ? data : Path.GetTempPath(), "CncEngraver", "journals");
        Directory.CreateDirectory(folder);
        var name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(drawing)}-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}-{Environment.ProcessId}.jsonl");
        return Path.Combine(folder, name);
    }
}
