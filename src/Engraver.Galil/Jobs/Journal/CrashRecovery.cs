using System.Text.Json;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>A run that never gave the controller back: this computer died, or the link did. Its journal tells how it had found the controller.</summary>
/// <param name="JournalPath">The journal of that run.</param>
/// <param name="Found">The controller as it had found it.</param>
/// <param name="Program">The program that had stood in the memory.</param>
internal sealed record CrashRecovery(string JournalPath, JournalFound Found, string Program)
{
    private const string CopySuffix = ".program.dmc";

    /// <summary>Where the found program is kept beside a journal.</summary>
    public static string CopyOf(string journalPath) => journalPath + CopySuffix;

    /// <summary>The last run with this controller that was not ended properly, by the journals of the folder; null when there is none.</summary>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    public static CrashRecovery? Last(string journalPath, JournalFound now)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(journalPath))!;
        return new DirectoryInfo(folder).EnumerateFiles("*" + CopySuffix)
            .OrderByDescending(copy => copy.LastWriteTimeUtc)
            .Select(copy => Read(copy.FullName, now))
            .FirstOrDefault(run => run is not null);
    }

    private static CrashRecovery? Read(string copyPath, JournalFound now)
    {
        var journal = copyPath[..^CopySuffix.Length];
        return IsReadable(journal) && Unended(journal) is { } found && found.IsSameController(now) ? new CrashRecovery(journal, found, File.ReadAllText(copyPath, ProgramMemory.CopyEncoding)) : null;
    }

    /// <summary>A journal that went into a pipe is not there to be read again, and asking the pipe would wait for ever; like an empty file it has no length.</summary>
    private static bool IsReadable(string journal) => new FileInfo(journal) is { Exists: true, Length: > 0 };

    /// <summary>The last "found" of the journal, unless the controller was given back behind it.</summary>
    private static JournalFound? Unended(string journal)
    {
        JournalFound? found = null;
        foreach (var line in JobJournal.ReadLines(journal))
        {
            switch (Kind(line))
            {
                case "found": found = JobJournal.Read<JournalFound>(line); break;
                case "end" when JobJournal.Read<JournalEnd>(line) is { LeftAsFound: true }: found = null; break;
                case "givenBack": found = null; break;
            }
        }

        return found;
    }

    /// <summary>A crash may have left half a line.</summary>
    private static string? Kind(string line)
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
