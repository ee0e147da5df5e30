using System.Text.RegularExpressions;

namespace Engraver.TestKit;

/// <summary>Finds, in a line of the pseudo-language, a sentence that was inserted into a text as a fact, like a name: its marks hide it from
/// <c>PseudoLanguage.Unspoken</c>.</summary>
public static partial class HiddenSentence
{
    public static bool IsIn(string line) => ThreeWords().IsMatch(line);

    /// <summary>Three plain words in a row within the marks of a fact. Texts of the runtime about files and of System.CommandLine about arguments are not
    /// counted, because they are translated separately.</summary>
    [GeneratedRegex("‹(?!Could not find |Argument '|Required argument |Unrecognized command )[^‹›]*[a-z]{2,} [a-z]{2,} [a-z]{2,}[^‹›]*›")]
    private static partial Regex ThreeWords();
}
