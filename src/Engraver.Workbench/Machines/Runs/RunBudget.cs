using System.Globalization;
using Engraver.Core.Languages;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>How much room on the disk the runs may take whose journals nobody named: when a run begins, the oldest ones are deleted beyond that, each with
/// the files beside its journal. One that is under way, that did not end properly or that can be resumed is never deleted.</summary>
public static class RunBudget
{
    /// <summary>Where the operator has set nothing.</summary>
    public const int UsualMegabytes = 1000;

    private const long Megabyte = 1_000_000;
    private const string Ending = ".jsonl";

    /// <summary>A journal and what is written beside it.</summary>
    private static readonly string[] s_besides = ["", KeptConversation.PathOf(""), KeptTrace.PathOf(""), JournalledRun.ProgramCopyOf("")];

    private static string SettingFile => Path.Combine(UserFiles.Folder, "runs-megabytes.txt");

    /// <summary>The operator's setting.</summary>
    public static int Megabytes
    {
        get
        {
            try
            {
                return File.Exists(SettingFile) && int.TryParse(File.ReadAllText(SettingFile), NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture, out var set) && set > 0 ? set : UsualMegabytes;
            }
            catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
            {
                return UsualMegabytes;
            }
        }
    }

    /// <summary>Changes the setting.</summary>
    /// <returns>Why that failed, without a full stop; null when it is kept.</returns>
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
            return SystemReason.Of(unwritable);
        }
    }

    /// <summary>What the kept runs take, in megabytes.</summary>
    public static double UsedMegabytes => UsedIn(JournalFolder.Usual);

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

    /// <summary>Deletes the oldest runs of a folder until those that are left take no more than so much, or none may be deleted.</summary>
    public static void MakeRoom(string folder, int megabytes)
    {
        try
        {
            var runs = Runs(folder);
            var size = runs.Sum(static run => run.Size);
            foreach (var run in runs.OrderBy(static run => run.Written))
            {
                if (size <= megabytes * Megabyte) return;
                if (!MayGo(run.Journal)) continue;
                foreach (var file in run.Files) file.Delete();
                size -= run.Size;
            }
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            // Somebody reads one of them: the next run tries again.
        }
    }

    /// <summary>A file without a journal may be of a run that begins just now, or nobody's.</summary>
    private static bool MayGo(string journal) => File.Exists(journal) && JournalledRun.Read(journal) is { IsSettled: true };

    private static List<RunFiles> Runs(string folder) => !Directory.Exists(folder) ? [] :
    [
        .. new DirectoryInfo(folder).EnumerateFiles("*" + Ending + "*")
            .Select(static file => (File: file, Journal: JournalOf(file.FullName)))
            .Where(static pair => pair.Journal is not null)
            .GroupBy(static pair => pair.Journal!, static pair => pair.File)
            .Select(static files => new RunFiles(files.Key, [.. files])),
    ];

    /// <summary>Null for a file that no run has written.</summary>
    private static string? JournalOf(string path) =>
        s_besides.FirstOrDefault(ending => path.EndsWith(Ending + ending, StringComparison.Ordinal)) is { } beside ? path[..^beside.Length] : null;

    private sealed record RunFiles(string Journal, IReadOnlyList<FileInfo> Files)
    {
        public long Size { get; } = Files.Sum(static file => file.Length);

        public DateTime Written { get; } = Files.Max(static file => file.LastWriteTimeUtc);
    }
}
