using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Workbench.Verification;

/// <summary>A posted program as it stands in a file. Whether it is a program is for its reader to judge.</summary>
/// <param name="open">Begins the text anew. What cannot be read throws then, or while it is read.</param>
public sealed class ReadBackFile(Func<TextReader> open)
{
    public static ReadBackFile Open(string path) => new(() => new StreamReader(path));

    public static ReadBackFile FromText(string text) => new(() => new StringReader(text));

    /// <summary>Has the text read from its beginning, as far as the reader wants it.</summary>
    /// <returns>What the reader found; why the file cannot be read.</returns>
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

    /// <summary>All of it, for a short program that is needed whole; without a text the reason.</summary>
    public (string? Text, Diagnostic? Fault) Whole()
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

    private static Diagnostic Fault(Exception unreadable) => DocumentRules.Unreadable.At(default, SystemReason.Of(unreadable));
}
