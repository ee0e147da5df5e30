using System.Text.Json;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>A run that did not restore the controller, because this computer or the link failed. Its journal holds the controller's state before the
/// run.</summary>
/// <param name="JournalPath">The journal of that run.</param>
/// <param name="Found">The controller's state before that run.</param>
/// <param name="Program">The program that was in the memory.</param>
internal sealed record CrashRecovery(string JournalPath, JournalFound Found, string Program)
{
    private const string CopySuffix = ".program.dmc";

    /// <summary>Path of the found program, beside the journal.</summary>
    public static string CopyOf(string journalPath) => journalPath + CopySuffix;

    /// <summary>The last run with this controller that was not ended properly, by the journals of the folder; null when there is none.</summary>
    /// <param name="journalPath">Journal of the run that begins now.</param>
    /// <param name="resumed">Journal of the job that it resumes, which may be in another folder; null for none.</param>
    /// <exception cref="IOException">A folder cannot be read.</exception>
    public static CrashRecovery? Last(string journalPath, string? resumed, JournalFound now)
    {
        var folders = new[] { journalPath, resumed }.OfType<string>().Select(path => Path.GetDirectoryName(Path.GetFullPath(path))!).Distinct(StringComparer.Ordinal);
        return folders.SelectMany(folder => new DirectoryInfo(folder).EnumerateFiles("*" + CopySuffix))
            .OrderByDescending(copy => copy.LastWriteTimeUtc)
            .Select(copy => Read(copy.FullName, now))
            .FirstOrDefault(run => run is not null);
    }

    private static CrashRecovery? Read(string copyPath, JournalFound now)
    {
        var journal = copyPath[..^CopySuffix.Length];
        return JobJournal.IsReadable(journal) && Unended(journal) is { } found && found.IsSameController(now) ? new CrashRecovery(journal, found, File.ReadAllText(copyPath, ControllerProgramMemory.CopyEncoding)) : null;
    }

    /// <summary>The last "found" line of the journal, unless the controller was restored after it. A line that was changed after it was written is not
    /// used.</summary>
    private static JournalFound? Unended(string journal)
    {
        JournalFound? found = null;
        foreach (var line in JobJournal.ReadLines(journal))
        {
            if (JournalSeal.Of(line) is { IsTrue: false }) return null;
            switch (Kind(line))
            {
                case "found": found = JobJournal.Read<JournalFound>(line); break;
                case "end" when JobJournal.Read<JournalEnd>(line) is { LeftAsFound: true }: found = null; break;
                case "givenBack": found = null; break;
            }
        }

        return found;
    }

    /// <summary>The kind of a line; null for half a line, as a crash may leave it.</summary>
    internal static string? Kind(string line)
    {
        try
        {
            using var document = JsonDocument.Parse(line);
            return document.RootElement.GetProperty("kind").GetString();
        }
        catch (Exception torn) when (torn is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            return null;
        }
    }
}
