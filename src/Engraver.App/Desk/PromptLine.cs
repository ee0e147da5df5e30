namespace Engraver.App.Desk;

/// <summary>The text of a prompt as the desktop shows it.</summary>
internal static class PromptLine
{
    /// <summary>Instruction and default without the options, which are shown beside it as buttons.</summary>
    public static string WithoutOptions(string prompt)
    {
        var open = prompt.IndexOf(" [", StringComparison.Ordinal);
        var close = open < 0 ? -1 : prompt.IndexOf(']', open);
        if (close < 0) return prompt;
        var before = prompt[..open];
        return (before.EndsWith(" or", StringComparison.Ordinal) ? before[..^3] : before) + prompt[(close + 1)..];
    }
}
