using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <summary>The prompt was <c>?</c>; the reason was fetched with TC1.</summary>
/// <param name="Code">The number of TC1; compare this, never the text.</param>
/// <param name="Text">The controller's text for the code.</param>
/// <param name="Command">The refused command.</param>
public sealed record Rejected(TcCode Code, string Text, string Command) : Reply
{
    /// <summary>Index of the refused command in its line.</summary>
    public int Part { get; init; }

    /// <summary>One sentence for the operator: the refused command, code and text, and the meaning of the code.</summary>
    public string Explain() => Wording.Get("Reply.Refused", Command, (int)Code, Text, TcCodes.Hint(Code));

    /// <summary>The same in the controller-independent form.</summary>
    public MachineRefusal ToRefusal() => new((int)Code, Text, Command, Explain());
}
