using System.Globalization;
using Engraver.Core.Languages;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Disk space limit of runs without an explicit journal path: when a run starts, the oldest runs beyond the limit are deleted with all their files.
/// Runs that are active, did not end regularly or can be resumed are not deleted.</summary>
public static class RunBudget
{
    /// <summary>The default limit.</summary>
    public const int DefaultMegabytes = 1000;

    private const long Megabyte = 1_000_000;
    private const string JournalExtension = ".jsonl";

    /// <summary>Suffixes of a journal and of the files beside it.</summary>
    private static readonly string[] s_suffixes = ["", ConversationFile.PathOf(""), TraceFile.PathOf(""), JournalledRun.ProgramCopyOf("")];

    private static string SettingFile => Path.Combine(UserFiles.Folder, "runs-megabytes.txt");

    /// <summary>The limit set by the operator.</summary>
    public static int Megabytes
    {
        get
        {
            try
            {
                return File.Exists(SettingFile) && int.TryParse(File.ReadAllText(SettingFile), NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture, out var set) && set > 0 ? set : DefaultMegabytes;
            }
            catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
            {
                return DefaultMegabytes;
            }
        }
    }

    /// <summary>Changes the setting.</summary>
    /// <returns>Why that failed, without a full stop; null on success.</returns>
    public static string? Set(int megabytes)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(megabytes);
        try
        {
            Directory.CreateDirectory(UserFiles.Folder);
            OutputFile.Write(SettingFile, output => output.WriteLine(megabytes.ToString(CultureInfo.InvariantCulture)));
            return null;
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return SystemErrorText.FromException(unwritable);
        }
    }

    /// <summary>Disk space of the stored runs, megabytes.</summary>
    public static double UsedMegabytes => UsedIn(JournalFolder.Default);

    /// <summary>The same of another folder.</summary>
    public static double UsedIn(string folder)
    {
        try
        {
            return Runs(folder).Sum(static run => run.Size) / (double)Megabyte;
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return 0.0;
        }
    }

    /// <summary>Deletes the oldest runs of a folder until the rest is within the limit or no more may be deleted.</summary>
    public static void MakeRoom(string folder, int megabytes)
    {
        try
        {
            var runs = Runs(folder);
            var size = runs.Sum(static run => run.Size);
            foreach (var run in runs.OrderBy(static run => run.Written))
            {
                if (size <= megabytes * Megabyte) return;
                if (!IsDeletable(run.Journal)) continue;
                foreach (var file in run.Files) file.Delete();
                size -= run.Size;
            }
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            // A file is in use: the next run tries again.
        }
    }

    /// <summary>A file without a journal may belong to a run that is just starting, so it is not deleted.</summary>
    private static bool IsDeletable(string journal) => File.Exists(journal) && JournalledRun.Read(journal) is { IsClosed: true };

    private static List<RunFiles> Runs(string folder) => !Directory.Exists(folder) ? [] :
    [
        .. new DirectoryInfo(folder).EnumerateFiles("*" + JournalExtension + "*")
            .Select(static file => (File: file, Journal: JournalOf(file.FullName)))
            .Where(static pair => pair.Journal is not null)
            .GroupBy(static pair => pair.Journal!, static pair => pair.File)
            .Select(static files => new RunFiles(files.Key, [.. files])),
    ];

    /// <summary>Null for a file that does not belong to a run.</summary>
    private static string? JournalOf(string path) =>
        s_suffixes.FirstOrDefault(ending => path.EndsWith(JournalExtension + ending, StringComparison.Ordinal)) is { } beside ? path[..^beside.Length] : null;

    private sealed record RunFiles(string Journal, IReadOnlyList<FileInfo> Files)
    {
        public long Size { get; } = Files.Sum(static file => file.Length);

        public DateTime Written { get; } = Files.Max(static file => file.LastWriteTimeUtc);
    }
}
