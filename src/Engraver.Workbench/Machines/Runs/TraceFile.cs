using Engraver.Core.Languages;
using Engraver.Core.Verification;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The file beside a journal with the positions of the machine.</summary>
public static class TraceFile
{
    private const string FileExtension = ".trace.csv";

    /// <summary>Path of the file of a journal.</summary>
    public static string PathOf(string journal) => journal + FileExtension;

    /// <summary>The journal of a trace; a journal itself.</summary>
    public static string JournalOf(string file)
    {
        ArgumentNullException.ThrowIfNull(file);
        return file.EndsWith(FileExtension, StringComparison.Ordinal) ? file[..^FileExtension.Length] : file;
    }

    /// <summary>Saves a trace beside its journal, unless the journal is a stream.</summary>
    /// <returns>Why it could not be written; null on success and for a stream.</returns>
    internal static string? Save(RunTrace trace, string journal)
    {
        if (FileKind.IsStream(journal)) return null;
        try
        {
            OutputFile.Write(PathOf(journal), trace.Write);
            return null;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return SystemErrorText.FromException(failure);
        }
    }

    /// <summary>Reads the trace of a journal.</summary>
    /// <param name="journal">The journal, or the trace beside it.</param>
    /// <exception cref="IOException">There is none, or it cannot be read.</exception>
    /// <exception cref="FormatException">The file is not a trace.</exception>
    public static RunTrace Read(string journal)
    {
        ArgumentNullException.ThrowIfNull(journal);
        using var input = File.OpenText(journal.EndsWith(FileExtension, StringComparison.Ordinal) ? journal : PathOf(journal));
        return RunTrace.Read(input);
    }

    /// <summary>The journal of the last run of a drawing with a saved trace; null if there is none.</summary>
    /// <param name="drawing">The drawing's file; runs are identified by its name.</param>
    /// <param name="folder">Folder of the journals; null for the default.</param>
    public static string? LastOf(string drawing, string? folder = null) => AllOf(drawing, folder) is [.., var last] ? last : null;

    /// <summary>The journals of all runs of a drawing with saved traces, the oldest first.</summary>
    /// <param name="drawing">As for <see cref="LastOf"/>.</param>
    /// <param name="folder">As for <see cref="LastOf"/>.</param>
    public static IReadOnlyList<string> AllOf(string drawing, string? folder = null)
    {
        folder ??= JournalFolder.Default;
        if (!Directory.Exists(folder)) return [];
        var name = Path.GetFileNameWithoutExtension(drawing);
        return [.. Directory.EnumerateFiles(folder, $"{name}-*.jsonl{FileExtension}")
            .Where(file => JournalFolder.IsOf(Path.GetFileName(file), name))
            .OrderBy(file => Path.GetFileName(file), StringComparer.Ordinal)
            .Select(file => file[..^FileExtension.Length])];
    }
}
