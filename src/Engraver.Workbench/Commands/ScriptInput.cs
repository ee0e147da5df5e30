using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>An input of a script with its place, for the sentence that ends the script.</summary>
internal sealed record ScriptInput(string Path, ScriptToken Token)
{
    public string Place(string sentence) => FormattableString.Invariant($"{Path}({Token.Line}): '{Token.Text}': {sentence}");
}
