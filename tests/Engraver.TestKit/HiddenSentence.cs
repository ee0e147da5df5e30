using System.Text.RegularExpressions;

namespace Engraver.TestKit;

/// <summary>Finds, in a line of the pseudo-language, a sentence that was given to a text as a fact, as if it were a name: its marks hide it from
/// <c>PseudoLanguage.Unspoken</c>.</summary>
public static partial class HiddenSentence
{
    public static bool IsIn(string line) => ThreeWords().IsMatch(line);

    /// <summary>Three plain words in a row inside of the marks of a fact. Not counted is what the runtime says of a file and System.CommandLine of
    /// arguments: they have languages of their own.</summary>
    [GeneratedRegex("‹(?!Could not find |Argument '|Required argument |Unrecognized command )[^‹›]*[a-z]{2,} [a-z]{2,} [a-z]{2,}[^‹›]*›")]
    private static partial Regex ThreeWords();
}
