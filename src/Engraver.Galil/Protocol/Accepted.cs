namespace Engraver.Galil.Protocol;

/// <summary>The prompt was <c>:</c>.</summary>
/// <param name="Data">The text before the prompt, trimmed; empty when the command returns nothing. Lines are separated by LF.</param>
public sealed record Accepted(string Data) : Reply
{
    internal static Accepted Silent { get; } = new("");
}
