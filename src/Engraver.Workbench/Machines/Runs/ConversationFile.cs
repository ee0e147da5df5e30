using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The compressed file beside a journal with the conversation with the controller, used to replay the run.</summary>
public static class ConversationFile
{
    private const string FileExtension = ".wire";

    /// <summary>Path of the file of a journal.</summary>
    public static string PathOf(string journal) => journal + FileExtension;

    /// <summary>Creates the file of a journal, unless one of them would be a stream.</summary>
    /// <returns>The file, or why it could not be created; neither for a stream.</returns>
    internal static (StreamWriter? File, string? Failure) Create(string journal)
    {
        if (FileKind.IsStream(journal) || FileKind.IsStream(PathOf(journal))) return (null, null);
        try
        {
            return (CompressedText.Create(PathOf(journal)), null);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return (null, SystemErrorText.FromException(unwritable));
        }
    }
}
