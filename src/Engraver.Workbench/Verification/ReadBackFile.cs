using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Verification;

/// <summary>A posted program as it stands in a file.</summary>
/// <param name="Text">Null when the file cannot be read; then <paramref name="Diagnostics"/> say why.</param>
public sealed record ReadBackFile(string? Text, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>Reads the text of any file; whether it is a program is for its reader to judge.</summary>
    public static ReadBackFile Open(string path)
    {
        try
        {
            return FromText(File.ReadAllText(path));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new ReadBackFile(null, [DocumentRules.Unreadable.At(default, unreadable.Message.TrimEnd('.'))]);
        }
    }

    public static ReadBackFile FromText(string text) => new(text, []);
}
