using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>An input of a script with its place, for the sentence that ends the script.</summary>
internal sealed record ScriptInput(string Path, ScriptToken Token)
{
    /// <summary>A result that ends the script, its sentence with the place; what is no failure stays as it is.</summary>
    public FeedResult Placed(FeedResult result) => result switch
    {
        FeedResult.Failed failed => failed with { Sentence = Place(failed.Sentence) },
        FeedResult.NotUnderstood unclear => new FeedResult.Failed(CommandFailure.Usage, Place(unclear.Sentence)),
        _ => result,
    };

    private string Place(string sentence) => FormattableString.Invariant($"{Path}({Token.Line}): '{Token.Text}': {sentence}");
}
