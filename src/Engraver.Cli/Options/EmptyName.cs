using System.CommandLine;
using System.CommandLine.Parsing;

namespace Engraver.Cli.Options;

/// <summary>Finds a name that was given and is empty, as a variable of a shell that is not set gives it. No verb has a use for one: only a text may be
/// empty.</summary>
internal static class EmptyName
{
    /// <summary>The place of <see cref="Option.HelpName"/> by which an option takes any text.</summary>
    private const string AnyText = "TEXT";

    /// <returns>The argument or option; null when every name says something.</returns>
    public static string? In(ParseResult parsed)
    {
        foreach (var part in parsed.CommandResult.Children)
        {
            if (!part.Tokens.Any(token => token.Value.Length == 0)) continue;
            if (part is ArgumentResult { Argument: var argument }) return argument.Name;
            if (part is OptionResult { Option: { HelpName: not AnyText } and not SettingOption { MayBeEmpty: true } and var option } && option.ValueType == typeof(string)) return option.Name;
        }

        return null;
    }
}
