using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Workbench.Verification;

/// <summary>A posted program in a file. Its reader decides whether it is valid.</summary>
/// <param name="open">Opens the text from its start. Throws, now or during reading, if it cannot be read.</param>
public sealed class ReadBackFile(Func<TextReader> open)
{
    public static ReadBackFile Open(string path) => new(() => new StreamReader(path));

    public static ReadBackFile FromText(string text) => new(() => new StringReader(text));

    /// <summary>Passes the text to a reader.</summary>
    /// <returns>The findings of the reader, or why the file cannot be read.</returns>
    public async Task<IReadOnlyList<Diagnostic>> ReadAsync(Func<TextReader, Task<IReadOnlyList<Diagnostic>>> read)
    {
        ArgumentNullException.ThrowIfNull(read);
        try
        {
            using var text = open();
            return await read(text).ConfigureAwait(false);
        }
        catch (Exception unreadable) when (IsUnreadable(unreadable))
        {
            return [Fault(unreadable)];
        }
    }

    /// <summary>The whole text of a short program; without a text the reason.</summary>
    public (string? Text, Diagnostic? Fault) ReadAll()
    {
        try
        {
            using var text = open();
            return (text.ReadToEnd(), null);
        }
        catch (Exception unreadable) when (IsUnreadable(unreadable))
        {
            return (null, Fault(unreadable));
        }
    }

    private static bool IsUnreadable(Exception exception) => exception is IOException or UnauthorizedAccessException or InvalidDataException;

    private static Diagnostic Fault(Exception unreadable) => DocumentRules.Unreadable.At(default, SystemErrorText.FromException(unreadable));
}
