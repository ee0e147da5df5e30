namespace Engraver.Workbench.Commands;

/// <summary>A typed command name with AutoCAD's prefixes: <c>'</c> transparent, <c>_</c> international, <c>.</c> built-in, <c>-</c> without a dialog.</summary>
internal static class CommandPrefix
{
    private const string Prefixes = "'_.-";

    public static string WithoutPrefix(string typed) => typed.TrimStart([.. Prefixes]);

    /// <summary>True if the prefixes include a dash.</summary>
    public static bool HasDash(string typed) => typed[..^WithoutPrefix(typed).Length].Contains('-', StringComparison.Ordinal);
}
