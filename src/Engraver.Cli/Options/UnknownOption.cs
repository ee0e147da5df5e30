using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Core.Languages;

namespace Engraver.Cli.Options;

/// <summary>Finds a word that is written like an option and does not belong to the verb. The library takes such a word for the file, and then blames the word
/// after it.</summary>
internal static class UnknownOption
{
    /// <returns>A sentence that names the word; null when every option is known. A file whose name begins with a hyphen is written ./-NAME, or after
    /// <c>--</c>.</returns>
    public static string? In(ParseResult parsed)
    {
        var taken = parsed.CommandResult.Children.OfType<OptionResult>().SelectMany(option => option.Tokens).ToHashSet(ReferenceEqualityComparer.Instance);
        var word = parsed.Tokens.TakeWhile(token => token.Type != TokenType.DoubleDash).FirstOrDefault(token => token.Type == TokenType.Argument && IsWrittenAsOption(token.Value) && !taken.Contains(token));
        if (word is null) return null;
        var name = word.Value.Split('=', ':')[0];
        return NearestWord.Find(name, Names(parsed.CommandResult)) is { } nearest ? Wording.Get("UnknownOption.Nearest", name, nearest) : Wording.Get("UnknownOption.None", name);
    }

    private static bool IsWrittenAsOption(string word) => word is ['-', '-' or (>= 'a' and <= 'z') or (>= 'A' and <= 'Z'), _, ..] or ['-', (>= 'a' and <= 'z') or (>= 'A' and <= 'Z')];

    /// <summary>The options of the verb, and those that every verb takes.</summary>
    private static IEnumerable<string> Names(CommandResult command)
    {
        for (var at = command; at is not null; at = at.Parent as CommandResult)
        {
            foreach (var option in at.Command.Options.Where(option => !option.Hidden && (at == command || option.Recursive))) yield return option.Name;
        }
    }
}
