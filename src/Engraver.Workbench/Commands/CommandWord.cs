namespace Engraver.Workbench.Commands;

/// <summary>A typed command name without AutoCAD's prefixes: <c>'</c> transparent, <c>_</c> international, <c>.</c> built-in, <c>-</c> without a dialog (there are none here).</summary>
internal static class CommandWord
{
    public static string Bare(string typed) => typed.TrimStart('\'', '_', '.', '-');
}
