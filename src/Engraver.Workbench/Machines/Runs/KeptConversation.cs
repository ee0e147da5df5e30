using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The file beside a journal in which stands what was said to the controller, compressed: by it the run can be replayed.</summary>
public static class KeptConversation
{
    private const string Ending = ".wire";

    /// <summary>Runs whose conversations are kept in the operator's own folder; that of a long job is tens of megabytes.</summary>
    private const int MostKept = 20;

    /// <summary>The file of a journal.</summary>
    public static string PathOf(string journal) => journal + Ending;

    /// <summary>Begins the file of a journal; beside a stream, and in one, there is no place for it.</summary>
    /// <returns>The file, or why there is none; neither beside a stream.</returns>
    internal static (StreamWriter? File, string? Failure) Begin(string journal)
    {
        if (FileKind.IsStream(journal) || FileKind.IsStream(PathOf(journal))) return (null, null);
        try
        {
            return (CompressedText.Create(PathOf(journal)), null);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return (null, SystemReason.Of(unwritable));
        }
    }

    /// <summary>Deletes the oldest of a folder, so that there is room for one more; never one of a run that can be resumed.</summary>
    internal static void MakeRoom(string folder)
    {
        try
        {
            foreach (var old in new DirectoryInfo(folder).EnumerateFiles("*.jsonl" + Ending).OrderByDescending(file => file.LastWriteTimeUtc).Skip(MostKept - 1).Where(file => file.FullName[..^Ending.Length] is var journal && (!File.Exists(journal) || RunBudget.MayGo(journal)))) old.Delete();
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            // Somebody reads it: the next run tries again.
        }
    }
}
