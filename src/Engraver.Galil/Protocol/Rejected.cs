namespace Engraver.Galil.Protocol;

/// <summary>The prompt was <c>?</c>; the reason was asked with TC1.</summary>
/// <param name="Code">The number of TC1; compare this, never the text.</param>
/// <param name="Text">The controller's own words.</param>
/// <param name="Command">What was refused.</param>
public sealed record Rejected(TcCode Code, string Text, string Command) : Reply
{
    /// <summary>One sentence for the operator: what was refused, code and text, and what the code means here.</summary>
    public string Explain() => $"The controller refused '{Command}' with TC {(int)Code} ({Text}){TcCodes.Hint(Code)}.";
}
