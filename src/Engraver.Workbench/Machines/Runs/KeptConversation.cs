using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The file beside a journal in which stands what was said to the controller, compressed: by it the run can be replayed.</summary>
public static class KeptConversation
{
    private const string Ending = ".wire";

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
}
