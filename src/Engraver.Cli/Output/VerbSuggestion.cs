using System.CommandLine;
using Engraver.Core.Languages;

namespace Engraver.Cli.Output;

/// <summary>Suggests the nearest verb for an unknown word.</summary>
internal static class VerbSuggestion
{
    /// <summary>Null when the first word is a verb or an option: the error is elsewhere.</summary>
    public static string? For(string[] args, RootCommand root)
    {
        if (args.Length == 0 || args[0].StartsWith('-') || root.Subcommands.Any(verb => verb.Name == args[0])) return null;
        return NearestWord.Find(args[0], root.Subcommands.Select(verb => verb.Name)) is { } nearest
            ? Wording.Get("VerbSuggestion.Nearest", args[0], nearest)
            : Wording.Get("VerbSuggestion.None", args[0], string.Join(", ", root.Subcommands.Select(verb => verb.Name)));
    }
}
